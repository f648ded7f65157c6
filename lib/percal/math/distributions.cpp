#include "percal/math/distributions.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_erf.h>

#include <cmath>
#include <numbers>

namespace percal {
namespace {

// GSL ends the program where a result underflows or an argument is out of range; here that is a 0 or NaN.
[[maybe_unused]] const bool errors_are_values = (gsl_set_error_handler_off(), true);

constexpr double practically_infinite = 1e8;  // degrees of freedom: t and normal agree to 8 digits

}  // namespace

double normal_quantile(double p) { return gsl_cdf_ugaussian_Pinv(p); }

double student_quantile(double p, double degrees_of_freedom) {
  if (degrees_of_freedom > practically_infinite) return normal_quantile(p);
  return gsl_cdf_tdist_Pinv(p, degrees_of_freedom);
}

double student_cdf(double x, double degrees_of_freedom) {
  if (degrees_of_freedom > practically_infinite) return gsl_cdf_ugaussian_P(x);
  return gsl_cdf_tdist_P(x, degrees_of_freedom);
}

double chi_squared_quantile(double p, double degrees_of_freedom) { return gsl_cdf_chisq_Pinv(p, degrees_of_freedom); }

double f_quantile(double p, double numerator, double denominator) {
  if (denominator > practically_infinite) return chi_squared_quantile(p, numerator) / numerator;
  return gsl_cdf_fdist_Pinv(p, numerator, denominator);
}

double chi_squared_tail(double x, double degrees_of_freedom) { return gsl_cdf_chisq_Q(x, degrees_of_freedom); }

double f_tail(double x, double numerator, double denominator) {
  if (denominator > practically_infinite) return chi_squared_tail(x * numerator, numerator);
  return gsl_cdf_fdist_Q(x, numerator, denominator);
}

double log_normal_cdf(double z) {
  if (z > 0) return std::log1p(-gsl_cdf_ugaussian_Q(z));
  return gsl_sf_log_erfc(-z / std::numbers::sqrt2) - std::numbers::ln2;
}

double log_normal_cdf_slope(double z) { return gsl_sf_hazard(-z); }

}  // namespace percal
