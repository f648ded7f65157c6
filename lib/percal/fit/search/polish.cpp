#include "percal/fit/search/polish.hpp"

#include <ceres/ceres.h>

#include <cmath>

#include "percal/estimate/frozen_fit.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Residuals whose squares are the loss of data - columns(alphas) mu(alphas), over the size of the data.
class Projected : public ceres::CostFunction {
 public:
  Projected(const std::vector<WeightedPoint>& points, int terms, Signs signs, const ScaledLoss& loss)
      : points_(points), data_(weighted_stress(points)), size_(data_.norm()), signs_(signs), loss_(loss) {
    mutable_parameter_block_sizes()->push_back(terms);
    set_num_residuals(static_cast<int>(points.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const int terms = parameter_block_sizes()[0];
    const std::vector<double> alphas(parameters[0], parameters[0] + terms);
    const TermColumns columns = term_columns(points_, alphas);
    const Moduli moduli = best_moduli(columns.stress, data_, signs_, loss_);
    if (!std::isfinite(moduli.objective)) return false;
    const VectorXd residual = data_ - columns.stress * moduli.mu;
    VectorXd slope(residual.size());  // d(root of the loss)/d(residual)
    for (Eigen::Index i = 0; i < residual.size(); ++i) {
      const double root = std::copysign(std::sqrt(loss_of(loss_, residual(i))), residual(i));
      slope(i) = root == 0 ? 1 : weight_of(loss_, residual(i)) * residual(i) / root;
      residuals[i] = root / size_;
    }
    if (jacobians && jacobians[0]) {
      const MatrixXd jacobian = derivative(columns, moduli, slope).transpose();  // Ceres stores by rows
      MatrixXd::Map(jacobians[0], jacobian.rows(), jacobian.cols()) = jacobian;
    }
    return true;
  }

 private:
  // -P diag(slope) d(columns)/d(alphas) mu, P the projection off the columns in use.
  MatrixXd derivative(const TermColumns& columns, const Moduli& moduli, const VectorXd& slope) const {
    std::vector<Eigen::Index> used;
    for (Eigen::Index k = 0; k < moduli.mu.size(); ++k)
      if (moduli.mu(k) != 0) used.push_back(k);
    MatrixXd basis(data_.size(), used.size());
    for (std::size_t k = 0; k < used.size(); ++k) {
      basis.col(k) = slope.asDiagonal() * columns.stress.col(used[k]);
      for (int twice = 0; twice < 2; ++twice)
        basis.col(k) -= basis.leftCols(k) * (basis.leftCols(k).transpose() * basis.col(k)).eval();
      basis.col(k).normalize();
    }
    const MatrixXd moved = slope.asDiagonal() * columns.by_alpha * (moduli.mu / -size_).asDiagonal();
    return moved - basis * (basis.transpose() * moved);
  }

  const std::vector<WeightedPoint>& points_;
  VectorXd data_;
  double size_;
  Signs signs_;
  ScaledLoss loss_;
};

ceres::Solver::Options options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 500;
  options.function_tolerance = 1e-16;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-13;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  return options;
}

// The exponents at a bound that the objective pushes them against.
std::vector<int> pushed_against_bound(const Projected& cost, const std::vector<SearchedAlpha>& alphas,
                                      const std::vector<double>& at) {
  VectorXd residual(cost.num_residuals());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(residual.size(), at.size());
  const double* parameters[] = {at.data()};
  double* jacobians[] = {jacobian.data()};
  std::vector<int> pushed;
  if (!cost.Evaluate(parameters, residual.data(), jacobians)) return pushed;
  const VectorXd gradient = jacobian.transpose() * residual;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double close = 1e-9 * (alphas[k].high - alphas[k].low), slope = gradient(static_cast<Eigen::Index>(k));
    if ((at[k] <= alphas[k].low + close && slope > 0) || (at[k] >= alphas[k].high - close && slope < 0))
      pushed.push_back(static_cast<int>(k));
  }
  return pushed;
}

// One run of Ceres over the exponents that are not held. Moves `at`.
ceres::Solver::Summary descend(Projected& cost, const std::vector<SearchedAlpha>& alphas, std::vector<double>& at,
                               const std::vector<int>& held) {
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, at.data());
  for (std::size_t k = 0; k < alphas.size(); ++k) {
    problem.SetParameterLowerBound(at.data(), static_cast<int>(k), alphas[k].low);
    problem.SetParameterUpperBound(at.data(), static_cast<int>(k), alphas[k].high);
  }
  if (held.size() == at.size())
    problem.SetParameterBlockConstant(at.data());
  else if (!held.empty())
    problem.SetManifold(at.data(), new ceres::SubsetManifold(static_cast<int>(at.size()), held));
  ceres::Solver::Summary summary;
  ceres::Solve(options(), &problem, &summary);
  return summary;
}

}  // namespace

// Ceres projects a step that leaves the box onto it, which ends short of the minimum. So exponents that are pushed against a bound are
// held there while the others go on; one that wants to leave it again may.
Polished polish(const std::vector<WeightedPoint>& points, const std::vector<SearchedAlpha>& alphas, Signs signs,
                const ScaledLoss& loss) {
  quiet_ceres();
  std::vector<double> at;
  for (const auto& alpha : alphas) at.push_back(alpha.start);
  Projected cost(points, static_cast<int>(at.size()), signs, loss);
  bool converged = false;
  int iterations = 0;
  std::vector<int> held;
  for (std::size_t pass = 0; pass <= at.size() + 1; ++pass) {
    const auto summary = descend(cost, alphas, at, held);
    converged = summary.termination_type == ceres::CONVERGENCE;
    iterations += static_cast<int>(summary.iterations.size());
    const auto pushed = pushed_against_bound(cost, alphas, at);
    if (pushed == held) break;
    held = pushed;
  }
  const Moduli moduli = best_moduli(term_columns(points, at).stress, weighted_stress(points), signs, loss);
  Polished polished{{}, moduli.objective, converged, iterations};
  for (std::size_t k = 0; k < at.size(); ++k) polished.terms.push_back({moduli.mu(k), at[k]});
  return polished;
}

}  // namespace percal
