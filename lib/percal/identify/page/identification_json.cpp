#include "percal/identify/page/identification_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "percal/card/card_json.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

// A value where there is one, else null.
template <class Value>
Json where(bool is_there, const Value& value) {
  return is_there ? Json(value) : Json(nullptr);
}

Json sphere_to_json(const ParticleScene& sphere) {
  return {{"particle", sphere.name},
          {"radius_m", sphere.radius},
          {"particle_density_kg_m3", sphere.density},
          {"speed_m_s", sphere.speed}};
}

Json calibration_to_json(const IdentifyJob& job) {
  Json calibration = sphere_to_json(job.calibration);
  calibration["penetration_m"] = job.penetration;
  calibration["penetration_standard_error_m"] = finite(job.penetration_error);
  return calibration;
}

Json model_to_json(const IdentifyJob& job, const Identification& found) {
  Json model = sphere_to_json(job.model), formulations = Json::array();
  for (std::size_t i = 0; i < job.gelatin.formulations.size(); ++i) {
    const Formulation& f = job.gelatin.formulations[i];
    formulations.push_back({{"concentration", f.concentration},
                            {"mu_quasistatic_as_given_Pa", f.mu_quasi_static},
                            {"mu_highrate_as_given_Pa", found.gelatin.high_rate[i]},
                            {"penetration_m", f.penetration},
                            {"penetration_sd_m", finite(f.penetration_sd)},
                            {"in_law", f.measured}});
  }
  model["material"] = job.gelatin.name;
  model["density_kg_m3"] = job.gelatin.density;
  model["formulations"] = formulations;
  return model;
}

// Of a scan: its trials at each known pair, and the score of each alpha between the candidates.
Json alpha_to_json(const IdentifyJob& job, const Identification& found) {
  const bool is_scanned = found.alpha_scan.has_value();
  const AlphaFinding scan = found.alpha_scan.value_or(AlphaFinding{});
  Json trials = Json::array(), scores = Json::array();
  for (const AlphaTrial& trial : scan.trials) {
    const RidgePair& pair = std::get<AlphaScan>(job.alpha).target[trial.pair];
    trials.push_back({{"alpha", trial.alpha},
                      {"erosion_strain", pair.erosion_strain},
                      {"mu_as_given_Pa", pair.mu},
                      {"depth_m", where(trial.usable, job.penetration * std::exp(trial.log_misfit))}});
  }
  for (const AlphaScore& score : scan.scores)
    scores.push_back({{"alpha", score.alpha}, {"mean_deviation", score.mean}});
  return {{"value", found.alpha},
          {"from", is_scanned ? "scan" : "given"},
          {"best", where(is_scanned, scan.best)},
          {"best_mean_deviation", where(is_scanned, scan.best_score)},
          {"mean_deviation", where(is_scanned, scan.score)},
          {"standard_error", where(is_scanned, scan.score_error)},
          {"indistinguishable_from", where(is_scanned, scan.lowest)},
          {"indistinguishable_to", where(is_scanned, scan.highest)},
          {"at_edge", scan.at_edge},
          {"ridge_is_in_sample", is_scanned},
          {"trials", trials},
          {"scores", scores}};
}

Json ridge_to_json(const IdentifyJob& job, const Identification& found) {
  Json ridge = Json::array();
  const double a = job.calibration.radius;
  for (const RidgePoint& point : found.ridge) {
    const bool is_found = point.inversion.outcome == InversionOutcome::found;
    const Penetration known = point.at_known ? point.at_known->penetration : Penetration{};
    ridge.push_back({{"erosion_strain", point.erosion_strain},
                     {"outcome", word(point.inversion.outcome)},
                     {"mu_as_given_Pa", where(is_found, point.mu)},
                     {"mu_true_Pa", where(is_found, true_modulus(point.mu, found.alpha, job.convention))},
                     {"relative_error_solver", where(is_found, point.solver_error)},
                     {"relative_error_data", where(is_found, point.data_error)},
                     {"dlnP_dlnmu", where(is_found, point.inversion.slope)},
                     {"evaluations", point.inversion.points.size()},
                     {"table_mu_as_given_Pa", where(point.known.has_value(), point.known.value_or(RidgePair{}).mu)},
                     {"depth_over_radius_at_table_pair", finite(over(known.depth, a))},
                     {"depth_over_radius_at_table_pair_spread", finite(over(known.spread, a))},
                     {"outcome_at_table_pair", where(point.at_known.has_value(), word(known.outcome))}});
  }
  return ridge;
}

