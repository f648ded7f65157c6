#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "percal/card/abaqus/abaqus.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr std::size_t fields_of_line = 8;
constexpr double as_good_as_absent = 1e15;  // of D2 and D3, whose terms are (J - 1)^4 / D2 and (J - 1)^6 / D3

constexpr std::array other_options{LawSign{"NEOHOOKE", "neo-Hooke: the Ogden term alpha = 2 with mu = 2 C10"},
                                   LawSign{"MOONEY-RIVLIN", as_mooney_rivlin},
                                   LawSign{"YEOH", "Yeoh rubber"},
                                   LawSign{"ARRUDA-BOYCE", "Arruda-Boyce rubber"},
                                   LawSign{"VANDERWAALS", "van der Waals rubber"},
                                   LawSign{"MARLOW", rubber_from_curve},
                                   LawSign{"POLYNOMIAL", "a polynomial of the invariants"},
                                   LawSign{"REDUCEDPOLYNOMIAL", "a polynomial of the invariants"},
                                   LawSign{"USER", "a user's own law"}};

// How the keywords begin that end a material: what a model has besides. Any other one between is part of it.
constexpr std::array ends_of_material{
    "*MATERIAL", "*NODE",      "*ELEMENT",   "*NSET",    "*ELSET",  "*SURFACE",  "*SOLIDSECTION", "*SHELLSECTION",
    "*STEP",     "*BOUNDARY",  "*AMPLITUDE", "*PART",    "*END",    "*INST",     "*ASSEMBLY",     "*MEMBRANESECTION",
    "*INITIAL",  "*CONTACT",   "*TIE",       "*COUPL",   "*RIGID",  "*EQUATION", "*MPC",          "*ORIENTATION",
    "*HEADING",  "*RESTART",   "*OUTPUT",    "*INCLUDE", "*TRANSF", "*SYSTEM",   "*PHYSICAL",     "*PREPRINT",
    "*FRICTION", "*TIMEPOINTS"};

std::string keyword_of(const DeckBlock& block) { return block.keyword.substr(0, block.keyword.find(',')); }

bool ends_material(const std::string& keyword) {
  return std::ranges::any_of(ends_of_material, [&](const char* start) { return keyword.starts_with(start); });
}

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

// The law that a *HYPERELASTIC has instead of Ogden's by constants; nothing where it has them.
std::optional<std::string> other_law(const DeckBlock& block) {
  const auto options = split_at(',', block.keyword);
  const auto has = [&](const std::string& option) { return std::ranges::find(options, option) != options.end(); };
  if (has("OGDEN")) return has("TESTDATAINPUT") ? std::optional<std::string>(ogden_from_curve) : std::nullopt;
  for (const std::string& option : options)
    if (const std::string law = law_of(other_options, option); !law.empty()) return law;
  return "";
}

int terms_of(const DeckBlock& block, const std::string& file) {
  const Place place{file, block.number, "*HYPERELASTIC"};
  for (const std::string& option : split_at(',', block.keyword)) {
    if (!option.starts_with("N=")) continue;
    const double terms = deck_number(option.substr(2), place);
    if (terms != 1 && terms != 2 && terms != 3) throw BadInput(place, option, "OGDEN with N=1, N=2 or N=3");
    return static_cast<int>(terms);
  }
  return 1;
}

// The constants at one temperature, a field each, blank ones as they are: mu and alpha of every term, the D, the temperature and
// field variables.
struct Constants {
  int line;
  std::vector<std::string> fields;

  std::string text(std::size_t i) const { return i < fields.size() ? fields[i] : ""; }
};

std::vector<Constants> constants_of(const DeckBlock& block, std::size_t terms) {
  const std::size_t lines = 1 + 3 * terms / fields_of_line;  // the temperature may be the first field of the next
  std::vector<Constants> sets;
  for (std::size_t i = 0; i < block.data.size(); ++i) {
    auto fields = split_at(',', block.data[i].text);
    if (is_blank(fields.back())) fields.pop_back();  // a comma at the end
    if (i % lines == 0) sets.push_back({block.data[i].number, {}});
    auto& all = sets.back().fields;
    all.resize(i % lines * fields_of_line);
    all.insert(all.end(), fields.begin(), fields.end());
  }
  return sets;
}

// What a program does with a D1 that it takes for 0.
struct ZeroD1 {
  double largest;
  void (*take)(FoundCard& card, const Place& place);
};

void incompressible(FoundCard& card, const Place& place) { set_bulk_modulus(card.material, 0, 1, place); }

void replaced_by_calculix(FoundCard& card, const Place& place) {
  constexpr double calculix_d1 = 0.1;  // over mu
  set_bulk_modulus(card.material, calculix_d1 / shear_modulus(card.material), 1, place);
  card.ignored.push_back(place.key + " = 0: CalculiX puts 0.1/mu in its place, nu = 0.475");
}

