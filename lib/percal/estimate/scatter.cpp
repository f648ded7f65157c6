#include "percal/estimate/scatter.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "percal/estimate/frozen_fit.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

bool tells_a_side(const Datum& datum) { return datum.seen == Seen::above || datum.seen == Seen::below; }

// Whether a group has such data and no number.
bool has_sides_alone(const std::vector<Datum>& data, int group) {
  bool sides = false;
  for (const Datum& datum : data) {
    if (datum.group != group) continue;
    if (datum.is_number()) return false;
    sides |= tells_a_side(datum);
  }
  return sides;
}

// What the first guess and the last word need to know of a group.
struct GroupData {
  std::vector<double> squared_error, squared_residual;  // of its numbers
  double least = 0, largest = 0;                        // values
  bool has_exact = false;                               // a number without an error of its own

  double range() const {
    const double spread = largest - least, size = std::max(std::abs(least), std::abs(largest));
    return spread > 0 ? spread : size > 0 ? size : 1;
  }
};

GroupData gather(const CalibrationProblem& problem, const VectorXd& residuals, int group) {
  GroupData found;
  for (std::size_t i = 0; i < problem.data.size(); ++i) {
    const Datum& datum = problem.data[i];
    if (datum.group != group || !datum.is_number()) continue;
    const bool first = found.squared_error.empty();
    found.squared_error.push_back(datum.error * datum.error);
    found.squared_residual.push_back(residuals[i] * residuals[i]);
    found.least = first ? datum.value : std::min(found.least, datum.value);
    found.largest = first ? datum.value : std::max(found.largest, datum.value);
    found.has_exact |= datum.error == 0;
  }
  return found;
}

// sum r^2/(e^2 + s^2) = number of data, by Newton's method from below: the left side falls and is convex.
double moment_scatter_squared(const GroupData& group) {
  const auto n = static_cast<double>(group.squared_error.size());
  if (n == 0) return 0;
  double mean = 0;
  for (const double squared : group.squared_residual) mean += squared / n;
  double s2 = std::max(0.0, mean - *std::ranges::max_element(group.squared_error));
  for (int step = 0; step < 100; ++step) {
    double excess = -n, slope = 0;
    for (std::size_t i = 0; i < group.squared_error.size(); ++i) {
      const double variance = group.squared_error[i] + s2;
      if (variance == 0) continue;
      excess += group.squared_residual[i] / variance;
      slope -= group.squared_residual[i] / (variance * variance);
    }
    if (slope == 0 || excess <= 1e-12 * n) break;
    s2 -= excess / slope;
  }
  return s2;
}

// Where no datum has an error of its own, a perfect fit would leave a scatter of 0 and weights without limit.
constexpr double least_scatter = 1e-9;  // of the range of the group's values

double least_scatter_squared(const CalibrationProblem& problem, int group) {
  if (has_sides_alone(problem.data, group)) return least_scatter_of_sides * least_scatter_of_sides;
  const GroupData found = gather(problem, VectorXd::Zero(static_cast<int>(problem.data.size())), group);
  return found.has_exact ? std::pow(least_scatter * found.range(), 2) : 0;
}

// K = V^-1 over the numbers: a diagonal, and a block for the correlated ones.
struct Precision {
  VectorXd diagonal;
  std::vector<int> correlated;
  MatrixXd block;

  template <class Matrix>
  Matrix times(const Matrix& rows) const {
    Matrix product = diagonal.asDiagonal() * rows;
    if (!correlated.empty()) product(correlated, Eigen::all) = block * rows(correlated, Eigen::all);
    return product;
  }
};

Precision precision_of(const std::vector<Datum>& data, const Weights& weights) {
  Precision precision{weights.deviation.cwiseAbs2().cwiseInverse(), weights.correlated, {}};
  for (std::size_t i = 0; i < data.size(); ++i)
    if (!data[i].is_number()) precision.diagonal[i] = 0;
  if (precision.correlated.empty()) return precision;
  const auto m = static_cast<int>(precision.correlated.size());
  const MatrixXd inverse = weights.factor.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(m, m));
  precision.block = inverse.transpose() * inverse;
  precision.diagonal(precision.correlated) = precision.block.diagonal();
  return precision;
}

