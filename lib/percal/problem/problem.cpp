#include "percal/problem/problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace percal {

double Problem::whole_depth() const {
  double sum = depth;
  for (const LowerLayer& layer : below) sum += layer.depth;
  return sum;
}

double mach_number(const Problem& problem) {
  double largest = std::sqrt(problem.pi4 / (problem.bulk_ratio + 4.0 / 3));
  for (const LowerLayer& layer : problem.below)
    largest = std::max(largest, std::sqrt(layer.density / layer.mu / (layer.bulk_ratio + 4.0 / 3)));
  return largest;
}

double subsonic_bulk_ratio(double pi4) { return 1.01 * pi4 / (recommended_mach * recommended_mach) - 4.0 / 3; }

int usual_graded_columns(double fine_width, int elements_per_radius) {
  const int fine_columns = std::max(1, static_cast<int>(std::lround(fine_width * elements_per_radius)));
  return std::max(2, (fine_columns + 1) / 2);
}

double replicate_speed_factor(int replicate) {
  const int step = (replicate + 1) / 2;
  return 1 + (replicate % 2 == 1 ? 0.001 : -0.001) * step;
}

double round_to_12_digits(double x) { return std::strtod(fmt::format("{:.11e}", x).c_str(), nullptr); }

}  // namespace percal
