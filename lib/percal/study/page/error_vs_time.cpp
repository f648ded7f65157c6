#include "percal/study/page/error_vs_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"

namespace percal {

using namespace page;

namespace {

// --- as JSON ------------------------------------------------------------------------------------------------------

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

// Null errors where the rung was not fitted.
Json rung_with_error(const Rung& rung, const RungError* error) {
  Json json = rung_to_json(rung);
  json.update(error ? error_to_json(*error) : emptied(error_to_json({})));
  return json;
}

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
                     {"spread_of_a_run", study.model.noise},
                     {"irregularity", study.model.irregularity}};
  Json json = study.is_fitted() ? numbers : emptied(numbers);
  const bool is_below_zero = found.outcome == GridOutcome::fitted && !study.is_fitted();
  json["outcome"] = is_below_zero ? "no depth above zero" : word(found.outcome);
  return json;
}

Json change_to_json(const Change& change) {
  return {{"elements_per_radius", change.elements_per_radius},
          {"share", finite(change.share)},
          {"standard_error", finite(change.standard_error)},
          {"is_significant", change.is_significant()},
          {"cost_ratio", finite(change.cost_ratio)}};
}

// --- the page -----------------------------------------------------------------------------------------------------

std::string bounded(const std::string& low, const std::optional<double>& high, const std::string& high_words) {
  return low + " to " + (high ? high_words : "no bound");
}

Table worth_table(const Json& result) {
  Table table{
      .caption = "",
      .rows = {{"mesh", "depth", "error", "interval, %"}},
      .notes = {"Mesh: elements per radius. Error: against the extrapolated depth; then with the noise of one run "
                "or of a mean of so many. Time: of the processor, for one run."}};
  std::vector<std::string>& header = table.rows.front();
  for (const int count : replicate_counts) header.push_back(counted(count, "run"));
  header.emplace_back("time");
  for (const Json& mesh : list(result, "meshes")) {
    const Json& error = at(mesh, "error");
    const auto low = number(error, "low"), high = number(error, "high");
    table.rows.push_back(
        {shown(number(mesh, "elements_per_radius")), depth_or_outcome(mesh), signed_percent(number(error, "value")),
         low ? bounded(fmt::format("{:+.1f}", 100 * *low), high, fmt::format("{:+.1f}", 100 * high.value_or(NAN)))
             : absent});
    for (const int count : replicate_counts)
      table.rows.back().push_back(
          rough_percent(number(at(at(mesh, "error_of_mean_of"), std::to_string(count)), "value")));
    table.rows.back().push_back(cpu_time(number(mesh, "cpu_s")));
  }
  return table;
}

Table advice_table(const Json& result) {
  Table table{.caption = "The cheapest setting for an error",
              .rows = {{"error", "mesh", "runs", "its error (of the mesh, noise)", "time", "interval"}},
              .notes = {}};
  for (const Json& one : list(result, "advice")) {
    const std::string target = percent(number(one, "target_error"), 0);
    const auto error = [&](const char* key) { return rough_percent(number(one, key)); };
    const auto low = number(one, "cpu_low_s"), high = number(one, "cpu_high_s");
    const std::string interval = low ? bounded(cpu_time(low), high, cpu_time(high)) : absent;
    if (yes(one, "found"))
      table.rows.push_back(
          {target, shown(number(one, "elements_per_radius")), shown(number(one, "replicates")),
           fmt::format("{} ({}, {})", error("error"), error("discretisation_error"), error("noise_error")),
           cpu_time(number(one, "cpu_s")), interval});
    else
      table.rows.push_back({target, "none", absent, absent, absent, interval});
    const std::string note = !yes(one, "found") ? "None: " + text(one, "why_not") + "."
                             : yes(one, "cost_estimated")
                                 ? target + " is extrapolated: no mesh of the ladder reaches it."
                                 : "";
    if (!note.empty() && std::ranges::find(table.notes, note) == table.notes.end()) table.notes.push_back(note);
  }
  return table;
}

std::string what_next(const Json& result) {
  const auto is_found = [](const Json& one) { return yes(one, "found"); };
  const Json& advice = list(result, "advice");
  if (std::any_of(advice.begin(), advice.end(), is_found))
    return "`percal impact SCENE --accuracy 2%` runs the cheapest setting for an error: this ladder is kept for it.";
  return "Finer meshes (--meshes) and more runs on each (--replicates) may tell more; finished runs are not repeated.";
}

Section answer_section(const Json& result) {
  Section section{.id = "answer", .title = "What each mesh is worth", .blocks = {}, .detail = Detail::answer};
  std::vector<std::string> meshes;
  for (const double n : numbers(at(at(result, "ladder"), "elements_per_radius"))) meshes.push_back(shown(n));
  add_sentence(section, fmt::format("{} elements per radius, {} runs on each, time step factor {}.", joined(meshes),
                                    shown(number(at(result, "ladder"), "replicates")),
                                    shown(number(at(result, "ladder"), "time_step_factor"))));
  add(section, worth_table(result));
  add(section, advice_table(result));
  add_sentence(section, what_next(result));
  return section;
}

