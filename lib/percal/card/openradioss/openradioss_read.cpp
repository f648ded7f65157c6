#include <fmt/core.h>

#include <array>
#include <set>
#include <tuple>

#include "percal/card/openradioss/openradioss.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double nu_of_zero = 0.495;
constexpr double no_cut = 1e20;  // a sigma_cut of this or more cuts nothing
constexpr std::size_t values_of_line = 5;
constexpr double first_with_s_flag = 2018;  // versions before compare lambda^2 - 1 whatever the flag says

constexpr std::array other_laws{
    LawSign{"/MAT/LAW62", "Ogden with viscosity (VISC_HYP): its terms could be read only without the viscosity"},
    LawSign{"/MAT/VISC_HYP", "Ogden with viscosity: its terms could be read only without the viscosity"},
    LawSign{"/MAT/LAW69", ogden_from_curve},
    LawSign{"/MAT/LAW88", ogden_from_curve},
    LawSign{"/MAT/LAW92", "Arruda-Boyce rubber"},
    LawSign{"/MAT/LAW94", "Yeoh rubber"},
    LawSign{"/MAT/LAW95", "Bergstrom-Boyce rubber"},
    LawSign{"/MAT/LAW100", "a rubber of networks with viscosity"}};

// Part 1 of "/MAT/LAW42/1/2" is MAT.
std::string part(const DeckBlock& block, std::size_t i) {
  const auto parts = split_at('/', block.keyword);
  return i < parts.size() ? parts[i] : "";
}

double number(const DeckLine& line, std::size_t start, std::size_t width, const std::string& file,
              const std::string& name) {
  const std::string text = start < line.text.size() ? line.text.substr(start, width) : "";
  return deck_number(text, Place{file, line.number, name});
}

// Reads `count` values, five to a line of 20 columns each, from line `first` on.
std::vector<double> values(const DeckBlock& block, std::size_t first, std::size_t count, const std::string& file,
                           const std::string& name) {
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) {
    const DeckLine& line = block.line(first + i / values_of_line, file, name);
    all.push_back(number(line, 20 * (i % values_of_line), 20, file, name + "_" + std::to_string(i + 1)));
  }
  return all;
}

void add_terms(const std::vector<double>& moduli, const std::vector<double>& exponents, CardModulus meaning,
               const UnitSystem& units, const Place& place, CardMaterial& material) {
  for (std::size_t k = 0; k < moduli.size(); ++k) {
    add_term(material, moduli[k] * units.stress, exponents[k], meaning,
             {place.file, place.line, "alpha_" + std::to_string(k + 1)});
  }
}

// What Fct_IDblk multiplies K by: 1 where there is none. Throws BadInput for a function that is not a constant.
double bulk_factor(const Deck& deck, const DeckLine& general, const std::string& file) {
  const double id = number(general, 50, 10, file, "Fct_IDblk"), scale = number(general, 60, 20, file, "Fscale_blk");
  if (id == 0) return 1;
  std::set<double> ordinates;
  for (const DeckBlock& block : deck.blocks)
    if (block.keyword == fmt::format("/FUNCT/{:g}", id))
      for (std::size_t i = 1; i < block.data.size(); ++i)
        if (!is_blank(block.data[i].text)) ordinates.insert(number(block.data[i], 20, 20, file, "Y"));
  if (ordinates.size() != 1)
    throw BadInput(Place{file, general.number, "Fct_IDblk"}, "a function of the bulk modulus", "0, or a constant one");
  return *ordinates.begin() * (scale == 0 ? 1 : scale);
}

void read_law42(const Deck& deck, const DeckBlock& block, const std::string& file, const UnitSystem& units,
                FoundCard& card) {
  const DeckLine& general = block.line(2, file, "Nu, sigma_cut, ..., M and I_form");
  const double nu = number(general, 0, 20, file, "Nu");
  if (const double cut = number(general, 20, 20, file, "sigma_cut"); cut != 0 && cut < no_cut)
    card.ignored.push_back("sigma_cut");
  if (number(general, 80, 10, file, "M") != 0)
    throw BadInput(Place{file, general.number, "M"}, "a Prony series", "0: a material without viscosity");
  const auto mu = values(block, 3, 10, file, "Mu"), alpha = values(block, 5, 10, file, "alpha");
  add_terms(mu, alpha, CardModulus::two_mu_over_alpha, units, Place{file, block.number, ""}, card.material);
  card.material.bulk_modulus = shear_modulus(card.material) * bulk_factor(deck, general, file) *
                               ratio_of(nu == 0 ? nu_of_zero : nu, Place{file, general.number, "Nu"});
}

