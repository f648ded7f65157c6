// Whether printed errors hold: 40 random slow shots by each rule of erosion, run by default, then again on other phases, with better
// settings, or on elements of half the size.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "percal/math/draws.hpp"
#include "percal/math/statistics.hpp"
#include "percal/observe/depth_error.hpp"
#include "percal/problem/domain.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/study/extrapolation.hpp"
#include "percal/study/measured_effects.hpp"

namespace percal {
namespace {

constexpr int scenes = 40, held_at_least = 36, further_runs = 8;
constexpr std::uint64_t seed = 20261129;
constexpr double shallowest = 2, deepest = 15;  // radii, of a single run on coarse elements: these are cheap
constexpr double deepest_with_length = 8;       // twice the elements are run besides
constexpr double elements_with_length = 7;      // per radius
constexpr double fewest_in_length = 3, most_in_length = 5;

double log_uniform(Draws& draws, double low, double high) { return low * std::pow(high / low, draws.uniform()); }

Scene drawn(Draws& draws) {
  Scene scene;
  scene.particle.radius = 1e-3;
  scene.particle.density = 1000 * log_uniform(draws, 1.1, 17);
  scene.particle.speed = 100;
  scene.target.density = 1000;
  scene.target.mu_as_given = 1000 * 1e4 / log_uniform(draws, 1, 30);
  scene.target.alpha = 2 + 10 * draws.uniform();
  scene.target.erosion = StrainErosion{0.3 + 1.2 * draws.uniform()};
  scene.target.depth = 30e-3;
  return scene;
}

// Erosion is judged over three to five elements.
Scene drawn_with_length(Draws& draws) {
  Scene scene = drawn(draws);
  scene.mesh.elements_per_radius = elements_with_length;
  const double elements = fewest_in_length + (most_in_length - fewest_in_length) * draws.uniform();
  scene.target.erosion_average = AverageWithin{scene.particle.radius * elements / elements_with_length};
  return scene;
}

// As deep as it needs, and no deeper; nothing where a single run on `elements_per_radius` erodes nothing or is not so deep, in radii.
std::optional<Scene> cut_to_its_depth(Scene scene, double elements_per_radius, double most_radii, Campaign& campaign) {
  const ImpactResult run = campaign.evaluate(reduce(on_mesh(scene, elements_per_radius)).problem).result;
  const bool is_so_deep = run.depth >= shallowest && run.depth <= most_radii;
  if (run.outcome != Outcome::stopped || run.eroded == 0 || !is_so_deep) return std::nullopt;
  scene.target.depth = scene.particle.radius * std::ceil(1.5 * run.depth + 5);
  return scene;
}

// On other phases and at other speeds than the five of a default run.
std::vector<Problem> further(const Problem& problem) {
  std::vector<Problem> more;
  for (int k = 0; k < further_runs; ++k) {
    more.push_back(on_mesh(problem, replicate_mesh(problem.elements_per_radius, k, further_runs)));
    more.back().speed_factor = 1 + 0.001 * (k - (further_runs - 1) / 2.0);
  }
  return more;
}

struct Held {
  int phase = 0;
  std::array<int, 3> rules{};  // wall, time step, K
};

TEST(SlowCoverage, PrintedErrorsHoldForNineOfTenRandomShots) {
  Draws draws(seed);
  Campaign campaign(nullptr, 0);
  Held held;
  for (int n = 0; n < scenes;) {
    const auto scene = cut_to_its_depth(drawn(draws), 5, deepest, campaign);
    if (!scene) continue;
    const Reduction reduction = reduce(*scene);
    const auto runs = campaign.evaluate(replicates_of(reduction.problem, scene->replicates), nullptr);
    const Penetration found = summarise(runs, reduction.problem, reduction.scales);
    const Penetration again =
        summarise(campaign.evaluate(further(reduction.problem), nullptr), reduction.problem, reduction.scales);
    ASSERT_TRUE(found.depth && again.depth) << "seed " << seed << ", scene " << n;
    const DepthError error = depth_error(*scene, reduction, found);
    // The further runs' mean has an error of its own.
    const double theirs = *phase_half_width(again.standard_error, further_runs), off = *again.depth - *found.depth;
    const double ours = *error.of(DepthErrorSource::mesh_phase).half_width;
    held.phase += std::abs(off) <= std::hypot(ours, theirs) ? 1 : 0;
    std::string line = fmt::format("{:2}: {:5.2f} radii, phase {:4.1f} %, off {:+4.1f} % ({:3.1f})", n,
                                   *found.depth / scene->particle.radius, 100 * ours / *found.depth,
                                   100 * off / *found.depth, 100 * theirs / *found.depth);
    const auto effects = measured_effects(reduction, runs, campaign, nullptr);
    ASSERT_EQ(effects.size(), held.rules.size()) << "seed " << seed << ", scene " << n;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const MeasuredEffect& effect = effects[i];
      const double ruled = *error.of(effect.source).half_width;
      const double scatter = *phase_half_width(effect.standard_error, effect.pairs);
      held.rules[i] += std::abs(effect.difference) <= std::hypot(ruled, scatter) ? 1 : 0;
      line += fmt::format(", {} {:.1f}: {:+4.1f} % ({:3.1f})", word(effect.source), 100 * ruled / *found.depth,
                          100 * effect.difference / *found.depth, 100 * effect.standard_error / *found.depth);
    }
    fmt::print("{}\n", line);
    ++n;
  }
  fmt::print("held: mesh phase {}, wall {}, time step {}, K {} of {}\n", held.phase, held.rules[0], held.rules[1],
             held.rules[2], scenes);
  EXPECT_GE(held.phase, held_at_least) << "seed " << seed;
  for (const int rule : held.rules) EXPECT_GE(rule, held_at_least) << "seed " << seed;
}

TEST(SlowCoverage, ThePrintedErrorAndBiasReachTheDepthAtNoElementSizeInNineOfTen) {
  Draws draws(seed + 1);
  Campaign campaign(nullptr, 0);
  int held = 0;
  for (int n = 0; n < scenes;) {
    const auto scene = cut_to_its_depth(drawn_with_length(draws), elements_with_length, deepest_with_length, campaign);
    if (!scene) continue;
    const Reduction reduction = reduce(*scene);
    const Penetration found = summarise(campaign.evaluate(replicates_of(reduction.problem, scene->replicates), nullptr),
                                        reduction.problem, reduction.scales);
    const auto limit = extrapolated(*scene, found, campaign, nullptr);
    ASSERT_TRUE(limit) << "seed " << seed + 1 << ", scene " << n;
    const DepthError error = depth_error(*scene, reduction, found);
    const double phase = *error.of(DepthErrorSource::mesh_phase).half_width, bias = error.bias->half_width.value();
    const double theirs = *phase_half_width(limit->standard_error, limit->replicates),
                 off = limit->depth - *found.depth;
    held += std::abs(off) <= std::hypot(phase, bias, theirs) ? 1 : 0;
    fmt::print("{:2}: {:5.2f} radii, h/l {:.2f}, phase {:4.1f} %, bias {:4.1f} %, at h = 0 {:+5.1f} % ({:4.1f})\n", n,
               *found.depth / scene->particle.radius, *element_over_erosion_length(*scene), 100 * phase / *found.depth,
               100 * bias / *found.depth, 100 * off / *found.depth, 100 * theirs / *found.depth);
    ++n;
  }
  fmt::print("held: {} of {}\n", held, scenes);
  EXPECT_GE(held, held_at_least) << "seed " << seed + 1;
}

}  // namespace
}  // namespace percal
