#include <algorithm>
#include <cmath>

#include "percal/estimate/intervals.hpp"

namespace percal {

// After Sherman and Morrison the covariance C becomes C - C g g^T C/(error^2 + g^T C g), g the candidate's gradient.   (17)
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
