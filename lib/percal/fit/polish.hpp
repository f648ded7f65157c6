// Ceres from one start, within its basin.
#pragma once
#include "percal/fit/alpha_scan.hpp"

namespace percal {

struct Polished {
  Ogden solid;       // mu in the scale of the points' stress
  double objective;  // sum of squared weighted residuals
  bool converged;
  int iterations;
  // J^T J of the residuals with respect to (ln mu, alpha): [0] mu mu, [1] mu alpha, [2] alpha alpha.
  double normal_matrix[3];
};

// Levenberg-Marquardt with automatic derivatives over (ln mu, alpha), alpha between the bracket's ends.
Polished polish(const std::vector<WeightedPoint>& points, const Bracket& bracket);

}  // namespace percal