Json similarity_to_json(const IdentifyJob& job, const Identification& found) {
  const SimilarityFinding& s = found.similarity;
  return {{"target_density_kg_m3", *s.model.target_density},
          {"modulus_ratio", s.modulus_ratio},
          {"penetration_m", s.penetration},
          {"formulation", job.gelatin.formulations[s.formulation].concentration},
          {"formulation_penetration_m", job.gelatin.formulations[s.formulation].penetration},
          {"formulation_mismatch", s.mismatch},
          {"mu_as_given_Pa", found.gelatin.high_rate[s.formulation]}};
}

Json tissue_to_json(const IdentifyJob& job, const Identification& found) {
  const TissueFinding& t = found.tissue;
  const auto as_true = [&](double as_given) { return true_modulus(as_given, found.alpha, job.convention); };
  return {{"name", job.tissue.name},
          {"mu_highrate_as_given_Pa", t.mu},
          {"mu_highrate_true_Pa", as_true(t.mu)},
          {"mu_quasistatic_as_given_Pa", t.mu_quasi_static},
          {"mu_quasistatic_true_Pa", as_true(t.mu_quasi_static)},
          {"youngs_quasistatic_as_given_Pa", t.youngs_quasi_static},
          {"youngs_quasistatic_true_Pa", as_true(t.youngs_quasi_static)},
          {"alpha", found.alpha},
          {"erosion_strain", t.erosion ? Json(t.erosion->strain) : Json(nullptr)},
          {"erosion_strain_error", t.erosion ? Json(t.erosion->error) : Json(nullptr)},
          {"strain_measure", word(job.measure)},
          {"convention", word(job.convention)}};
}

Json model_check_to_json(const Identification& found) {
  if (!found.model_check) return nullptr;
  const Penetration& p = found.model_check->penetration;
  return {{"depth_m", finite(p.depth)},
          {"depth_spread_m", finite(p.spread)},
          {"outcome", word(p.outcome)},
          {"expected_m", found.similarity.penetration}};
}

Json mesh_study_to_json(const IdentifyJob& job, const Identification& found) {
  Json all = Json::array();
  for (std::size_t i = 0; i < found.mesh_study.size(); ++i) {
    const Penetration& p = found.mesh_study[i].penetration;
    all.push_back({{"elements_per_radius", job.mesh_study[i]},
                   {"outcome", word(p.outcome)},
                   {"depth_m", finite(p.depth)},
                   {"depth_spread_m", finite(p.spread)}});
  }
  return all;
}

// CPU seconds of each mesh's runs, whether they were made now or taken from the store.
Json mesh_cost_to_json(const IdentifyJob& job, const Identification& found) {
  Json all = Json::array();
  for (std::size_t i = 0; i < found.mesh_study.size(); ++i) {
    double seconds = 0;
    for (const Evaluation& run : found.mesh_study[i].runs) seconds += run.cpu_seconds;
    all.push_back({{"elements_per_radius", job.mesh_study[i]}, {"cpu_s", seconds}});
  }
  return all;
}

const char* material_word(const PredictionMaterial& material) {
  if (std::holds_alternative<PairGiven>(material)) return "given";
  return std::holds_alternative<IdentifiedTissue>(material) ? "tissue" : "model";
}

Json predictions_to_json(const Identification& found) {
  Json all = Json::array();
  for (const PredictionResult& result : found.predictions)
    for (std::size_t i = 0; i < result.shots.size(); ++i) {
      const PredictedShot& shot = result.set->shots[i];
      const Shooting& shooting = result.shots[i];
      const Penetration& p = shooting.penetration;
      all.push_back({{"system", result.set->system},
                     {"material", material_word(result.set->material)},
                     {"elements_per_radius", result.set->elements_per_radius},
                     {"particle", shot.particle},
                     {"particle_density_kg_m3", shot.density},
                     {"mu_true_Pa", shooting.reduction.mu_true},
                     {"target_density_kg_m3", result.set->target_density},
                     {"radius_m", shot.radius},
                     {"speed_m_s", shot.speed},
                     {"outcome", word(p.outcome)},
                     {"runs", shooting.runs.size()},
                     {"depth_m", finite(p.depth)},
                     {"depth_from", p.is_joined ? "runs and atlas" : "runs"},
                     {"depth_spread_m", finite(p.spread)},
                     {"depth_standard_error_m", finite(p.standard_error)},
                     {"depth_at_least_m", finite(p.at_least)},
                     {"measured_m", finite(shot.measured)},
                     {"thesis_fe_m", finite(shot.reference)},
                     {"mach", shooting.reduction.mach},
                     {"energy_worst_closure", p.worst_closure},
                     {"numerical_loss", p.energy.numerical_loss()}});
    }
  return all;
}

