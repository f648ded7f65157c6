// Quantiles and tails of the distributions that tests and intervals need.
#pragma once

namespace percal {

// The value below which the share p of the distribution lies, 0 < p < 1. Degrees of freedom are positive, not necessarily whole;
// those of Student's t and the second of F may be infinite. NaN for other arguments.
double normal_quantile(double p);
double student_quantile(double p, double degrees_of_freedom);
double chi_squared_quantile(double p, double degrees_of_freedom);
double f_quantile(double p, double numerator, double denominator);

// The share of the distribution below x; degrees of freedom as above.
double student_cdf(double x, double degrees_of_freedom);

// The share of the distribution above x.
double chi_squared_tail(double x, double degrees_of_freedom);
double f_tail(double x, double numerator, double denominator);

// ln Phi(z) of the standard normal distribution, and its derivative phi(z)/Phi(z): exact to rounding in both tails.
double log_normal_cdf(double z);
double log_normal_cdf_slope(double z);

}  // namespace percal
