// The objective over alpha alone, mu solved for: where Ceres starts from.
#pragma once
#include <vector>

#include "percal/material/homogeneous.hpp"

namespace percal {

// A residual is weight * (stress - mu f(alpha)): weight 1/stress makes it relative.
struct WeightedPoint {
  PrincipalPair pair;
  double stress;  // in a scale that makes it about 1
  double weight;
};

struct ProfileValue {
  double alpha;
  double mu;         // the best modulus at this alpha; may be negative, or 0 where no modulus is finite
  double objective;  // infinite where mu is not positive
};

// mu by linear least squares: docs/theory/curves.md (13)
ProfileValue profile(const std::vector<WeightedPoint>& points, double alpha);

// A local minimum of the scan lies between low and high.
struct Bracket {
  ProfileValue start;
  double low, high;
};

// Every local minimum on [-largest, largest], the ends included. Two neighbours that no ridge higher than the rounding
// error parts count as one.
std::vector<Bracket> scan_alpha(const std::vector<WeightedPoint>& points, double largest, int steps);

}  // namespace percal
