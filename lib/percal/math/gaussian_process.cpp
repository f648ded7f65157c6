#include "percal/math/gaussian_process.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace percal {

std::optional<GaussianProcess> GaussianProcess::conditioned(const Eigen::MatrixXd& covariance,
                                                            const Eigen::VectorXd& values) {
  Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  if (factor.info() != Eigen::Success) return std::nullopt;
  return GaussianProcess(std::move(factor), values);
}

GaussianProcess::GaussianProcess(Eigen::LLT<Eigen::MatrixXd> factor, const Eigen::VectorXd& values)
    : factor_(std::move(factor)), values_(values), weights_(factor_.solve(values)) {}

Eigen::MatrixXd GaussianProcess::whitened(Eigen::MatrixXd cross) const {
  if (cross.cols() > 0) factor_.matrixL().solveInPlace(cross);  // Eigen takes the address of the first number
  return cross;
}

double GaussianProcess::log_likelihood() const {
  const double half_log_determinant = factor_.matrixLLT().diagonal().array().log().sum();
  const double n = static_cast<double>(values_.size());
  return -0.5 * values_.dot(weights_) - half_log_determinant - 0.5 * n * std::log(2 * std::numbers::pi);
}

Eigen::MatrixXd GaussianProcess::inverse_factor() const {
  return whitened(Eigen::MatrixXd::Identity(values_.size(), values_.size()));
}

// (K^-1 y y^T K^-1 - K^-1)/2
Eigen::MatrixXd GaussianProcess::likelihood_gradient() const {
  const Eigen::MatrixXd inverse_lower = inverse_factor();
  Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(values_.size(), values_.size());
  gradient.selfadjointView<Eigen::Lower>().rankUpdate(inverse_lower.transpose(), -0.5);
  gradient.selfadjointView<Eigen::Lower>().rankUpdate(weights_, 0.5);
  gradient.triangularView<Eigen::StrictlyUpper>() = gradient.transpose();
  return gradient;
}

LeftOutValues GaussianProcess::leave_one_out() const {
  const Eigen::VectorXd inverse_diagonal = inverse_factor().colwise().squaredNorm();
  return {-weights_.cwiseQuotient(inverse_diagonal), inverse_diagonal.cwiseSqrt().cwiseInverse()};
}

}  // namespace percal
