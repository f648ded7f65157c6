#include "percal/calibrate/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "percal/calibrate/cards.hpp"
#include "percal/calibrate/page/sections.hpp"
#include "percal/card/card_json.hpp"
#include "percal/page/numbers.hpp"

namespace percal {
namespace calibration_page {
namespace {

Json verdict_to_json(const CalibrationJob& job, const Verdict& verdict) {
  Json factors = Json::array();
  for (const ImpliedRateFactor& rate : verdict.rate_factors)
    factors.push_back({{"material", job.materials[rate.material].name},
                       {"given", rate.given},
                       {"given_error", rate.given_error},
                       {"implied", finite(rate.implied.value)},
                       {"implied_interval", interval_to_json(rate.implied.interval)},
                       {"mu_of_depths_Pa", finite(rate.modulus_of_depths.value)},
                       {"mu_of_depths_interval_Pa", interval_to_json(rate.modulus_of_depths.interval)},
                       {"mu_of_curves_Pa", finite(rate.modulus_of_curves)},
                       {"agreement", word(rate.agreement)}});
  return {{"agreement", word(verdict.agreement)}, {"sentences", verdict.sentences}, {"rate_factors", factors}};
}

Json hypothesis_to_json(const CalibrationJob& job, const HypothesisResult& result) {
  const Hypothesis& hypothesis = job.hypotheses[result.index];
  Json json{{"name", hypothesis.name},
            {"verdict", verdict_to_json(job, result.verdict)},
            {"convention", word(hypothesis.convention)},
            {"strain_measure", word(hypothesis.measure)},
            {"ridges", ridges_to_json(fitted_parameters(job, result), result.ridges)},
            {"shots", shots_to_json(job, result.shots)},
            {"curves", curves_to_json(job, result.curves)},
            {"fresh_runs", fresh_to_json(job, result.fresh)},
            {"fresh_mean_deviation", result.fresh.empty() ? Json() : finite(result.fresh_deviation)},
            {"mesh_error", finite(result.mesh_error)},
            {"aicc", finite(result.aicc)},
            {"findings", result.findings}};
  json.update(fit_to_json(job, result));
  json.update(predictions_to_json(job, result.sets, result.cross_validations, result.leave_one_out));
  json.update(moduli_to_json(result));
  return json;
}

// What a parameter of the data is under a hypothesis: fitted, held, or "-" without a datum.
std::string value_under(const Json& hypothesis, const std::string& parameter) {
  for (const Json& one : list(hypothesis, "held"))
    if (text(one, "name") == parameter) return value_words(one, "value") + " held";
  for (const Json& one : list(hypothesis, "parameters"))
    if (text(one, "name") == parameter) return value_words(one, "value");
  return absent;
}

std::string mean_deviation_of(const Json& hypothesis, const std::string& set) {
  for (const Json& one : list(hypothesis, "sets"))
    if (text(one, "name") == set) return percent(number(one, "mean_deviation"));
  return absent;
}

// Choices, parameters and deviations of all hypotheses.
Table side_by_side(const Json& result) {
  const Json& hypotheses = list(result, "hypotheses");
  Table table{
      .caption = "How each hypothesis takes the data, and what it gives", .rows = {{"hypothesis"}}, .notes = {}};
  const auto row = [&](const std::string& what, const auto& cell) {
    table.rows.push_back({what});
    for (const Json& hypothesis : hypotheses) table.rows.back().push_back(cell(hypothesis));
  };
  std::vector<std::string> sets;
  for (const Json& hypothesis : hypotheses) {
    table.rows[0].push_back(fmt::format("{}", table.rows[0].size()));
    table.notes.push_back(table.rows[0].back() + ": " + text(hypothesis, "name"));
    for (const Json& set : list(hypothesis, "sets"))
      if (std::find(sets.begin(), sets.end(), text(set, "name")) == sets.end()) sets.push_back(text(set, "name"));
  }
  row("mu means", [](const Json& one) { return text(one, "convention"); });
  row("a held erosion strain is", [](const Json& one) { return text(one, "strain_measure"); });
  for (const Json& parameter : list(at(result, "data"), "parameters"))
    row(text(parameter, "name"), [&](const Json& one) { return value_under(one, text(parameter, "name")); });
  for (const std::string& set : sets) row(set, [&](const Json& one) { return mean_deviation_of(one, set); });
  double best = HUGE_VAL;
  for (const Json& one : hypotheses) best = std::min(best, number_or(one, "aicc", HUGE_VAL));
  if (hypotheses.size() > 1 && std::isfinite(best)) {
    row("AICc above the best", [&](const Json& one) { return shown(number_or(one, "aicc", nowhere) - best, 3); });
    table.notes.push_back(
        "AICc: what the data say for a hypothesis, its parameters counted against it; 2 more is worse, 10 more "
        "hopeless.");
  }
  table.notes.push_back("Moduli as given; of sets the mean size of their depths' deviations.");
  return table;
}

Section hypotheses_section(const Json& result) {
  Section section{.id = "hypotheses", .title = "What was looked for, and how", .blocks = {}};
  add(section, searched_table(result));
  if (!list(result, "hypotheses").empty()) add(section, side_by_side(result));
  return section;
}

Section hypothesis_section(const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  Section section{.id = fmt::format("hypothesis-{}", number_of_hypothesis),
                  .title = fmt::format("Hypothesis {}: {}", number_of_hypothesis, text(hypothesis, "name")),
                  .blocks = {}};
  List findings{texts(at(hypothesis, "findings")), Tone::note};
  const auto said = findings_of_all(result);
  std::erase_if(findings.items,
                [&](const auto& one) { return std::find(said.begin(), said.end(), one) != said.end(); });
  add(section, std::move(findings));
  add_fit(section, result, hypothesis, number_of_hypothesis);
  add_curves(section, result, hypothesis, number_of_hypothesis);
  add_shots(section, result, hypothesis, number_of_hypothesis);
  add_predictions(section, result, hypothesis);
  add_fresh_runs(section, result, hypothesis, number_of_hypothesis);
  add_errors(section, result, hypothesis);
  return section;
}

}  // namespace
}  // namespace calibration_page

page::Json calibration_to_json(const CalibrationJob& job, const CalibrationResult& result) {
  using namespace calibration_page;
  Json hypotheses = Json::array(), cards = Json::array();
  for (const HypothesisResult& hypothesis : result.hypotheses) {
    hypotheses.push_back(hypothesis_to_json(job, hypothesis));
    for (const CardMaterial& card : calibration_cards(job, hypothesis)) cards.push_back(card_to_json(card));
  }
  Json json = result_head("calibrate", {{"job", job.file}, {"toml", job.text}});
  json.update({{"title", job.title},
               {"level", job.level},
               {"seed", job.training.seed},
               {"data",
                {{"parameters", searched_to_json(job)},
                 {"shots", measured_shots_to_json(job)},
                 {"curves", measured_curves_to_json(job)},
                 {"width_was_chosen", job.width_was_chosen},
                 {"ridge_points", published_to_json(job)}}},
               {"hypotheses", hypotheses},
               {"cards", cards},
               {"dehn", result.dehn ? dehn_to_json(job, *result.dehn) : Json()},
               {"emulator", emulator_to_json(result.emulator)},
               {"shot_model", result.shot_model ? shot_model_to_json(*result.shot_model) : Json()},
               {"findings", result.findings},
               {"cost", cost_to_json({.runs = result.cost.runs,
                                      .reused = result.cost.reused,
                                      .cpu_seconds = result.cost.cpu_seconds,
                                      .wall_seconds = result.cost.wall_seconds,
                                      .budget_seconds = result.cost.budget_seconds,
                                      .instruction_level = result.cost.instruction_level,
                                      .advice = result.cost.advice})}});
  return json;
}

page::Page calibrate_page(const page::Json& result) {
  using namespace calibration_page;
  Page page{.title = text(result, "title"), .summary = "", .sections = {}};
  add_answer(page, result);
  add(page, hypotheses_section(result));
  add(page, moduli_section(result));
  add(page, ridges_section(result));
  add(page, depths_section(result));
  add(page, predictions_section(result));
  int n = 0;
  for (const Json& hypothesis : list(result, "hypotheses")) add(page, hypothesis_section(result, hypothesis, ++n));
  add(page, emulator_section(result));
  add(page, provenance_section(result));
  add(page, input_section(result));
  return page;
}

}  // namespace percal
