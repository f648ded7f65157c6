#include "percal/estimate/weights.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "percal/math/distributions.hpp"

namespace percal {
namespace {

bool correlates(const std::vector<Datum>& data, const Eigen::MatrixXd& covariance, int i) {
  if (!data[i].is_number()) return false;
  for (int j = 0; j < covariance.cols(); ++j)
    if (j != i && data[j].is_number() && covariance(i, j) != 0) return true;
  return false;
}

// A covariance that rounding made slightly indefinite gets as much on its diagonal as makes it definite.
Eigen::MatrixXd cholesky_factor(Eigen::MatrixXd matrix) {
  const double largest = matrix.diagonal().maxCoeff();
  for (double jitter = 1e-14; jitter < 1; jitter *= 10) {
    const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
    if (factor.info() == Eigen::Success) return factor.matrixL();
    matrix.diagonal().array() += jitter * largest;
  }
  return matrix.diagonal().cwiseAbs().cwiseSqrt().asDiagonal();
}

}  // namespace

Eigen::VectorXd residuals(const CalibrationProblem& problem, const ModelAnswer& answer) {
  Eigen::VectorXd difference = answer.value;
  for (std::size_t i = 0; i < problem.data.size(); ++i) difference[i] -= problem.data[i].value;
  return difference;
}

Weights make_weights(const std::vector<Datum>& data, const std::vector<double>& scatter,
                     const Eigen::MatrixXd& covariance) {
  const int n = static_cast<int>(data.size());
  Weights weights;
  weights.deviation.resize(n);
  for (int i = 0; i < n; ++i) {
    const double own = data[i].error, group = scatter[data[i].group];
    const double model = covariance.size() > 0 ? std::max(covariance(i, i), 0.0) : 0;
    weights.deviation[i] = std::sqrt(own * own + group * group + model);
  }
  if (covariance.size() == 0) return weights;

  for (int i = 0; i < n; ++i)
    if (correlates(data, covariance, i)) weights.correlated.push_back(i);
  if (weights.correlated.empty()) return weights;
  Eigen::MatrixXd variance = covariance(weights.correlated, weights.correlated);
  variance.diagonal() = weights.deviation(weights.correlated).cwiseAbs2();
  weights.factor = cholesky_factor(variance);
  return weights;
}

double Weights::log_determinant(const std::vector<Datum>& data) const {
  double sum = 0;
  for (std::size_t i = 0; i < data.size(); ++i)
    if (data[i].is_number()) sum += 2 * std::log(deviation[i]);
  for (std::size_t k = 0; k < correlated.size(); ++k)
    sum += 2 * std::log(factor(k, k)) - 2 * std::log(deviation[correlated[k]]);
  return sum;
}

double change(const Weights& before, const Weights& after) {
  double largest = (after.deviation.cwiseQuotient(before.deviation).cwiseAbs2().array() - 1).abs().maxCoeff();
  if (before.correlated != after.correlated) return 1;
  if (before.correlated.empty()) return largest;
  const Eigen::MatrixXd first = before.factor * before.factor.transpose();
  const Eigen::MatrixXd second = after.factor * after.factor.transpose();
  return std::max(largest, (second - first).cwiseAbs().maxCoeff() / first.diagonal().maxCoeff());
}

SideResidual side_residual(double z) {
  const double residual = std::sqrt(-2 * log_normal_cdf(z));
  if (residual == 0) return {};
  return {residual, -log_normal_cdf_slope(z) / residual};
}

Whitened whiten(const CalibrationProblem& problem, const Weights& weights, const ModelAnswer& answer,
                const Eigen::VectorXd& searched) {
  const auto& data = problem.data;
  const int n = static_cast<int>(data.size()), p = static_cast<int>(problem.parameters.size());
  const auto priors =
      std::ranges::count_if(problem.parameters, [](const FreeParameter& free) { return free.prior.has_value(); });
  Whitened white{Eigen::VectorXd::Zero(n + priors), Eigen::MatrixXd::Zero(n + priors, p)};

  const Eigen::VectorXd difference = residuals(problem, answer);
  white.residual.head(n) = difference.cwiseQuotient(weights.deviation);
  white.jacobian.topRows(n) = weights.deviation.cwiseInverse().asDiagonal() * answer.jacobian;
  if (!weights.correlated.empty()) {
    const auto lower = weights.factor.triangularView<Eigen::Lower>();
    const Eigen::VectorXd some = difference(weights.correlated);
    const Eigen::MatrixXd rows = answer.jacobian(weights.correlated, Eigen::all);
    white.residual(weights.correlated) = lower.solve(some).eval();
    white.jacobian(weights.correlated, Eigen::all) = lower.solve(rows).eval();
  }
  for (int i = 0; i < n; ++i)
    if (const int of = side(data[i].seen); of != 0) {
      const auto [residual, slope] = side_residual(of * white.residual[i]);
      white.residual[i] = residual;
      white.jacobian.row(i) *= of * slope;
    }

  int row = n;
  for (int k = 0; k < p; ++k) {
    const FreeParameter& free = problem.parameters[k];
    if (!free.prior) continue;
    white.residual[row] = (searched[k] - free.searched(*free.prior)) / free.prior_error;
    white.jacobian(row++, k) = 1 / free.prior_error;
  }
  return white;
}

}  // namespace percal
