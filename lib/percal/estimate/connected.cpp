#include "percal/estimate/connected.hpp"

#include <algorithm>
#include <cmath>

#include "percal/estimate/profile.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;

constexpr int steps = 12;
constexpr double same_place = 1e-4;  // of the box

}  // namespace

// The parameter that is furthest off is led to its goal in small steps, the others fitted anew, and stays there; then the next. On a
// ridge, straight or curved, the first one takes the others with it.
bool connected(const CalibrationProblem& problem, const Minimum& from, const Minimum& to) {
  const VectorXd width = upper_bounds(problem) - lower_bounds(problem);
  VectorXd here = from.searched;
  const auto off = [&](const VectorXd& there) {
    return VectorXd((to.searched - there).cwiseQuotient(width).cwiseAbs());
  };
  if (off(here).maxCoeff() < same_place) return true;
  if (std::abs(to.deviance - from.deviance) > barrier) return false;

  Surroundings near(problem, from);
  std::vector<int> held;
  int furthest = 0;
  while (off(here).maxCoeff(&furthest) >= same_place) {
    if (std::ranges::find(held, furthest) != held.end()) return false;
    held.push_back(furthest);
    const double start = here[furthest];
    for (int step = 1; step <= steps; ++step) {
      here[furthest] = start + (to.searched[furthest] - start) * step / steps;
      const auto point = near.fit_others(here, held);
      if (!(point.rise < barrier)) return false;
      here = point.searched;
    }
  }
  return true;
}

}  // namespace percal
