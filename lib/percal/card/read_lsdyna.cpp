#include <map>
#include <optional>

#include "percal/card/deck.hpp"
#include "percal/card/lsdyna.hpp"
#include "percal/card/modulus.hpp"

namespace percal {
namespace {

constexpr std::size_t short_columns = 10, long_columns = 20;
constexpr const char* measure_comment = "$ strain measure of MXEPS: ";

// The data lines of one keyword: fixed fields, or free ones where a line has commas.
struct Fields {
  const DeckBlock& block;
  const std::string& file;
  std::size_t columns;

  std::string text(const DeckLine& line, std::size_t field) const {
    if (line.text.find(',') != std::string::npos) {
      const auto fields = split_at_commas(line.text);
      return field < fields.size() ? fields[field] : "";
    }
    const std::size_t start = field * columns;
    return start < line.text.size() ? line.text.substr(start, columns) : "";
  }
  double number(const DeckLine& line, std::size_t field, const std::string& name) const {
    return deck_number(text(line, field), Place{file, line.number, name});
  }
};

// Ten columns, or twenty where *KEYWORD LONG=Y or a '+' says so; a '-' goes back to ten.
std::size_t columns_of(const Deck& deck, const DeckBlock& block) {
  std::size_t columns = short_columns;
  for (const DeckBlock& one : deck.blocks)
    if (one.keyword.starts_with("*KEYWORD") && one.keyword.find("LONG=Y") != std::string::npos) columns = long_columns;
  if (block.keyword.ends_with('+')) columns = long_columns;
  if (block.keyword.ends_with('-')) columns = short_columns;
  return columns;
}

bool has_title(const DeckBlock& block) { return block.keyword.find("_TITLE") != std::string::npos; }

bool is_ogden(const DeckBlock& block) {
  return block.keyword.starts_with("*MAT_OGDEN_RUBBER") || block.keyword.starts_with("*MAT_077_O");
}

StrainMeasure measure_of(const Deck& deck, const std::string& file, int line) {
  std::optional<StrainMeasure> found;
  for (const DeckLine& comment : deck.comments) {
    if (!comment.text.starts_with(measure_comment) || comment.number > line) continue;
    const std::string rest = comment.text.substr(std::string(measure_comment).size());
    const std::string said = rest.substr(0, rest.find(' '));
    for (const auto measure : {StrainMeasure::engineering, StrainMeasure::true_strain, StrainMeasure::green_lagrange})
      if (said == word(measure)) found = measure;
  }
  if (found) return *found;
  throw BadInput(Place{file, line, "MXEPS"}, "no comment that tells its strain measure",
                 std::string(measure_comment) + "engineering, true or green-lagrange, on a line above");
}

void read_terms(const Fields& fields, const DeckLine& moduli, const DeckLine& exponents, const UnitSystem& units,
                CardMaterial& material) {
  for (std::size_t k = 0; k < 8; ++k) {
    const std::string index = std::to_string(k + 1);
    const double modulus = fields.number(moduli, k, "MU" + index) * units.stress;
    const double alpha = fields.number(exponents, k, "ALPHA" + index);
    if (modulus == 0) continue;
    const Place place{fields.file, exponents.number, "ALPHA" + index};
    if (alpha == 0) throw BadInput(place, "0", "a number other than 0, as MU" + index + " is not 0");
    add_term(material, term_of_field(modulus, alpha, CardModulus::two_mu_over_alpha), place);
  }
}

FoundCard read_ogden(const Fields& fields, const UnitSystem& units) {
  const DeckBlock& block = fields.block;
  const std::string& file = fields.file;
  const std::size_t first = has_title(block) ? 1 : 0;
  const DeckLine& general = block.line(first, file, "MID, RO, PR and N");
  const DeckLine& moduli = block.line(first + 1, file, "MU1 to MU8");
  const DeckLine& exponents = block.line(first + 2, file, "ALPHA1 to ALPHA8");
  FoundCard card{.material = {.name = first == 1 ? trimmed(block.data[0].text) : trimmed(fields.text(general, 0)),
                              .density = 0,
                              .terms = {},
                              .bulk_modulus = 0},
                 .line = block.number,
                 .ignored = {}};
  const double terms = fields.number(general, 3, "N");
  if (terms != 0) throw BadInput(Place{file, general.number, "N"}, std::to_string(terms), "0: constants, not curves");
  card.material.density = fields.number(general, 1, "RO") * units.density();
  const double nu = fields.number(general, 2, "PR");
  if (!(nu > -1 && nu < 0.5))
    throw BadInput(Place{file, general.number, "PR"}, std::to_string(nu), "a number between -1 and 0.5");
  for (const auto& [field, name] : std::map<std::size_t, std::string>{{5, "G"}, {6, "SIGF"}, {7, "REF"}})
    if (fields.number(general, field, name) != 0) card.ignored.push_back(name);
  read_terms(fields, moduli, exponents, units, card.material);
  for (std::size_t i = first + 3; i < block.data.size(); ++i)
    if (fields.number(block.data[i], 0, "Gi") != 0)
      throw BadInput(Place{file, block.data[i].number, "Gi"}, "a Prony series", "a material without viscosity");
  card.material.bulk_modulus = shear_modulus(card.material) * bulk_to_shear(nu);
  check(card.material, Place{.file = file, .line = block.number, .key = ""});
  return card;
}

// *MAT_ADD_EROSION of the material with this number.
void read_erosion(const Deck& deck, const std::string& file, const std::string& id, FoundCard& card) {
  for (const DeckBlock& block : deck.blocks) {
    if (!block.keyword.starts_with("*MAT_ADD_EROSION")) continue;
    const Fields fields{block, file, columns_of(deck, block)};
    const std::size_t first = has_title(block) ? 1 : 0;
    if (trimmed(fields.text(block.line(first, file, "MID to NCS"), 0)) != id) continue;
    const DeckLine& limits = block.line(first + 1, file, "MNPRES to FAILTM");
    const double limit = fields.number(limits, 3, "MXEPS");
    if (limit != 0) card.material.erosion = CardErosion{limit, measure_of(deck, file, limits.number)};
    const char* const names[] = {"MNPRES", "SIGP1", "SIGVM", "MXEPS", "EPSSH", "SIGTH", "IMPULSE", "FAILTM"};
    for (std::size_t field = 0; field < 8; ++field)
      if (field != 3 && fields.number(limits, field, names[field]) != 0)
        card.ignored.push_back(std::string(names[field]) + " of *MAT_ADD_EROSION");
  }
}

}  // namespace

std::vector<FoundCard> read_lsdyna_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Deck deck = parse_deck(text, "$", '*');
  std::vector<FoundCard> cards;
  for (const DeckBlock& block : deck.blocks) {
    if (!is_ogden(block)) continue;
    const Fields fields{block, file, columns_of(deck, block)};
    FoundCard card = read_ogden(fields, units);
    const DeckLine& general = block.data[has_title(block) ? 1 : 0];
    read_erosion(deck, file, trimmed(fields.text(general, 0)), card);
    if (card.material.erosion) check(card.material, Place{.file = file, .line = block.number, .key = ""});
    cards.push_back(card);
  }
  return cards;
}

}  // namespace percal