// Of a datum that tells a side, z deviations of size 1/sqrt(K) from its value: d(-ln Phi(z))/d scatter^2 and the information of scatter^2
// that such a datum has before its side is known, K^2/2 times this.                                                  (7a)
double side_score(double z, double K) { return -0.5 * z * K * log_normal_cdf_slope(z); }
double side_information(double z) { return 0.5 * z * z * log_normal_cdf_slope(z) * log_normal_cdf_slope(-z); }

double quadratic(const MatrixXd& B, const MatrixXd& A, int i, int j) { return B.row(i) * A * B.row(j).transpose(); }

}  // namespace

std::vector<double> first_scatter(const CalibrationProblem& problem, const VectorXd& residuals) {
  std::vector<double> scatter;
  for (int g = 0; g < static_cast<int>(problem.groups.size()); ++g) {
    const GroupData group = gather(problem, residuals, g);
    if (!problem.groups[g].estimated)
      scatter.push_back(problem.groups[g].fixed);
    else if (has_sides_alone(problem.data, g))
      scatter.push_back(first_scatter_of_sides);
    else
      scatter.push_back(std::max(std::sqrt(moment_scatter_squared(group)), coarse_scatter * group.range()));
  }
  return scatter;
}

MatrixXd bounded_inverse(const CalibrationProblem& problem, const MatrixXd& information, const std::vector<int>& free) {
  MatrixXd inverse = MatrixXd::Zero(information.rows(), information.cols());
  if (free.empty()) return inverse;
  const VectorXd width = (upper_bounds(problem) - lower_bounds(problem))(free);
  const MatrixXd scaled = width.asDiagonal() * information(free, free) * width.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled);
  const VectorXd variance = solver.eigenvalues().cwiseMax(1).cwiseInverse();
  const MatrixXd vectors = width.asDiagonal() * solver.eigenvectors();
  inverse(free, free) = vectors * variance.asDiagonal() * vectors.transpose();
  return inverse;
}

// With K = V^-1, B = K J, A = (J^T K J + priors)^-1 and P = K - B A B^T:
//   score_g = (sum_g u_i^2 - sum_g P_ii)/2, u = K r;   fisher_gh = sum over i in g, j in h of P_ij^2/2
// where P is never formed: the sums need K where it is not 0, and p x p matrices.                     (6), (7)
RestrictedLikelihood restricted_likelihood(const CalibrationProblem& problem, const ModelAnswer& answer,
                                           const VectorXd& searched, const std::vector<double>& scatter,
                                           const std::vector<int>& free) {
  const auto& data = problem.data;
  const int n = static_cast<int>(data.size()), groups = static_cast<int>(problem.groups.size());
  const int p = static_cast<int>(problem.parameters.size());
  const Weights weights = make_weights(data, scatter, answer.covariance);
  const Whitened white = whiten(problem, weights, answer, searched);
  const Precision K = precision_of(data, weights);
  const VectorXd r = residuals(problem, answer), u = K.times(r);
  MatrixXd B = K.times(answer.jacobian);
  for (int i = 0; i < n; ++i)  // the whitened row is J_i d rho/dz over the deviation
    if (tells_a_side(data[i])) B.row(i) = white.jacobian.row(i) / weights.deviation[i];

  RestrictedLikelihood found;
  found.score = VectorXd::Zero(groups);
  found.fisher = MatrixXd::Zero(groups, groups);
  found.covariance = bounded_inverse(problem, white.information(), free);
  const MatrixXd& A = found.covariance;
  VectorXd with_no_fit = VectorXd::Zero(groups);
  std::vector<MatrixXd> G(groups, MatrixXd::Zero(p, p));  // sum over the group of B_i^T B_i
  for (int i = 0; i < n; ++i) {
    if (!data[i].is_number() && !tells_a_side(data[i])) continue;
    const int g = data[i].group;
    const double removed = quadratic(B, A, i, i);  // K_ii - P_ii
    G[g] += B.row(i).transpose() * B.row(i);
    double precision = K.diagonal[i], information = 1;
    if (tells_a_side(data[i])) {
      const double z = side(data[i].seen) * r[i] / weights.deviation[i];
      precision = std::pow(weights.deviation[i], -2);
      information = side_information(z);
      found.score[g] += side_score(z, precision) + 0.5 * removed;
    } else {
      found.score[g] += 0.5 * (u[i] * u[i] - precision + removed);
    }
    with_no_fit[g] += 0.5 * information * precision * precision;
    found.fisher(g, g) += 0.5 * information * (precision * precision - 2 * precision * removed);
  }
  for (std::size_t a = 0; a < K.correlated.size(); ++a)
    for (std::size_t b = 0; b < K.correlated.size(); ++b) {
      if (a == b) continue;
      const int i = K.correlated[a], j = K.correlated[b];
      found.fisher(data[i].group, data[j].group) +=
          0.5 * (K.block(a, b) * K.block(a, b) - 2 * K.block(a, b) * quadratic(B, A, i, j));
    }
  for (int g = 0; g < groups; ++g) {
    // What sides alone tell of a parameter does not grow and shrink with their scatter as a sum of squares does: no Student's t.
    found.covariance_slope.push_back(has_sides_alone(data, g) ? MatrixXd::Zero(p, p) : MatrixXd(A * G[g] * A));
    for (int h = 0; h < groups; ++h) found.fisher(g, h) += 0.5 * (A * G[g] * A * G[h]).trace();
  }
  for (int g = 0; g < groups; ++g)
    if (!problem.groups[g].estimated || found.fisher(g, g) <= 1e-6 * with_no_fit[g]) {
      found.score[g] = 0;
      found.fisher.row(g).setZero();
      found.fisher.col(g).setZero();
      found.covariance_slope[g].setZero();
    }
  return found;
}

