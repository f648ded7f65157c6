// Unstructured meshes of 4-node quads in the half plane (r, z) or the plane (x, y), and discs of them.
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

// A disc of radius 1 about the origin: a rounded square in the middle and rings around it, so that no quad degenerates.
struct Disc {
  QuadMesh mesh;
  // Counter-clockwise; half_disc: from (0, -1) to (0, 1); disc: closed, the first not repeated.
  std::vector<int> boundary;
};

// The half x >= 0, and all of it. elements_per_radius >= 2 of them lie between centre and boundary.
Disc half_disc(int elements_per_radius);
Disc disc(int elements_per_radius);

// The sine of the sharpest or bluntest corner of any element, 1 for rectangles; not positive where one is not convex.
double worst_corner(const QuadMesh& mesh);

}  // namespace percal
