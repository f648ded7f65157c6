#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/lsdyna/lsdyna.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr int short_columns = 10, long_columns = 20;
constexpr double digits_that_matter = 1e-5;  // relative; far below what any parameter is known to
constexpr double worst_bulk_modulus = 0.01;
constexpr std::size_t title_characters = 80;
constexpr std::size_t fields_of_card = 8;

// The card's numbers in its units.
struct Numbers {
  double density, nu;
  std::vector<double> mu, alpha;
  double mxeps;  // 0: none
};

Numbers numbers_of(const CardMaterial& material, const UnitSystem& units) {
  Numbers numbers{.density = material.density / units.density(),
                  .nu = poisson_ratio(material.bulk_modulus / shear_modulus(material)),
                  .mu = {},
                  .alpha = {},
                  .mxeps = material.erosion ? material.erosion->limit : 0};
  for (const Ogden& term : material.terms) {
    numbers.mu.push_back(modulus_field(term, CardModulus::two_mu_over_alpha) / units.stress);
    numbers.alpha.push_back(term.alpha);
  }
  return numbers;
}

// Relative error of K/mu when PR is written in so many columns; infinite for PR = 0.5.
double bulk_error(const Numbers& numbers, double ratio, int columns) {
  const double error = std::abs(bulk_to_shear(*field_number(number_field(numbers.nu, columns))) / ratio - 1);
  return std::isfinite(error) ? error : HUGE_VAL;
}

bool all_hold(const Numbers& numbers, double ratio, int columns) {
  std::vector<double> all = {numbers.density};
  all.insert(all.end(), numbers.mu.begin(), numbers.mu.end());
  all.insert(all.end(), numbers.alpha.begin(), numbers.alpha.end());
  if (numbers.mxeps != 0) all.push_back(numbers.mxeps);
  const bool held = std::all_of(all.begin(), all.end(), [&](double value) {
    return std::abs(*field_number(number_field(value, columns)) / value - 1) <= digits_that_matter;
  });
  return held && bulk_error(numbers, ratio, columns) <= digits_that_matter;
}

// A comment line of field names and the line of fields under it.
std::string lines(const std::vector<std::string>& names, std::vector<std::string> fields, int columns) {
  fields.resize(fields_of_card, "0.");
  std::string text = fixed_line(names, columns);
  text.front() = '$';
  return text + fixed_line(fields, columns);
}

std::vector<std::string> numbered(const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= fields_of_card; ++i) names.push_back(name + std::to_string(i));
  return names;
}

std::vector<std::string> written(const std::vector<double>& numbers, int columns) {
  std::vector<std::string> fields;
  for (const double number : numbers) fields.push_back(number_field(number, columns));
  return fields;
}

std::string erosion_keyword(const CardErosion& erosion, int columns, const std::string& suffix) {
  std::string text;
  text += comment_lines("$", "elements go at a largest principal strain of " + in_all_measures(erosion));
  text += comment_lines("$", "strain measure of MXEPS: " + word(erosion.measure) +
                                 " (measure not documented: which one LS-DYNA compares in this material is not said in "
                                 "its manual, so the number is written as given)");
  text += "*MAT_ADD_EROSION" + suffix + "\n";
  text += lines({"MID", "EXCL", "MXPRES", "MNEPS", "EFFEPS", "VOLEPS", "NUMFIP", "NCS"},
                {"1", "0.", "0.", "0.", "0.", "0.", "1.", "1."}, columns);
  text += lines({"MNPRES", "SIGP1", "SIGVM", "MXEPS", "EPSSH", "SIGTH", "IMPULSE", "FAILTM"},
                {"0.", "0.", "0.", number_field(erosion.limit, columns)}, columns);
  return text;
}

}  // namespace

