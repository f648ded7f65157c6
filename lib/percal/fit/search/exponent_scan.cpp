#include "percal/fit/search/exponent_scan.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "percal/fit/search/moduli.hpp"

namespace percal {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// A dip shallower than this share of the objective, or of this share squared of all weighted stress, is rounding.
constexpr double shallow = 1e-10;

// Stresses of all points for mu = 1 at alpha = 0, step, 2 step, .. and their negatives, by the addition theorems: no
// transcendental function after the first, and no digits lost, since everything that is added is positive.   (3)
//   stress(alpha) = 4 weight factor sinh(alpha half)/alpha exp(alpha mean)
class Responses {
 public:
  Responses(const std::vector<WeightedPoint>& points, double step) : step_(step) {
    const auto n = static_cast<Eigen::Index>(points.size());
    for (auto* array : {&factor_, &half_, &sinh_step_, &cosh_step_, &exp_step_}) array->resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& [pair, stress, weight, test] = points[i];
      factor_(i) = 4 * weight * pair.nominal_factor;
      half_(i) = (pair.log_i - pair.log_j) / 2;
      sinh_step_(i) = std::sinh(step * half_(i));
      cosh_step_(i) = std::cosh(step * half_(i));
      exp_step_(i) = std::exp(step * (pair.log_i + pair.log_j) / 2);
    }
    sinh_ = Eigen::ArrayXd::Zero(n);
    cosh_ = exp_ = Eigen::ArrayXd::Ones(n);
    inverse_step_ = exp_step_.inverse();
    inverse_ = exp_;
  }
  void advance() {
    ++steps_;
    const Eigen::ArrayXd sinh_before = sinh_;
    sinh_ = sinh_ * cosh_step_ + cosh_ * sinh_step_;
    cosh_ = cosh_ * cosh_step_ + sinh_before * sinh_step_;
    exp_ *= exp_step_;
    inverse_ *= inverse_step_;
  }
  double alpha() const { return steps_ * step_; }
  Eigen::VectorXd at_zero() const { return factor_ * half_; }
  Eigen::VectorXd at_alpha() const { return factor_ * sinh_ * exp_ / alpha(); }
  Eigen::VectorXd at_minus_alpha() const { return factor_ * sinh_ * inverse_ / alpha(); }

 private:
  double step_;
  int steps_ = 0;
  Eigen::ArrayXd factor_, half_, sinh_step_, cosh_step_, exp_step_, inverse_step_, sinh_, cosh_, exp_, inverse_;
};

ProfileValue least_squares(double alpha, const Eigen::VectorXd& response, const Eigen::VectorXd& data) {
  const double largest = response.lpNorm<Eigen::Infinity>();
  if (!(largest > 0) || !std::isfinite(largest)) return {alpha, 0, never};
  const double inverse = 1 / largest;
  const double scaled = (response * inverse).dot(data) / (response * inverse).squaredNorm();
  const double mu = scaled * inverse;
  if (!(mu > 0) || !std::isnormal(mu)) return {alpha, std::isnormal(mu) ? mu : 0, never};
  return {alpha, mu, (data - (scaled * inverse) * response).squaredNorm()};
}

ProfileValue at(double alpha, const Eigen::VectorXd& response, const Eigen::VectorXd& data, const ScaledLoss& loss) {
  if (loss.loss == Loss::squares) return least_squares(alpha, response, data);
  const Moduli best = best_moduli(response, data, Signs::positive, loss);
  if (!std::isfinite(best.objective) || !std::isnormal(best.mu(0))) return {alpha, 0, never};
  return {alpha, best.mu(0), best.objective};
}

constexpr double singular_correlation = 1e-12;  // determinant of the correlations below which terms are not told apart

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
  if (!(among.determinant() > singular_correlation)) return never;
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

std::vector<ProfileValue> profile(const std::vector<WeightedPoint>& points, const ScaledLoss& loss, double largest,
                                  int half) {
  const Eigen::VectorXd data = weighted_stress(points);
  std::vector<ProfileValue> scan(2 * half + 1);
  Responses responses(points, largest / half);
  scan[half] = at(0, responses.at_zero(), data, loss);
  for (int i = 1; i <= half; ++i) {
    responses.advance();
    scan[half + i] = at(responses.alpha(), responses.at_alpha(), data, loss);
    scan[half - i] = at(-responses.alpha(), responses.at_minus_alpha(), data, loss);
  }
  return scan;
}

std::vector<Bracket> minima_of(const std::vector<ProfileValue>& scan, double weighted_squares) {
  const double floor = shallow * shallow * weighted_squares;
  const int steps = static_cast<int>(scan.size()) - 1;
  const auto at = [&](int i) { return scan[std::clamp(i, 0, steps)]; };

  std::vector<int> lowest;  // of each basin
  for (int i = 0; i <= steps; ++i) {
    if (!std::isfinite(scan[i].objective)) continue;
    if ((i > 0 && scan[i - 1].objective <= scan[i].objective) ||
        (i < steps && scan[i + 1].objective < scan[i].objective))
      continue;
    if (!lowest.empty()) {
      double ridge = 0;
      for (int k = lowest.back(); k <= i; ++k) ridge = std::max(ridge, scan[k].objective);
      const double higher = std::max(scan[lowest.back()].objective, scan[i].objective);
      if (ridge - higher <= shallow * higher + floor) {
        if (scan[i].objective < scan[lowest.back()].objective) lowest.back() = i;
        continue;
      }
    }
    lowest.push_back(i);
  }
  std::vector<Bracket> brackets;
  for (int i : lowest) brackets.push_back({scan[i], at(i - 1).alpha, at(i + 1).alpha});
  return brackets;
}

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
