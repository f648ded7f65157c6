// The block of quads that a sphere is shot into: square near the axis, wider towards the wall. Lengths in particle radii.
#pragma once
#include <vector>

namespace percal {

// Node (i, j) stands at radius[i] and depth j row_height. Element (i, j) has it as its upper inner corner.
struct GradedMesh {
  std::vector<double> radius;  // columns + 1 of them, from 0 (the axis) to the wall; of a whole mesh from wall to wall
  int rows = 0;
  double row_height = 0;

  int columns() const { return static_cast<int>(radius.size()) - 1; }
  long elements() const { return static_cast<long>(columns()) * rows; }
};

struct GradedMeshOptions {
  int elements_per_radius = 10;
  double fine_width = 1;   // columns are square up to here
  int graded_columns = 5;  // then this many, each wider than the last by one factor, reach the wall
  double width = 5;
  double depth = 75;
};

// Needs depth > 0 and width > 0. Where the fine columns reach the wall there are no graded ones.
GradedMesh graded_mesh(const GradedMeshOptions& options);

// The mesh and its mirror image about x = 0.
GradedMesh mirrored(const GradedMesh& right_half);

}  // namespace percal
