#include "percal/math/statistics.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "percal/base/error.hpp"

namespace percal {

double mean(std::span<const double> values) { return gsl_stats_mean(values.data(), 1, values.size()); }

double sample_deviation(std::span<const double> values) { return gsl_stats_sd(values.data(), 1, values.size()); }

double mean_relative_error(std::span<const double> computed, std::span<const double> measured) {
  double sum = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) sum += std::abs(computed[i] / measured[i] - 1);
  return sum / static_cast<double>(measured.size());
}

std::optional<double> Line::error_at(double x) const {
  if (!slope_error) return std::nullopt;
  double variance = *slope_error * *slope_error * x * x + *intercept_error * *intercept_error +
                    2 * x * *correlation * *slope_error * *intercept_error;
  return std::sqrt(std::max(variance, 0.0));
}

Line linear_trend(std::span<const double> x, std::span<const double> y) {
  auto n = x.size();
  if (n != y.size())
    throw BadInput("linear trend: found " + std::to_string(n) + " x and " + std::to_string(y.size()) + " y");
  if (n < 2 || std::ranges::all_of(x, [&](double value) { return value == x[0]; }))
    throw BadInput("linear trend: found " + std::to_string(n) +
                   " point(s) at one x; accepted: two different x or more");

  double intercept, slope, variance_intercept, covariance, variance_slope, squares;
  gsl_set_error_handler_off();
  int status = gsl_fit_linear(x.data(), 1, y.data(), 1, n, &intercept, &slope, &variance_intercept, &covariance,
                              &variance_slope, &squares);
  if (status != GSL_SUCCESS || !std::isfinite(slope) || !std::isfinite(intercept))
    throw BadInput(std::string("linear trend: no line through these points (") + gsl_strerror(status) + ")");

  Line line;
  line.slope = slope;
  line.intercept = intercept;
  line.points = static_cast<int>(n);
  double total = gsl_stats_tss(y.data(), 1, n);
  line.r2 = total > 0 ? 1 - squares / total : 1;
  if (n > 2) {
    line.slope_error = std::sqrt(variance_slope);
    line.intercept_error = std::sqrt(variance_intercept);
    double product = *line.slope_error * *line.intercept_error;
    line.correlation = product > 0 ? covariance / product : 0;
  }
  return line;
}

}  // namespace percal
