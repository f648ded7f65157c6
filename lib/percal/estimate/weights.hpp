// Residuals made equal: divided by their errors, and turned so that the model's correlated errors no longer correlate.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "percal/estimate/least_squares.hpp"

namespace percal {

// V = diag(error^2 + scatter^2) + model covariance of all data, as its Cholesky factor V = L L^T. Only the data whose model
// errors correlate need a matrix. A datum that is no number is independent of all others.            docs/theory/calibration.md (2)
struct Weights {
  Eigen::VectorXd deviation;    // sqrt V_ii of each datum
  std::vector<int> correlated;  // data whose row of V has more than its diagonal
  Eigen::MatrixXd factor;       // lower triangle, of the correlated data

  double log_determinant(const std::vector<Datum>& data) const;  // ln det V of the numbers
};

// `scatter` has one standard deviation for each group; `covariance` may be empty.
Weights make_weights(const std::vector<Datum>& data, const std::vector<double>& scatter,
                     const Eigen::MatrixXd& covariance);

// The largest relative change of an entry of V.
double change(const Weights& before, const Weights& after);

// The sum of squares is the objective; first the data, then the priors.
struct Whitened {
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;  // with respect to all searched parameters

  double objective() const { return residual.squaredNorm(); }
  Eigen::VectorXd gradient() const { return jacobian.transpose() * residual; }  // of half the objective
  Eigen::MatrixXd information() const { return jacobian.transpose() * jacobian; }
};
Whitened whiten(const CalibrationProblem& problem, const Weights& weights, const ModelAnswer& answer,
                const Eigen::VectorXd& searched);

// The residual of a datum that only tells a side, when the model lies z deviations on that side of its value: sqrt(-2 ln Phi(z)).  (3)
struct SideResidual {
  double residual = 0, slope = 0;  // slope: d residual / dz
};
SideResidual side_residual(double z);

// model - value of each datum.
Eigen::VectorXd residuals(const CalibrationProblem& problem, const ModelAnswer& answer);

}  // namespace percal
