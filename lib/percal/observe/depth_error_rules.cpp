#include "percal/observe/depth_error_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "percal/scene/width.hpp"

namespace percal {
namespace {

// The largest principal stress in uniaxial tension at a layer's erosion limit, over K: how compressible the target is where it is about
// to erode. An energy limit W stands for alpha W, its stress where the stretch is large.
double limit_stress_over_bulk(const Erosion& erosion, double mu, double alpha, double bulk) {
  if (const auto* strain = std::get_if<StrainErosion>(&erosion)) {
    const double stretch = stretch_at(strain->limit, strain->measure);
    return 2 * mu / alpha * (std::pow(stretch, alpha) - std::pow(stretch, -alpha / 2)) / bulk;
  }
  if (const auto* stress = std::get_if<StressErosion>(&erosion)) return stress->limit / bulk;
  if (const auto* energy = std::get_if<EnergyErosion>(&erosion)) return std::abs(alpha) * energy->limit / bulk;
  return 0;
}

double limit_stress_over_bulk(const Problem& problem) {
  double largest = limit_stress_over_bulk(problem.erosion, problem.mu(), problem.alpha, problem.bulk());
  for (const LowerLayer& layer : problem.below)
    if (auto erosion = problem.erosion; std::isfinite(layer.erosion_limit)) {
      std::visit(
          [&](auto& limit) {
            if constexpr (requires { limit.limit; }) limit.limit = layer.erosion_limit;
          },
          erosion);
      largest = std::max(largest, limit_stress_over_bulk(erosion, layer.mu, layer.alpha, layer.bulk_ratio * layer.mu));
    }
  return largest;
}

// From this width on, in radii, this share.
struct WallRow {
  double from, share;
};
using WallRule = std::array<WallRow, 4>;

// docs/theory/errors.md (13): what 95 of 100 random scenes kept. Soft: the stress at the erosion limit is below 10 mu.
constexpr WallRule soft_and_slow{{{0, 0.1}, {5, 0.05}, {8, 0.01}, {12, 0.007}}},
    slow{{{0, 0.06}, {5, 0.03}, {8, 0.01}, {12, 0.007}}}, fast{{{0, 0.15}, {5, 0.06}, {8, 0.02}, {12, 0.01}}};
constexpr double soft_below = 10, slow_width = 5, rounding = 1e-9;

constexpr double step_share = 0.015, usual_step = 0.9;
// Six radii deep or more, the share grows with the stress at the erosion limit over K.
constexpr double least_of_bulk = 0.03, most_of_bulk = 0.14, share_of_stress = 0.12, deep_from = 6;
constexpr double share_of_squared_mach = 0.17;

}  // namespace

RuledShare wall_share(const Scene& scene, const Problem& problem) {
  const double width = problem.width * scene.particle.radius / reach_of(scene);
  const double stress = limit_stress_over_bulk(problem) * problem.bulk_ratio;
  const bool is_slow = usual_width_in_reaches(scene) <= slow_width;
  const WallRule& rule = !is_slow ? fast : stress < soft_below ? soft_and_slow : slow;
  const auto row = std::ranges::find_if(rule.rbegin(), rule.rend(),
                                        [&](const WallRow& one) { return width >= one.from * (1 - rounding); });
  return {row->share,
          fmt::format("rule of random scenes: {:.4g} radii to the wall, a {} shot{}", width, is_slow ? "slow" : "fast",
                      is_slow && stress < soft_below ? ", little stress at the erosion limit" : "")};
}

RuledShare time_step_share(const Problem& problem, double worst_closure) {
  const double ratio = problem.time_step_factor / usual_step;
  return {std::max(step_share * ratio * ratio, worst_closure),
          fmt::format("rule of random scenes: {:.4g} of the stable step, second order; energy closes to {:.1g}",
                      problem.time_step_factor, worst_closure)};
}

RuledShare bulk_share(const Reduction& reduction, double depth) {
  const double stress = limit_stress_over_bulk(reduction.problem), mach = reduction.mach;
  if (mach >= 1) return {std::nullopt, fmt::format("not known at Mach {:.2g}: the depth depends on K", mach)};
  const double beyond = std::max(0.0, mach * mach - recommended_mach * recommended_mach);
  const double radii = depth / reduction.scales.radius;
  const double share =
      radii >= deep_from ? std::clamp(share_of_stress * stress, least_of_bulk, most_of_bulk) : most_of_bulk;
  return {share + share_of_squared_mach * beyond,
          fmt::format("rule of random scenes: Mach {:.2g}, stress at the erosion limit {:.2g} K, {:.2g} radii deep",
                      mach, stress, radii)};
}

std::string bias_words(double element_over_length) {
  return fmt::format(
      "not extrapolated: first order in h/l = {:.2g}, typically c h/l with c 0.1 to 0.5 (docs/theory/errors.md); "
      "--extrapolate runs a finer mesh",
      element_over_length);
}

}  // namespace percal
