// Points that fill a box evenly, the same ones every time.
#pragma once
#include <Eigen/Core>

namespace percal {

inline constexpr int most_sobol_dimensions = 40;

// Sobol's sequence (GSL): points number skip, skip + 1, ... of it, each a row with numbers in (0, 1). A longer stretch begins with
// the shorter one, and what a later call skips has been given before. 1 to 40 dimensions; count and skip not negative.
Eigen::MatrixXd sobol_points(int count, int dimensions, int skip);

}  // namespace percal
