// percal card write: the material card of a result, on standard output or in a file.
#include "card_options.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {

Exit run_card_write(const CardArguments& card, const Common& common) {
  const UnitSystem units = unit_system(card.units.empty() ? "si" : card.units);
  const CardMaterial material = card_of_result(read_file(card.result), card.result, card_request(card));
  const std::optional<Solver> solver = solver_of_word(card.solver);
  const std::string text = solver ? write_card(*solver, material, units) : csv_card(material, units, curve_range(card));
  if (common.check) {
    if (!common.quiet) print_text(card.result + ": a result that " + card.solver + " can have a card of\n");
    return Exit::done;
  }
  if (card.file.empty()) {
    print_text(text);
    return Exit::done;
  }
  write_file(card.file, text);
  if (!common.quiet)
    print_text("wrote " + card.file + ": '" + material.name + "' for " + card.solver + " in " + units.name + "\n");
  return Exit::done;
}

}  // namespace percal::tools
