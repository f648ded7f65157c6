#include "card_options.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "percal/card/field.hpp"
#include "percal/text/file.hpp"
#include "percal/units/quantity.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

double density_of(const std::string& text) {
  const std::string accepted = "a positive density with its unit, such as \"1010 kg/m3\"";
  const Place place{"", 0, "--density"};
  try {
    const Quantity density = parse_quantity(text);
    if (density.dimension != dimension::density) throw BadInput(place, in_quotes(text), accepted);
    if (!(density.value > 0)) throw BadInput(place, in_quotes(text), accepted);
    return density.value;
  } catch (const std::invalid_argument& error) {
    throw BadInput(place, in_quotes(text) + " (" + error.what() + ")", accepted);
  }
}

bool is_json(const std::string& text) {
  const auto start = text.find_first_not_of(" \t\r\n");
  return start != std::string::npos && text[start] == '{';
}

}  // namespace

CardRequest card_request(const CardArguments& card) {
  CardRequest request{.name = card.name};
  if (!card.density.empty()) request.density = density_of(card.density);
  if (card.bulk_to_shear) {
    if (!(*card.bulk_to_shear > 0) || !std::isfinite(*card.bulk_to_shear))
      throw BadInput({"", 0, "--bulk-to-shear"}, std::to_string(*card.bulk_to_shear), "a positive number K/mu");
    request.bulk_to_shear = card.bulk_to_shear;
  }
  if (card.nu) {
    if (!(*card.nu > -1 && *card.nu < 0.5))
      throw BadInput({"", 0, "--nu"}, std::to_string(*card.nu), "a number between -1 and 0.5");
    request.bulk_to_shear = bulk_to_shear(*card.nu);
  }
  return request;
}

CurveRange curve_range(const CardArguments& card) {
  CurveRange range;
  const auto deformation = deformation_of(card.mode);
  if (!deformation) throw BadInput({"", 0, "--mode"}, in_quotes(card.mode), "uniaxial, equibiaxial, planar or shear");
  range.deformation = *deformation;
  if (range.deformation == Deformation::simple_shear) range.low = 0, range.high = 1;
  if (!card.range.empty()) {
    const auto colon = card.range.find(':');
    const auto low = field_number(card.range.substr(0, colon));
    const auto high = colon == std::string::npos ? std::nullopt : field_number(card.range.substr(colon + 1));
    if (!low || !high) throw BadInput({"", 0, "LOW:HIGH"}, in_quotes(card.range), "two numbers such as 0.5:2");
    range.low = *low;
    range.high = *high;
  }
  range.points = card.points;
  return range;
}

ReadCard read_any_card(const CardArguments& card) {
  const std::string text = read_file(card.card);
  if (is_json(text)) {
    CardRequest request = card_request(card);
    return {{card_of_result(text, card.card, request), 0, {}}, "", "si"};
  }
  const auto solver = card.solver.empty() ? solver_of(text) : solver_of_word(card.solver);
  if (!solver)
    throw BadInput({card.card, 0, ""}, "no keyword of the six programs",
                   "a card for " + listed(solver_words()) + ", or --solver");
  const auto units = card.units.empty() ? unit_system_of(text) : unit_system(card.units);
  if (!units)
    throw BadInput({card.card, 0, "--units"}, "no comment that names the unit system",
                   "the units of its numbers, such as --units mm-t-s-MPa");
  const auto cards = read_cards(*solver, text, card.card, *units);
  ReadCard read{card.name.empty() ? only_card(cards, card.card) : named_card(cards, card.name, card.card),
                solver_words()[static_cast<std::size_t>(*solver)], units->name};
  return read;
}

void print_text(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) != 0 || !written) throw IoFailure("standard output: cannot be written");
}

}  // namespace percal::tools
