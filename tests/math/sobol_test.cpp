#include <gtest/gtest.h>

#include <array>

#include "percal/math/draws.hpp"

namespace percal {
namespace {

TEST(Sobol, TheFirstPointsAreTheTextbooks) {
  const Eigen::MatrixXd points = sobol_points(3, 2, 0);
  const Eigen::MatrixXd expected = (Eigen::MatrixXd(3, 2) << 0.5, 0.5, 0.75, 0.25, 0.25, 0.75).finished();
  EXPECT_EQ(points, expected);
}

TEST(Sobol, AStretchAfterAnotherGoesOnWithTheSequence) {
  const Eigen::MatrixXd whole = sobol_points(40, 6, 0);
  EXPECT_EQ(sobol_points(17, 6, 0), whole.topRows(17));
  EXPECT_EQ(sobol_points(23, 6, 17), whole.bottomRows(23));
}

// The sequence's points 0 to 63 are one to a cell of 8 x 8; the origin, number 0, is not given out.
TEST(Sobol, PointsFillASquareEvenly) {
  const Eigen::MatrixXd points = sobol_points(63, 2, 0);
  std::array<int, 64> in_cell{};
  in_cell[0] = 1;
  for (int i = 0; i < 63; ++i) ++in_cell[static_cast<int>(8 * points(i, 0)) + 8 * static_cast<int>(8 * points(i, 1))];
  for (int count : in_cell) EXPECT_EQ(count, 1);
}

TEST(Sobol, NoPointLiesOnTheEdge) {
  const Eigen::MatrixXd points = sobol_points(1000, most_sobol_dimensions, 0);
  EXPECT_GT(points.minCoeff(), 0);
  EXPECT_LT(points.maxCoeff(), 1);
}

}  // namespace
}  // namespace percal
