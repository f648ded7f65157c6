#include "percal/study/study_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace percal {
namespace {

using Json = nlohmann::json;

Json finite(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
Json optional_json(const std::optional<double>& x) { return x ? finite(*x) : Json(nullptr); }

const char* word_of(Arithmetic arithmetic) { return arithmetic == Arithmetic::single_precision ? "single" : "double"; }

// The errors of a rung of the ladder of meshes; none for those that were not fitted, and for the other rungs.
const RungError* error_of(const Ladder& ladder, const ErrorVsTime& study, const Rung& rung) {
  const auto index = static_cast<std::size_t>(&rung - ladder.meshes.data());
  if (&rung < ladder.meshes.data() || index >= ladder.meshes.size() || index < study.first_used) return nullptr;
  return study.errors.empty() ? nullptr : &study.errors[index - study.first_used];
}

Json interval_to_json(const ErrorBand& interval) {
  return {{"value", finite(interval.value)}, {"low", finite(interval.low)}, {"high", finite(interval.high)}};
}

Json error_to_json(const RungError& error) {
  Json means;
  for (std::size_t c = 0; c < replicate_counts.size(); ++c)
    means[std::to_string(replicate_counts[c])] = interval_to_json(error.combined[c]);
  return {{"error", interval_to_json(error.signed_error)},
          {"fitted_depth_m", error.fitted_depth},
          {"uncertainty_m", optional_json(error.uncertainty)},
          {"discretisation_error", error.discretisation},
          {"error_of_mean_of", means}};
}

Json convergence_to_json(const Ladder& ladder, const ErrorVsTime& study) {
  const auto& found = study.convergence;
  if (!study.is_fitted()) {
    const bool has_fit = found.outcome == GridOutcome::fitted;
    return {{"outcome", has_fit ? "no depth above zero" : word(found.outcome)}};
  }
  return {{"outcome", word(found.outcome)},
          {"extrapolated_depth_m", study.limit.value},
          {"extrapolated_depth_low_m", study.limit.low},
          {"extrapolated_depth_high_m", study.limit.high},
          {"fitted_from_elements_per_radius", ladder.meshes[study.first_fitted].elements_per_radius},
          {"form", word(found.fit.form)},
          {"fine_weighted", found.fit.fine_weighted},
          {"a_m", found.fit.a},
          {"b_m", found.fit.b},
          {"order", found.fit.form == ErrorForm::first_and_second_order ? Json(nullptr) : Json(found.fit.order)},
          {"observed_order", found.observed_order},
          {"standard_deviation_m", found.fit.standard_deviation},
          {"data_range_m", found.data_range},
          {"safety_factor", found.safety_factor},
          {"is_smooth", found.is_smooth()},
          {"spread_of_a_run", study.model.noise},
          {"irregularity", study.model.irregularity}};
}

Json change_to_json(const Change& change) {
  return {{"elements_per_radius", change.elements_per_radius},
          {"share", optional_json(change.share)},
          {"standard_error", optional_json(change.standard_error)},
          {"is_significant", change.is_significant()},
          {"cost_ratio", finite(change.cost_ratio)}};
}

std::string cell(const std::optional<double>& x) { return x && std::isfinite(*x) ? fmt::format("{:.9g}", *x) : ""; }

}  // namespace

Json rung_to_json(const Rung& rung) {
  const auto& p = rung.penetration;
  Json outcomes = Json::array();
  for (const Outcome outcome : p.outcomes) outcomes.push_back(word(outcome));
  return {{"elements_per_radius", rung.elements_per_radius},
          {"elements", rung.elements},
          {"time_step_factor", rung.time_step_factor},
          {"arithmetic", word_of(rung.arithmetic)},
          {"replicates", rung.replicates},
          {"outcome", word(p.outcome)},
          {"outcomes", outcomes},
          {"depth_m", optional_json(p.depth)},
          {"depth_spread_m", optional_json(p.spread)},
          {"depth_standard_error_m", optional_json(p.standard_error)},
          {"depth_at_least_m", optional_json(p.at_least)},
          {"steps", rung.steps},
          {"element_steps", rung.element_steps},
          {"cpu_s", rung.cpu_seconds}};
}

Json advice_to_json(const AdvisedSetting& advice) {
  const auto found = [&](const auto& value) { return advice.is_found ? Json(value) : Json(nullptr); };
  return {{"target_error", advice.target},
          {"found", advice.is_found},
          {"why_not", advice.why_not},
          {"cost_estimated", advice.cost_is_estimated},
          {"elements_per_radius", found(advice.elements_per_radius)},
          {"replicates", found(advice.replicates)},
          {"arithmetic", found("single")},
          {"discretisation_error", found(advice.discretisation_error)},
          {"noise_error", found(advice.noise_error)},
          {"error", found(advice.error)},
          {"cpu_s", found(advice.cpu_seconds)},
          {"cpu_low_s", optional_json(advice.cpu_seconds_low)},
          {"cpu_high_s", optional_json(advice.cpu_seconds_high)}};
}

Json error_vs_time_to_json(const Ladder& ladder, const ErrorVsTime& study, const std::vector<AdvisedSetting>& advice) {
  Json meshes = Json::array(), half_steps = Json::array(), changes = Json::array(), advised = Json::array();
  for (const Rung& rung : ladder.meshes) {
    meshes.push_back(rung_to_json(rung));
    if (const RungError* error = error_of(ladder, study, rung)) meshes.back().update(error_to_json(*error));
  }
  for (const Rung& rung : ladder.half_steps) half_steps.push_back(rung_to_json(rung));
  for (const Change& change : study.half_step) changes.push_back(change_to_json(change));
  for (const AdvisedSetting& one : advice) advised.push_back(advice_to_json(one));
  return {{"meshes", meshes},
          {"half_steps", half_steps},
          {"double_precision", rung_to_json(ladder.double_precision)},
          {"convergence", convergence_to_json(ladder, study)},
          {"change_by_half_the_step", changes},
          {"change_by_double_precision", change_to_json(study.double_precision)},
          {"advice", advised},
          {"findings", study.findings}};
}

std::string error_vs_time_csv(const Ladder& ladder, const ErrorVsTime& study) {
  std::string csv =
      "elements_per_radius,elements,time_step_factor,arithmetic,replicates,outcome,depth_m,depth_spread_m,"
      "depth_standard_error_m,fitted_depth_m,uncertainty_m,error,error_low,error_high,discretisation_error";
  for (const int count : replicate_counts)
    csv += fmt::format(",error_of_mean_of_{0},error_of_mean_of_{0}_low,error_of_mean_of_{0}_high", count);
  csv += ",steps,element_steps,cpu_s\n";
  const auto add = [&](const Rung& rung) {
    const auto& p = rung.penetration;
    const RungError* error = error_of(ladder, study, rung);
    csv += fmt::format("{},{},{:.9g},{},{},{},{},{},{}", rung.elements_per_radius, rung.elements, rung.time_step_factor,
                       word_of(rung.arithmetic), rung.replicates, word(p.outcome), cell(p.depth), cell(p.spread),
                       cell(p.standard_error));
    std::vector<std::optional<double>> cells(6 + 3 * replicate_counts.size());
    if (error) {
      cells = {error->fitted_depth,     error->uncertainty,       error->signed_error.value,
               error->signed_error.low, error->signed_error.high, error->discretisation};
      for (const ErrorBand& mean : error->combined) cells.insert(cells.end(), {mean.value, mean.low, mean.high});
    }
    for (const auto& one : cells) csv += fmt::format(",{}", cell(one));
    csv += fmt::format(",{:.9g},{:.9g},{:.6g}\n", rung.steps, rung.element_steps, rung.cpu_seconds);
  };
  for (const Rung& rung : ladder.meshes) add(rung);
  for (const Rung& rung : ladder.half_steps) add(rung);
  add(ladder.double_precision);
  return csv;
}

}  // namespace percal
