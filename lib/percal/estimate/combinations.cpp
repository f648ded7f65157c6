#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "percal/estimate/intervals.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double largest_deviation = 1e6;

// The component that says most is positive.
VectorXd with_sign(const VectorXd& weight) {
  int largest = 0;
  weight.cwiseAbs().maxCoeff(&largest);
  return weight[largest] < 0 ? VectorXd(-weight) : weight;
}

}  // namespace

std::vector<Combination> combinations(const CalibrationProblem& problem, const Minimum& minimum) {
  MatrixXd information = minimum.information;
  for (int k = 0; k < information.rows(); ++k)
    if (problem.parameters[k].prior) information(k, k) -= std::pow(problem.parameters[k].prior_error, -2);

  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(information);  // eigenvalues ascend
  std::vector<Combination> found;
  for (int k = static_cast<int>(information.rows()) - 1; k >= 0; --k) {
    const double eigenvalue = std::max(solver.eigenvalues()[k], std::pow(largest_deviation, -2));
    const double deviation = 1 / std::sqrt(eigenvalue);
    found.push_back({with_sign(solver.eigenvectors().col(k)), deviation, deviation <= std::log(hopeless_factor) / 4});
  }
  return found;
}

MatrixXd correlation(const Minimum& minimum) {
  const VectorXd deviation = minimum.covariance.diagonal().cwiseSqrt();
  const VectorXd inverse = (deviation.array() > 0).select(deviation.cwiseInverse(), 0);
  MatrixXd matrix = inverse.asDiagonal() * minimum.covariance * inverse.asDiagonal();
  matrix.diagonal().setOnes();
  return matrix;
}

}  // namespace percal
