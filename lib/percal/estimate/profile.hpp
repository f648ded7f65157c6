// The objective along one parameter with the others fitted anew, seen from a minimum whose weights are kept.
#pragma once
#include <vector>

#include "percal/estimate/frozen_fit.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/estimate/scatter.hpp"

namespace percal {

// A minimum with its weights frozen, so that rises of the objective can be compared. Seen from several threads at once where the model is.
class Surroundings {
 public:
  Surroundings(const CalibrationProblem& problem, const Minimum& minimum);

  const CalibrationProblem& problem() const { return problem_; }
  const Minimum& minimum() const { return minimum_; }
  const Weights& weights() const { return weights_; }
  const ModelAnswer& answer() const { return answer_; }  // at the minimum

  // The rise where some parameters are held and the others fitted from `start`, whose held entries say where. Infinite where
  // the model has no answer.
  struct Point {
    Eigen::VectorXd searched;
    double rise = 0;
  };
  Point fit_others(const Eigen::VectorXd& start, const std::vector<int>& held) const;

  // Satterthwaite's degrees of freedom of the variance of weight . parameters; infinite where no scatter is estimated.  (12)
  double degrees_of_freedom(const Eigen::VectorXd& weight) const;

 private:
  const CalibrationProblem& problem_;
  const Minimum& minimum_;
  ModelAnswer answer_;
  Weights weights_;
  RestrictedLikelihood likelihood_;
};

// Outwards along one parameter (direction -1 or 1) from a point below the threshold, until the rise reaches it or the bound is met.
// `also_held` stay where the start has them, all others are fitted anew; `deviation` is a guess of how far it is worth to step.
struct Walk {
  Surroundings::Point end;
  bool at_bound = false;                    // the threshold was not reached
  std::vector<Surroundings::Point> points;  // all that were fitted, the end among them
};
struct Path {
  int parameter, direction;
  double threshold, deviation;
  std::vector<int> also_held;
};
Walk walk(const Surroundings& surroundings, const Surroundings::Point& start, const Path& path);

// From the minimum to both sides.
struct Profile {
  ProfileInterval interval;
  Walk down, up;
};
Profile trace_profile(const Surroundings& surroundings, int parameter, double threshold);

}  // namespace percal