std::string lsdyna_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  const Numbers numbers = numbers_of(material, units);
  const double ratio = material.bulk_modulus / shear_modulus(material);
  const int columns = all_hold(numbers, ratio, short_columns) ? short_columns : long_columns;
  if (!(bulk_error(numbers, ratio, columns) <= worst_bulk_modulus)) {
    throw BadInput(Place{.file = "", .line = 0, .key = "bulk_modulus_Pa"},
                   fmt::format("{:.6g} Pa, which is {:.3g} mu", material.bulk_modulus, ratio),
                   "for an LS-DYNA card at most some 1e13 mu: PR has twenty columns at most");
  }
  const std::string suffix = columns == long_columns ? "+" : "";
  std::string text = card_comments(
      {"$", "MU", CardModulus::two_mu_over_alpha, "volumetric law: PR of K/mu; U = K (J - 1 - ln J)"}, material, units);
  if (columns == long_columns)
    text += comment_lines("$", "long format, fields of 20 columns: ten do not hold every number, and K, to 1e-5");
  if (!material.erosion) text += comment_lines("$", no_erosion_comment(material));
  text += "*MAT_OGDEN_RUBBER_TITLE" + suffix + "\n" + ascii_name(material.name, "-_. ,()%", title_characters) + "\n";
  text += lines({"MID", "RO", "PR", "N", "NV", "G", "SIGF", "REF"},
                {"1", number_field(numbers.density, columns), number_field(numbers.nu, columns), "0", "0"}, columns);
  text += lines(numbered("MU"), written(numbers.mu, columns), columns);
  text += lines(numbered("ALPHA"), written(numbers.alpha, columns), columns);
  if (material.erosion) text += erosion_keyword(*material.erosion, columns, suffix);
  return text;
}

namespace {

constexpr const char* measure_comment = "$ strain measure of MXEPS: ";

// The data lines of one keyword: fixed fields, or free ones where a line has commas.
struct Fields {
  const DeckBlock& block;
  const std::string& file;
  int columns;

  std::string text(const DeckLine& line, std::size_t field) const {
    if (line.text.find(',') != std::string::npos) {
      const auto fields = split_at(',', line.text);
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
int columns_of(const Deck& deck, const DeckBlock& block) {
  int columns = short_columns;
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
    add_term(material, modulus, alpha, CardModulus::two_mu_over_alpha,
             {fields.file, exponents.number, "ALPHA" + index});
  }
}

FoundCard read_ogden(const Fields& fields, const UnitSystem& units) {
  const DeckBlock& block = fields.block;
  const std::string& file = fields.file;
  const std::size_t first = has_title(block) ? 1 : 0;
  const DeckLine& general = block.line(first, file, "MID, RO, PR and N");
  const DeckLine& moduli = block.line(first + 1, file, "MU1 to MU8");
  const DeckLine& exponents = block.line(first + 2, file, "ALPHA1 to ALPHA8");
  FoundCard card{.material = {.name = first == 1 ? trimmed(block.data[0].text) : trimmed(fields.text(general, 0))},
                 .line = block.number};
  const double terms = fields.number(general, 3, "N");
  if (terms != 0) throw BadInput(Place{file, general.number, "N"}, std::to_string(terms), "0: constants, not curves");
  card.material.density = fields.number(general, 1, "RO") * units.density();
  const double ratio = ratio_of(fields.number(general, 2, "PR"), {file, general.number, "PR"});
  for (const auto& [field, name] : std::map<std::size_t, std::string>{{5, "G"}, {6, "SIGF"}, {7, "REF"}})
    if (fields.number(general, field, name) != 0) card.ignored.push_back(name);
  read_terms(fields, moduli, exponents, units, card.material);
  for (std::size_t i = first + 3; i < block.data.size(); ++i)
    if (fields.number(block.data[i], 0, "Gi") != 0)
      throw BadInput(Place{file, block.data[i].number, "Gi"}, "a Prony series", "a material without viscosity");
  card.material.bulk_modulus = shear_modulus(card.material) * ratio;
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