void read_law82(const DeckBlock& block, const std::string& file, const UnitSystem& units, FoundCard& card) {
  const DeckLine& general = block.line(2, file, "N and Nu");
  const double n = number(general, 0, 10, file, "N");
  if (!(n >= 1 && n <= 10)) throw BadInput(Place{file, general.number, "N"}, std::to_string(n), "1 to 10");
  const auto count = static_cast<std::size_t>(n);
  const std::string rest = general.text.size() > 10 ? general.text.substr(10) : "";
  const double nu = deck_number(rest, Place{file, general.number, "Nu"});
  const std::size_t lines = (count + values_of_line - 1) / values_of_line;
  const auto mu = values(block, 3, count, file, "mu"), alpha = values(block, 3 + lines, count, file, "alpha");
  const auto d = values(block, 3 + 2 * lines, count, file, "D");
  add_terms(mu, alpha, CardModulus::mu, units, Place{file, block.number, ""}, card.material);
  if (nu != 0) {
    card.material.bulk_modulus = shear_modulus(card.material) * ratio_of(nu, Place{file, general.number, "Nu"});
  } else if (d[0] > 0) {
    set_bulk_modulus(card.material, d[0], units.stress, Place{file, general.number, "D_1"});
    for (std::size_t i = 1; i < d.size(); ++i)
      if (d[i] != 0) card.ignored.push_back(fmt::format("D_{} (a higher term of the volumetric law)", i + 1));
  } else {
    throw BadInput(Place{file, general.number, "Nu"}, "neither Nu nor D_1", "one of them");
  }
}

// Of /BEGIN; 0 where there is none.
double version_of(const Deck& deck, const std::string& file) {
  for (const DeckBlock& block : deck.blocks)
    if (block.keyword == "/BEGIN" && block.data.size() > 1) return number(block.data[1], 0, 10, file, "version");
  return 0;
}

void read_tensstrain(const Deck& deck, const DeckBlock& block, const std::string& file, FoundCard& card) {
  const std::string keyword = trimmed(block.written);
  const auto pass_over = [&](const std::string& what) { card.ignored.push_back(what + " of " + keyword); };
  const DeckLine& line = block.line(0, file, "Epsilon_t1 to S_Flag");
  const double start = number(line, 0, 20, file, "Epsilon_t1"), end = number(line, 20, 20, file, "Epsilon_t2");
  const double flag = number(line, 90, 10, file, "S_Flag");
  if (flag != 13 && flag != 23) {
    card.ignored.push_back(keyword + ": S_Flag other than 13 (engineering) or 23 (true)");
    card.erodes_otherwise = true;
    return;
  }
  if (start != end) pass_over("Epsilon_t1, where softening starts,");
  for (const auto& [column, width, name] :
       {std::tuple{40, 10, "fct_ID (by strain rate)"}, {50, 20, "Epsilon_f1"}, {70, 20, "Epsilon_f2"}})
    if (number(line, column, width, file, name) != 0) pass_over(name);
  const std::array functions{"fct_IDel (by element size)", "fct_IDt (by temperature)"};
  for (std::size_t i = 0; i < functions.size() && i + 1 < block.data.size(); ++i)
    if (number(block.data[i + 1], 0, 10, file, functions[i]) != 0) pass_over(functions[i]);
  const double version = version_of(deck, file);
  if (version != 0 && version < first_with_s_flag) {
    card.material.erosion = CardErosion{end / 2, StrainMeasure::green_lagrange};
    pass_over(
        fmt::format("S_Flag {:g}, which version {:g} does not know, so that it compares lambda^2 - 1,", flag, version));
  } else {
    card.material.erosion = CardErosion{end, flag == 13 ? StrainMeasure::engineering : StrainMeasure::true_strain};
  }
}

// The keywords that add to the material of this number: /FAIL/TENSSTRAIN, and others, which are said.
void read_additions(const Deck& deck, const std::string& file, const std::string& id, FoundCard& card) {
  static const std::set<std::string> additions = {"FAIL", "VISC", "EOS", "NONLOCAL", "HEAT", "THERM_STRESS", "LEAK"};
  for (const DeckBlock& block : deck.blocks) {
    const std::string kind = part(block, 1);
    if (!additions.count(kind) || part(block, 3) != id) continue;
    if (kind == "VISC")
      throw BadInput(Place{file, block.number, trimmed(block.written)}, "viscosity of the material",
                     "a material without viscosity");
    if (kind == "FAIL" && part(block, 2) == "TENSSTRAIN") {
      read_tensstrain(deck, block, file, card);
    } else {
      card.ignored.push_back(trimmed(block.written));
      card.erodes_otherwise = card.erodes_otherwise || kind == "FAIL";
    }
  }
}

}  // namespace

FoundMaterials read_openradioss_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Deck deck = parse_deck(text, "#", '/');
  FoundMaterials found;
  for (const DeckBlock& block : deck.blocks) {
    const std::string law = part(block, 2);
    const bool law42 = law == "LAW42" || law == "OGDEN", law82 = law == "LAW82";
    if (part(block, 1) != "MAT") continue;
    if (!law42 && !law82) {
      found.others.push_back({block.number, "/MAT/" + law, law_of(other_laws, block.keyword)});
      continue;
    }
    if (!part(block, 4).empty())
      throw BadInput(Place{file, block.number, "unit_ID"}, trimmed(block.written),
                     "a material without a unit system of its own");
    FoundCard card{.material = {.name = trimmed(block.line(0, file, "the title").text)}, .line = block.number};
    if (const double density = number(block.line(1, file, "the density"), 0, 20, file, "RHO_I"); density != 0)
      card.material.density = density * units.density();
    if (law42) read_law42(deck, block, file, units, card);
    if (law82) read_law82(block, file, units, card);
    read_additions(deck, file, part(block, 3), card);
    check_solid(card.material, Place{.file = file, .line = block.number, .key = ""});
    found.cards.push_back(card);
  }
  return found;
}

}  // namespace percal
