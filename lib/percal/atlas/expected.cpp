#include "percal/atlas/expected.hpp"

#include <algorithm>
#include <cmath>

#include "percal/campaign/sphere_runs.hpp"
#include "percal/math/distributions.hpp"
#include "percal/math/root.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/width.hpp"

namespace percal {
namespace {

constexpr double rounding = 1e-9;
constexpr int most_places = 6;           // of a search for a root
constexpr double near_a_place = 0.2;     // of ln value: its runs are those of a root as near as that
constexpr double farthest_step = 1.5;    // from one place to the next
constexpr double root_tolerance = 1e-4;  // of ln value
constexpr double least_slope = 0.05;
constexpr double aside = 0.1;  // of ln value, for the slope

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

// A line's own 95 % half width that is so small beside the others' widens the interval by 8 %.
constexpr double upper = 0.975, little = 0.4;
constexpr int fewest_answers = 5;
constexpr double share_of_slope = 0.15;  // by which it may be off

// Wherever the wall is.
const Atlas* atlas_of_setting(const Problem& problem) {
  if (!is_for_an_emulator(problem) || !problem.below.empty()) return nullptr;
  Problem far = problem;
  far.width = farthest_wall;
  if (problem.graded_columns == usual_graded_columns(problem)) far.graded_columns = usual_graded_columns(far);
  return own_atlas(setting_of(far));
}

}  // namespace

const Atlas* atlas_about(const Problem& problem) {
  const bool wall_is_felt = problem.width < usual_width(problem.pi4, problem.density_ratio) * (1 - rounding);
  return wall_is_felt ? nullptr : atlas_of_setting(problem);
}

std::optional<ExpectedDepth> expected_depth(const Problem& problem) {
  const Atlas* atlas = atlas_about(problem);
  if (!atlas || !has_elements_of(*atlas, problem)) return std::nullopt;
  const ExpectedDepth expected = said_by(emulator_near(*atlas, inputs_of(problem)), problem);
  return is_sure(expected) ? std::optional(expected) : std::nullopt;
}

AtlasDepth in_metres(const ExpectedDepth& expected, double radius) {
  return {.depth = std::exp(expected.log_depth) * radius,
          .deviation = expected.deviation,
          .noise = expected.noise,
          .width = farthest_wall};
}

std::optional<ExpectedRoot> expected_root(const std::function<Problem(double log_value)>& problem, double log_depth,
                                          double from, double farthest) {
  const Atlas* atlas = atlas_of_setting(problem(from));  // at the root the wall is to be far enough
  if (!atlas || !has_elements_of(*atlas, problem(from))) return std::nullopt;
  const auto at = [&](double log_value) { return inputs_of(problem(log_value)); };
  const auto misfit_by = [&](const Emulator& emulator) {
    return [&, h = element_size(problem(from))](double log_value) {
      return emulator.depth({at(log_value)}, h, false).log_depth[0] - log_depth;
    };
  };
  // Where its depth is that within farthest_step of a place; else as far as that goes.
  const auto next_place = [&](const Emulator& emulator, double place) {
    const auto misfit = misfit_by(emulator);
    const double low = std::max(place - farthest_step, from - farthest),
                 high = std::min(place + farthest_step, from + farthest);
    if (misfit(low) < 0) return low;
    if (misfit(high) > 0) return high;
    return root(misfit, low, high, root_tolerance);
  };
  double place = from;
  for (int k = 0; k < most_places; ++k) {
    const double next = next_place(roughly_near(*atlas, at(place)), place);
    const bool arrived = std::abs(next - place) < near_a_place;
    place = next;
    if (arrived) break;
  }
  const Emulator near = emulator_near(*atlas, at(place));
  place = next_place(near, place);
  const auto misfit = misfit_by(near);
  const ExpectedRoot found{.log_value = place,
                           .slope = (misfit(place + aside) - misfit(place - aside)) / (2 * aside),
                           .at = said_by(near, problem(place))};
  const bool is_root = std::abs(misfit(place)) < found.at.noise && found.slope < -least_slope;
  return is_root && is_sure(found.at) && atlas_about(problem(place)) == atlas ? std::optional(found) : std::nullopt;
}

void begin_at(const ExpectedRoot& root, double others, InversionOptions& options) {
  options.start = root.log_value;
  options.expected_slope = -root.slope;
  options.slope_error = share_of_slope * options.expected_slope;
  options.noise = root.at.noise;
  int enough = std::min(fewest_answers, options.fewest_in_line);
  while (enough < options.fewest_in_line && student_quantile(upper, enough - 2) * root.at.noise / std::sqrt(enough) >
                                                little * normal_quantile(upper) * others)
    ++enough;
  options.fewest_in_line = enough;
}

}  // namespace percal
