#include "percal/identify/result_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "percal/base/version.hpp"
#include "percal/card/card_json.hpp"
#include "percal/identify/figures_json.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

using Json = nlohmann::json;

Json maybe(const std::optional<double>& value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }

Json table_to_json(const IdentifyJob& job, const ComparisonTable& table) {
  Json rows = Json::array();
  for (const ComparedNumber& row : table.rows)
    rows.push_back({{"what", row.what},
                    {"unit", row.unit},
                    {"reference", maybe(row.reference)},
                    {"ours", maybe(row.ours)},
                    {"difference", maybe(row.difference())},
                    {"error", maybe(row.error)},
                    {"remark", row.remark}});
  return {{"name", table.name},
          {"note", table.note},
          {"reference", table.beside.empty() ? job.reference_name : table.beside},
          {"mean_difference", maybe(table.mean_difference())},
          {"rows", rows}};
}

Json tables_to_json(const IdentifyJob& job, const std::vector<ComparisonTable>& tables) {
  Json all = Json::array();
  for (const ComparisonTable& table : tables) all.push_back(table_to_json(job, table));
  return all;
}

Json ridge_to_json(const IdentifyJob& job, const Identification& found) {
  Json ridge = Json::array();
  for (const RidgePoint& point : found.ridge) {
    const bool is_found = point.inversion.outcome == InversionOutcome::found;
    Json entry{{"erosion_strain", point.erosion_strain},
               {"outcome", word(point.inversion.outcome)},
               {"mu_as_given_Pa", is_found ? Json(point.mu) : Json(nullptr)},
               {"mu_true_Pa", is_found ? Json(true_modulus(point.mu, found.alpha, job.convention)) : Json(nullptr)},
               {"relative_error_solver", is_found ? Json(point.solver_error) : Json(nullptr)},
               {"relative_error_data", is_found ? Json(point.data_error) : Json(nullptr)},
               {"dlnP_dlnmu", is_found ? Json(point.inversion.slope) : Json(nullptr)},
               {"evaluations", point.inversion.points.size()},
               {"depth_over_radius_at_table_pair", nullptr}};
    if (point.known) entry["table_mu_as_given_Pa"] = point.known->mu;
    if (point.at_known) {
      const double a = job.calibration.radius;
      const Penetration& p = point.at_known->penetration;
      entry["depth_over_radius_at_table_pair"] = p.depth ? Json(*p.depth / a) : Json(nullptr);
      entry["depth_over_radius_at_table_pair_spread"] = p.spread ? Json(*p.spread / a) : Json(nullptr);
      entry["outcome_at_table_pair"] = word(p.outcome);
    }
    ridge.push_back(entry);
  }
  return ridge;
}

Json alpha_to_json(const IdentifyJob& job, const Identification& found) {
  if (!found.alpha_scan) return {{"value", found.alpha}, {"from", "given"}};
  const AlphaFinding& scan = *found.alpha_scan;
  return {{"value", found.alpha},
          {"from", "scan"},
          {"best", scan.best},
          {"best_mean_deviation", scan.best_score},
          {"mean_deviation", scan.score},
          {"standard_error", scan.score_error},
          {"indistinguishable_from", scan.lowest},
          {"indistinguishable_to", scan.highest},
          {"at_edge", scan.at_edge},
          {"ridge_is_in_sample", true},
          {"trials", identification_json::alpha_trials_to_json(job, found)},
          {"scores", identification_json::alpha_scores_to_json(found)}};
}

Json tissue_to_json(const IdentifyJob& job, const Identification& found) {
  const TissueFinding& t = found.tissue;
  return {{"name", job.tissue.name},
          {"mu_highrate_as_given_Pa", t.mu},
          {"mu_highrate_true_Pa", true_modulus(t.mu, found.alpha, job.convention)},
          {"mu_quasistatic_as_given_Pa", t.mu_quasi_static},
          {"youngs_quasistatic_as_given_Pa", t.youngs_quasi_static},
          {"youngs_quasistatic_true_Pa", true_modulus(t.youngs_quasi_static, found.alpha, job.convention)},
          {"alpha", found.alpha},
          {"erosion_strain", t.erosion ? Json(t.erosion->strain) : Json(nullptr)},
          {"erosion_strain_error", t.erosion ? Json(t.erosion->error) : Json(nullptr)},
          {"strain_measure", word(job.measure)},
          {"convention", word(job.convention)}};
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

std::string word(const PredictionMaterial& material) {
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
                     {"material", word(result.set->material)},
                     {"elements_per_radius", result.set->elements_per_radius},
                     {"particle", shot.particle},
                     {"particle_density_kg_m3", shot.density},
                     {"mu_true_Pa", shooting.reduction.mu_true},
                     {"target_density_kg_m3", result.set->target_density},
                     {"radius_m", shot.radius},
                     {"speed_m_s", shot.speed},
                     {"outcome", word(p.outcome)},
                     {"depth_m", maybe(p.depth)},
                     {"depth_spread_m", maybe(p.spread)},
                     {"depth_at_least_m", maybe(p.at_least)},
                     {"measured_m", maybe(shot.measured)},
                     {"thesis_fe_m", maybe(shot.reference)},
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
                   {"mean_deviation_from_measured", maybe(result.mean_deviation_from_measured)},
                   {"mean_deviation_from_thesis_fe", maybe(result.mean_deviation_from_reference)}});
  return all;
}

Json model_check_to_json(const Identification& found) {
  if (!found.model_check) return nullptr;
  const Penetration& p = found.model_check->penetration;
  return {{"depth_m", maybe(p.depth)},
          {"depth_spread_m", maybe(p.spread)},
          {"outcome", word(p.outcome)},
          {"expected_m", found.similarity.penetration}};
}

Json calibration_to_json(const IdentifyJob& job) {
  Json calibration = identification_json::sphere_to_json(job.calibration);
  calibration["penetration_m"] = job.penetration;
  calibration["penetration_standard_error_m"] = maybe(job.penetration_error);
  return calibration;
}

Json model_to_json(const IdentifyJob& job, const Identification& found) {
  Json model = identification_json::sphere_to_json(job.model);
  model["material"] = job.gelatin.name;
  model["density_kg_m3"] = job.gelatin.density;
  model["formulations"] = identification_json::formulations_to_json(job, found);
  return model;
}

}  // namespace

Json identification_to_json(const IdentifyJob& job, const Identification& found, const IdentifyCost& cost) {
  using namespace identification_json;
  const GelatinLaw& law = found.gelatin.law;
  return {
      {"schema", result_schema},
      {"percal", version()},
      {"command", "identify"},
      {"isa", cost.instruction_level},
      {"input", {{"job", job.file}, {"toml", read_file(job.file)}}},
      {"title", job.title},
      {"complete", found.complete()},
      {"calibration", calibration_to_json(job)},
      {"model", model_to_json(job, found)},
      {"gelatin_law", {{"k_Pa", law.factor}, {"n", law.exponent}, {"k_standard_error_Pa", maybe(law.factor_error)}}},
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
      {"steps", tables_to_json(job, found.steps)},
      {"tables", tables_to_json(job, found.tables)},
      {"findings", found.findings},
      {"cost",
       {{"runs", cost.runs},
        {"reused", cost.reused},
        {"wall_s", cost.wall_seconds},
        {"cpu_s", cost.cpu_seconds},
        {"mesh_study", mesh_cost_to_json(job, found)}}}};
}

}  // namespace percal