Table run_table(const Json& result) {
  Table table{.caption = "The runs: a mesh, half the time step, double precision",
              .rows = {{"mesh", "elements", "time step", "arithmetic", "outcome", "depth", "spread", "standard error",
                        "steps", "element-steps", "time of a run"}},
              .notes = {}};
  const auto row = [&](const Json& rung) {
    std::vector<std::string> outcomes;
    for (const std::string& outcome : texts(at(rung, "outcomes")))
      if (std::ranges::find(outcomes, outcome) == outcomes.end()) outcomes.push_back(outcome);
    table.rows.push_back({shown(number(rung, "elements_per_radius")), shown(number(rung, "elements"), 9),
                          shown(number(rung, "time_step_factor"), 3), text(rung, "arithmetic"), joined(outcomes),
                          length(number(rung, "depth_m")), length(number(rung, "depth_spread_m"), 2),
                          length(number(rung, "depth_standard_error_m"), 2),
                          fmt::format("{:.0f}", number_or(rung, "steps", 0)), shown(number(rung, "element_steps"), 3),
                          cpu_time(number(rung, "cpu_s"))});
  };
  for (const char* rungs : {"meshes", "half_steps"})
    for (const Json& rung : list(result, rungs)) row(rung);
  row(at(result, "double_precision"));
  return table;
}

Table change_table(const Json& result) {
  Table table{.caption = "What time step and arithmetic are worth",
              .rows = {{"", "mesh", "change of the depth", "standard error", "significant", "time ratio"}},
              .notes = {"No change where one of the two did not stop."}};
  const auto row = [&](const char* what, const Json& change) {
    table.rows.push_back({what, shown(number(change, "elements_per_radius")),
                          signed_percent(number(change, "share"), 2), percent(number(change, "standard_error"), 2),
                          yes(change, "is_significant") ? "yes" : "no", shown(number(change, "cost_ratio"), 3)});
  };
  for (const Json& change : list(result, "change_by_half_the_step")) row("half the time step", change);
  row("double precision", at(result, "change_by_double_precision"));
  return table;
}

Section time_section(const Json& result) {
  Section section{.id = "time", .title = "Error against run time", .blocks = {}};
  add(section, error_against_time(result));
  return section;
}

Section mesh_section(const Json& result) {
  Section section{.id = "mesh", .title = "Mesh and noise", .blocks = {}};
  const Json& found = at(result, "convergence");
  add(section, depth_against_element_size(result));
  if (number(found, "extrapolated_depth_m"))
    add_sentence(
        section,
        fmt::format("Where the error comes from: the mesh (error {}, fitted from {} elements per "
                    "radius, observed order {}), and the noise of erosion (a run scatters by {}). "
                    "Scatter about the fit {}, from mesh to mesh {} beyond the noise.",
                    text(found, "form"), shown(number(found, "fitted_from_elements_per_radius")),
                    shown(number(found, "observed_order"), 2), percent(number(found, "spread_of_a_run"), 2),
                    length(number(found, "standard_deviation_m"), 2), rough_percent(number(found, "irregularity"))));
  add(section, run_table(result));
  add(section, change_table(result));
  return section;
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
          {"discretisation_error", found(advice.discretisation_error)},
          {"noise_error", found(advice.noise_error)},
          {"error", found(advice.error)},
          {"cpu_s", found(advice.cpu_seconds)},
          {"cpu_low_s", finite(advice.cpu_seconds_low)},
          {"cpu_high_s", finite(advice.cpu_seconds_high)}};
}

Json error_vs_time_to_json(const Scene& scene, const Ladder& ladder, const ErrorVsTime& study,
                           const std::vector<AdvisedSetting>& advice, const Cost& cost) {
  Json meshes = Json::array(), half_steps = Json::array(), changes = Json::array(), advised = Json::array();
  for (std::size_t i = 0; i < ladder.meshes.size(); ++i) {
    const bool has_error = !study.errors.empty() && i >= study.first_used;
    meshes.push_back(rung_with_error(ladder.meshes[i], has_error ? &study.errors[i - study.first_used] : nullptr));
  }
  for (const Rung& rung : ladder.half_steps) half_steps.push_back(rung_with_error(rung, nullptr));
  for (const Change& change : study.half_step) changes.push_back(change_to_json(change));
  for (const AdvisedSetting& one : advice) advised.push_back(advice_to_json(one));
  Json json = study_head(study_kind::error_vs_time, input_of(scene), cost);
  json.update({{"ladder",
                {{"elements_per_radius", ladder.options.meshes},
                 {"replicates", ladder.options.replicates},
                 {"time_step_factor", finite(ladder.options.time_step_factor)}}},
               {"meshes", meshes},
               {"half_steps", half_steps},
               {"double_precision", rung_with_error(ladder.double_precision, nullptr)},
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

Page error_vs_time_page(const Json& result) {
  const Json& found = at(result, "convergence");
  Page page;
  page.title = "Error against run time: " + studied_scene(result);
  page.summary = number(found, "extrapolated_depth_m")
                     ? fmt::format("Extrapolated depth {} ({} to {}); a run scatters by {} of it.",
                                   length(number(found, "extrapolated_depth_m")),
                                   length(number(found, "extrapolated_depth_low_m")),
                                   length(number(found, "extrapolated_depth_high_m")),
                                   percent(number(found, "spread_of_a_run"), 2))
                     : "No error can be given: " + text(found, "outcome") + ".";
  for (auto section : {answer_section, findings_section, time_section, mesh_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
