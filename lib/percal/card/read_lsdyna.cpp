#include "percal/card/deck.hpp"
#include "percal/card/lsdyna.hpp"

namespace percal {
namespace {

constexpr std::size_t columns = 10;
constexpr const char* measure_comment = "$ strain measure of MXEPS: ";

double number_at(const DeckLine& line, std::size_t field, const std::string& file, const std::string& name) {
  const std::size_t start = field * columns;
  const std::string text = start < line.text.size() ? line.text.substr(start, columns) : "";
  return deck_number(text, Place{file, line.number, name});
}

void need_one_term(const DeckLine& line, const std::string& file, const std::string& name) {
  for (std::size_t field = 1; field < 8; ++field) {
    const std::string field_name = name + std::to_string(field + 1);
    const double value = number_at(line, field, file, field_name);
    if (value != 0) throw BadInput(Place{file, line.number, field_name}, std::to_string(value), "0: one term only");
  }
}

StrainMeasure measure_of(const Deck& deck, const std::string& file, int line) {
  for (const DeckLine& comment : deck.comments) {
    if (!comment.text.starts_with(measure_comment)) continue;
    const std::string rest = comment.text.substr(std::string(measure_comment).size());
    const std::string found = rest.substr(0, rest.find(' '));
    for (const auto measure : {StrainMeasure::engineering, StrainMeasure::true_strain, StrainMeasure::green_lagrange}) {
      if (found == word(measure)) return measure;
    }
  }
  throw BadInput(Place{file, line, "MXEPS"}, "no comment that tells its strain measure",
                 std::string(measure_comment) + "engineering, true or green-lagrange");
}

}  // namespace

CardMaterial read_lsdyna_card(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Deck deck = parse_deck(text, "$");
  const DeckBlock& ogden = deck.need("*MAT_OGDEN_RUBBER", file);
  const DeckLine& general = ogden.line(0, file, "MID, RO, PR and N");
  const DeckLine& moduli = ogden.line(1, file, "MU1 to MU8");
  const DeckLine& exponents = ogden.line(2, file, "ALPHA1 to ALPHA8");
  const double terms = number_at(general, 3, file, "N");
  if (terms != 0) throw BadInput(Place{file, general.number, "N"}, std::to_string(terms), "0: constants, not curves");
  need_one_term(moduli, file, "MU");
  need_one_term(exponents, file, "ALPHA");

  CardMaterial material{};
  material.density = number_at(general, 1, file, "RO") * units.density();
  const double nu = number_at(general, 2, file, "PR");
  if (!(nu > -1 && nu < 0.5)) {
    throw BadInput(Place{file, general.number, "PR"}, std::to_string(nu), "a number between -1 and 0.5");
  }
  material.alpha = number_at(exponents, 0, file, "ALPHA1");
  const double mu1 = number_at(moduli, 0, file, "MU1") * units.stress;
  material.mu_true = true_modulus(mu1, material.alpha, ModulusConvention::mu_over_alpha);
  material.bulk_modulus = material.mu_true * bulk_to_shear(nu);
  if (const DeckBlock* erosion = deck.find("*MAT_ADD_EROSION")) {
    const DeckLine& limits = erosion->line(1, file, "MNPRES to FAILTM");
    const double limit = number_at(limits, 3, file, "MXEPS");
    if (limit != 0) material.erosion = CardErosion{limit, measure_of(deck, file, limits.number)};
  }
  check(material, Place{.file = file, .line = ogden.number, .key = ""});
  return material;
}

}  // namespace percal
