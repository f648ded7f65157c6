#include <algorithm>
#include <limits>

#include "percal/estimate/profile.hpp"

namespace percal {

using Eigen::VectorXd;

Surroundings::Surroundings(const CalibrationProblem& problem, const Minimum& minimum)
    : minimum_(minimum),
      evaluator_(problem),
      answer_(evaluator_.with_covariance(minimum.searched)),
      weights_(make_weights(problem.data, minimum.scatter, answer_.covariance)),
      likelihood_(
          restricted_likelihood(problem, answer_, minimum.searched, minimum.scatter, free_parameters(problem, {}))) {}

Surroundings::Point Surroundings::fit_others(const VectorXd& start, const std::vector<int>& held) {
  std::vector<Held> fixed;
  for (const int k : held) fixed.push_back({k, start[k]});
  const FrozenFit fit = frozen_fit(evaluator_, weights_, start, free_parameters(problem(), fixed));
  return {fit.searched, fit.objective - minimum_.objective};
}

// With c = w . C w and g its slopes by the squared scatters, whose covariance is F^-1: 2 c^2/(g . F^-1 g).
double Surroundings::degrees_of_freedom(const VectorXd& weight) const {
  const auto groups = static_cast<int>(likelihood_.covariance_slope.size());
  VectorXd slope(groups);
  for (int g = 0; g < groups; ++g) slope[g] = weight.dot(likelihood_.covariance_slope[g] * weight);
  const double variance = weight.dot(likelihood_.covariance * weight);
  const double uncertainty = slope.dot(scatter_covariance(likelihood_) * slope);
  if (!(uncertainty > 0)) return std::numeric_limits<double>::infinity();
  return std::max(1.0, 2 * variance * variance / uncertainty);
}

}  // namespace percal
