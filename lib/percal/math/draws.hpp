// Random numbers, and points that fill a box evenly: the same ones every time. The random numbers' bits depend on the seed alone: the
// engine is the standard's, the distributions are written out here because the standard leaves theirs to each library.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace percal {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}

  double uniform();      // in (0, 1), ends excluded
  double normal();       // standard normal
  int index(int count);  // 0 .. count - 1, each as likely

 private:
  std::mt19937_64 engine_;
};

inline constexpr int most_sobol_dimensions = 40;

// Sobol's sequence (GSL): points number skip, skip + 1, ... of it, each a row with numbers in (0, 1). A longer stretch begins with
// the shorter one, and what a later call skips has been given before. 1 to 40 dimensions; count and skip not negative.
Eigen::MatrixXd sobol_points(int count, int dimensions, int skip);

}  // namespace percal
