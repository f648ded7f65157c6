#include "percal/card/ansys.hpp"

#include <fmt/core.h>

#include "percal/card/field.hpp"
#include "percal/card/header.hpp"

namespace percal {
namespace {

constexpr int field_characters = 20;
constexpr std::size_t numbers_of_command = 6;
constexpr std::size_t name_characters = 60;

}  // namespace

std::string ansys_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  std::string text = card_comments(
      {"!", "mu_", CardModulus::two_mu_over_alpha, "volumetric law: d_1 = 2/K; U = (J - 1)^2 / d_1"}, material, units);
  text += comment_lines("!", material.erosion ? "no erosion in this card: elements should go at a largest principal "
                                                "strain of " +
                                                    in_all_measures(*material.erosion)
                                              : "no erosion in this card");
  text += "! name: " + ascii_name(material.name, "-_. ", name_characters) + "\n";
  text += "MP,DENS,1," + number_field(material.density / units.density(), field_characters) + "\n";
  text += fmt::format("TB,HYPER,1,1,{},OGDEN\n", material.terms.size());
  std::vector<double> numbers;
  for (const Ogden& term : material.terms) {
    numbers.push_back(modulus_field(term, CardModulus::two_mu_over_alpha) / units.stress);
    numbers.push_back(term.alpha);
  }
  numbers.push_back(2 / (material.bulk_modulus / units.stress));
  numbers.resize(3 * material.terms.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % numbers_of_command == 0) text += fmt::format("{}TBDATA,{}", i == 0 ? "" : "\n", i + 1);
    text += "," + number_field(numbers[i], field_characters);
  }
  return text + "\n";
}

}  // namespace percal
