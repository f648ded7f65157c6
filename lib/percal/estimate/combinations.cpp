// What follows from a minimum's information and covariance alone.
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

std::vector<Advice> next_experiments(const Minimum& minimum, const Eigen::VectorXd& target_weight,
                                     const std::vector<Candidate>& candidates) {
  const Eigen::VectorXd target = minimum.covariance * target_weight;
  const double now = target_weight.dot(target);
  std::vector<Advice> advice;
  for (const Candidate& candidate : candidates) {
    const double predicted = candidate.gradient.dot(minimum.covariance * candidate.gradient);
    const double shared = candidate.gradient.dot(target), whole = candidate.error * candidate.error + predicted;
    const double gained = whole > 0 && now > 0 ? shared * shared / (whole * now) : 0;
    advice.push_back({candidate.label, std::sqrt(std::max(0.0, 1 - gained))});
  }
  std::ranges::stable_sort(advice, {}, &Advice::width_ratio);
  return advice;
}

}  // namespace percal
