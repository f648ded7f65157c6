// The block of bricks that a body is shot into in three dimensions: cubes near its path, longer towards the walls. Lengths in particle
// radii; x to the right, y along the body's thickness, z downwards from the surface.
#pragma once
#include <vector>

namespace percal {

// Node (i, j, k) stands at (x[i], y[j], z[k]). Element (i, j, k) has it as its corner of least x, y and z.
struct BoxGrid {
  std::vector<double> x, y, z;

  int columns_x() const { return static_cast<int>(x.size()) - 1; }
  int columns_y() const { return static_cast<int>(y.size()) - 1; }
  int rows() const { return static_cast<int>(z.size()) - 1; }
  long elements() const { return static_cast<long>(columns_x()) * columns_y() * rows(); }
};

// Along one half axis: cells of one size to the first node at or beyond `fine`, then cells that grow to the wall at `end`.
struct BoxAxis {
  double fine, end;
};

struct BoxGridOptions {
  double elements_per_radius = 6;
  double growth = 1.25;  // of each cell over the one before, at most, where they grow
  BoxAxis left{0, 0};    // of x, counted to the left; none where x = 0 is a plane of symmetry
  BoxAxis right{1, 5};
  BoxAxis along{1, 5};    // of y
  BoxAxis against{0, 0};  // of y, counted the other way; none where y = 0 is a plane of symmetry
  BoxAxis down{75, 75};   // of z
};

// Needs positive lengths, but for `left` and `against`. Nodes stand on x = 0, y = 0 and z = 0.     docs/theory/solid.md (1)
BoxGrid box_grid(const BoxGridOptions& options);

}  // namespace percal
