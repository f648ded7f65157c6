#include "percal/mesh/box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace percal {
namespace {

TEST(BoxGrid, CubesInTheMiddleAndCellsThatGrowToTheWalls) {
  const BoxGrid grid = box_grid({.elements_per_radius = 4,
                                 .growth = 1.25,
                                 .left = {0.6, 4},
                                 .right = {1.1, 6},
                                 .along = {0.3, 5},
                                 .down = {2, 10}});
  const auto near = [](const std::vector<double>& planes, double x) {
    return *std::min_element(planes.begin(), planes.end(),
                             [&](double a, double b) { return std::abs(a - x) < std::abs(b - x); });
  };
  for (const double x : {-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0, 1.25}) EXPECT_DOUBLE_EQ(near(grid.x, x), x);
  EXPECT_DOUBLE_EQ(grid.x.front(), -4);
  EXPECT_DOUBLE_EQ(grid.x.back(), 6);
  EXPECT_DOUBLE_EQ(grid.y[2], 0.5);
  EXPECT_DOUBLE_EQ(grid.y.back(), 5);
  EXPECT_DOUBLE_EQ(grid.z[8], 2);
  EXPECT_DOUBLE_EQ(grid.z.back(), 10);
  for (const auto* planes : {&grid.x, &grid.y, &grid.z})
    for (std::size_t i = 2; i < planes->size(); ++i) {
      const double before = (*planes)[i - 1] - (*planes)[i - 2], width = (*planes)[i] - (*planes)[i - 1];
      ASSERT_GT(width, 0);
      EXPECT_LT(std::max(width / before, before / width), 1.26);
    }
}

TEST(BoxGrid, BothSidesOfAPlaneAreMirrorImages) {
  const BoxGrid grid = box_grid({.left = {1, 5}, .against = {1, 5}});
  for (const auto* planes : {&grid.x, &grid.y})
    for (std::size_t i = 0; i < planes->size(); ++i) EXPECT_EQ((*planes)[i], -(*planes)[planes->size() - 1 - i]);
  EXPECT_EQ(grid.x, grid.y);
}

TEST(BoxGrid, AQuarterBeginsAtTheMiddle) {
  const BoxGrid grid = box_grid({});
  EXPECT_EQ(grid.x.front(), 0);
  EXPECT_EQ(grid.y.front(), 0);
}

}  // namespace
}  // namespace percal
