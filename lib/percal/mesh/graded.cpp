#include "percal/mesh/graded.hpp"

#include <algorithm>
#include <cmath>

namespace percal {
namespace {

// first (q + q^2 + ... + q^n), the width of n columns of which each is q times the one before.
double graded_width(double first, double q, int n) {
  double sum = 0, width = first;
  for (int k = 0; k < n; ++k) sum += width *= q;
  return sum;
}

// The growth factor with which n columns fill `gap`; bisection, since the width grows with q.
double growth_factor(double first, double gap, int n) {
  double low = 0.01, high = 2;
  while (graded_width(first, high, n) < gap) high *= 2;
  for (int k = 0; k < 200; ++k) {
    const double middle = (low + high) / 2;
    (graded_width(first, middle, n) < gap ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

GradedMesh graded_mesh(const GradedMeshOptions& options) {
  GradedMesh mesh;
  const int n = options.elements_per_radius;
  const double fine = std::min(options.fine_width, options.width);
  const int fine_columns = std::max(1, static_cast<int>(std::lround(fine * n)));
  for (int i = 0; i <= fine_columns; ++i) mesh.radius.push_back(fine * i / fine_columns);
  const double gap = options.width - fine;
  if (gap > 1e-9 * options.width) {
    const int graded = std::max(1, options.graded_columns);
    double width = fine / fine_columns, at = fine;
    const double q = growth_factor(width, gap, graded);
    for (int k = 0; k < graded; ++k) mesh.radius.push_back(at += width *= q);
    mesh.radius.back() = options.width;
  }
  mesh.rows = std::max(1, static_cast<int>(std::lround(options.depth * n)));
  mesh.row_height = options.depth / mesh.rows;
  return mesh;
}

GradedMesh mirrored(const GradedMesh& right_half) {
  GradedMesh whole = right_half;
  whole.radius.clear();
  for (auto x = right_half.radius.rbegin(); *x > 0; ++x) whole.radius.push_back(-*x);
  whole.radius.insert(whole.radius.end(), right_half.radius.begin(), right_half.radius.end());
  return whole;
}

}  // namespace percal
