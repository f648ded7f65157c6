#include "percal/mesh/graded.hpp"

#include <algorithm>
#include <cmath>

namespace percal {
namespace {

constexpr double rounding = 1e-9;  // of a count of columns: below it, a number is whole

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

// Square columns to the first node at or beyond the fine width.
double square_columns(const GradedMeshOptions& options) {
  return std::max(1.0, std::ceil(options.fine_width * options.elements_per_radius * (1 - rounding)));
}

// What is left to the wall beyond the square columns, in their widths.
double gap_in_columns(const GradedMeshOptions& options) {
  return options.width * options.elements_per_radius - square_columns(options);
}

}  // namespace

GradedCounts counts_of(const GradedMeshOptions& options) {
  const double n = options.elements_per_radius;
  GradedCounts counts{.rows = std::max(1.0, std::round(options.depth * n))};
  if (options.graded_columns > 0 && gap_in_columns(options) >= 1 - rounding) {
    counts.fine_columns = square_columns(options);
    counts.graded_columns = options.graded_columns;
    counts.fine_column_width = 1 / n;
  } else {
    counts.fine_columns = std::max(1.0, std::round(options.width * n));
    counts.fine_column_width = options.width / counts.fine_columns;
  }
  return counts;
}

GradedMesh graded_mesh(const GradedMeshOptions& options) {
  const GradedCounts counts = counts_of(options);
  const auto fine = static_cast<int>(counts.fine_columns), graded = static_cast<int>(counts.graded_columns);
  const double edge = graded > 0 ? fine / options.elements_per_radius : options.width;
  GradedMesh mesh;
  for (int i = 0; i <= fine; ++i) mesh.radius.push_back(edge * i / fine);
  if (graded > 0) {
    double width = edge / fine, at = edge;
    mesh.growth = growth_factor(width, options.width - edge, graded);
    for (int k = 0; k < graded; ++k) mesh.radius.push_back(at += width *= mesh.growth);
    mesh.radius.back() = options.width;
  }
  mesh.rows = static_cast<int>(counts.rows);
  mesh.row_height = options.depth / mesh.rows;
  return mesh;
}

int graded_columns_for(double growth, const GradedMeshOptions& options) {
  const double gap = gap_in_columns(options);
  if (gap < 2) return 0;
  const double columns =
      growth > 1 + rounding ? std::log1p(gap * (growth - 1) / growth) / std::log(growth) : gap;  // (8b)
  return std::max(1, static_cast<int>(std::ceil(columns * (1 - rounding))));
}

GradedMesh mirrored(const GradedMesh& right_half) {
  GradedMesh whole = right_half;
  whole.radius.clear();
  for (auto x = right_half.radius.rbegin(); *x > 0; ++x) whole.radius.push_back(-*x);
  whole.radius.insert(whole.radius.end(), right_half.radius.begin(), right_half.radius.end());
  return whole;
}

}  // namespace percal
