// percal card write: the material card of a result, on standard output or in a file.
#include <cstdio>

#include "commands.hpp"
#include "percal/card/abaqus.hpp"
#include "percal/card/card_json.hpp"
#include "percal/card/lsdyna.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

std::string card_for(const std::string& solver, const CardMaterial& material, const UnitSystem& units) {
  if (solver == "lsdyna") return lsdyna_card(material, units);
  if (solver == "abaqus" || solver == "calculix") return abaqus_card(material, units);
  throw BadInput(Place{.file = "", .line = 0, .key = "--solver"}, "'" + solver + "'", "lsdyna, abaqus, calculix");
}

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) != 0 || !written) throw IoFailure("standard output: cannot be written");
}

}  // namespace

Exit run_card_write(const CardArguments& card, const Common& common) {
  const UnitSystem units = unit_system(card.units);
  const CardMaterial material = card_of_result(read_file(card.result), card.result);
  const std::string text = card_for(card.solver, material, units);
  if (card.file.empty()) {
    print(text);
    return Exit::done;
  }
  write_file(card.file, text);
  if (!common.quiet)
    print("wrote " + card.file + ": '" + material.name + "' for " + card.solver + " in " + units.name + "\n");
  return Exit::done;
}

}  // namespace percal::tools
