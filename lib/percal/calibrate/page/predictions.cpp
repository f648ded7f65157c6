// Deviations of whole sets and of the depths that a fit did not see, with Dehn's closed form beside them.
#include <fmt/core.h>

#include <algorithm>

#include "percal/calibrate/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::calibration_page {
namespace {

Json deviation_to_json(const Deviation& deviation) {
  const bool any = deviation.shots > 0;
  return {{"name", deviation.name},
          {"shots", deviation.shots},
          {"mean_deviation", any ? finite(deviation.mean_absolute) : Json()},
          {"mean_signed_deviation", any ? finite(deviation.mean_signed) : Json()},
          {"within_interval", deviation.within}};
}

Json validations_to_json(const CalibrationJob& job, const std::vector<CrossValidationResult>& all) {
  Json validations = Json::array();
  for (const CrossValidationResult& one : all)
    validations.push_back({{"name", one.name},
                           {"shots_fitted", one.fitted},
                           {"fit", deviation_to_json(one.fit)},
                           {"prediction", deviation_to_json(one.prediction)},
                           {"goal", finite(one.goal)},
                           {"shots", shots_to_json(job, one.shots)}});
  return validations;
}

}  // namespace

Json predictions_to_json(const CalibrationJob& job, const std::vector<Deviation>& sets,
                         const std::vector<CrossValidationResult>& cross_validations,
                         const std::vector<CrossValidationResult>& leave_one_out) {
  Json of_sets = Json::array();
  for (const Deviation& set : sets) of_sets.push_back(deviation_to_json(set));
  return {{"sets", of_sets},
          {"cross_validations", validations_to_json(job, cross_validations)},
          {"leave_one_out", validations_to_json(job, leave_one_out)}};
}

Json dehn_to_json(const CalibrationJob& job, const DehnResult& dehn) {
  Json json = predictions_to_json(job, dehn.sets, dehn.cross_validations, dehn.leave_one_out);
  json.update({{"minimum", minimum_to_json(job, dehn.parameters, dehn.minimum)},
               {"parameters", parameters_to_json(dehn.parameters, dehn.minimum, dehn.intervals, {})},
               {"shots", shots_to_json(job, dehn.shots)}});
  return json;
}

// --- the page -------------------------------------------------------------------------------------------------------

namespace {

constexpr const char* kinds[] = {"cross_validations", "leave_one_out"};

// The entry of this name in a list; null where there is none.
const Json& by_name(const Json& entries, const std::string& name) {
  static const Json nothing = nullptr;
  for (const Json& entry : entries)
    if (text(entry, "name") == name) return entry;
  return nothing;
}

std::string mean_of(const Json& deviation) { return percent(number(deviation, "mean_deviation")); }

std::string within_words(const Json& deviation) {
  return fmt::format("{} of {}", shown(number(deviation, "within_interval")), shown(number(deviation, "shots")));
}

// "6.0 %, goal met"; a validation without a goal is only said.
std::string prediction_words(const Json& validation) {
  const auto mean = number(at(validation, "prediction"), "mean_deviation"), goal = number(validation, "goal");
  if (!mean || !goal) return percent(mean);
  return percent(mean) + (*mean <= *goal ? ", met" : ", missed");
}

Table set_table(const Json& result, const Json& hypothesis) {
  Table table{.caption = "Depths by set: model over measured, less 1",
              .rows = {{"set", "mean size", "signed mean", "within " + level_words(result), "Dehn's mean size"}},
              .notes = {}};
  for (const Json& set : list(hypothesis, "sets"))
    table.rows.push_back({text(set, "name"), mean_of(set), signed_percent(number(set, "mean_signed_deviation")),
                          within_words(set), mean_of(by_name(list(at(result, "dehn"), "sets"), text(set, "name")))});
  return table;
}

Table prediction_table(const Json& result, const Json& hypothesis) {
  Table table{
      .caption = "Predicted from the others: deviations of the fitted and of the predicted depths",
      .rows = {{"validation", "fitted", "mean size", "predicted", "signed mean", "within " + level_words(result)}},
      .notes = {}};
  for (const char* kind : kinds)
    for (const Json& one : list(hypothesis, kind)) {
      const Json& prediction = at(one, "prediction");
      table.rows.push_back({text(one, "name"), shown(number(one, "shots_fitted")), mean_of(at(one, "fit")),
                            mean_of(prediction), signed_percent(number(prediction, "mean_signed_deviation")),
                            within_words(prediction)});
    }
  return table;
}

}  // namespace

void add_predictions(Section& section, const Json& result, const Json& hypothesis) {
  add(section, set_table(result, hypothesis));
  add(section, prediction_table(result, hypothesis));
}

Section predictions_section(const Json& result) {
  Section section{.id = "predictions", .title = "Predicted from the others", .blocks = {}};
  const Json& hypotheses = list(result, "hypotheses");
  Table table{.caption = "Mean size of the deviations of depths that the fit did not see",
              .rows = {{"validation", "predicted", "goal", "Dehn's closed form"}},
              .notes = {}};
  for (std::size_t n = 1; n <= hypotheses.size(); ++n) table.rows[0].push_back(fmt::format("hypothesis {}", n));
  for (const char* kind : kinds) {
    std::vector<std::string> names;
    for (const Json& hypothesis : hypotheses)
      for (const Json& one : list(hypothesis, kind))
        if (std::find(names.begin(), names.end(), text(one, "name")) == names.end()) names.push_back(text(one, "name"));
    for (const std::string& name : names) {
      std::vector<std::string> row{name, "-", "-",
                                   mean_of(at(by_name(list(at(result, "dehn"), kind), name), "prediction"))};
      for (const Json& hypothesis : hypotheses) {
        const Json& one = by_name(list(hypothesis, kind), name);
        row.push_back(prediction_words(one));
        if (const auto shots = number(at(one, "prediction"), "shots")) row[1] = shown(shots);
        if (const auto goal = number(one, "goal")) row[2] = percent(goal);
      }
      table.rows.push_back(row);
    }
  }
  add(section, std::move(table));
  Table dehn{.caption = "Dehn's closed form, fitted to the same shots",
             .rows = {{"parameter", "value", level_words(result) + " interval"}},
             .notes = {}};
  for (const Json& one : list(at(result, "dehn"), "parameters"))
    dehn.rows.push_back({text(one, "name"), value_words(one, "value"), interval_words(one, "interval")});
  add(section, std::move(dehn));
  return section;
}

}  // namespace percal::calibration_page
