#include "percal/atlas/expected.hpp"

#include <algorithm>
#include <cmath>

#include "percal/campaign/sphere_runs.hpp"
#include "percal/math/root.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/width.hpp"

namespace percal {
namespace {

constexpr double rounding = 1e-9;
constexpr int most_places = 4;           // emulators of a search for a root
constexpr double near_a_place = 0.4;     // of ln value: that far the emulator of a place is asked
constexpr double farthest_step = 1.5;    // from one place to the next
constexpr double root_tolerance = 1e-4;  // of ln value
constexpr double least_slope = 0.05;

ExpectedDepth said_by(const Emulator& emulator, const Problem& problem) {
  const double h = element_size(problem);
  const DepthAnswers said = emulator.depth({inputs_of(problem)}, h, true);
  return {said.log_depth[0], std::sqrt(said.covariance(0, 0)), emulator.noise(h)};
}

bool has_elements_of(const Atlas& atlas, const Problem& problem) {
  const auto [finest, coarsest] = std::ranges::minmax(atlas.runs, {}, &TrainingRun::h);
  const double h = element_size(problem);
  return h > finest.h * (1 - rounding) && h < coarsest.h * (1 + rounding);
}

bool is_sure(const ExpectedDepth& expected) { return expected.deviation < expected.noise; }

}  // namespace

const Atlas* atlas_about(const Problem& problem) {
  if (!is_for_an_emulator(problem) || !problem.below.empty()) return nullptr;
  if (problem.width < usual_width(problem.pi4, problem.density_ratio) * (1 - rounding)) return nullptr;
  Problem far = problem;
  far.width = farthest_wall;
  if (problem.graded_columns == usual_graded_columns(problem)) far.graded_columns = usual_graded_columns(far);
  return own_atlas(setting_of(far));
}

std::optional<ExpectedDepth> expected_depth(const Problem& problem) {
  const Atlas* atlas = atlas_about(problem);
  if (!atlas || !has_elements_of(*atlas, problem)) return std::nullopt;
  const ExpectedDepth expected = said_by(emulator_near(*atlas, inputs_of(problem)), problem);
  return is_sure(expected) ? std::optional(expected) : std::nullopt;
}

std::optional<ExpectedRoot> expected_root(const std::function<Problem(double log_value)>& problem, double log_depth,
                                          double from, double farthest) {
  double place = from;
  for (int k = 0; k < most_places; ++k) {
    const Problem here = problem(place);
    const Atlas* atlas = atlas_about(here);
    if (!atlas || !has_elements_of(*atlas, here)) return std::nullopt;
    const Emulator near = emulator_near(*atlas, inputs_of(here));
    const auto misfit = [&](double log_value) {
      const Problem at = problem(log_value);
      return near.depth({inputs_of(at)}, element_size(at), false).log_depth[0] - log_depth;
    };
    const double low = std::max(place - farthest_step, from - farthest),
                 high = std::min(place + farthest_step, from + farthest);
    const double at_low = misfit(low), at_high = misfit(high);
    const double next = at_low < 0 ? low : at_high > 0 ? high : root(misfit, low, high, root_tolerance);
    if (at_low < 0 || at_high > 0 || std::abs(next - place) > near_a_place) {
      if (next == place) return std::nullopt;
      place = next;
      continue;
    }
    constexpr double aside = 0.1;
    const ExpectedRoot found{.log_value = next,
                             .slope = (misfit(next + aside) - misfit(next - aside)) / (2 * aside),
                             .at = said_by(near, problem(next))};
    return found.slope < -least_slope && is_sure(found.at) ? std::optional(found) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace percal
