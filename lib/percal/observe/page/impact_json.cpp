#include "percal/observe/page/impact_json.hpp"

#include <fmt/format.h>

#include <cmath>

#include "percal/observe/block_reach.hpp"
#include "percal/observe/history.hpp"
#include "percal/observe/page/depth_error.hpp"
#include "percal/observe/page/field_measures.hpp"
#include "percal/observe/stored_run.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/units/quantity.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }
Json count_or_null(const std::optional<int>& count) { return count ? Json(*count) : Json(nullptr); }

// What of the mesh the program chose, and what came of it.
Json mesh_to_json(const Reduction& reduction) {
  const Problem& p = reduction.problem;
  return {{"elements_per_radius", p.elements_per_radius},
          {"width_over_radius", p.width},
          {"width_was_chosen", reduction.mesh.width_was_chosen},
          {"columns", reduction.mesh.columns},
          {"graded_columns", p.graded_columns},
          {"graded_columns_were_chosen", reduction.mesh.columns_were_chosen},
          {"growth", reduction.mesh.growth},
          {"computed_share", p.geometry == Geometry::block ? Json(computed_share(p)) : Json(nullptr)}};
}

Json atlas_to_json(const std::optional<AtlasDepth>& atlas) {
  if (!atlas) return nullptr;
  return {{"depth_m", atlas->depth},
          {"low_m", atlas->low()},
          {"high_m", atlas->high()},
          {"width_over_radius", atlas->width}};
}

Json ladder_to_json(const AdvisedAccuracy& advised) {
  if (advised.atlas) return nullptr;
  return {{"elements_per_radius", advised.studied_meshes},
          {"replicates", advised.studied_replicates},
          {"time_step_factor", advised.time_step_factor}};
}

Json accuracy_to_json(const AdvisedAccuracy& advised) {
  return {{"target_error", advised.target_error},
          {"why_not", text_or_null(advised.why_not)},
          {"cost_estimated", advised.is_extrapolated},
          {"elements_per_radius", finite(advised.elements_per_radius)},
          {"replicates", count_or_null(advised.replicates)},
          {"arithmetic", advised.elements_per_radius ? Json("single") : Json(nullptr)},
          {"discretisation_error", finite(advised.discretisation_error)},
          {"noise_error", finite(advised.noise_error)},
          {"error", finite(advised.error)},
          {"cpu_s", finite(advised.cpu_seconds)},
          {"cpu_low_s", finite(advised.cpu_seconds_low)},
          {"cpu_high_s", finite(advised.cpu_seconds_high)},
          {"from", advised.atlas ? "the atlas" : "the study"},
          {"atlas", atlas_to_json(advised.atlas)},
          {"ladder", ladder_to_json(advised)},
          {"study_was_kept", advised.study_was_kept},
          {"study_cpu_s", advised.study_cpu_seconds}};
}

// How many elements each criterion took out, and how many went because they were distorted. Null where nothing erodes.
Json eroded_by_to_json(const Problem& problem, const ImpactResult& r) {
  static constexpr const char* names[] = {nullptr, "strain", "stress", "energy"};  // by the alternatives of Erosion
  if (std::holds_alternative<NoErosion>(problem.erosion)) return nullptr;
  Json by{{names[problem.erosion.index()], r.eroded - r.distorted}, {"distortion", r.distorted}};
  if (problem.further_erosion.is_empty()) return by;
  if (std::holds_alternative<StrainErosion>(problem.erosion)) by["strain"] = r.eroded_by.strain;
  if (std::holds_alternative<StressErosion>(problem.erosion) || problem.further_erosion.stress)
    by["stress"] = r.eroded_by.stress;
  if (problem.further_erosion.energy) by["energy"] = r.eroded_by.energy;
  return by;
}

Json run_to_json(const Evaluation& run, const Problem& replicate, const Scales& scales, double depth) {
  const ImpactResult& r = run.result;
  return {{"elements_per_radius", replicate.elements_per_radius},
          {"speed_factor", replicate.speed_factor},
          {"outcome", word(r.outcome)},
          {"reason", text_or_null(r.reason)},
          {"depth_m", finite(depth)},
          {"speeds_behind_m_s", speeds_behind_to_json(r, scales)},
          {"final", aftermath_to_json(r.aftermath, scales)},
          {"steps", r.steps},
          {"elements", r.elements},
          {"eroded", r.eroded},
          {"eroded_by", eroded_by_to_json(replicate, r)},
          {"smallest_jacobian", finite(r.smallest_jacobian)},
          {"smallest_step_over_first", finite(r.smallest_step)},
          {"sideways_m", finite(r.sideways * scales.radius)},
          {"turn_rad", finite(r.turn)},
          {"across_m", r.in_space ? finite(r.in_space->across * scales.radius) : Json(nullptr)},
          {"turn_axis", r.in_space ? Json(r.in_space->axis) : Json(nullptr)},
          {"energy_closure", finite(r.energy.closure())},
          {"cpu_s", finite(run.cpu_seconds)},
          {"reused", run.reused}};
}

