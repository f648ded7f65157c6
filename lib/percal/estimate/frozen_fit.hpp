// The least-squares fit with weights that do not change: Ceres, within bounds.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "percal/estimate/least_squares.hpp"
#include "percal/estimate/weights.hpp"

namespace percal {

// The problem's model, counted; the last answer is kept because solvers ask twice for the same point.
class Evaluator {
 public:
  explicit Evaluator(const CalibrationProblem& problem) : problem_(problem) {}

  const CalibrationProblem& problem() const { return problem_; }
  const ModelAnswer& values(const Eigen::VectorXd& searched);
  ModelAnswer with_covariance(const Eigen::VectorXd& searched);
  int evaluations() const { return evaluations_; }

 private:
  const CalibrationProblem& problem_;
  Eigen::VectorXd last_;
  ModelAnswer answer_;
  int evaluations_ = 0;
};

// All numbers of it can be used.
bool finite(const ModelAnswer& answer);

struct FrozenFit {
  Eigen::VectorXd searched;
  double objective = 0;  // infinite where the model has no answer
  bool converged = false;
};

// From `start`, moved into the box; only the parameters `free` (ascending indices) change.
FrozenFit frozen_fit(Evaluator& evaluator, const Weights& weights, const Eigen::VectorXd& start,
                     const std::vector<int>& free);

Eigen::VectorXd lower_bounds(const CalibrationProblem& problem);  // searched scale
Eigen::VectorXd upper_bounds(const CalibrationProblem& problem);

enum class AtBound { no, low, high };
AtBound at_bound(const CalibrationProblem& problem, const Eigen::VectorXd& searched, int parameter);

// All parameters but the held ones.
std::vector<int> free_parameters(const CalibrationProblem& problem, const std::vector<Held>& held);

// Throws BadInput where there are no data or parameters, or their numbers cannot be used.
void check_problem(const CalibrationProblem& problem);

// Fits with weights that are frozen, settled by repetition, from one point. Of a problem that is checked.
Minimum settle(Evaluator& evaluator, const Eigen::VectorXd& start, const std::vector<Held>& held,
               const SearchOptions& options);

// glog prints on standard error even where Ceres is silent: this stops it, once. A host that has set glog up itself keeps its
// settings. To be called before a ceres::Solve.
void quiet_ceres();

}  // namespace percal
