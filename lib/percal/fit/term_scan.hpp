// Where Ceres starts from with two and three terms: the objective on a grid of exponents, the moduli solved for.
#pragma once
#include <vector>

#include "percal/fit/moduli.hpp"

namespace percal {

struct TermScan {
  std::vector<std::vector<double>>
      minima;  // exponents of every local minimum of the grid, best first, at most `most_minima`
  int scanned = 0;
};
inline constexpr int most_minima = 24;

// All pairs of exponents between -largest and largest in steps of 0.25, and all triples in steps of 1. The points' rows
// may carry weights (a robust loss): `rows` multiplies them. With positive signs only sets all of whose moduli are
// positive count: the others are solids of fewer terms.
TermScan scan_pairs(const std::vector<WeightedPoint>& points, const Eigen::VectorXd& rows, Signs signs, double largest);
TermScan scan_triples(const std::vector<WeightedPoint>& points, const Eigen::VectorXd& rows, Signs signs,
                      double largest);

}  // namespace percal
