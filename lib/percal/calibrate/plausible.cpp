#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "percal/calibrate/job_fit.hpp"
#include "percal/math/distributions.hpp"
#include "percal/math/draws.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int steps_between = 25;      // walk steps from one kept point to the next
constexpr double longest_step = 0.15;  // of the box, where the data hardly hold a direction

// Weights of the data, held at the minimum: errors, scatter and the model's own variance, each datum for itself.
VectorXd weights_at_minimum(const JobFit& fit) {
  const ModelAnswer answer = fit.problem.model(fit.best().searched, Want::values_and_covariance);
  VectorXd weights(answer.value.size());
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const Datum& datum = fit.problem.data[static_cast<std::size_t>(i)];
    const double scatter = fit.best().scatter[datum.group];
    const double own = answer.covariance.size() > 0 ? answer.covariance(i, i) : 0;
    weights[i] = 1 / std::max(1e-12, datum.error * datum.error + scatter * scatter + own);
  }
  return weights;
}

double objective(const JobFit& fit, const VectorXd& weights, const VectorXd& searched) {
  const VectorXd value = fit.problem.model(searched, Want::values).value;
  double sum = 0;
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    const Datum& datum = fit.problem.data[static_cast<std::size_t>(i)];
    const double residual = value[i] - datum.value;
    if (const int of = side(datum.seen); of != 0)
      sum -= 2 * log_normal_cdf(of * residual * std::sqrt(weights[i]));
    else
      sum += weights[i] * residual * residual;
  }
  for (std::size_t k = 0; k < fit.problem.parameters.size(); ++k) {
    const FreeParameter& parameter = fit.problem.parameters[k];
    if (!parameter.prior) continue;
    const double off =
        (searched[static_cast<Eigen::Index>(k)] - parameter.searched(*parameter.prior)) / parameter.prior_error;
    sum += off * off;
  }
  return sum;
}

// Columns: one standard deviation along each axis of the fit's covariance, no longer than a share of the box.
MatrixXd step_directions(const JobFit& fit) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(fit.best().covariance);
  MatrixXd directions = solver.eigenvectors();
  for (Eigen::Index k = 0; k < directions.cols(); ++k) {
    double length = std::sqrt(std::max(0.0, solver.eigenvalues()[k]));
    for (Eigen::Index j = 0; j < directions.rows(); ++j) {
      const FreeParameter& parameter = fit.problem.parameters[static_cast<std::size_t>(j)];
      const double box = parameter.searched(parameter.high) - parameter.searched(parameter.low);
      if (std::abs(directions(j, k)) > 1e-9) length = std::min(length, longest_step * box / std::abs(directions(j, k)));
    }
    directions.col(k) *= length;
  }
  return directions;
}

bool inside(const JobFit& fit, const VectorXd& searched) {
  for (std::size_t k = 0; k < fit.problem.parameters.size(); ++k) {
    const FreeParameter& parameter = fit.problem.parameters[k];
    const double x = searched[static_cast<Eigen::Index>(k)];
    if (x < parameter.searched(parameter.low) || x > parameter.searched(parameter.high)) return false;
  }
  return true;
}

}  // namespace

std::vector<VectorXd> plausible_points(const JobFit& fit, int count, double temperature, unsigned seed) {
  Draws draws(seed);
  const VectorXd weights = weights_at_minimum(fit);
  const MatrixXd directions = step_directions(fit);
  const double stride = 2.38 / std::sqrt(static_cast<double>(directions.cols()));  // Gelman, Roberts and Gilks (1996)
  VectorXd here = fit.best().searched;
  double height = objective(fit, weights, here);
  std::vector<VectorXd> points{fit.at};
  for (int step = 1; static_cast<int>(points.size()) < count; ++step) {
    VectorXd normal(directions.cols());
    for (double& z : normal) z = draws.normal();
    const VectorXd there = here + stride * directions * normal;
    const double threshold = std::log(draws.uniform());
    if (inside(fit, there)) {
      const double new_height = objective(fit, weights, there);
      if ((height - new_height) / (2 * temperature) > threshold) {
        here = there;
        height = new_height;
      }
    }
    if (step % steps_between != 0) continue;
    VectorXd all = fit.at;
    all(fit.of_model) = here;
    points.push_back(all);
  }
  return points;
}

}  // namespace percal
