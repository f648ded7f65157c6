// Values of a Gaussian process, conditioned on noisy ones. What its covariance is, the caller knows. C. E. Rasmussen, C. K. I.
// Williams: Gaussian Processes for Machine Learning, MIT Press 2006, algorithm 2.1 and sections 5.4.1, 5.4.2.
//                                                                                              docs/theory/emulator.md
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>

namespace percal {

// Of each value from all the others: (prediction - value), and the standard deviation of that, noise included.
struct LeftOutValues {
  Eigen::VectorXd error, deviation;
};

class GaussianProcess {
 public:
  // `covariance` K (n x n, its lower triangle is read): of the values with their noise on the diagonal; `values` y (n), of mean
  // zero before they are known. Nothing where K is not positive definite.
  static std::optional<GaussianProcess> conditioned(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& values);

  // K^-1 y: the mean at a point is their product with its covariances with the values.
  const Eigen::VectorXd& weights() const { return weights_; }

  // L^-1 C with K = L L^T and C (n x m) the covariances of the values with m other points: V^T V is what their covariance
  // loses by what is known.
  Eigen::MatrixXd whitened(Eigen::MatrixXd cross) const;

  // ln p(y)
  double log_likelihood() const;
  // d ln p / d K, as a symmetric matrix G: for a K that depends on theta, d ln p / d theta = sum_ab G_ab dK_ab/dtheta.
  Eigen::MatrixXd likelihood_gradient() const;

  // By the closed formula, without fitting again.
  LeftOutValues leave_one_out() const;

 private:
  GaussianProcess(Eigen::LLT<Eigen::MatrixXd> factor, const Eigen::VectorXd& values);
  Eigen::MatrixXd inverse_factor() const;

  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::VectorXd values_, weights_;
};

}  // namespace percal
