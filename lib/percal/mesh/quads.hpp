// Unstructured meshes of 4-node quads in the half plane (r, z) or the plane (x, y), and makers of the simple ones.
#pragma once
#include <array>
#include <vector>

namespace percal {

using Point = std::array<double, 2>;  // r, z or x, y

// Corners of an element run counter-clockwise.
struct QuadMesh {
  std::vector<Point> nodes;
  std::vector<std::array<int, 4>> elements;
};

// A mesh with four sides, `across` elements from inner to outer by `along` elements from first to last. The nodes of
// each side stand in the order in which the boundary runs counter-clockwise, the body on its left.
struct QuadBlock {
  QuadMesh mesh;
  std::vector<int> inner, outer, first, last;
  int across = 0, along = 0;

  // Node i from the inner side, j from the first.
  int node(int i, int j) const { return j * (across + 1) + i; }
};

// From x = left (the inner side) to right, and from y = bottom (the first) to top. Neighbouring elements differ in width by
// a factor growth_x, in height by growth_y.
struct RectangleOptions {
  double left = 0, right = 1, bottom = 0, top = 1;
  int across = 10, along = 10;
  double growth_x = 1, growth_y = 1;
};
QuadBlock rectangle(const RectangleOptions& options);

// Part of a ring: radii inner to outer, angles first to last (radians from the first axis). From 0 to pi/2 it is half of a
// thick sphere in the (r, z) half plane above z = 0, or a quarter of a tube in the plane. `growth` is the factor between
// the radial sizes of neighbours.
struct SectorOptions {
  double inner = 1, outer = 2, first_angle = 0, last_angle = 1.57079632679489661923;
  int across = 10, along = 10;
  double growth = 1;
};
QuadBlock sector(const SectorOptions& options);

// A disc of radius 1 about the origin: a rounded square in the middle and rings around it, so that no quad degenerates.
struct Disc {
  QuadMesh mesh;
  std::vector<int>
      boundary;  // counter-clockwise; half_disc: from (0, -1) to (0, 1); disc: closed, the first not repeated
};

// The half x >= 0, and all of it. elements_per_radius >= 2 of them lie between centre and boundary.
Disc half_disc(int elements_per_radius);
Disc disc(int elements_per_radius);

// The sine of the sharpest or bluntest corner of any element, 1 for rectangles; not positive where one is not convex.
double worst_corner(const QuadMesh& mesh);

}  // namespace percal