// Fisher's scoring, kept at or above 0. Late steps are halved, so that a scatter which jumps to and fro settles.
std::vector<double> restricted_scatter(const CalibrationProblem& problem, const ModelAnswer& answer,
                                       const VectorXd& searched, std::vector<double> scatter,
                                       const std::vector<int>& free) {
  const int groups = static_cast<int>(scatter.size());
  constexpr double most_growth = 4;  // in a step, of a scatter that sides alone tell: its likelihood is no parabola
  VectorXd least(groups), squared(groups);
  std::vector<bool> sides_alone(groups);
  for (int g = 0; g < groups; ++g) {
    sides_alone[g] = problem.groups[g].estimated && has_sides_alone(problem.data, g);
    least[g] = problem.groups[g].estimated ? least_scatter_squared(problem, g) : scatter[g] * scatter[g];
    squared[g] = std::max(least[g], scatter[g] * scatter[g]);
  }
  for (int step = 0; step < 100; ++step) {
    const auto likelihood = restricted_likelihood(problem, answer, searched, scatter, free);
    const double damping = step < 20 ? 1 : 0.5;
    const VectorXd before = squared;
    squared += damping * (scatter_covariance(likelihood) * likelihood.score);
    for (int g = 0; g < groups; ++g) {
      if (sides_alone[g]) squared[g] = std::clamp(squared[g], before[g] / most_growth, before[g] * most_growth);
      const bool says_nothing = likelihood.fisher(g, g) == 0;
      squared[g] = says_nothing ? least[g] : std::max(least[g], squared[g]);
      scatter[g] = std::sqrt(squared[g]);
    }
    if ((squared - before).cwiseAbs().maxCoeff() <= 1e-13 * squared.maxCoeff()) break;
  }
  return scatter;
}

MatrixXd scatter_covariance(const RestrictedLikelihood& likelihood) {
  const VectorXd size = likelihood.fisher.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd unit = (size.array() > 0).select(size.cwiseInverse(), 0);
  const MatrixXd scaled = unit.asDiagonal() * likelihood.fisher * unit.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled);
  const VectorXd value = solver.eigenvalues();
  const VectorXd inverse = (value.array() > 1e-8).select(value.cwiseInverse(), 0);
  return unit.asDiagonal() * solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose() *
         unit.asDiagonal();
}

}  // namespace percal
