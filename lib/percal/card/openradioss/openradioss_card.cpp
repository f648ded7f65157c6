#include <fmt/core.h>

#include <cmath>

#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/openradioss/openradioss.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr int columns = 20;
constexpr std::size_t title_characters = 100;
constexpr std::size_t fields_of_line = 5;
constexpr double smallest_nu = 1e-10;  // 0 would mean 0.495

std::string right(const std::string& text, int width) { return fmt::format("{:>{}}", text, width); }

// Mu_1 to Mu_5 or alpha_1 to alpha_5, and the line of zeros for 6 to 10.
std::string ten_fields(const std::string& name, std::vector<std::string> fields) {
  fields.resize(2 * fields_of_line, "0");
  std::string text;
  for (std::size_t start = 0; start < fields.size(); start += fields_of_line) {
    std::string line = "#", numbers;
    for (std::size_t i = start; i < start + fields_of_line; ++i) {
      line += right(fmt::format("{}_{}", name, i + 1), i == start ? columns - 1 : columns);
      numbers += right(fields[i], columns);
    }
    text += line + "\n" + numbers + "\n";
  }
  return text;
}

std::string erosion_of(const CardErosion& given) {
  CardErosion erosion = given;
  if (given.measure == StrainMeasure::green_lagrange)
    erosion = {strain_at(stretch_at(given.limit, given.measure), StrainMeasure::engineering),
               StrainMeasure::engineering};
  const bool engineering = erosion.measure == StrainMeasure::engineering;
  std::string text = comment_lines("#", "elements go at a largest principal strain of " + in_all_measures(given));
  text +=
      comment_lines("#", fmt::format("strain measure of Epsilon_t1 and Epsilon_t2: {} (S_Flag {}: first principal, {})",
                                     word(erosion.measure), engineering ? 13 : 23, word(erosion.measure)));
  text += "/FAIL/TENSSTRAIN/1\n";
  text += "#         EPSILON_T1          EPSILON_T2    FCT_ID          EPSILON_F1          EPSILON_F2    S_FLAG\n";
  const std::string limit = right(number_field(erosion.limit), columns);
  text += limit + limit + right("0", 10) + right("0", columns) + right("0", columns) +
          right(engineering ? "13" : "23", 10) + "\n";
  text += "# FCT_IDEL           FSCALE_EL              EI_REF\n";
  text += right("0", 10) + right("0", columns) + right("0", columns) + "\n";
  text += "#  FCT_IDT            FSCALE_T\n";
  text += right("0", 10) + right("0", columns) + "\n";
  return text;
}

}  // namespace

std::string openradioss_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  double nu = poisson_ratio(material.bulk_modulus / shear_modulus(material));
  if (std::abs(nu) < smallest_nu) nu = smallest_nu;
  std::string text = card_comments(
      {"#", "Mu_", CardModulus::two_mu_over_alpha, "volumetric law: Nu of K/mu; U = K (J - 1)^2 / 2"}, material, units);
  if (!material.erosion) text += comment_lines("#", no_erosion_comment(material));
  text += "/MAT/LAW42/1\n" + ascii_name(material.name, "-_. ,()%+", title_characters) + "\n";
  text += "#              RHO_I\n" + right(number_field(material.density / units.density()), columns) + "\n";
  text += "#                 NU           SIGMA_CUT   JSTRAIN FCT_IDBLK         FSCALE_BLK         M    I_FORM\n";
  text += right(number_field(nu), columns) + right("0", columns) + right("0", 10) + right("0", 10) +
          right("0", columns) + right("0", 10) + right("0", 10) + "\n";
  std::vector<std::string> moduli, exponents;
  for (const Ogden& term : material.terms) {
    moduli.push_back(number_field(modulus_field(term, CardModulus::two_mu_over_alpha) / units.stress));
    exponents.push_back(number_field(term.alpha));
  }
  text += ten_fields("MU", moduli) + ten_fields("ALPHA", exponents);
  if (material.erosion) text += erosion_of(*material.erosion);
  return text;
}

