#include "accuracy.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "percal/atlas/expected.hpp"
#include "percal/base/progress.hpp"
#include "percal/study/kept_ladder.hpp"
#include "percal/text/one_value.hpp"

namespace percal::tools {
namespace {

constexpr double finest_accuracy = 0.001, coarsest_accuracy = 0.5;

// Why there is nothing to run; empty: there is.
std::string why_not(const AdvisedSetting& advice) {
  return advice.is_found ? "" : fmt::format("An error of {:.3g} %: {}", 100 * advice.target, advice.why_not);
}

AdvisedAccuracy accuracy_of(const AdvisedSetting& advice) {
  AdvisedAccuracy accuracy{.target_error = advice.target, .why_not = why_not(advice)};
  if (!advice.is_found) return accuracy;
  accuracy.elements_per_radius = advice.elements_per_radius;
  accuracy.replicates = advice.replicates;
  accuracy.discretisation_error = advice.discretisation_error;
  accuracy.noise_error = advice.noise_error;
  accuracy.error = advice.error;
  return accuracy;
}

AdvisedAccuracy by_study(const AdvisedSetting& advice, const LadderOptions& ladder) {
  AdvisedAccuracy accuracy = accuracy_of(advice);
  if (advice.is_found) accuracy.cpu_seconds = advice.cpu_seconds;
  accuracy.cpu_seconds_low = advice.cpu_seconds_low;
  accuracy.cpu_seconds_high = advice.cpu_seconds_high;
  accuracy.is_extrapolated = advice.cost_is_estimated;
  accuracy.studied_meshes = ladder.meshes;
  accuracy.studied_replicates = ladder.replicates;
  accuracy.time_step_factor = ladder.time_step_factor.value();
  return accuracy;
}

// The scene's own mesh with as many runs as are needed beside what the atlas knows; nothing where it does not know, or expects the sphere to
// come near the lower face.
std::optional<AdvisedAccuracy> by_atlas(const Scene& scene, double target_error) {
  const Scene rung =
      rung_scene(scene, scene.mesh.elements_per_radius, scene.solver.time_step_factor, Arithmetic::single_precision);
  const Problem problem = reduce(rung).problem;
  const auto expected = expected_depth(problem);
  if (!expected) return std::nullopt;
  const AtlasDepth atlas = in_metres(*expected, scene.particle.radius);
  if (atlas.high() > problem.whole_depth() * scene.particle.radius) return std::nullopt;
  AdvisedAccuracy accuracy =
      accuracy_of(advise(problem.elements_per_radius, atlas.noise, target_error, atlas.deviation));
  accuracy.time_step_factor = problem.time_step_factor;
  accuracy.atlas = atlas;
  return accuracy;
}

}  // namespace

AdvisedAccuracy by_runs_alone(const AdvisedAccuracy& by_atlas) {
  AdvisedAccuracy accuracy =
      accuracy_of(advise(*by_atlas.elements_per_radius, by_atlas.atlas->noise, by_atlas.target_error));
  accuracy.time_step_factor = by_atlas.time_step_factor;
  accuracy.atlas = by_atlas.atlas;
  return accuracy;
}

double parse_accuracy(const std::string& text) {
  constexpr double round_off = 1e-12;
  return one_share(text, "--accuracy",
                   {.low = finest_accuracy * (1 - round_off),
                    .high = coarsest_accuracy,
                    .words = fmt::format("a share of the depth from {0}% to {1}%, as \"2%\" or \"0.02\"",
                                         100 * finest_accuracy, 100 * coarsest_accuracy)});
}

AdvisedAccuracy advised_accuracy(const Scene& scene, double target_error, Store& store, const Common& common) {
  const std::string key = study_key(scene);
  const auto kept = kept_ladder(store, key);
  if (!kept)
    if (auto accuracy = by_atlas(scene, target_error)) return *accuracy;
  const LadderOptions options = kept.value_or(usual_ladder(scene));
  if (common.talks() && !kept) {
    fmt::print("no study of this scene is kept: its error against time is measured first, by {} runs\n",
               ladder_runs(options));
    std::fflush(stdout);
  }
  Campaign campaign(&store, common.threads);
  const Ladder ladder = [&] {
    Progress progress("study", ladder_runs(options));
    return run_ladder(scene, options, campaign, &progress);
  }();
  if (!kept) keep_ladder(store, key, ladder.options);
  const double cpu_seconds = campaign.cost().cpu_seconds;
  if (common.talks() && !kept) fmt::print("the study took {:.1f} s of processor time and is kept\n", cpu_seconds);
  AdvisedAccuracy accuracy = by_study(advise(ladder, error_vs_time(ladder), target_error), ladder.options);
  accuracy.study_was_kept = kept.has_value();
  accuracy.study_cpu_seconds = cpu_seconds;
  return accuracy;
}

Scene with_setting(const Scene& scene, const AdvisedAccuracy& advised) {
  if (!advised.why_not.empty()) return scene;
  Scene set = rung_scene(scene, *advised.elements_per_radius, advised.time_step_factor, Arithmetic::single_precision);
  set.output = scene.output;
  set.replicates = *advised.replicates;
  return set;
}

}  // namespace percal::tools
