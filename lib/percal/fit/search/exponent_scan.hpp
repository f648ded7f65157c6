// Where Ceres starts from: the objective over one, two or three exponents, the moduli solved for.
#pragma once
#include <vector>

#include "percal/fit/search/curve_problem.hpp"
#include "percal/fit/search/moduli.hpp"

namespace percal {

// One exponent.
struct ProfileValue {
  double alpha;
  double mu;         // the best modulus at this alpha; may be negative, or 0 where no modulus is finite
  double objective;  // infinite where mu is not positive
};

// mu by linear least squares at 2 half + 1 values of alpha from -largest to largest: docs/theory/curves.md (13)
std::vector<ProfileValue> profile(const std::vector<WeightedPoint>& points, const ScaledLoss& loss, double largest,
                                  int half);

// A local minimum of the scan lies between low and high.
struct Bracket {
  ProfileValue start;
  double low, high;
};

// Every local minimum of a scan, its ends included. Two neighbours that no ridge higher than the rounding error parts
// count as one; `weighted_squares` is the sum of the squared weighted stresses, which the rounding error goes with.
std::vector<Bracket> minima_of(const std::vector<ProfileValue>& scan, double weighted_squares);

// Two and three exponents, on a grid.
struct TermScan {
  // Exponents of every local minimum of the grid, best first, at most `most_minima`.
  std::vector<std::vector<double>> minima;
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
