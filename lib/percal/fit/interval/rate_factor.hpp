// One factor between the curves of a solid at two rates: stress at the high rate = factor * stress at the low rate, one Ogden shape for
// both. Guha 2009, section 3.3.1; docs/theory/curves.md
#pragma once
#include <string>
#include <vector>

#include "percal/fit/interval/uncertainty.hpp"

namespace percal {

// One curve of the pair. Its points weigh as their errors about a fit of its own say, estimated or known.
struct RateCurve {
  int points = 0;  // used
  ErrorSource errors = ErrorSource::residuals;
  double scatter = 0;  // of its residuals about a fit of its own: dimensionless or Pa; 1 is as known errors say
  Ogden alone;         // that fit
};

// Whether one alpha serves both curves: F = (weighted sum of squares with one alpha - with two)/(the latter/(n - 4)).
struct OneShape {
  double f = 0;
  int degrees_of_freedom = 0;  // n - 4
  double chance = 1;           // of an F so large where one shape holds
  bool serves = true;          // chance above `shape_refuted`
};
inline constexpr double shape_refuted = 0.05;

struct RateFactor {
  double level = 0.95;
  Residual residual = Residual::relative;
  ParameterUncertainty factor, mu_slow, mu_fast, alpha;
  RateCurve slow, fast;
  OneShape one_shape;
  int degrees_of_freedom = 0;  // n - 3
  bool converged = false;
  std::vector<std::string> findings;
};

// Throws BadInput where a curve cannot be fitted alone: fewer than three points, no positive modulus that fits, points
// that lie on the model exactly.
RateFactor fit_rate_factor(const CurveData& slow, const CurveData& fast, Residual residual, double level);

}  // namespace percal
