#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>

#include "percal/card/card_text.hpp"
#include "percal/card/lsdyna/lsdyna.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr const char* measure_comment = "$ strain measure of MXEPS: ";

constexpr std::array other_laws{LawSign{"*MAT_027", as_mooney_rivlin},
                                LawSign{"*MAT_MOONEY-RIVLIN", as_mooney_rivlin},
                                LawSign{"*MAT_077_H", "hyperelastic by C10, C01, ..., no Ogden terms"},
                                LawSign{"*MAT_HYPERELASTIC_RUBBER", "hyperelastic by C10, C01, ..., no Ogden terms"},
                                LawSign{"*MAT_181", rubber_from_curve},
                                LawSign{"*MAT_SIMPLIFIED_RUBBER", rubber_from_curve},
                                LawSign{"*MAT_031", "Frazer-Nash rubber"},
                                LawSign{"*MAT_FRAZER_NASH", "Frazer-Nash rubber"},
                                LawSign{"*MAT_127", "Arruda-Boyce rubber"},
                                LawSign{"*MAT_ARRUDA_BOYCE", "Arruda-Boyce rubber"},
                                LawSign{"*MAT_007", "Blatz-Ko rubber"},
                                LawSign{"*MAT_BLATZ-KO", "Blatz-Ko rubber"}};

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
  int columns = lsdyna_short;
  for (const DeckBlock& one : deck.blocks)
    if (one.keyword.starts_with("*KEYWORD") && one.keyword.find("LONG=Y") != std::string::npos) columns = lsdyna_long;
  if (block.keyword.ends_with('+')) columns = lsdyna_long;
  if (block.keyword.ends_with('-')) columns = lsdyna_short;
  return columns;
}

bool has_title(const DeckBlock& block) { return block.keyword.find("_TITLE") != std::string::npos; }

bool is_ogden(const DeckBlock& block) {
  return block.keyword.starts_with("*MAT_OGDEN_RUBBER") || block.keyword.starts_with("*MAT_077_O");
}

std::optional<StrainMeasure> measure_of(const Deck& deck, int line) {
  std::optional<StrainMeasure> found;
  for (const DeckLine& comment : deck.comments) {
    if (!comment.text.starts_with(measure_comment) || comment.number > line) continue;
    const std::string rest = comment.text.substr(std::string(measure_comment).size());
    const std::string said = rest.substr(0, rest.find(' '));
    for (const auto measure : {StrainMeasure::engineering, StrainMeasure::true_strain, StrainMeasure::green_lagrange})
      if (said == word(measure)) found = measure;
  }
  return found;
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
  FoundCard card{.material = {.name = first == 1 ? trimmed(block.data[0].text) : trimmed(fields.text(general, 0))},
                 .line = block.number};
  if (const double terms = fields.number(general, 3, "N"); terms != 0)
    throw BadInput(Place{file, general.number, "N"}, fmt::format("{:g}", terms),
                   "0: constants, not curves (percal fit finds them from the curve)");
  const DeckLine& moduli = block.line(first + 1, file, "MU1 to MU8");
  const DeckLine& exponents = block.line(first + 2, file, "ALPHA1 to ALPHA8");
  if (const double density = fields.number(general, 1, "RO"); density != 0)
    card.material.density = density * units.density();
  const double ratio = ratio_of(fields.number(general, 2, "PR"), {file, general.number, "PR"});
  for (const auto& [field, name] : {std::pair{5, "G"}, {6, "SIGF"}, {7, "REF"}})
    if (fields.number(general, field, name) != 0) card.ignored.push_back(name);
  read_terms(fields, moduli, exponents, units, card.material);
  for (std::size_t i = first + 3; i < block.data.size(); ++i)
    if (fields.number(block.data[i], 0, "Gi") != 0)
      throw BadInput(Place{file, block.data[i].number, "Gi"}, "a Prony series", "a material without viscosity");
  card.material.bulk_modulus = shear_modulus(card.material) * ratio;
  check_solid(card.material, Place{.file = file, .line = block.number, .key = ""});
  return card;
}

