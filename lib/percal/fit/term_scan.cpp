#include "percal/fit/term_scan.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace percal {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double dependent = 1e-12;  // determinant of the correlations below which terms are not told apart

// The responses of all exponents of the grid, each of unit length, as products with each other and with the data (unit
// length too): all that a least-squares problem of a few of them needs.
struct Grid {
  std::vector<double> alphas;
  Eigen::MatrixXd among;  // 0 for an exponent whose response is not finite
  Eigen::VectorXd with_data;
};

Grid grid_of(const std::vector<WeightedPoint>& points, const Eigen::VectorXd& rows, double largest, double step) {
  Grid grid;
  const int half = static_cast<int>(std::lround(largest / step));
  for (int i = -half; i <= half; ++i) grid.alphas.push_back(i * step);
  Eigen::MatrixXd columns = rows.asDiagonal() * term_columns(points, grid.alphas).stress;
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    const double size = columns.col(k).stableNorm();
    if (size > 0 && std::isfinite(size))
      columns.col(k) /= size;
    else
      columns.col(k).setZero();
  }
  grid.among = columns.transpose() * columns;
  grid.with_data = columns.transpose() * (rows.asDiagonal() * weighted_stress(points)).normalized();
  return grid;
}

// 1 - (share of the data that the responses of `set` explain).
template <int terms>
double objective(const Grid& grid, const std::array<int, terms>& set, Signs signs) {
  Eigen::Matrix<double, terms, terms> among;
  Eigen::Matrix<double, terms, 1> with_data;
  for (int i = 0; i < terms; ++i) {
    with_data(i) = grid.with_data(set[i]);
    for (int j = 0; j < terms; ++j) among(i, j) = grid.among(set[i], set[j]);
  }
  if (!(among.determinant() > dependent)) return never;
  const Eigen::Matrix<double, terms, 1> moduli = among.inverse() * with_data;
  if (signs == Signs::positive && !(moduli.minCoeff() > 0)) return never;
  return 1 - moduli.dot(with_data);
}

struct Found {
  double objective;
  std::vector<double> alphas;
};

TermScan best_of(std::vector<Found>& found, int scanned) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.objective < b.objective; });
  TermScan scan;
  scan.scanned = scanned;
  for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), most_minima); ++i)
    scan.minima.push_back(found[i].alphas);
  return scan;
}

}  // namespace

TermScan scan_pairs(const std::vector<WeightedPoint>& points, const Eigen::VectorXd& rows, Signs signs,
                    double largest) {
  const Grid grid = grid_of(points, rows, largest, 0.25);
  const int n = static_cast<int>(grid.alphas.size());
  Eigen::MatrixXd values = Eigen::MatrixXd::Constant(n + 2, n + 2, never);  // a rim of never around it
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) values(i + 1, j + 1) = objective<2>(grid, {i, j}, signs);
  std::vector<Found> found;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      const double value = values(i + 1, j + 1);
      if (value < never && values.block<3, 3>(i, j).minCoeff() >= value)
        found.push_back({value, {grid.alphas[i], grid.alphas[j]}});
    }
  return best_of(found, n * (n - 1) / 2);
}

TermScan scan_triples(const std::vector<WeightedPoint>& points, const Eigen::VectorXd& rows, Signs signs,
                      double largest) {
  const Grid grid = grid_of(points, rows, largest, 1);
  const int n = static_cast<int>(grid.alphas.size()), m = n + 2;
  std::vector<double> values(static_cast<std::size_t>(m) * m * m, never);
  const auto at = [&](int i, int j, int k) -> double& { return values[((i + 1) * m + j + 1) * m + k + 1]; };
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) at(i, j, k) = objective<3>(grid, {i, j, k}, signs);
  const auto lowest_around = [&](int i, int j, int k) {
    double lowest = never;
    for (int di = -1; di <= 1; ++di)
      for (int dj = -1; dj <= 1; ++dj)
        for (int dk = -1; dk <= 1; ++dk) lowest = std::min(lowest, at(i + di, j + dj, k + dk));
    return lowest;
  };
  std::vector<Found> found;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        const double value = at(i, j, k);
        if (value < never && lowest_around(i, j, k) >= value)
          found.push_back({value, {grid.alphas[i], grid.alphas[j], grid.alphas[k]}});
      }
  return best_of(found, n * (n - 1) * (n - 2) / 6);
}

}  // namespace percal
