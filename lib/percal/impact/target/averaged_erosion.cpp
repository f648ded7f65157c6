#include "percal/impact/target/averaged_erosion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "percal/impact/settings.hpp"

namespace percal {
namespace {

double bell(double squared_distance, double length) {
  const double inside = std::max(0.0, 1 - squared_distance / (length * length));
  return inside * inside;
}

// The weights of one column's elements in averages around another's. In plane strain there is no ring; half a model stands for
// the whole, and its columns left of the middle are images of those to the right.
class Weights {
 public:
  Weights(const Problem& problem, const std::vector<ColumnShape>& shapes, const GradedMesh& mesh, double length)
      : mesh_(mesh),
        length_(length),
        is_plane_(problem.geometry == Geometry::plane_strain),
        has_images_(is_plane_ && !problem.whole) {
    for (const ColumnShape& shape : shapes) volumes_.push_back(shape.thickness * shape.width);
  }

  // The column that stands at this place, which may lie beyond the first or the last; -1: none.
  int column_at(int place) const {
    if (place >= mesh_.columns()) return -1;
    return place >= 0 ? place : has_images_ && -place <= mesh_.columns() ? -place - 1 : -1;
  }

  // By the rows between; none where even the same row is too far.
  std::vector<double> of(int place, int around) const {
    std::vector<double> weights;
    if (column_at(place) < 0) return weights;
    for (int rows = 0; rows * mesh_.row_height < length_; ++rows) {
      const double weight = volumes_[column_at(place)] * at(place, around, rows * mesh_.row_height);
      if (!(weight > 0)) break;
      weights.push_back(weight);
    }
    return weights;
  }

 private:
  double middle(int place) const {
    const int column = column_at(place);
    const double x = (mesh_.radius[column] + mesh_.radius[column + 1]) / 2;
    return place < 0 ? -x : x;
  }
  double at(int place, int around, double apart) const {
    if (!is_plane_) return bell_of_ring(middle(around), middle(place), apart, length_);
    const double along = middle(place) - middle(around);
    return bell(along * along + apart * apart, length_);
  }

  const GradedMesh& mesh_;
  const double length_;
  const bool is_plane_, has_images_;
  std::vector<double> volumes_;  // per height of a row
};

}  // namespace

// The squared bell is (p + q cos t)^2 up to the angle where it ends.
double bell_of_ring(double radius, double ring, double apart, double length) {
  const double square = length * length;
  const double p = 1 - (radius * radius + ring * ring + apart * apart) / square, q = 2 * radius * ring / square;
  if (!(q > 0)) return p > 0 ? p * p : 0;
  const double end = std::acos(std::clamp(-p / q, -1.0, 1.0));
  const double integral = p * p * end + 2 * p * q * std::sin(end) + q * q * (end / 2 + std::sin(2 * end) / 4);
  return std::max(0.0, integral / std::numbers::pi);
}

template <class Real>
std::vector<Real> AveragedErosion<Real>::padded(const std::vector<double>& by_rows_between) const {
  std::vector<Real> weights(by_rows_between.rbegin(), by_rows_between.rend());
  if (weights.empty()) return weights;
  weights.insert(weights.end(), by_rows_between.begin() + 1, by_rows_between.end());
  weights.resize(weights.size() + kernel_.lanes);
  return weights;
}

template <class Real>
AveragedErosion<Real>::AveragedErosion(const Problem& problem, const Block<Real>& block, const TargetSolid& solid) {
  if (solid.erosion_kind != ErosionKind::averaged_energy) return;
  const GradedMesh& mesh = block.mesh();
  largest_average_ += averaging_allowance * mesh.row_height / std::get<AverageWithin>(problem.erosion_average).length;
  const Weights weights(problem, block.shapes(), mesh, std::get<AverageWithin>(problem.erosion_average).length);
  for (int i = 0; i < mesh.columns(); ++i) {
    pairs_.emplace_back();
    for (int places = 0;; ++places) {
      Pair pair{{weights.column_at(i - places), padded(weights.of(i - places, i))}, {}};
      if (places > 0) pair.right = {weights.column_at(i + places), padded(weights.of(i + places, i))};
      if (!pair.left.is_there() && !pair.right.is_there()) break;
      pairs_.back().push_back(std::move(pair));
    }
  }
  for (int j = 0; j < mesh.rows; ++j)
    per_limit_.push_back(solid.erodes(j) ? Real(1 / solid.of_row(j).erosion_limit) : Real(0));
  per_limit_.resize(mesh.rows + kernel_.lanes);
}

template <class Real>
WeightedSum AveragedErosion<Real>::sum_over(const Block<Real>& block, const Neighbour& neighbour, int row) const {
  if (!neighbour.is_there()) return {};
  const int reach = (static_cast<int>(neighbour.weights.size()) - kernel_.lanes) / 2;
  const int begin = std::max(0, row - reach), end = std::min(row + reach + 1, block.mesh().rows);
  const long first = block.at(neighbour.column, begin);
  const auto& view = block.view();
  return kernel_.weighted_sum(view.alive + first, view.foreseen_measure + first, per_limit_.data() + begin,
                              neighbour.weights.data() + (begin - row + reach), end - begin);
}

template <class Real>
double AveragedErosion<Real>::average_around(const Block<Real>& block, int column, int row) const {
  WeightedSum sum;
  for (const Pair& pair : pairs_[column]) {
    const WeightedSum left = sum_over(block, pair.left, row), right = sum_over(block, pair.right, row);
    sum.share += left.share + right.share;
    sum.weight += left.weight + right.weight;
  }
  return sum.share / sum.weight;
}

template <class Real>
void AveragedErosion<Real>::judge(Block<Real>& block, int column, Rows rows) const {
  const auto& view = block.view();
  const int end = std::min(rows.end, block.mesh().rows);
  for (int j = rows.begin; j < end; ++j) {
    Real& alive = view.alive[block.at(column, j)];
    if (alive == Real(candidate)) alive = Real(average_around(block, column, j) > largest_average_ ? condemned : 1);
  }
}

template class AveragedErosion<float>;
template class AveragedErosion<double>;

}  // namespace percal
