#include "percal/card/abaqus.hpp"
#include "percal/card/deck.hpp"

namespace percal {
namespace {

std::vector<std::string> split_at_commas(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char letter : line) {
    if (letter == ',') {
      fields.emplace_back();
    } else {
      fields.back() += letter;
    }
  }
  return fields;
}

}  // namespace

CardMaterial read_abaqus_card(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Deck deck = parse_deck(text, "**");
  const DeckBlock& name = deck.need("*MATERIAL,NAME=", file);
  const DeckLine& density = deck.need("*DENSITY", file).line(0, file, "the density");
  const DeckBlock& ogden = deck.need("*HYPERELASTIC,OGDEN", file);
  if (ogden.keyword.find("N=1") == std::string::npos) {
    throw BadInput(Place{file, ogden.number, "*HYPERELASTIC"}, ogden.keyword, "OGDEN, N=1");
  }
  const DeckLine& constants = ogden.line(0, file, "mu, alpha and D1");
  const std::vector<std::string> fields = split_at_commas(constants.text);
  if (fields.size() < 3) {
    throw BadInput(Place{file, constants.number, "*HYPERELASTIC"}, "'" + constants.text + "'", "mu, alpha, D1");
  }
  CardMaterial material{};
  material.name = name.keyword.substr(std::string("*MATERIAL,NAME=").size());
  material.density =
      deck_number(split_at_commas(density.text).front(), Place{file, density.number, "density"}) * units.density();
  material.mu_true = deck_number(fields[0], Place{file, constants.number, "mu"}) * units.stress;
  material.alpha = deck_number(fields[1], Place{file, constants.number, "alpha"});
  const double d1 = deck_number(fields[2], Place{file, constants.number, "D1"});
  if (!(d1 > 0)) throw BadInput(Place{file, constants.number, "D1"}, fields[2], "a positive number");
  material.bulk_modulus = 2 / d1 * units.stress;
  check(material, Place{.file = file, .line = ogden.number, .key = ""});
  return material;
}

}  // namespace percal
