// Rectangles and sectors of quads, for the closed forms that tests hold a body against.
#pragma once
#include <cassert>
#include <cmath>
#include <vector>

#include "percal/mesh/quads.hpp"

namespace percal {

// A mesh with four sides, `across` elements from inner to outer by `along` elements from first to last. The nodes of
// each side stand in the order in which the boundary runs counter-clockwise, the body on its left.
struct QuadBlock {
  QuadMesh mesh;
  std::vector<int> inner, outer, first, last;
  int across = 0, along = 0;

  // Node i from the inner side, j from the first.
  int node(int i, int j) const { return j * (across + 1) + i; }
};

// count + 1 numbers from 0 to 1 whose gaps grow by one factor.
inline std::vector<double> graded_shares(int count, double growth) {
  std::vector<double> at{0};
  double gap = 1;
  for (int i = 0; i < count; ++i, gap *= growth) at.push_back(at.back() + gap);
  for (double& x : at) x /= at.back();
  at.back() = 1;
  return at;
}

// Element corners and sides of a block whose nodes are still at the origin.
inline QuadBlock empty_block(int across, int along) {
  assert(across >= 1 && along >= 1);
  QuadBlock block;
  block.across = across;
  block.along = along;
  block.mesh.nodes.resize(static_cast<std::size_t>(across + 1) * (along + 1));
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < across; ++i)
      block.mesh.elements.push_back(
          {block.node(i, j), block.node(i + 1, j), block.node(i + 1, j + 1), block.node(i, j + 1)});
  for (int i = 0; i <= across; ++i) block.first.push_back(block.node(i, 0));
  for (int j = 0; j <= along; ++j) block.outer.push_back(block.node(across, j));
  for (int i = across; i >= 0; --i) block.last.push_back(block.node(i, along));
  for (int j = along; j >= 0; --j) block.inner.push_back(block.node(0, j));
  return block;
}

// From x = left (the inner side) to right, and from y = bottom (the first) to top. Neighbouring elements differ in
// width by a factor growth_x, in height by growth_y.
struct RectangleOptions {
  double left = 0, right = 1, bottom = 0, top = 1;
  int across = 10, along = 10;
  double growth_x = 1, growth_y = 1;
};

inline QuadBlock rectangle(const RectangleOptions& o) {
  QuadBlock block = empty_block(o.across, o.along);
  const auto x = graded_shares(o.across, o.growth_x), y = graded_shares(o.along, o.growth_y);
  for (int j = 0; j <= o.along; ++j)
    for (int i = 0; i <= o.across; ++i)
      block.mesh.nodes[block.node(i, j)] = {o.left + (o.right - o.left) * x[i], o.bottom + (o.top - o.bottom) * y[j]};
  return block;
}

// Part of a ring: radii inner to outer, angles first to last (radians from the first axis). From 0 to pi/2 it is half
// of a thick sphere in the (r, z) half plane above z = 0, or a quarter of a tube in the plane. `growth` is the factor
// between the radial sizes of neighbours.
struct SectorOptions {
  double inner = 1, outer = 2, first_angle = 0, last_angle = 1.57079632679489661923;
  int across = 10, along = 10;
  double growth = 1;
};

inline QuadBlock sector(const SectorOptions& o) {
  QuadBlock block = empty_block(o.across, o.along);
  const auto share = graded_shares(o.across, o.growth);
  for (int j = 0; j <= o.along; ++j)
    for (int i = 0; i <= o.across; ++i) {
      const double radius = o.inner + (o.outer - o.inner) * share[i];
      const double angle = o.first_angle + (o.last_angle - o.first_angle) * j / o.along;
      Point at{radius * std::cos(angle), radius * std::sin(angle)};
      for (double& x : at)
        if (std::abs(x) < 1e-12 * o.outer) x = 0;  // on an axis, not beside it
      block.mesh.nodes[block.node(i, j)] = at;
    }
  return block;
}

}  // namespace percal
