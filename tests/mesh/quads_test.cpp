#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "mesh/quad_blocks.hpp"

namespace percal {
namespace {

double area(const QuadMesh& mesh) {
  double sum = 0;
  for (const auto& e : mesh.elements) {
    const auto &a = mesh.nodes[e[0]], &b = mesh.nodes[e[1]], &c = mesh.nodes[e[2]], &d = mesh.nodes[e[3]];
    sum += ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])) / 2;
  }
  return sum;
}

// Edges that one element alone has, in its direction.
std::set<std::array<int, 2>> open_edges(const QuadMesh& mesh) {
  std::set<std::array<int, 2>> edges;
  for (const auto& e : mesh.elements)
    for (int a = 0; a < 4; ++a)
      if (edges.erase({e[(a + 1) % 4], e[a]}) == 0) edges.insert({e[a], e[(a + 1) % 4]});
  return edges;
}

TEST(Quads, TheSidesOfABlockAreItsBoundaryCounterClockwise) {
  const QuadBlock block = sector({.across = 3, .along = 5});
  auto open = open_edges(block.mesh);
  EXPECT_EQ(open.size(), 16u);
  for (const auto* side : {&block.inner, &block.outer, &block.first, &block.last})
    for (std::size_t k = 0; k + 1 < side->size(); ++k) EXPECT_EQ(open.erase({(*side)[k], (*side)[k + 1]}), 1u);
  EXPECT_TRUE(open.empty());
}

TEST(Quads, ARectangleGrowsByItsFactors) {
  const QuadBlock block =
      rectangle({.left = 1, .right = 8, .bottom = -1, .top = 1, .across = 3, .along = 2, .growth_x = 2, .growth_y = 1});
  EXPECT_DOUBLE_EQ(block.mesh.nodes[block.node(1, 0)][0], 2);
  EXPECT_DOUBLE_EQ(block.mesh.nodes[block.node(2, 0)][0], 4);
  EXPECT_DOUBLE_EQ(block.mesh.nodes[block.node(3, 1)][1], 0);
  EXPECT_DOUBLE_EQ(area(block.mesh), 14);
  EXPECT_DOUBLE_EQ(worst_corner(block.mesh), 1);
}

TEST(Quads, ASectorStandsOnBothAxesExactly) {
  const QuadBlock block = sector({.inner = 1, .outer = 2, .across = 4, .along = 7});
  for (const int n : block.first) EXPECT_EQ(block.mesh.nodes[n][1], 0);
  for (const int n : block.last) EXPECT_EQ(block.mesh.nodes[n][0], 0);
  for (const int n : block.inner) EXPECT_NEAR(std::hypot(block.mesh.nodes[n][0], block.mesh.nodes[n][1]), 1, 1e-15);
}

TEST(Quads, AHalfDiscIsRoundWellShapedAndClosedByTheAxis) {
  for (const int n : {2, 3, 5, 10, 31}) {
    const Disc made = half_disc(n);
    EXPECT_GT(worst_corner(made.mesh), 0.7) << n;
    auto open = open_edges(made.mesh);
    for (std::size_t k = 0; k + 1 < made.boundary.size(); ++k)
      EXPECT_EQ(open.erase({made.boundary[k], made.boundary[k + 1]}), 1u) << n;
    EXPECT_EQ(open.size(), 2u * n) << "n elements on each half of the axis";
    for (const auto& edge : open)
      for (const int node : edge) EXPECT_EQ(made.mesh.nodes[node][0], 0);
    for (const int node : made.boundary)
      EXPECT_NEAR(std::hypot(made.mesh.nodes[node][0], made.mesh.nodes[node][1]), 1, 1e-15);
    EXPECT_EQ(made.mesh.nodes[made.boundary.front()], (Point{0, -1}));
    EXPECT_EQ(made.mesh.nodes[made.boundary.back()], (Point{0, 1}));
    EXPECT_NEAR(area(made.mesh), std::numbers::pi / 2, 2.0 / (n * n));
  }
}

TEST(Quads, ADiscIsClosedAndItsQuadsAreOfOneSize) {
  const Disc made = disc(10);
  EXPECT_EQ(open_edges(made.mesh).size(), made.boundary.size());
  EXPECT_GT(worst_corner(made.mesh), 0.7);
  double shortest = 1, longest = 0;
  for (const auto& e : made.mesh.elements)
    for (int a = 0; a < 4; ++a) {
      const Point &p = made.mesh.nodes[e[a]], &q = made.mesh.nodes[e[(a + 1) % 4]];
      const double length = std::hypot(p[0] - q[0], p[1] - q[1]);
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
  EXPECT_GT(shortest, 0.5 / 10);
  EXPECT_LT(longest, 1.6 / 10);
}

}  // namespace
}  // namespace percal
