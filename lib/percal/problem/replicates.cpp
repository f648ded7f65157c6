#include "percal/problem/replicates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "percal/problem/domain.hpp"

namespace percal {

// On a coarse mesh the walk must not leave it.
double walk_span(double elements_per_radius) { return std::min(phase_span, elements_per_radius / 2); }

double replicate_mesh(double elements_per_radius, int index, int count) {
  const double from_middle = index - (count - 1) / 2.0;
  return round_to_12_digits(elements_per_radius + from_middle * walk_span(elements_per_radius) / count);
}

double replicate_speed_factor(int step) {
  const int away = (step + 1) / 2;
  return round_to_12_digits(1 + (step % 2 == 1 ? 0.001 : -0.001) * away);
}

double replicate_speed(int index, int count) {
  const int from_middle = index - middle_replicate(count);
  return replicate_speed_factor(from_middle > 0 ? 2 * from_middle - 1 : -2 * from_middle);
}

std::vector<Problem> replicates_of(const Problem& problem, int count) {
  std::vector<Problem> replicates;
  for (int k = 0; k < count; ++k) {
    replicates.push_back(on_mesh(problem, replicate_mesh(problem.elements_per_radius, k, count)));
    replicates.back().speed_factor = replicate_speed(k, count);
    if (k != middle_replicate(count)) replicates.back().history_samples = 0;
  }
  return replicates;
}

double drawn_mesh(double elements_per_radius, unsigned seed, int draw) {
  constexpr double golden = std::numbers::phi - 1;
  double whole = 0;
  const double place = std::modf(golden * (static_cast<double>(seed % 1000003U) + draw), &whole);
  return round_to_12_digits(elements_per_radius + (place - 0.5) * walk_span(elements_per_radius));
}

}  // namespace percal
