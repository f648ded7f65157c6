#include <set>

#include "percal/card/abaqus.hpp"
#include "percal/card/deck.hpp"
#include "percal/card/modulus.hpp"

namespace percal {
namespace {

// Options of a keyword line that belong to a material: they do not end it.
const std::set<std::string> of_material = {"*VISCOELASTIC", "*MULLINSEFFECT", "*DAMPING",         "*EXPANSION",
                                           "*HYSTERESIS",   "*DEPVAR",        "*CONDUCTIVITY",    "*SPECIFICHEAT",
                                           "*ELASTIC",      "*PLASTIC",       "*DAMAGEINITIATION"};

struct Keyword {
  std::string name;                  // "*HYPERELASTIC"
  std::vector<std::string> options;  // "OGDEN", "N=2"

  std::string value(const std::string& option) const {  // of "N=2"; empty where there is none
    for (const std::string& one : options)
      if (one.starts_with(option + "=")) return one.substr(option.size() + 1);
    return "";
  }
};

Keyword keyword_of(const std::string& line) {
  auto parts = split_at_commas(line);
  Keyword keyword{parts.front(), {}};
  keyword.options.assign(parts.begin() + 1, parts.end());
  return keyword;
}

// The name as it is written, without quotation marks.
std::string name_of(const DeckBlock& block) {
  for (const std::string& option : split_at_commas(block.written)) {
    if (!upper_without_blanks(option).starts_with("NAME=")) continue;
    std::string name = trimmed(option.substr(option.find('=') + 1));
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    return name;
  }
  return "";
}

int terms_of(const Keyword& keyword, const DeckBlock& block, const std::string& file) {
  const Place place{file, block.number, "*HYPERELASTIC"};
  bool ogden = false;
  for (const std::string& option : keyword.options) {
    ogden = ogden || option == "OGDEN";
    if (option == "TESTDATAINPUT") throw BadInput(place, "TEST DATA INPUT", "constants, which percal fit finds");
  }
  if (!ogden) throw BadInput(place, block.written, "*HYPERELASTIC, OGDEN");
  const std::string n = keyword.value("N");
  const double terms = n.empty() ? 1 : deck_number(n, place);
  if (terms != 1 && terms != 2 && terms != 3) throw BadInput(place, "N=" + n, "OGDEN with N=1, N=2 or N=3");
  return static_cast<int>(terms);
}

struct Number {
  std::string text;
  int line;
};

void read_ogden(const DeckBlock& block, const std::string& file, const UnitSystem& units, FoundCard& card) {
  const int terms = terms_of(keyword_of(block.keyword), block, file);
  std::vector<Number> numbers;
  for (const DeckLine& line : block.data)
    for (const std::string& text : split_at_commas(line.text))
      if (!is_blank(text)) numbers.push_back({text, line.number});
  const std::size_t needed = 2 * terms + 1;
  if (numbers.size() < needed)
    throw BadInput(Place{file, block.data.empty() ? block.number : block.data.front().number, "*HYPERELASTIC"},
                   std::to_string(numbers.size()) + " numbers", "mu and alpha of every term, then D1");
  const auto number = [&](std::size_t i, const std::string& name) {
    return deck_number(numbers[i].text, Place{file, numbers[i].line, name});
  };
  for (int k = 0; k < terms; ++k) {
    const std::string index = terms == 1 ? "" : std::to_string(k + 1);
    const double mu = number(2 * k, "mu" + index) * units.stress, alpha = number(2 * k + 1, "alpha" + index);
    add_term(card.material, term_of_field(mu, alpha, CardModulus::mu),
             Place{file, numbers[2 * k].line, "alpha" + index});
  }
  const double d1 = number(needed - 1, "D1");
  if (!(d1 > 0))
    throw BadInput(Place{file, numbers[needed - 1].line, "D1"}, numbers[needed - 1].text, "a positive number");
  card.material.bulk_modulus = 2 / d1 * units.stress;
  constexpr double as_good_as_absent = 1e15;  // of D2 and D3, whose terms are (J - 1)^4 / D2 and (J - 1)^6 / D3
  for (int k = 2; k <= terms && needed + k - 2 < numbers.size(); ++k) {
    const double value = number(needed + k - 2, "D" + std::to_string(k));
    if (value != 0 && value < as_good_as_absent)
      card.ignored.push_back("D" + std::to_string(k) + " (a higher term of the volumetric law)");
  }
}

}  // namespace

std::vector<FoundCard> read_abaqus_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Deck deck = without_blank_lines(parse_deck(text, "**", '*'));
  std::vector<FoundCard> cards;
  const auto& blocks = deck.blocks;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (keyword_of(blocks[i].keyword).name != "*MATERIAL") continue;
    FoundCard card{.material = {.name = name_of(blocks[i]), .density = 0, .terms = {}, .bulk_modulus = 0},
                   .line = blocks[i].number,
                   .ignored = {}};
    int ogden_line = 0;
    for (std::size_t j = i + 1; j < blocks.size(); ++j) {
      const std::string name = keyword_of(blocks[j].keyword).name;
      if (name == "*DENSITY") {
        const DeckLine& line = blocks[j].line(0, file, "the density");
        card.material.density =
            deck_number(split_at_commas(line.text).front(), Place{file, line.number, "density"}) * units.density();
      } else if (name == "*HYPERELASTIC") {
        ogden_line = blocks[j].number;
        read_ogden(blocks[j], file, units, card);
      } else if (of_material.count(name)) {
        card.ignored.push_back(trimmed(blocks[j].written));
      } else {
        break;
      }
    }
    if (ogden_line == 0) continue;  // another kind of material
    if (card.material.density == 0)
      throw BadInput(Place{file, card.line, "*DENSITY"}, "no density of material '" + card.material.name + "'",
                     "a material with *DENSITY");
    check(card.material, Place{.file = file, .line = ogden_line, .key = ""});
    cards.push_back(card);
  }
  return cards;
}

}  // namespace percal
