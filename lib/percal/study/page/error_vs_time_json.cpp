// A study of error against processor time as result.json and as CSV.                                   docs/formats/study.md
#include <fmt/format.h>

#include "percal/page/numbers.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/study/page/error_vs_time.hpp"

namespace percal {

using namespace page;

namespace {

Json band_to_json(const ErrorBand& band) {
  return {{"value", finite(band.value)}, {"low", finite(band.low)}, {"high", finite(band.high)}};
}

Json error_to_json(const RungError& error) {
  Json means;
  for (std::size_t c = 0; c < replicate_counts.size(); ++c)
    means[std::to_string(replicate_counts[c])] = band_to_json(error.combined[c]);
  return {{"error", band_to_json(error.signed_error)},
          {"fitted_depth_m", error.fitted_depth},
          {"uncertainty_m", finite(error.uncertainty)},
          {"discretisation_error", error.discretisation},
          {"error_of_mean_of", means}};
}

// What the study says of a rung; null where it says nothing.
Json rung_of_study(const Scene& scene, const Rung& rung, const LadderModel* model, const ErrorBand* from_finest,
                   const RungError* error) {
  Json json = rung_to_json(rung);
  json["element_over_erosion_length"] = finite(element_over_erosion_length(on_mesh(scene, rung.elements_per_radius)));
  json["spread_of_a_run"] = model ? Json(model->noise.on(rung.elements_per_radius)) : Json(nullptr);
  json["from_finest"] = from_finest ? band_to_json(*from_finest) : Json(nullptr);
  json.update(error ? error_to_json(*error) : emptied(error_to_json({})));
  return json;
}

Json mesh_of_study(const Scene& scene, const Ladder& ladder, const ErrorVsTime& study, std::size_t i) {
  if (i < study.first_used) return rung_of_study(scene, ladder.meshes[i], nullptr, nullptr, nullptr);
  const std::size_t used = i - study.first_used;
  return rung_of_study(scene, ladder.meshes[i], &study.model, &study.from_finest[used],
                       study.errors.empty() ? nullptr : &study.errors[used]);
}

Json bare_rung(const Scene& scene, const Rung& rung) { return rung_of_study(scene, rung, nullptr, nullptr, nullptr); }

Json convergence_to_json(const Ladder& ladder, const ErrorVsTime& study) {
  const auto& found = study.convergence;
  const auto& fit = found.fit;
  const Json numbers{{"extrapolated_depth_m", study.limit.value},
                     {"extrapolated_depth_low_m", study.limit.low},
                     {"extrapolated_depth_high_m", study.limit.high},
                     {"fitted_from_elements_per_radius", ladder.meshes.at(study.first_fitted).elements_per_radius},
                     {"form", word(fit.form)},
                     {"fine_weighted", fit.fine_weighted},
                     {"a_m", fit.a},
                     {"b_m", fit.b},
                     {"order", fit.form == ErrorForm::first_and_second_order ? Json(nullptr) : Json(fit.order)},
                     {"observed_order", found.observed_order},
                     {"standard_deviation_m", fit.standard_deviation},
                     {"data_range_m", found.data_range},
                     {"safety_factor", found.safety_factor},
                     {"is_smooth", found.is_smooth()},
                     {"irregularity", study.model.irregularity}};
  Json json = study.is_fitted() ? numbers : emptied(numbers);
  const bool is_below_zero = found.outcome == GridOutcome::fitted && !study.is_fitted();
  json["outcome"] = !study.has_limit() ? "no limit" : is_below_zero ? "no depth above zero" : word(found.outcome);
  const auto answered = [&](double value) { return study.is_answered() ? Json(value) : Json(nullptr); };
  json["spread_of_a_run"] = answered(study.model.noise.on_usual_mesh);
  json["spread_order"] = answered(study.model.noise.order);
  return json;
}

Json change_to_json(const Change& change) {
  return {{"elements_per_radius", change.elements_per_radius},
          {"share", finite(change.share)},
          {"standard_error", finite(change.standard_error)},
          {"is_significant", change.is_significant()},
          {"cost_ratio", finite(change.cost_ratio)}};
}

}  // namespace

Json advice_to_json(const AdvisedSetting& advice) {
  const auto found = [&](const auto& value) { return advice.is_found ? Json(value) : Json(nullptr); };
  return {{"target_error", advice.target},
          {"found", advice.is_found},
          {"why_not", advice.why_not},
          {"cost_estimated", advice.cost_is_estimated},
          {"elements_per_radius", found(advice.elements_per_radius)},
          {"replicates", found(advice.replicates)},
          {"arithmetic", found("single")},
          {"discretisation_error", finite(advice.discretisation_error)},
          {"noise_error", found(advice.noise_error)},
          {"error", found(advice.error)},
          {"cpu_s", found(advice.cpu_seconds)},
          {"cpu_low_s", finite(advice.cpu_seconds_low)},
          {"cpu_high_s", finite(advice.cpu_seconds_high)}};
}

Json error_vs_time_to_json(const Scene& scene, const Ladder& ladder, const ErrorVsTime& study,
                           const std::vector<AdvisedSetting>& advice, const Cost& cost) {
  Json meshes = Json::array(), half_steps = Json::array(), changes = Json::array(), advised = Json::array();
  for (std::size_t i = 0; i < ladder.meshes.size(); ++i) meshes.push_back(mesh_of_study(scene, ladder, study, i));
  for (const Rung& rung : ladder.half_steps) half_steps.push_back(bare_rung(scene, rung));
  for (const Change& change : study.half_step) changes.push_back(change_to_json(change));
  for (const AdvisedSetting& one : advice) advised.push_back(advice_to_json(one));
  Json json = study_head(study_kind::error_vs_time, input_of(scene), cost);
  json.update({{"ladder",
                {{"elements_per_radius", ladder.options.meshes},
                 {"replicates", ladder.options.replicates},
                 {"time_step_factor", finite(ladder.options.time_step_factor)},
                 {"erosion_length_m", finite(erosion_length(scene.target))}}},
               {"meshes", meshes},
               {"half_steps", half_steps},
               {"double_precision", bare_rung(scene, ladder.double_precision)},
               {"convergence", convergence_to_json(ladder, study)},
               {"change_by_half_the_step", changes},
               {"change_by_double_precision", change_to_json(study.double_precision)},
               {"advice", advised},
               {"findings", study.findings},
               {"level", error_level},
               {"seed", resampling_seed}});
  return json;
}

std::string error_vs_time_csv(const Json& result) {
  std::vector<ResultColumn> columns;
  for (const char* key : {"elements_per_radius", "elements", "time_step_factor", "arithmetic", "replicates", "outcome",
                          "depth_m", "depth_spread_m", "depth_standard_error_m", "fitted_depth_m", "uncertainty_m"})
    columns.push_back({key, key});
  const auto add_band = [&](const std::string& name, const std::string& path) {
    columns.insert(columns.end(),
                   {{name, path + "/value"}, {name + "_low", path + "/low"}, {name + "_high", path + "/high"}});
  };
  for (const char* key : {"element_over_erosion_length", "spread_of_a_run"}) columns.push_back({key, key});
  add_band("from_finest", "from_finest");
  add_band("error", "error");
  columns.push_back({"discretisation_error", "discretisation_error"});
  for (const int count : replicate_counts)
    add_band(fmt::format("error_of_mean_of_{}", count), fmt::format("error_of_mean_of/{}", count));
  for (const char* key : {"steps", "element_steps", "cpu_s"}) columns.push_back({key, key});
  std::vector<Json> rungs = list(result, "meshes");
  for (const Json& rung : list(result, "half_steps")) rungs.push_back(rung);
  rungs.push_back(at(result, "double_precision"));
  return as_csv(columns, rungs);
}

}  // namespace percal