// What *MAT_ADD_EROSION compares, a line each. A field is off where it is 0 or EXCL.
constexpr std::array<std::array<const char*, 8>, 2> limits{
    {{"", "", "MXPRES", "MNEPS", "EFFEPS", "VOLEPS", "", ""},
     {"MNPRES", "SIGP1", "SIGVM", "MXEPS", "EPSSH", "SIGTH", "IMPULSE", "FAILTM"}}};

constexpr const char* unknown_strain =
    "MXEPS (a largest principal strain whose measure is not known: a comment \"$ strain measure of MXEPS: "
    "engineering\", "
    "true or green-lagrange, above it says)";

void read_erosion(const Deck& deck, const Fields& fields, FoundCard& card) {
  const DeckBlock& block = fields.block;
  const std::size_t first = has_title(block) ? 1 : 0;
  const DeckLine& general = block.line(first, fields.file, "MID to NCS");
  const double off = fields.number(general, 1, "EXCL");
  const double conditions = fields.number(general, 7, "NCS");
  const auto pass_over = [&](const std::string& what, double value) {
    card.ignored.push_back(fmt::format("{} of *MAT_ADD_EROSION: {:g}", what, value));
  };
  if (const double points = fields.number(general, 6, "NUMFIP"); points != 0 && points != 1)
    pass_over("NUMFIP", points);
  if (conditions > 1) pass_over("NCS (so many limits must be passed at once)", conditions);
  for (std::size_t row = 0; row < limits.size(); ++row) {
    const DeckLine& line = block.line(first + row, fields.file, "MNPRES to FAILTM");
    for (std::size_t field = 0; field < limits[row].size(); ++field) {
      const std::string name = limits[row][field];
      const double value = name.empty() ? 0 : fields.number(line, field, name);
      if (value == 0 || value == off) continue;
      const auto measure = name == "MXEPS" ? measure_of(deck, line.number) : std::nullopt;
      if (measure && conditions <= 1) {
        card.material.erosion = CardErosion{value, *measure};
        continue;
      }
      pass_over(name == "MXEPS" && !measure ? unknown_strain : name, value);
      card.erodes_otherwise = true;
    }
  }
  for (std::size_t i = first + 2; i < block.data.size(); ++i)
    if (block.data[i].text.find_first_of("123456789") != std::string::npos)
      card.ignored.push_back(fmt::format("line {} of *MAT_ADD_EROSION (damage)", block.data[i].number));
}

// "1", " 01" and "1." are one material.
bool same_number(const std::string& id, const std::string& other) {
  const auto number = field_number(id);
  return number ? number == field_number(other) : trimmed(id) == trimmed(other);
}

// All *MAT_ADD_... of the material with this number.
void read_additions(const Deck& deck, const std::string& file, const std::string& id, FoundCard& card) {
  for (const DeckBlock& block : deck.blocks) {
    if (!block.keyword.starts_with("*MAT_ADD_")) continue;
    const Fields fields{block, file, columns_of(deck, block)};
    const std::size_t first = has_title(block) ? 1 : 0;
    if (!same_number(fields.text(block.line(first, file, "MID"), 0), id)) continue;
    if (block.keyword.starts_with("*MAT_ADD_EROSION")) {
      read_erosion(deck, fields, card);
    } else {
      card.ignored.push_back(fmt::format("{} (line {})", trimmed(block.written), block.number));
      card.erodes_otherwise = card.erodes_otherwise || block.keyword.find("DAMAGE") != std::string::npos;
    }
  }
  if (card.material.erosion) check_solid(card.material, Place{.file = file, .line = card.line, .key = ""});
}

}  // namespace

FoundMaterials read_lsdyna_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Deck deck = parse_deck(text, "$", '*');
  FoundMaterials found;
  for (const DeckBlock& block : deck.blocks) {
    if (!block.keyword.starts_with("*MAT_") || block.keyword.starts_with("*MAT_ADD_")) continue;
    if (!is_ogden(block)) {
      found.others.push_back({block.number, trimmed(block.written), law_of(other_laws, block.keyword)});
      continue;
    }
    const Fields fields{block, file, columns_of(deck, block)};
    FoundCard card = read_ogden(fields, units);
    const DeckLine& general = block.data[has_title(block) ? 1 : 0];
    read_additions(deck, file, fields.text(general, 0), card);
    found.cards.push_back(card);
  }
  return found;
}

}  // namespace percal
