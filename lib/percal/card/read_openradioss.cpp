#include "percal/card/deck.hpp"
#include "percal/card/modulus.hpp"
#include "percal/card/openradioss.hpp"

namespace percal {
namespace {

constexpr double nu_of_zero = 0.495;
constexpr std::size_t fields_of_line = 5;

// The parts of "/MAT/LAW42/1/2".
std::vector<std::string> parts_of(const DeckBlock& block) {
  std::vector<std::string> parts;
  for (const char letter : block.keyword) {
    if (letter == '/') {
      parts.emplace_back();
    } else if (!parts.empty()) {
      parts.back() += letter;
    }
  }
  return parts;
}

std::string part(const std::vector<std::string>& parts, std::size_t i) { return i < parts.size() ? parts[i] : ""; }

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
    if (moduli[k] == 0) continue;
    const Place of_term{place.file, place.line, "alpha_" + std::to_string(k + 1)};
    if (exponents[k] == 0) throw BadInput(of_term, "0", "a number other than 0, as its modulus is not 0");
    add_term(material, term_of_field(moduli[k] * units.stress, exponents[k], meaning), of_term);
  }
}

double ratio_of(double nu, const Place& place) {
  if (!(nu > -1 && nu < 0.5)) throw BadInput(place, std::to_string(nu), "a number between -1 and 0.5");
  return bulk_to_shear(nu);
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
    const auto parts = parts_of(block);
    if (part(parts, 0) != "FAIL" || part(parts, 2) != id) continue;
    if (part(parts, 1) != "TENSSTRAIN") {
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
    const auto parts = parts_of(block);
    const std::string law = part(parts, 1);
    const bool law42 = law == "LAW42" || law == "OGDEN", law82 = law == "LAW82";
    if (part(parts, 0) != "MAT" || (!law42 && !law82)) continue;
    if (!part(parts, 3).empty())
      throw BadInput(Place{file, block.number, "unit_ID"}, trimmed(block.written),
                     "a material without a unit system of its own");
    FoundCard card{.material = {.name = trimmed(block.line(0, file, "the title").text),
                                .density = 0,
                                .terms = {},
                                .bulk_modulus = 0},
                   .line = block.number,
                   .ignored = {}};
    const DeckLine& density = block.line(1, file, "the density");
    card.material.density = number(density, 0, 20, file, "RHO_I") * units.density();
    if (law42) read_law42(block, file, units, card);
    if (law82) read_law82(block, file, units, card);
    read_erosion(deck, file, part(parts, 2), card);
    check(card.material, Place{.file = file, .line = block.number, .key = ""});
    cards.push_back(card);
  }
  return cards;
}

}  // namespace percal