namespace {

constexpr double nu_of_zero = 0.495;

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
    const DeckLine& line = block.line(first + i / fields_of_line, file, name);
    all.push_back(number(line, 20 * (i % fields_of_line), 20, file, name + "_" + std::to_string(i + 1)));
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

void read_law42(const DeckBlock& block, const std::string& file, const UnitSystem& units, FoundCard& card) {
  const DeckLine& general = block.line(2, file, "Nu, sigma_cut, ..., M and I_form");
  const double nu = number(general, 0, 20, file, "Nu");
  if (number(general, 20, 20, file, "sigma_cut") != 0) card.ignored.push_back("sigma_cut");
  if (number(general, 50, 10, file, "fct_ID_bulk") != 0)
    throw BadInput(Place{file, general.number, "fct_ID_bulk"}, "a function of the bulk modulus", "0");
  if (number(general, 80, 10, file, "M") != 0)
    throw BadInput(Place{file, general.number, "M"}, "a Prony series", "0: a material without viscosity");
  const auto mu = values(block, 3, 10, file, "Mu"), alpha = values(block, 5, 10, file, "alpha");
  add_terms(mu, alpha, CardModulus::two_mu_over_alpha, units, Place{file, block.number, ""}, card.material);
  card.material.bulk_modulus =
      shear_modulus(card.material) * ratio_of(nu == 0 ? nu_of_zero : nu, Place{file, general.number, "Nu"});
}

void read_law82(const DeckBlock& block, const std::string& file, const UnitSystem& units, FoundCard& card) {
  const DeckLine& general = block.line(2, file, "N and Nu");
  const double n = number(general, 0, 10, file, "N");
  if (!(n >= 1 && n <= 10)) throw BadInput(Place{file, general.number, "N"}, std::to_string(n), "1 to 10");
  const auto count = static_cast<std::size_t>(n);
  const std::string rest = general.text.size() > 10 ? general.text.substr(10) : "";
  const double nu = deck_number(rest, Place{file, general.number, "Nu"});
  const std::size_t lines = (count + fields_of_line - 1) / fields_of_line;
  const auto mu = values(block, 3, count, file, "mu"), alpha = values(block, 3 + lines, count, file, "alpha");
  const auto d = values(block, 3 + 2 * lines, count, file, "D");
  add_terms(mu, alpha, CardModulus::mu, units, Place{file, block.number, ""}, card.material);
  if (nu != 0) {
    card.material.bulk_modulus = shear_modulus(card.material) * ratio_of(nu, Place{file, general.number, "Nu"});
  } else if (d[0] > 0) {
    card.material.bulk_modulus = 2 / d[0] * units.stress;
  } else {
    throw BadInput(Place{file, general.number, "Nu"}, "neither Nu nor D_1", "one of them");
  }
}

// /FAIL/TENSSTRAIN of the material with this number.
void read_erosion(const Deck& deck, const std::string& file, const std::string& id, FoundCard& card) {
  for (const DeckBlock& block : deck.blocks) {
    if (part(block, 1) != "FAIL" || part(block, 3) != id) continue;
    if (part(block, 2) != "TENSSTRAIN") {
      card.ignored.push_back(trimmed(block.written));
      continue;
    }
    const DeckLine& line = block.line(0, file, "Epsilon_t1 to S_Flag");
    const double start = number(line, 0, 20, file, "Epsilon_t1"), end = number(line, 20, 20, file, "Epsilon_t2");
    const double flag = number(line, 90, 10, file, "S_Flag");
    if (flag != 13 && flag != 23) {
      card.ignored.push_back(trimmed(block.written) + ": S_Flag other than 13 (engineering) or 23 (true)");
      continue;
    }
    if (start != end) card.ignored.push_back("Epsilon_t1 of /FAIL/TENSSTRAIN, where softening starts");
    card.material.erosion = CardErosion{end, flag == 13 ? StrainMeasure::engineering : StrainMeasure::true_strain};
  }
}

}  // namespace

std::vector<FoundCard> read_openradioss_cards(const std::string& text, const std::string& file,
                                              const UnitSystem& units) {
  const Deck deck = parse_deck(text, "#", '/');
  std::vector<FoundCard> cards;
  for (const DeckBlock& block : deck.blocks) {
    const std::string law = part(block, 2);
    const bool law42 = law == "LAW42" || law == "OGDEN", law82 = law == "LAW82";
    if (part(block, 1) != "MAT" || (!law42 && !law82)) continue;
    if (!part(block, 4).empty())
      throw BadInput(Place{file, block.number, "unit_ID"}, trimmed(block.written),
                     "a material without a unit system of its own");
    FoundCard card{.material = {.name = trimmed(block.line(0, file, "the title").text)}, .line = block.number};
    const DeckLine& density = block.line(1, file, "the density");
    card.material.density = number(density, 0, 20, file, "RHO_I") * units.density();
    if (law42) read_law42(block, file, units, card);
    if (law82) read_law82(block, file, units, card);
    read_erosion(deck, file, part(block, 3), card);
    check(card.material, Place{.file = file, .line = block.number, .key = ""});
    cards.push_back(card);
  }
  return cards;
}

}  // namespace percal
