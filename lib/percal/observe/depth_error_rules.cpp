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

// docs/theory/errors.md (13): what 95 of 100 random scenes kept.
constexpr std::array<WallRow, 4> wall_rows{{{0, 0.12}, {5, 0.06}, {8, 0.02}, {12, 0.01}}};
// Slow shots: from this stress at the erosion limit on, over mu.
constexpr double slow_width = 5, firm_from = 20, share_of_firm = 0.02;
constexpr double rounding = 1e-9;

constexpr double step_share = 0.02, step_share_of_block = 0.04, usual_step = 0.9;
// By the stress at the erosion limit over K.
constexpr double share_of_stress = 0.2, least_of_bulk = 0.05, most_of_bulk = 0.16;
constexpr double share_of_squared_mach = 0.17;

// By pi4; of second order in h/l where it is smaller than those measured.
constexpr double biased_from = 8, share_of_bias = 0.05, share_of_bias_of_fast = 0.15, least_measured = 1.0 / 5;

}  // namespace

RuledShare wall_share(const Scene& scene, const Problem& problem) {
  const double width = problem.width * scene.particle.radius / reach_of(scene) * (1 + rounding);
  const auto row =
      std::ranges::find_if(wall_rows.rbegin(), wall_rows.rend(), [&](const WallRow& one) { return width >= one.from; });
  const bool is_slow = usual_width_in_reaches(scene) <= slow_width;
  const bool is_firm =
      is_slow && width >= slow_width && limit_stress_over_bulk(problem) * problem.bulk_ratio >= firm_from;
  return {is_firm ? std::min(row->share, share_of_firm) : row->share,
          fmt::format("rule of random scenes: {:.4g} radii to the wall, a {} shot{}", width, is_slow ? "slow" : "fast",
                      is_firm ? fmt::format(", {:g} mu or more at the erosion limit", firm_from) : "")};
}

RuledShare time_step_share(const Problem& problem, double worst_closure) {
  const double ratio = problem.time_step_factor / usual_step;
  const double share = problem.geometry == Geometry::block ? step_share_of_block : step_share;
  return {std::max(share * ratio * ratio, worst_closure),
          fmt::format("rule of random scenes: {:.4g} of the stable step, second order; energy closes to {:.1g}",
                      problem.time_step_factor, worst_closure)};
}

RuledShare bulk_share(const Reduction& reduction) {
  const double stress = limit_stress_over_bulk(reduction.problem), mach = reduction.mach;
  if (mach >= 1) return {std::nullopt, fmt::format("not known at Mach {:.2g}: the depth depends on K", mach)};
  const double beyond = std::max(0.0, mach * mach - recommended_mach * recommended_mach);
  return {std::clamp(share_of_stress * stress, least_of_bulk, most_of_bulk) + share_of_squared_mach * beyond,
          fmt::format("rule of random scenes: Mach {:.2g}, stress at the erosion limit {:.2g} K", mach, stress)};
}

RuledShare bias_share(const Problem& problem, double element_over_length) {
  const double share = problem.pi4 < biased_from ? share_of_bias : share_of_bias_of_fast;
  return {share * std::pow(std::min(1.0, element_over_length / least_measured), 2),
          fmt::format("elements of {:.2g} of the erosion length, pi4 {:.3g}", element_over_length, problem.pi4)};
}

}  // namespace percal