// Null where there is no depth. A study's errors hold for the depth that it chose mesh and replicates for.
Json error_to_json(const ImpactFindings& f) {
  if (!f.penetration.depth) return nullptr;
  ErrorEvidence evidence = f.evidence;
  if (f.accuracy && !f.penetration.is_joined) {
    evidence.discretisation = f.accuracy->discretisation_error;
    evidence.noise = f.accuracy->noise_error;
  }
  return depth_error_to_json(depth_error(f.scene, f.reduction, f.penetration, evidence));
}

// What the runs say; of none: null.
Json outcome_to_json(const ImpactFindings& f) {
  const bool ran = !f.runs.empty();
  const int count = static_cast<int>(f.runs.size());
  const ImpactResult middle = ran ? f.runs[middle_replicate(count)].result : ImpactResult{};
  const auto replicates = replicates_of(f.reduction.problem, count);
  const auto of_a_run = [&](const auto& value) { return ran ? Json(value) : Json(nullptr); };
  Json runs = Json::array();
  for (std::size_t k = 0; k < f.runs.size(); ++k)
    runs.push_back(run_to_json(f.runs[k], replicates[k], f.reduction.scales, f.penetration.depths[k]));
  return {
      {"outcome", of_a_run(word(f.penetration.outcome))},
      {"depth_m", finite(f.penetration.depth)},
      {"depth_from", of_a_run(f.penetration.is_joined ? "runs and atlas" : "runs")},
      {"depth_spread_m", finite(f.penetration.spread)},
      {"depth_standard_error_m", finite(f.penetration.standard_error)},
      {"depth_at_least_m", finite(f.penetration.at_least)},
      {"depth_error", error_to_json(f)},
      {"extrapolation", extrapolation_to_json(f.evidence.extrapolation)},
      {"steps", of_a_run(middle.steps)},
      {"elements", of_a_run(middle.elements)},
      {"element_steps", of_a_run(middle.element_steps)},
      {"energy", of_a_run(energy_to_json(f.penetration.energy))},
      {"energy_worst_closure", of_a_run(finite(f.penetration.worst_closure))},
      {"history", middle.history.empty() ? Json(nullptr)
                                         : history_to_json(middle.history, f.reduction.problem, f.reduction.scales)},
      {"runs", runs}};
}

}  // namespace

std::string against_atlas(const ImpactFindings& f) {
  const AtlasDepth& atlas = *f.accuracy->atlas;
  const std::string expected = format_quantity(atlas.depth, dimension::length);
  if (!f.penetration.depth)
    return fmt::format("The atlas expects this shot to stop at {}, and not every run did.", expected);
  const double depth = *f.penetration.depth;
  double allowed = allowed_apart(atlas, static_cast<int>(f.runs.size()));
  if (f.reduction.problem.width < atlas.width)
    allowed +=
        depth_error(f.scene, f.reduction, f.penetration).of(DepthErrorSource::wall).half_width.value_or(0) / depth;
  const double apart = std::log(atlas.depth / depth);
  if (std::abs(apart) <= allowed) return "";
  return fmt::format("The atlas expects {}, {:.2g} % {} than these runs, where the errors of both allow {:.2g} %.",
                     expected, 100 * std::abs(std::expm1(apart)), apart > 0 ? "more" : "less", 100 * allowed);
}

Json impact_to_json(const ImpactFindings& f) {
  Json left_out = Json::array(), sentences = f.reduction.warnings;
  for (const LeftOut& omission : f.reduction.left_out)
    left_out.push_back({{"what", omission.what}, {"why", omission.why}});
  const FieldMeasures measures = field_measures(f.runs, f.reduction.problem, f.reduction.scales);
  if (!f.runs.empty())
    for (const auto& list :
         {warnings(f.penetration, f.runs), warnings(measures, f.runs), warnings_of_reach(f.reduction.problem, f.runs)})
      for (const std::string& warning : list) sentences.push_back(warning);
  for (const std::string& note : f.evidence.notes) sentences.push_back(note);
  if (f.accuracy && f.accuracy->atlas && !f.runs.empty() && !f.penetration.is_joined)
    if (const std::string words = against_atlas(f); !words.empty()) sentences.push_back(words);
  Json result = page::result_head("impact", {{"scene", f.scene.source}, {"toml", scene_to_toml(f.scene, "")}});
  result.update(outcome_to_json(f));
  result.update(field_measures_to_json(measures, f.scene, f.reduction, f.penetration, f.runs));
  result.update({{"mu_as_given_Pa", f.scene.target.mu_as_given},
                 {"mu_true_Pa", f.reduction.mu_true},
                 {"convention", word(f.scene.target.convention)},
                 {"bulk_modulus_Pa", f.reduction.bulk_modulus},
                 {"bulk_was_chosen", f.reduction.bulk_was_chosen},
                 {"mach", f.reduction.mach},
                 {"mesh", mesh_to_json(f.reduction)},
                 {"erosion_length_m", finite(erosion_length(f.scene.target))},
                 {"element_over_erosion_length", finite(element_over_erosion_length(f.scene))},
                 {"fields", f.fields ? Json{{"list", f.fields->list}, {"frames", f.fields->frames}} : Json(nullptr)},
                 {"picture", text_or_null(f.picture)},
                 {"accuracy", f.accuracy ? accuracy_to_json(*f.accuracy) : Json(nullptr)},
                 {"left_out", left_out},
                 {"findings", sentences},
                 {"cost", page::cost_to_json(f.cost)}});
  return result;
}

}  // namespace percal
