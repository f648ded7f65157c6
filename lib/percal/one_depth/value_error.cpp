#include "percal/one_depth/value_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/math/distributions.hpp"

namespace percal {

ValueErrorPart solver_share(const Inversion& found) {
  return {"solver's scatter", found.log_modulus_error * std::abs(found.slope), found.log_modulus_error,
          fmt::format("{} runs over the mesh phase scatter by {:.2g} % about their line", found.points_in_line,
                      100 * found.scatter)};
}

ValueErrorPart depth_share(const std::string& source, double of_depth, const std::string& how, const Inversion& found) {
  return {source, of_depth, of_depth / std::abs(found.slope), how};
}

ValueErrorPart value_share(const std::string& source, double of_value, const std::string& how, const Inversion& found) {
  return {source, of_value * std::abs(found.slope), of_value, how};
}

std::vector<ValueErrorPart> rule_shares(const DepthError& error, double depth, const Inversion& found) {
  const double half_widths = normal_quantile(0.5 + depth_error_level / 2);  // in standard deviations
  std::vector<ValueErrorPart> shares;
  for (const auto source : {DepthErrorSource::wall, DepthErrorSource::time_step, DepthErrorSource::bulk}) {
    const ErrorPart& part = error.of(source);
    if (part.half_width)
      shares.push_back(depth_share(word(source), *part.half_width / half_widths / depth, part.how, found));
    else
      shares.push_back({word(source), {}, {}, part.how});
  }
  return shares;
}

double half_width(const Inversion& found, const std::vector<ValueErrorPart>& others, double level) {
  double squares = 0;
  for (const ValueErrorPart& share : others) squares += share.of_value.value_or(0) * share.of_value.value_or(0);
  const double upper = 0.5 + level / 2;
  return std::hypot(student_quantile(upper, std::max(1, found.points_in_line - 2)) * found.log_modulus_error,
                    normal_quantile(upper) * std::sqrt(squares));
}

double of_depth(const std::vector<ValueErrorPart>& shares) {
  double squares = 0;
  for (const ValueErrorPart& share : shares) squares += share.of_depth.value_or(0) * share.of_depth.value_or(0);
  return std::sqrt(squares);
}

}  // namespace percal
