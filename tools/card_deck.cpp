// percal card write --deck uniaxial: the card in a single-element test, ready to run.
#include <filesystem>
#include <optional>

#include "card_options.hpp"
#include "percal/card/uniaxial_deck.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

// One file is written as --file says; several go to its folder under their own names, which hold the name of the run.
std::vector<std::string> paths_of(const std::vector<DeckFile>& files, const std::string& file) {
  if (files.size() == 1) return {file};
  std::vector<std::string> paths;
  for (const DeckFile& part : files) paths.push_back((std::filesystem::path(file).parent_path() / part.name).string());
  return paths;
}

}  // namespace

Exit run_card_deck(const CardArguments& card, const Common& common) {
  const std::optional<Solver> solver = solver_of_word(card.solver);
  if (!solver) {
    throw BadInput(Place{.file = "", .line = 0, .key = "--solver"}, "'" + card.solver + "' with --deck",
                   "lsdyna, abaqus, calculix, openradioss, febio, ansys");
  }
  const UnitSystem units = unit_system(card.units.empty() ? "si" : card.units);
  const CardMaterial material = card_of_result(read_file(card.result), card.result, card_request(card));
  const UniaxialTest test{.stretch = card.stretch, .increments = card.increments};
  const std::vector<DeckFile> files =
      uniaxial_deck_files(*solver, material, units, test, card.file.empty() ? "uniaxial" : card.file);
  if (common.check) {
    if (!common.quiet) print_text(card.result + ": a result that " + card.solver + " can have a deck of\n");
    return Exit::done;
  }
  if (card.file.empty()) {
    if (files.size() > 1) {
      throw BadInput(Place{.file = "", .line = 0, .key = "--file"}, "nothing",
                     "a name: the deck for " + card.solver + " is two files, as NAME_0000.rad and NAME_0001.rad");
    }
    print_text(files.front().text);
    return Exit::done;
  }
  const std::vector<std::string> paths = paths_of(files, card.file);
  for (std::size_t i = 0; i < files.size(); ++i) {
    write_file(paths[i], files[i].text);
    if (!common.quiet)
      print_text("wrote " + paths[i] + ": uniaxial test of '" + material.name + "' for " + card.solver + " in " +
                 units.name + "\n");
  }
  return Exit::done;
}

}  // namespace percal::tools
