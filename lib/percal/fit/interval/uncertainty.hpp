// How well curves determine the parameters of a solid: profile likelihood, bootstrap, correlation, and what they cannot tell.
// docs/theory/curves.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/estimate/intervals.hpp"
#include "percal/fit/interval/curve_calibration.hpp"
#include "percal/fit/search/fit_curves.hpp"

namespace percal {

struct UncertaintyOptions {
  double level = 0.95;
  int bootstrap = 0;  // replicates of each kind of bootstrap; 0: none
  unsigned seed = 20090401;
};

// Percentile intervals, one for each way to draw the replicates: points with return, residuals with return, or
// points drawn from the fitted model with normal errors.
struct BootstrapIntervals {
  Interval points, residuals, parametric;
};

// An exponent whose interval is wider than this is as good as unknown.
inline constexpr double hopeless_width = 10;

struct ParameterUncertainty {
  std::string name;  // "mu", "alpha"; "mu_1", .. where there are several terms
  std::string unit;  // "Pa" or empty
  double value = 0;
  // Profile likelihood, the piece of the region about this minimum; an open end is where the search ended, of this or of another
  // parameter.
  Interval interval;
  double searched_low = 0, searched_high = 0;
  bool identifiable = true;
  std::optional<BootstrapIntervals> bootstrap;
};

// About one minimum of the fit.
struct MinimumUncertainty {
  int minimum = 0;  // index in CurveFit::minima
  std::vector<ParameterUncertainty> parameters;
  Eigen::MatrixXd correlation;
  // Of the sum of all moduli, linearised; where there is more than one term.
  std::optional<Interval> small_strain_modulus;
  int bootstrap_failed = 0;  // replicates that did not converge, all kinds together
};

// All that the points allow of a parameter, over every minimum that they cannot rule out.
struct ParameterRegion {
  std::string name, unit;  // those of the parameters, and "small_strain_mu" in "Pa" where there are several terms
  Region pieces;
};

struct Uncertainty {
  UncertaintyOptions options;
  ErrorSource errors = ErrorSource::residuals;
  double scatter = 0;  // standard deviation of the residuals: dimensionless or Pa; with known errors 1 is as they say
  int degrees_of_freedom = 0;
  std::optional<double> neighbour_correlation;  // of residuals next to each other in the file
  std::vector<MinimumUncertainty> minima;       // the best, and those that the points cannot rule out
  std::vector<ParameterRegion> region;
  std::vector<std::string> findings;
};

// Empty `minima` where nothing was fitted, where the points leave no degree of freedom, and where they lie on the model
// exactly; `findings` says so. `data` and `fit` belong together.
Uncertainty uncertainty_of(const CurveData& data, const CurveFit& fit, const UncertaintyOptions& options);

std::string word(ErrorSource errors);  // "residuals", "standard errors"

}  // namespace percal
