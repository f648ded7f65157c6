// percal impact: one scene, its replicates, the summary.
#include <fmt/format.h>

#include <chrono>

#include "accuracy.hpp"
#include "impact_views.hpp"
#include "pages.hpp"
#include "percal/base/progress.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/observe/history.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/error_evidence.hpp"
#include "percal/text/file.hpp"
#include "percal/units/quantity.hpp"

namespace percal::tools {
namespace {

Scene scene_with_options(const ImpactArguments& arguments) {
  Scene scene = read_scene(arguments.scene);
  if (arguments.elements_per_radius) scene.mesh.elements_per_radius = *arguments.elements_per_radius;
  if (arguments.replicates) scene.replicates = *arguments.replicates;
  if (arguments.arithmetic)
    scene.solver.arithmetic =
        *arguments.arithmetic == "double" ? Arithmetic::double_precision : Arithmetic::single_precision;
  if (!arguments.history.empty()) scene.output.history = true;
  return scene;
}

// Of the run that is shown.
std::string picture_title(const Scene& scene, const Reduction& reduction, const ImpactResult& run) {
  return fmt::format("{} into {}: {}, depth {}", scene.particle.name, scene.target.name, word(run.outcome),
                     format_quantity(run.depth * reduction.scales.radius, dimension::length));
}

const ImpactResult& middle_run(const ImpactFindings& found) {
  return found.runs[middle_replicate(static_cast<int>(found.runs.size()))].result;
}

ErrorsAskedFor errors_asked_for(const ImpactArguments& arguments) {
  return {.measured = arguments.measure_errors, .extrapolated = arguments.extrapolate};
}

void write_history(const ImpactFindings& found, const std::string& file, const std::string& folder) {
  const auto csv = history_csv(middle_run(found).history, found.reduction.problem, found.reduction.scales);
  if (!file.empty()) write_file(file, csv);
  if (!folder.empty() && found.scene.output.history) write_file(folder + "/history.csv", csv);
}

}  // namespace

Exit run_impact(const ImpactArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  Scene scene = scene_with_options(arguments);
  const Problem asked = reduce(scene).problem;  // throws where it cannot be run
  refuse_what_is_too_large(asked, arguments.scene);
  std::optional<double> target_error;
  if (!arguments.accuracy.empty()) target_error = parse_accuracy(arguments.accuracy);
  check_errors_asked_for(errors_asked_for(arguments), scene);
  check_views(arguments, common);
  if (common.check) {
    const RunSize size = size_of(asked);
    return say_valid(fmt::format("{}: a scene that can be run: {}, {} runs of them", arguments.scene, in_words(size),
                                 scene.replicates),
                     {{"command", "impact"}, {"scene", arguments.scene}}, common, size);
  }
  if (!arguments.history.empty()) ensure_writable_file(arguments.history);
  ensure_views_can_be_made(arguments);
  const std::string folder = out_folder(arguments.scene, common);
  if (!folder.empty() && scene.output.history) ensure_writable_file(folder + "/history.csv");
  Store store(store_file(common));
  std::optional<AdvisedAccuracy> accuracy;
  if (target_error) {
    accuracy = advised_accuracy(scene, *target_error, store, common);
    scene = with_setting(scene, *accuracy);
  }
  const Reduction reduction = reduce(scene);
  ImpactFindings found{.scene = scene, .reduction = reduction, .accuracy = accuracy};
  if (accuracy && !accuracy->why_not.empty()) {
    deliver(impact_to_json(found), folder, common);
    return Exit::outcome_not_reached;
  }
  Campaign campaign(&store, common.threads);
  ImpactViews views(arguments, folder, reduction);
  const auto run = [&] {
    Progress progress("impact", scene.replicates);
    const auto middle = static_cast<std::size_t>(middle_replicate(scene.replicates));
    found.runs =
        campaign.evaluate(replicates_of(reduction.problem, scene.replicates), &progress, {views.observer(), middle});
    found.penetration = summarise(found.runs, reduction.problem, reduction.scales);
  };
  run();
  if (accuracy && accuracy->atlas) {
    if (against_atlas(found).empty()) {
      found.penetration = joined(found.penetration, *accuracy->atlas);
    } else {
      found.accuracy = by_runs_alone(*accuracy);
      scene = with_setting(scene, *found.accuracy);
      run();
    }
  }
  found.evidence =
      error_evidence(errors_asked_for(arguments), scene, reduction, found.runs, found.penetration, campaign);
  found.fields = views.fields();
  found.picture = arguments.picture;
  found.cost = cost_since(start, campaign);
  write_history(found, arguments.history, folder);
  deliver(impact_to_json(found), folder, common);
  views.draw(picture_title(scene, reduction, middle_run(found)));
  if (arguments.extrapolate && !found.evidence.extrapolation) return Exit::outcome_not_reached;
  const Outcome outcome = found.penetration.outcome;
  return outcome == Outcome::stopped || outcome == Outcome::passed_through ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
