#include <fmt/core.h>

#include <cctype>
#include <cmath>
#include <set>

#include "percal/card/abaqus/abaqus.hpp"
#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr std::size_t name_characters = 80;
constexpr std::size_t numbers_of_line = 8;

// A name that both programs take: letters, digits, '_' and '-', a letter first, at most 80 characters.
std::string material_name(const std::string& name) {
  const bool letter_first = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front()));
  return ascii_name((letter_first ? "" : "M") + name, "-_", name_characters);
}

// mu1, alpha1, mu2, alpha2, ..., D1, D2, ...: eight to a line. `absent` is what D2 and D3 are where they mean nothing.
std::string constants(const CardMaterial& material, const UnitSystem& units, double absent) {
  std::vector<double> numbers;
  for (const Ogden& term : material.terms) {
    numbers.push_back(modulus_field(term, CardModulus::mu) / units.stress);
    numbers.push_back(term.alpha);
  }
  numbers.push_back(2 / (material.bulk_modulus / units.stress));
  numbers.resize(3 * material.terms.size(), absent);
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += number_field(numbers[i]);
    const bool last = i + 1 == numbers.size();
    text += last || (i + 1) % numbers_of_line == 0 ? (last ? "\n" : ",\n") : ", ";
  }
  return text;
}

// CalculiX puts a number of its own in the place of a D1 that it takes for 0. docs/formats/cards.md
void check_calculix_d1(const CardMaterial& material, const UnitSystem& units) {
  constexpr double smallest = 1e-10;
  const double d1 = 2 / (material.bulk_modulus / units.stress);
  if (d1 >= smallest) return;
  throw BadInput(
      Place{.file = "", .line = 0, .key = "units"}, fmt::format("'{}', in which D1 = 2/K is {:.3g}", units.name, d1),
      fmt::format("for CalculiX units in which D1 is {:g} or more, as mm-t-s-MPa: it takes a smaller D1 for 0 "
                  "and puts 0.1/mu in its place",
                  smallest));
}

std::string card(const CardMaterial& material, const UnitSystem& units, double absent) {
  std::string text =
      card_comments({"**", "mu", CardModulus::mu, "volumetric law: D1 = 2/K; U = (J - 1)^2 / D1"}, material, units);
  text += comment_lines("**", no_erosion_comment(material));
  text += "*MATERIAL, NAME=" + material_name(material.name) + "\n";
  text += "*DENSITY\n" + number_field(material.density / units.density()) + "\n";
  text += "*HYPERELASTIC, OGDEN, N=" + std::to_string(material.terms.size()) + "\n";
  text += constants(material, units, absent);
  return text;
}

}  // namespace

std::string abaqus_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  return card(material, units, 0);
}

std::string calculix_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  check_calculix_d1(material, units);
  constexpr double absent = 1e20;  // 0 would be replaced here too
  return card(material, units, absent);
}

namespace {

// Options of a keyword line that belong to a material: they do not end it.
const std::set<std::string> of_material = {"*VISCOELASTIC", "*MULLINSEFFECT", "*DAMPING",         "*EXPANSION",
                                           "*HYSTERESIS",   "*DEPVAR",        "*CONDUCTIVITY",    "*SPECIFICHEAT",
                                           "*ELASTIC",      "*PLASTIC",       "*DAMAGEINITIATION"};

std::string keyword_of(const DeckBlock& block) { return block.keyword.substr(0, block.keyword.find(',')); }

// The name as it is written, without quotation marks.
std::string name_of(const DeckBlock& block) {
  for (const std::string& option : split_at(',', block.written)) {
    if (!upper_without_blanks(option).starts_with("NAME=")) continue;
    std::string name = trimmed(option.substr(option.find('=') + 1));
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    return name;
  }
  return "";
}

int terms_of(const DeckBlock& block, const std::string& file) {
  const Place place{file, block.number, "*HYPERELASTIC"};
  bool ogden = false;
  std::string n;
  for (const std::string& option : split_at(',', block.keyword)) {
    ogden = ogden || option == "OGDEN";
    if (option == "TESTDATAINPUT") throw BadInput(place, "TEST DATA INPUT", "constants, which percal fit finds");
    if (option.starts_with("N=")) n = option.substr(2);
  }
  if (!ogden) throw BadInput(place, block.written, "*HYPERELASTIC, OGDEN");
  const double terms = n.empty() ? 1 : deck_number(n, place);
  if (terms != 1 && terms != 2 && terms != 3) throw BadInput(place, "N=" + n, "OGDEN with N=1, N=2 or N=3");
  return static_cast<int>(terms);
}

struct Number {
  std::string text;
  int line;
};

void read_ogden(const DeckBlock& block, const std::string& file, const UnitSystem& units, FoundCard& card) {
  const int terms = terms_of(block, file);
  std::vector<Number> numbers;
  for (const DeckLine& line : block.data)
    for (const std::string& text : split_at(',', line.text))
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
    add_term(card.material, mu, alpha, CardModulus::mu, Place{file, numbers[2 * k].line, "alpha" + index});
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
  Deck deck = parse_deck(text, "**", '*');
  for (DeckBlock& block : deck.blocks)
    std::erase_if(block.data, [](const DeckLine& line) { return is_blank(line.text); });
  std::vector<FoundCard> cards;
  const auto& blocks = deck.blocks;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (keyword_of(blocks[i]) != "*MATERIAL") continue;
    FoundCard card{.material = {.name = name_of(blocks[i])}, .line = blocks[i].number};
    int ogden_line = 0;
    for (std::size_t j = i + 1; j < blocks.size(); ++j) {
      const std::string name = keyword_of(blocks[j]);
      if (name == "*DENSITY") {
        const DeckLine& line = blocks[j].line(0, file, "the density");
        card.material.density =
            deck_number(split_at(',', line.text).front(), Place{file, line.number, "density"}) * units.density();
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
    if (std::isnan(card.material.density))
      throw BadInput(Place{file, card.line, "*DENSITY"}, "no density of material '" + card.material.name + "'",
                     "a material with *DENSITY");
    check(card.material, Place{.file = file, .line = ogden_line, .key = ""});
    cards.push_back(card);
  }
  return cards;
}

}  // namespace percal
