#include "percal/estimate/frozen_fit.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <limits>
#include <mutex>

namespace percal {
namespace {

using Eigen::VectorXd;

// All whitened residuals as functions of the free parameters, which are one block.
class WhitenedCost : public ceres::CostFunction {
 public:
  WhitenedCost(Evaluator& evaluator, const Weights& weights, const VectorXd& start, const std::vector<int>& free,
               int residuals)
      : evaluator_(evaluator), weights_(weights), start_(start), free_(free) {
    set_num_residuals(residuals);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free.size()));
  }

  bool Evaluate(double const* const* parameters, double* residual, double** jacobians) const override {
    VectorXd searched = start_;
    for (std::size_t k = 0; k < free_.size(); ++k) searched[free_[k]] = parameters[0][k];
    const ModelAnswer& answer = evaluator_.values(searched);
    if (!finite(answer)) return false;
    const Whitened white = whiten(evaluator_.problem(), weights_, answer, searched);
    VectorXd::Map(residual, white.residual.size()) = white.residual;
    if (jacobians && jacobians[0]) {
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor>(jacobians[0], white.jacobian.rows(), static_cast<int>(free_.size())) =
          white.jacobian(Eigen::all, free_);
    }
    return true;
  }

 private:
  Evaluator& evaluator_;
  const Weights& weights_;
  const VectorXd& start_;
  const std::vector<int>& free_;
};

ceres::Solver::Options solver_options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-11;
  options.gradient_tolerance = 1e-12;
  options.parameter_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.max_num_line_search_step_size_iterations = 0;  // of bounded problems: frozen_fit() has its own way with bounds
  return options;
}

// One descent of Ceres. Moves `searched`; true where it converged.
bool descend(Evaluator& evaluator, const Weights& weights, VectorXd& searched, const std::vector<int>& free) {
  if (free.empty()) return true;
  const CalibrationProblem& problem = evaluator.problem();
  const VectorXd start = searched, low = lower_bounds(problem), high = upper_bounds(problem);
  const auto rows = whiten(problem, weights, evaluator.values(start), start).residual.size();
  WhitenedCost cost(evaluator, weights, start, free, static_cast<int>(rows));

  VectorXd block = start(free);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem least_squares(ownership);
  least_squares.AddResidualBlock(&cost, nullptr, block.data());
  for (std::size_t k = 0; k < free.size(); ++k) {
    least_squares.SetParameterLowerBound(block.data(), static_cast<int>(k), low[free[k]]);
    least_squares.SetParameterUpperBound(block.data(), static_cast<int>(k), high[free[k]]);
  }
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(), &least_squares, &summary);
  searched(free) = block;
  return summary.termination_type == ceres::CONVERGENCE;
}

// The free parameters that stand at a bound which the objective pushes them against.
std::vector<int> pushed_against_bound(Evaluator& evaluator, const Weights& weights, const VectorXd& searched,
                                      const std::vector<int>& free) {
  const CalibrationProblem& problem = evaluator.problem();
  const VectorXd gradient = whiten(problem, weights, evaluator.values(searched), searched).gradient();
  std::vector<int> pushed;
  for (const int k : free) {
    const AtBound side = at_bound(problem, searched, k);
    if ((side == AtBound::low && gradient[k] > 0) || (side == AtBound::high && gradient[k] < 0)) pushed.push_back(k);
  }
  return pushed;
}

// One step of Gauss and Newton without Ceres' damping, whose last trace it removes. Taken where it stays within the box and does not
// raise the objective.
void last_step(Evaluator& evaluator, const Weights& weights, VectorXd& searched, const std::vector<int>& free) {
  if (free.empty()) return;
  const CalibrationProblem& problem = evaluator.problem();
  const Whitened here = whiten(problem, weights, evaluator.values(searched), searched);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> jacobian;
  jacobian.setThreshold(1e-8);  // along a ridge: no step
  jacobian.compute(here.jacobian(Eigen::all, free));
  VectorXd there = searched;
  there(free) -= jacobian.solve(here.residual);
  const bool inside =
      (there.array() >= lower_bounds(problem).array()).all() && (there.array() <= upper_bounds(problem).array()).all();
  if (!inside || !finite(evaluator.values(there))) return;
  const double objective = whiten(problem, weights, evaluator.values(there), there).objective();
  if (objective <= here.objective() * (1 + 1e-14)) searched = there;
}

}  // namespace

