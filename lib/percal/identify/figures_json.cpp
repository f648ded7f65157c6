#include "percal/identify/figures_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace percal::identification_json {
namespace {

using Json = nlohmann::json;

Json maybe(const std::optional<double>& value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }

}  // namespace

Json sphere_to_json(const ParticleScene& sphere) {
  return {{"particle", sphere.name},
          {"radius_m", sphere.radius},
          {"particle_density_kg_m3", sphere.density},
          {"speed_m_s", sphere.speed}};
}

Json formulations_to_json(const IdentifyJob& job, const Identification& found) {
  Json all = Json::array();
  for (std::size_t i = 0; i < job.gelatin.formulations.size(); ++i) {
    const Formulation& f = job.gelatin.formulations[i];
    all.push_back({{"concentration", f.concentration},
                   {"mu_quasistatic_as_given_Pa", f.mu_quasi_static},
                   {"mu_highrate_as_given_Pa", found.gelatin.high_rate[i]},
                   {"penetration_m", f.penetration},
                   {"penetration_sd_m", maybe(f.penetration_sd)},
                   {"in_law", f.measured}});
  }
  return all;
}

Json alpha_trials_to_json(const IdentifyJob& job, const Identification& found) {
  Json all = Json::array();
  const auto* scan = std::get_if<AlphaScan>(&job.alpha);
  if (!scan || !found.alpha_scan) return all;
  for (const AlphaTrial& trial : found.alpha_scan->trials) {
    const RidgePair& pair = scan->target[trial.pair];
    all.push_back({{"alpha", trial.alpha},
                   {"erosion_strain", pair.erosion_strain},
                   {"mu_as_given_Pa", pair.mu},
                   {"depth_m", trial.usable ? Json(job.penetration * std::exp(trial.log_misfit)) : Json(nullptr)}});
  }
  return all;
}

Json alpha_scores_to_json(const Identification& found) {
  Json all = Json::array();
  if (found.alpha_scan)
    for (const AlphaScore& score : found.alpha_scan->scores)
      all.push_back({{"alpha", score.alpha}, {"mean_deviation", score.mean}});
  return all;
}

Json mesh_study_to_json(const IdentifyJob& job, const Identification& found) {
  Json all = Json::array();
  for (std::size_t i = 0; i < found.mesh_study.size(); ++i) {
    const Penetration& p = found.mesh_study[i].penetration;
    all.push_back({{"elements_per_radius", job.mesh_study[i]},
                   {"outcome", word(p.outcome)},
                   {"depth_m", maybe(p.depth)},
                   {"depth_spread_m", maybe(p.spread)}});
  }
  return all;
}

Json mesh_cost_to_json(const IdentifyJob& job, const Identification& found) {
  Json all = Json::array();
  for (std::size_t i = 0; i < found.mesh_study.size(); ++i) {
    double seconds = 0;
    for (const Evaluation& run : found.mesh_study[i].runs) seconds += run.cpu_seconds;
    all.push_back({{"elements_per_radius", job.mesh_study[i]}, {"cpu_s", seconds}});
  }
  return all;
}

Json trends_to_json(const IdentifyJob& job) {
  Json all = Json::array();
  for (const TrendTable& trend : job.trends) {
    const Line line = linear_trend(trend.x, trend.y);
    all.push_back({{"name", trend.name},
                   {"x_name", trend.x_name},
                   {"y_name", trend.y_name},
                   {"x", trend.x},
                   {"y", trend.y},
                   {"reference_y", trend.reference.empty() ? Json(nullptr) : Json(trend.reference)},
                   {"slope", line.slope},
                   {"slope_error", maybe(line.slope_error)},
                   {"intercept", line.intercept},
                   {"intercept_error", maybe(line.intercept_error)},
                   {"reference_slope", maybe(trend.reference_slope)},
                   {"reference_intercept", maybe(trend.reference_intercept)}});
  }
  return all;
}

Json scaled_line_to_json(const IdentifyJob& job, const Identification& found) {
  if (!job.scaled_line) return nullptr;
  const Line line = depth_trend(job.scaled_line->shots);
  Json shots = Json::array(), cases = Json::array();
  for (const Shot& shot : job.scaled_line->shots)
    shots.push_back({{"particle_density_kg_m3", shot.density},
                     {"radius_m", shot.radius},
                     {"speed_m_s", shot.speed},
                     {"measured_m", shot.depth}});
  const double speed_ratio = *found.similarity.model.speed / *found.similarity.prototype.speed;
  for (const PredictedShot& shot : job.scaled_line->cases) {
    System prototype;
    prototype.radius = shot.radius;
    prototype.speed = shot.speed;
    prototype.particle_density = shot.density;
    cases.push_back({{"particle", shot.particle},
                     {"particle_density_kg_m3", shot.density},
                     {"radius_m", shot.radius},
                     {"speed_m_s", shot.speed},
                     {"depth_m", depth_from_model(line, found.similarity.model, speed_ratio, prototype)},
                     {"measured_m", maybe(shot.measured)},
                     {"reference_m", maybe(shot.reference)}});
  }
  return {{"name", job.scaled_line->name},
          {"slope_m2_s_kg", line.slope},
          {"intercept_m", line.intercept},
          {"shots", shots},
          {"cases", cases}};
}

Json left_out_to_json(const IdentifyJob& job, const Identification& found) {
  Json all = Json::array();
  if (!found.complete()) return all;
  const TargetMaterial target{job.tissue.density, found.tissue.mu, found.alpha, found.tissue.erosion->strain};
  const Scene scene = impact_scene(job, job.calibration, target, job.volumetric, job.ridge.elements_per_radius);
  for (const LeftOut& omission : reduce(scene).left_out)
    all.push_back({{"what", omission.what}, {"why", omission.why}});
  return all;
}

}  // namespace percal::identification_json
