#include "percal/calibrate/result_json.hpp"

#include "percal/base/version.hpp"
#include "percal/calibrate/cards.hpp"
#include "percal/calibrate/json_parts.hpp"
#include "percal/card/card_json.hpp"

namespace percal {
namespace calibration_json {
namespace {

// The inputs in the order of SphereInputs.
Json lengths_to_json(const std::array<double, sphere_inputs>& length) {
  const char* const names[] = {"ln_pi4", "ln_pi5", "alpha", "erosion_strain", "ln_depth_over_radius", "ln_bulk_ratio"};
  Json all = Json::object();
  for (int i = 0; i < sphere_inputs; ++i) all[names[i]] = number(length[i]);
  return all;
}

Json settings_to_json(const EmulatorSettings& settings) {
  return {{"amplitude", number(settings.amplitude)},           {"length", lengths_to_json(settings.length)},
          {"mesh_amplitude", number(settings.mesh_amplitude)}, {"mesh_length", lengths_to_json(settings.mesh_length)},
          {"mesh_order", number(settings.mesh_order)},         {"noise", number(settings.noise)},
          {"noise_order", number(settings.noise_order)},       {"log_likelihood", number(settings.log_likelihood)},
          {"likelihood_evaluations", settings.evaluations}};
}

Json cost_to_json(const CalibrationCost& cost) {
  return {{"runs", cost.runs},
          {"reused", cost.reused},
          {"wall_s", number(cost.wall_seconds)},
          {"cpu_s", number(cost.cpu_seconds)},
          {"budget_s", number(cost.budget_seconds)},
          {"advice", cost.advice}};
}

}  // namespace

Json emulator_to_json(const CalibrationJob& job, const EmulatorReport& emulator) {
  Json hypotheses = Json::array(), rounds = Json::array(), outcomes = Json::array();
  for (const int r : emulator.hypotheses) hypotheses.push_back(job.hypotheses[r].name);
  for (const auto& round : emulator.rounds)
    rounds.push_back(
        {{"runs", round.runs}, {"cpu_s", number(round.cpu_seconds)}, {"error_at_optimum", number(round.error)}});
  for (const auto& [name, count] : emulator.outcomes) outcomes.push_back({{"outcome", name}, {"runs", count}});
  return {{"setting", emulator.setting},
          {"hypotheses", hypotheses},
          {"runs", emulator.runs},
          {"reused", emulator.reused},
          {"foreign", emulator.foreign},
          {"outcomes", outcomes},
          {"settings", settings_to_json(emulator.settings)},
          {"leave_one_out_error", number(emulator.leave_one_out)},
          {"standardised_deviation", number(emulator.standardised_deviation)},
          {"coverage95", number(emulator.coverage95)},
          {"error_at_optimum", number(emulator.error_at_optimum)},
          {"data_error", number(emulator.data_error)},
          {"stopped", emulator.stopped},
          {"rounds", rounds}};
}

}  // namespace calibration_json

nlohmann::json calibration_to_json(const CalibrationJob& job, const CalibrationResult& result) {
  using namespace calibration_json;
  Json emulators = Json::array(), hypotheses = Json::array();
  for (const EmulatorReport& emulator : result.emulators) emulators.push_back(emulator_to_json(job, emulator));
  for (const HypothesisResult& hypothesis : result.hypotheses)
    hypotheses.push_back(hypothesis_to_json(job, hypothesis));
  Json cards = Json::array();
  for (const HypothesisResult& hypothesis : result.hypotheses)
    for (const CardMaterial& card : calibration_cards(job, hypothesis)) cards.push_back(card_to_json(card));
  return {{"schema", result_schema},
          {"percal", version()},
          {"command", "calibrate"},
          {"isa", result.cost.instruction_level},
          {"title", job.title},
          {"input", {{"job", job.file}, {"toml", job.text}}},
          {"level", job.level},
          {"data", job_to_json(job)},
          {"hypotheses", hypotheses},
          {"cards", cards},
          {"dehn", result.dehn ? dehn_to_json(job, *result.dehn) : Json(nullptr)},
          {"emulators", emulators},
          {"findings", result.findings},
          {"cost", cost_to_json(result.cost)}};
}

}  // namespace percal
