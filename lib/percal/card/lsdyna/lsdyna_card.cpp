#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/lsdyna/lsdyna.hpp"

namespace percal {
namespace {

constexpr double digits_that_matter = 1e-5;  // relative; far below what any parameter is known to
constexpr double worst_bulk_modulus = 0.01;
constexpr std::size_t title_characters = 80;
constexpr std::size_t fields_of_card = 8;

// The card's numbers in its units.
struct Numbers {
  double density, nu;
  std::vector<double> mu, alpha;
  double mxeps;  // 0: none
};

Numbers numbers_of(const CardMaterial& material, const UnitSystem& units) {
  Numbers numbers{.density = material.density / units.density(),
                  .nu = poisson_ratio(material.bulk_modulus / shear_modulus(material)),
                  .mu = {},
                  .alpha = {},
                  .mxeps = material.erosion ? material.erosion->limit : 0};
  for (const Ogden& term : material.terms) {
    numbers.mu.push_back(modulus_field(term, CardModulus::two_mu_over_alpha) / units.stress);
    numbers.alpha.push_back(term.alpha);
  }
  return numbers;
}

// Relative error of K/mu when PR is written in so many columns; infinite for PR = 0.5.
double bulk_error(const Numbers& numbers, double ratio, int columns) {
  const double error = std::abs(bulk_to_shear(*field_number(number_field(numbers.nu, columns))) / ratio - 1);
  return std::isfinite(error) ? error : HUGE_VAL;
}

bool all_hold(const Numbers& numbers, double ratio, int columns) {
  std::vector<double> all = {numbers.density};
  all.insert(all.end(), numbers.mu.begin(), numbers.mu.end());
  all.insert(all.end(), numbers.alpha.begin(), numbers.alpha.end());
  if (numbers.mxeps != 0) all.push_back(numbers.mxeps);
  const bool held = std::all_of(all.begin(), all.end(), [&](double value) {
    return std::abs(*field_number(number_field(value, columns)) / value - 1) <= digits_that_matter;
  });
  return held && bulk_error(numbers, ratio, columns) <= digits_that_matter;
}

// A comment line of field names and the line of fields under it.
std::string lines(const std::vector<std::string>& names, std::vector<std::string> fields, int columns) {
  fields.resize(fields_of_card, "0.");
  std::string text = fixed_line(names, columns);
  text.front() = '$';
  return text + fixed_line(fields, columns);
}

std::vector<std::string> numbered(const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= fields_of_card; ++i) names.push_back(name + std::to_string(i));
  return names;
}

std::vector<std::string> written(const std::vector<double>& numbers, int columns) {
  std::vector<std::string> fields;
  for (const double number : numbers) fields.push_back(number_field(number, columns));
  return fields;
}

std::string erosion_keyword(const CardErosion& erosion, int columns, const std::string& suffix) {
  std::string text;
  text += comment_lines("$", "elements go at a largest principal strain of " + in_all_measures(erosion));
  text += comment_lines("$", "strain measure of MXEPS: " + word(erosion.measure) +
                                 " (measure not documented: which one LS-DYNA compares in this material is not said in "
                                 "its manual, so the number is written as given)");
  text += "*MAT_ADD_EROSION" + suffix + "\n";
  text += lines({"MID", "EXCL", "MXPRES", "MNEPS", "EFFEPS", "VOLEPS", "NUMFIP", "NCS"},
                {"1", "0.", "0.", "0.", "0.", "0.", "1.", "1."}, columns);
  text += lines({"MNPRES", "SIGP1", "SIGVM", "MXEPS", "EPSSH", "SIGTH", "IMPULSE", "FAILTM"},
                {"0.", "0.", "0.", number_field(erosion.limit, columns)}, columns);
  return text;
}

}  // namespace

std::string lsdyna_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  const Numbers numbers = numbers_of(material, units);
  const double ratio = material.bulk_modulus / shear_modulus(material);
  const int columns = all_hold(numbers, ratio, lsdyna_short) ? lsdyna_short : lsdyna_long;
  if (!(bulk_error(numbers, ratio, columns) <= worst_bulk_modulus)) {
    throw BadInput(Place{.file = "", .line = 0, .key = "bulk_modulus_Pa"},
                   fmt::format("{:.6g} Pa, which is {:.3g} mu", material.bulk_modulus, ratio),
                   "for an LS-DYNA card at most some 1e13 mu: PR has twenty columns at most");
  }
  const std::string suffix = columns == lsdyna_long ? "+" : "";
  std::string text = card_comments(
      {"$", "MU", CardModulus::two_mu_over_alpha, "volumetric law: PR of K/mu; U = K (J - 1 - ln J)"}, material, units);
  if (columns == lsdyna_long)
    text += comment_lines("$", "long format, fields of 20 columns: ten do not hold every number, and K, to 1e-5");
  if (!material.erosion) text += comment_lines("$", no_erosion_comment(material));
  text += "*MAT_OGDEN_RUBBER_TITLE" + suffix + "\n" + ascii_name(material.name, "-_. ,()%", title_characters) + "\n";
  text += lines({"MID", "RO", "PR", "N", "NV", "G", "SIGF", "REF"},
                {"1", number_field(numbers.density, columns), number_field(numbers.nu, columns), "0", "0"}, columns);
  text += lines(numbered("MU"), written(numbers.mu, columns), columns);
  text += lines(numbered("ALPHA"), written(numbers.alpha, columns), columns);
  if (material.erosion) text += erosion_keyword(*material.erosion, columns, suffix);
  return text;
}

}  // namespace percal
