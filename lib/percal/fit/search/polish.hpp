// Ceres from one start over the exponents, the moduli solved for at every step (variable projection).
#pragma once
#include <vector>

#include "percal/fit/search/moduli.hpp"

namespace percal {

// Where an exponent starts and between which values it stays.
struct SearchedAlpha {
  double start;
  double low, high;
};

struct Polished {
  std::vector<Ogden> terms;  // mu in the scale of the points' stress; 0 for a term that is better left out
  double objective;          // sum of the loss of the weighted residuals
  bool converged;
  int iterations;
};

// Levenberg-Marquardt with Kaufman's derivative of the projected residuals.           docs/theory/curves.md (22)
Polished polish(const std::vector<WeightedPoint>& points, const std::vector<SearchedAlpha>& alphas, Signs signs,
                const ScaledLoss& loss);

}  // namespace percal
