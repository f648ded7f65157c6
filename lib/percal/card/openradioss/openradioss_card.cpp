#include <fmt/core.h>

#include <cmath>

#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/openradioss/openradioss.hpp"

namespace percal {
namespace {

constexpr int columns = 20;
constexpr std::size_t title_characters = 100;
constexpr std::size_t fields_of_line = 5;
constexpr double most_bulk_ratio =
    48;  // K/mu: above it LAW42 raises K by itself where a stretch is below `least_stretch`
constexpr double least_stretch = 0.2;

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
  text += comment_lines(
      "#", fmt::format("S_Flag {} needs /BEGIN 2018 or later: version 2017 compares lambda^2 - 1 without a word, and "
                       "an element goes at stretch {:.4g}",
                       engineering ? 13 : 23, std::sqrt(1 + erosion.limit)));
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
  const double ratio = material.bulk_modulus / shear_modulus(material);
  std::string text = card_comments(
      {"#", "Mu_", CardModulus::two_mu_over_alpha, "volumetric law: Nu of K/mu; U = K (J - 1)^2 / 2"}, material, units);
  if (ratio > most_bulk_ratio)
    text += comment_lines(
        "#", fmt::format("LAW42 raises K by itself where K is more than {:g} mu and the smallest stretch below {:g}; "
                         "with a function that is 1 throughout as FCT_IDBLK it does not",
                         most_bulk_ratio, least_stretch));
  if (!material.erosion) text += comment_lines("#", no_erosion_comment(material));
  text += "/MAT/LAW42/1\n" + ascii_name(material.name, "-_. ,()%+", title_characters) + "\n";
  text += "#              RHO_I\n" + right(number_field(material.density / units.density()), columns) + "\n";
  text += "#                 NU           SIGMA_CUT   JSTRAIN FCT_IDBLK         FSCALE_BLK         M    I_FORM\n";
  text += right(number_field(poisson_ratio(ratio)), columns) + right("0", columns) + right("0", 10) + right("0", 10) +
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

}  // namespace percal
