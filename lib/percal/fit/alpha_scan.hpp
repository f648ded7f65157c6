// The objective over alpha alone, mu solved for: where Ceres starts from with one term.
#pragma once
#include <vector>

#include "percal/fit/curve_problem.hpp"
#include "percal/fit/loss.hpp"

namespace percal {

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

}  // namespace percal
