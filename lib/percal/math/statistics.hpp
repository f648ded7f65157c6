// Means, straight lines and power laws with their standard errors.
#pragma once
#include <optional>
#include <span>

namespace percal {

double mean(std::span<const double> values);  // not empty

// sqrt(sum (x - mean)^2 / (n - 1)); two values or more.
double sample_deviation(std::span<const double> values);

// Mean of |computed/measured - 1|: the "mean error" of a table of predictions. Same length, measured not 0.
double mean_relative_error(std::span<const double> computed, std::span<const double> measured);

// y = slope x + intercept by least squares. Standard errors come from the scatter about the line, with n - 2 degrees of
// freedom; two points leave none, and the errors are not there.
struct Line {
  double slope = 0;
  double intercept = 0;
  std::optional<double> slope_error;
  std::optional<double> intercept_error;
  std::optional<double> correlation;  // of slope and intercept
  double r2 = 0;                      // 1 - SSE/SST; 1 where all y are the same
  int points = 0;

  double at(double x) const { return slope * x + intercept; }
  // Standard error of at(x), the line's own: the scatter of single points is not in it.
  std::optional<double> error_at(double x) const;
};

// Throws BadInput for fewer than two points and where all x are the same.
Line linear_trend(std::span<const double> x, std::span<const double> y);

// What a power law's least squares add up: (y - k x^n)^2, or (1 - k x^n/y)^2.
enum class Misfit { absolute, relative };

enum class FitOutcome { converged, no_progress, out_of_iterations };

// y = factor x^exponent.
struct PowerLaw {
  double factor = 0;
  double exponent = 0;
  std::optional<double> factor_error;    // standard errors; not there without degrees of freedom
  std::optional<double> exponent_error;  // not there where the exponent was given
  double objective = 0;                  // the sum that was made smallest
  int points = 0;
  FitOutcome outcome = FitOutcome::converged;

  double at(double x) const;
};

// Least squares for the factor alone (linear) and for both (Levenberg-Marquardt from the line through the logarithms).
// x and y positive. Throws BadInput for a value that is not, for no point, and for fewer than two different x where the
// exponent is free.
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y, double exponent, Misfit misfit);
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y, Misfit misfit);

}  // namespace percal
