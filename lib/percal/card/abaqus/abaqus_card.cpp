#include <fmt/core.h>

#include <cctype>
#include <cmath>

#include "percal/card/abaqus/abaqus.hpp"
#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"

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
  const double d1 = 2 / (material.bulk_modulus / units.stress);
  if (d1 >= calculix_least_d1) return;
  throw BadInput(
      Place{.file = "", .line = 0, .key = "units"}, fmt::format("'{}', in which D1 = 2/K is {:.3g}", units.name, d1),
      fmt::format("for CalculiX units in which D1 is {:g} or more, as mm-t-s-MPa: it takes a smaller D1 for 0 "
                  "and puts 0.1/mu in its place",
                  calculix_least_d1));
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

}  // namespace percal
