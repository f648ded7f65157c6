#include "percal/fit/alpha_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percal {
namespace {

// A dip shallower than this share of the objective, or of this share squared of all weighted stress, is rounding.
constexpr double shallow = 1e-10;

double sum_of_squares(const std::vector<WeightedPoint>& points) {
  double sum = 0;
  for (const auto& point : points) sum += point.weight * point.stress * point.weight * point.stress;
  return sum;
}

}  // namespace

ProfileValue profile(const std::vector<WeightedPoint>& points, double alpha) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const Ogden unit{.mu = 1, .alpha = alpha};
  std::vector<double> response(points.size());
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    response[i] = points[i].weight * nominal_stress(unit, points[i].pair);
    largest = std::max(largest, std::abs(response[i]));
    if (!std::isfinite(response[i])) return {alpha, 0, never};
  }
  if (largest == 0) return {alpha, 0, never};
  double numerator = 0, denominator = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double scaled = response[i] / largest;
    numerator += points[i].weight * points[i].stress * scaled;
    denominator += scaled * scaled;
  }
  const double scaled_mu = numerator / denominator;
  double objective = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double residual = points[i].weight * points[i].stress - scaled_mu * (response[i] / largest);
    objective += residual * residual;
  }
  const double mu = scaled_mu / largest;
  return {alpha, mu, mu > 0 && std::isnormal(mu) ? objective : never};
}

std::vector<Bracket> scan_alpha(const std::vector<WeightedPoint>& points, double largest, int steps) {
  std::vector<ProfileValue> scan(steps + 1);
  for (int i = 0; i <= steps; ++i)
    scan[i] = profile(points, largest * (2.0 * i / steps - 1));  // odd steps would miss alpha = 0
  const double floor = shallow * shallow * sum_of_squares(points);
  const auto at = [&](int i) { return scan[std::clamp(i, 0, steps)]; };

  std::vector<int> lowest;  // of each basin
  for (int i = 0; i <= steps; ++i) {
    if (!std::isfinite(scan[i].objective)) continue;
    if ((i > 0 && scan[i - 1].objective <= scan[i].objective) ||
        (i < steps && scan[i + 1].objective < scan[i].objective))
      continue;
    if (!lowest.empty()) {
      double ridge = 0;
      for (int k = lowest.back(); k <= i; ++k) ridge = std::max(ridge, scan[k].objective);
      const double higher = std::max(scan[lowest.back()].objective, scan[i].objective);
      if (ridge - higher <= shallow * higher + floor) {
        if (scan[i].objective < scan[lowest.back()].objective) lowest.back() = i;
        continue;
      }
    }
    lowest.push_back(i);
  }
  std::vector<Bracket> brackets;
  for (int i : lowest) brackets.push_back({scan[i], at(i - 1).alpha, at(i + 1).alpha});
  return brackets;
}

}  // namespace percal