Json prediction_means_to_json(const Identification& found) {
  Json all = Json::array();
  for (const PredictionResult& result : found.predictions)
    all.push_back({{"system", result.set->system},
                   {"target_density_kg_m3", result.set->target_density},
                   {"mean_deviation_from_measured", finite(result.mean_deviation_from_measured)},
                   {"mean_deviation_from_thesis_fe", finite(result.mean_deviation_from_reference)}});
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
                   {"reference_y", where(!trend.reference.empty(), trend.reference)},
                   {"slope", line.slope},
                   {"slope_error", finite(line.slope_error)},
                   {"intercept", line.intercept},
                   {"intercept_error", finite(line.intercept_error)},
                   {"reference_slope", finite(trend.reference_slope)},
                   {"reference_intercept", finite(trend.reference_intercept)}});
  }
  return all;
}

// The line through the model's shots, these, and the depths that it gives; null where the job has none.
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
                     {"measured_m", finite(shot.measured)},
                     {"reference_m", finite(shot.reference)}});
  }
  return {{"name", job.scaled_line->name},
          {"slope_m2_s_kg", line.slope},
          {"intercept_m", line.intercept},
          {"shots", shots},
          {"cases", cases}};
}

// What the calibration impact at the identified pair does without; empty where there is no pair.
Json left_out_to_json(const IdentifyJob& job, const Identification& found) {
  Json all = Json::array();
  if (!found.complete()) return all;
  for (const LeftOut& omission : reduce(identified_scene(job, found)).left_out)
    all.push_back({{"what", omission.what}, {"why", omission.why}});
  return all;
}

Json comparisons_to_json(const IdentifyJob& job, const std::vector<ComparedNumbers>& comparisons) {
  Json all = Json::array();
  for (const ComparedNumbers& one : comparisons) all.push_back(comparison_to_json(job, one));
  return all;
}

}  // namespace

Json comparison_to_json(const IdentifyJob& job, const ComparedNumbers& comparison) {
  Json rows = Json::array();
  double sum = 0;
  int count = 0;
  for (const ComparedNumber& row : comparison.rows) {
    Json difference = nullptr;
    if (row.reference && row.ours && *row.reference != 0) {
      difference = (*row.ours - *row.reference) / *row.reference;
      sum += std::abs(difference.get<double>());
      ++count;
    }
    rows.push_back({{"what", row.what},
                    {"unit", row.unit},
                    {"reference", finite(row.reference)},
                    {"ours", finite(row.ours)},
                    {"difference", difference},
                    {"error", finite(row.error)},
                    {"digits", row.digits},
                    {"remark", row.remark}});
  }
  return {{"name", comparison.name},
          {"note", comparison.note},
          {"reference", comparison.beside.empty() ? job.reference_name : comparison.beside},
          {"mean_difference", where(count > 0, sum / count)},
          {"rows", rows}};
}

Json identification_to_json(const IdentifyJob& job, const Identification& found, const page::Cost& cost) {
  const GelatinLaw& law = found.gelatin.law;
  Json json = page::result_head("identify", {{"job", job.file}, {"toml", job.text}});
  json.update(
      {{"title", job.title},
       {"complete", found.complete()},
       {"layer",
        {{"depth_over_radius", job.layer.depth},
         {"width_over_radius", job.layer.width},
         {"width_was_chosen", job.layer.width_was_chosen}}},
       {"calibration", calibration_to_json(job)},
       {"model", model_to_json(job, found)},
       {"gelatin_law", {{"k_Pa", law.factor}, {"n", law.exponent}, {"k_standard_error_Pa", finite(law.factor_error)}}},
       {"alpha", alpha_to_json(job, found)},
       {"ridge", ridge_to_json(job, found)},
       {"similarity", similarity_to_json(job, found)},
       {"skin", tissue_to_json(job, found)},
       {"model_check", model_check_to_json(found)},
       {"mesh_study", mesh_study_to_json(job, found)},
       {"predictions", predictions_to_json(found)},
       {"prediction_means", prediction_means_to_json(found)},
       {"trends", trends_to_json(job)},
       {"scaled_line", scaled_line_to_json(job, found)},
       {"left_out", left_out_to_json(job, found)},
       {"cards", cards_to_json(found.card ? std::vector{*found.card} : std::vector<CardMaterial>{})},
       {"steps", comparisons_to_json(job, found.steps)},
       {"tables", comparisons_to_json(job, found.tables)},
       {"findings", found.findings},
       {"cost", page::cost_to_json(cost)}});
  json["cost"]["mesh_study"] = mesh_cost_to_json(job, found);
  return json;
}

}  // namespace percal
