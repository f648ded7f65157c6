// The block of quads that a sphere is shot into: square near the axis, wider towards the wall. Lengths in particle radii.
#pragma once
#include <vector>

namespace percal {

// Node (i, j) stands at radius[i] and depth j row_height. Element (i, j) has it as its upper inner corner.
struct GradedMesh {
  std::vector<double> radius;  // columns + 1 of them, from 0 (the axis) to the wall; of a whole mesh from wall to wall
  int rows = 0;
  double row_height = 0;
  double growth = 1;  // of each graded column over the one before; 1: none is graded

  int columns() const { return static_cast<int>(radius.size()) - 1; }
  long elements() const { return static_cast<long>(columns()) * rows; }
};

struct GradedMeshOptions {
  double elements_per_radius = 10;
  double fine_width = 1;   // columns are square up to here, or to the first node beyond
  int graded_columns = 5;  // then this many, each wider than the last by one factor, reach the wall; 0: all are even
  double width = 5;
  double depth = 75;
};

// Of a right half, in double: no depth or width is too large to be counted.     docs/theory/impact.md (8a), (8b)
struct GradedCounts {
  double fine_columns = 0;  // all of them where none is graded
  double graded_columns = 0;
  double rows = 0;
  double fine_column_width = 0;
  double columns() const { return fine_columns + graded_columns; }
};
GradedCounts counts_of(const GradedMeshOptions& options);

// Needs depth > 0 and width > 0, and counts that an int holds. Where less than a column is left between the fine ones and the
// wall, all are even.
GradedMesh graded_mesh(const GradedMeshOptions& options);

// Where nobody says how many columns are graded, each is at most so much wider than the one before.
inline constexpr double usual_growth = 1.2;  // docs/decisions/0012-mesh-and-phase.md

// The fewest graded columns of which none grows by more than `growth` > 0; the options' own number does not matter. 0 where
// fewer than two even columns would do.     docs/theory/impact.md (8b)
int graded_columns_for(double growth, const GradedMeshOptions& options);

// The mesh and its mirror image about x = 0.
GradedMesh mirrored(const GradedMesh& right_half);

}  // namespace percal