void read_constants(const Constants& constants, std::size_t terms, const std::string& file, const UnitSystem& units,
                    ZeroD1 zero_d1, FoundCard& card) {
  for (std::size_t i = 0; i < 2 * terms; ++i)
    if (is_blank(constants.text(i)))
      throw BadInput(Place{file, constants.line, "*HYPERELASTIC"}, std::to_string(i) + " numbers",
                     "mu and alpha of every term, then D1");
  const auto number = [&](std::size_t i, const std::string& name) {
    return deck_number(constants.text(i), Place{file, constants.line, name});
  };
  for (std::size_t k = 0; k < terms; ++k) {
    const std::string index = terms == 1 ? "" : std::to_string(k + 1);
    const double mu = number(2 * k, "mu" + index) * units.stress, alpha = number(2 * k + 1, "alpha" + index);
    add_term(card.material, mu, alpha, CardModulus::mu, Place{file, constants.line, "alpha" + index});
  }
  const Place place{file, constants.line, "D1"};
  if (const double d1 = number(2 * terms, "D1"); d1 >= 0 && d1 <= zero_d1.largest) {
    zero_d1.take(card, place);
  } else {
    set_bulk_modulus(card.material, d1, units.stress, place);
  }
  for (std::size_t k = 1; k < terms; ++k) {
    const std::string name = "D" + std::to_string(k + 1);
    const double d = number(2 * terms + k, name);
    const bool replaced = zero_d1.largest > 0 && d <= zero_d1.largest;  // by a number of the program's own
    if (replaced || (d != 0 && d < as_good_as_absent))
      card.ignored.push_back(name + (replaced ? " = 0, in whose place CalculiX puts a number of its own" : "") +
                             " (a higher term of the volumetric law)");
  }
}

// A material with one set of constants, or with one for each temperature.
std::vector<FoundCard> cards_of(const FoundCard& material, const DeckBlock& ogden, const std::string& file,
                                const UnitSystem& units, ZeroD1 zero_d1) {
  const auto terms = static_cast<std::size_t>(terms_of(ogden, file));
  const auto sets = constants_of(ogden, terms);
  if (sets.empty())
    throw BadInput(Place{file, ogden.number, "*HYPERELASTIC"}, "0 numbers", "mu and alpha of every term, then D1");
  std::vector<FoundCard> cards;
  for (const Constants& constants : sets) {
    FoundCard card = material;
    if (sets.size() > 1) card.material.name += " at " + trimmed(constants.text(3 * terms));
    read_constants(constants, terms, file, units, zero_d1, card);
    check_solid(card.material, Place{.file = file, .line = constants.line, .key = ""});
    cards.push_back(card);
  }
  return cards;
}

FoundMaterials read(const std::string& text, const std::string& file, const UnitSystem& units, ZeroD1 zero_d1) {
  Deck deck = parse_deck(text, "**", '*');
  for (DeckBlock& block : deck.blocks)
    std::erase_if(block.data, [](const DeckLine& line) { return is_blank(line.text); });
  FoundMaterials found;
  const auto& blocks = deck.blocks;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (keyword_of(blocks[i]) != "*MATERIAL") continue;
    FoundCard card{.material = {.name = name_of(blocks[i])}, .line = blocks[i].number};
    const DeckBlock *ogden = nullptr, *viscosity = nullptr;
    OtherMaterial other{blocks[i].number, trimmed(blocks[i].written), ""};
    for (std::size_t j = i + 1; j < blocks.size() && !ends_material(keyword_of(blocks[j])); ++j) {
      const std::string name = keyword_of(blocks[j]);
      if (name == "*DENSITY") {
        const DeckLine& line = blocks[j].line(0, file, "the density");
        card.material.density =
            deck_number(split_at(',', line.text).front(), Place{file, line.number, "density"}) * units.density();
        if (blocks[j].data.size() > 1) card.ignored.push_back("*DENSITY at further temperatures");
      } else if (name == "*HYPERELASTIC") {
        const auto law = other_law(blocks[j]);
        if (law) other = {blocks[j].number, trimmed(blocks[j].written), *law};
        if (!law) ogden = &blocks[j];
      } else {
        if (name == "*VISCOELASTIC") viscosity = &blocks[j];
        card.ignored.push_back(trimmed(blocks[j].written));
      }
    }
    if (!ogden) {
      found.others.push_back(other);
      continue;
    }
    if (viscosity)
      throw BadInput(Place{file, viscosity->number, "*VISCOELASTIC"},
                     "a Prony series (" + trimmed(viscosity->written) + ")",
                     "a material without viscosity: its constants at one rate");
    for (const FoundCard& one : cards_of(card, *ogden, file, units, zero_d1)) found.cards.push_back(one);
  }
  return found;
}

}  // namespace

FoundMaterials read_abaqus_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  return read(text, file, units, {0, incompressible});
}

FoundMaterials read_calculix_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  return read(text, file, units, {calculix_least_d1, replaced_by_calculix});
}

}  // namespace percal