const ModelAnswer& Evaluator::values(const VectorXd& searched) {
  if (last_.size() == searched.size() && last_ == searched) return answer_;
  answer_ = problem_.model(searched, Want::values);
  assert(answer_.value.size() == static_cast<Eigen::Index>(problem_.data.size()));
  assert(answer_.jacobian.rows() == answer_.value.size() && answer_.jacobian.cols() == searched.size());
  last_ = searched;
  ++evaluations_;
  return answer_;
}

ModelAnswer Evaluator::with_covariance(const VectorXd& searched) {
  ++evaluations_;
  return problem_.model(searched, Want::values_and_covariance);
}

bool finite(const ModelAnswer& answer) { return answer.value.allFinite() && answer.jacobian.allFinite(); }

VectorXd lower_bounds(const CalibrationProblem& problem) {
  VectorXd low(problem.parameters.size());
  for (int k = 0; k < low.size(); ++k) low[k] = problem.parameters[k].searched(problem.parameters[k].low);
  return low;
}

VectorXd upper_bounds(const CalibrationProblem& problem) {
  VectorXd high(problem.parameters.size());
  for (int k = 0; k < high.size(); ++k) high[k] = problem.parameters[k].searched(problem.parameters[k].high);
  return high;
}

AtBound at_bound(const CalibrationProblem& problem, const VectorXd& searched, int parameter) {
  const FreeParameter& free = problem.parameters[parameter];
  const double low = free.searched(free.low), high = free.searched(free.high), close = 1e-9 * (high - low);
  if (searched[parameter] <= low + close) return AtBound::low;
  return searched[parameter] >= high - close ? AtBound::high : AtBound::no;
}

std::vector<int> free_parameters(const CalibrationProblem& problem, const std::vector<Held>& held) {
  std::vector<int> free;
  for (int k = 0; k < static_cast<int>(problem.parameters.size()); ++k)
    if (std::ranges::none_of(held, [k](const Held& one) { return one.parameter == k; })) free.push_back(k);
  return free;
}

// Ceres projects a step that leaves the box onto it, which makes slow work of a valley that is cut by a bound. So parameters
// that end at a bound are kept there while the others go on without them; one that wants to leave it again may.
FrozenFit frozen_fit(Evaluator& evaluator, const Weights& weights, const VectorXd& start,
                     const std::vector<int>& free) {
  quiet_ceres();
  const CalibrationProblem& problem = evaluator.problem();
  FrozenFit fit{start, std::numeric_limits<double>::infinity(), false};
  fit.searched(free) = start(free).cwiseMax(lower_bounds(problem)(free)).cwiseMin(upper_bounds(problem)(free)).eval();
  if (!finite(evaluator.values(fit.searched))) return fit;

  std::vector<int> inner = free, pushed;
  for (std::size_t pass = 0; pass <= free.size() + 1; ++pass) {
    fit.converged = descend(evaluator, weights, fit.searched, inner);
    const auto now = pushed_against_bound(evaluator, weights, fit.searched, free);
    if (now == pushed) break;
    pushed = now;
    inner.clear();
    std::ranges::set_difference(free, pushed, std::back_inserter(inner));
  }
  last_step(evaluator, weights, fit.searched, inner);
  fit.objective = whiten(problem, weights, evaluator.values(fit.searched), fit.searched).objective();
  return fit;
}

void quiet_ceres() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (google::IsGoogleLoggingInitialized()) return;
    google::InitGoogleLogging("percal");
    FLAGS_logtostderr = true;
    FLAGS_minloglevel = 3;
  });
}

}  // namespace percal
