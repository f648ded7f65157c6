#include "percal/calibrate/result_text.hpp"

#include <algorithm>

#include "percal/calibrate/text_parts.hpp"

namespace percal {

using namespace calibration_text;

namespace {

// A parameter of the job under a hypothesis: fitted, held, or without a datum.
std::string value_under(const CalibrationJob& job, const HypothesisResult& hypothesis, int parameter) {
  const FreeParameter& free = job.parameters[parameter].free;
  const auto& held = job.hypotheses[hypothesis.index].held;
  if (const auto found = held.find(parameter); found != held.end()) return value_of(free, found->second) + " held";
  const auto place = std::find(hypothesis.parameters.begin(), hypothesis.parameters.end(), parameter);
  if (place == hypothesis.parameters.end() || hypothesis.minima.empty()) return "-";
  return value_of(free, free.natural(hypothesis.minima.front().searched[place - hypothesis.parameters.begin()]));
}

std::string quasi_static_modulus(const HypothesisResult& hypothesis, const std::string& material) {
  const auto found = std::find_if(hypothesis.moduli.begin(), hypothesis.moduli.end(),
                                  [&](const MaterialModuli& m) { return m.material == material; });
  const bool known = found != hypothesis.moduli.end() && found->youngs_quasi_static_true;
  return known ? pressure(found->youngs_quasi_static_true->value) : "-";
}

std::string mean_deviation_of(const std::vector<Deviation>& sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Deviation& d) { return d.name == name; });
  return found != sets.end() && found->shots > 0 ? percent(found->mean_absolute) : "-";
}

// Names of the sets of shots in all hypotheses, in their order.
std::vector<std::string> set_names(const CalibrationResult& result) {
  std::vector<std::string> names;
  for (const HypothesisResult& hypothesis : result.hypotheses)
    for (const Deviation& set : hypothesis.sets)
      if (std::find(names.begin(), names.end(), set.name) == names.end()) names.push_back(set.name);
  return names;
}

}  // namespace

TextTable hypotheses_side_by_side(const CalibrationJob& job, const CalibrationResult& result) {
  TextTable table{"hypotheses side by side", {{"hypothesis"}}, {}};
  const auto add = [&](const std::string& what, const auto& cell) {
    std::vector<std::string> row{what};
    for (const HypothesisResult& hypothesis : result.hypotheses) row.push_back(cell(hypothesis));
    table.rows.push_back(row);
  };
  for (const HypothesisResult& hypothesis : result.hypotheses)
    table.rows[0].push_back(fmt::format("{}", hypothesis.index + 1));
  const auto choices = [&](const HypothesisResult& hypothesis) -> const Hypothesis& {
    return job.hypotheses[hypothesis.index];
  };
  add("mu means", [&](const HypothesisResult& hypothesis) { return word(choices(hypothesis).convention); });
  add("strain", [&](const HypothesisResult& hypothesis) { return word(choices(hypothesis).measure); });
  add("contact stiffness",
      [&](const HypothesisResult& hypothesis) { return fmt::format("{:g}", choices(hypothesis).contact_stiffness); });
  for (std::size_t k = 0; k < job.parameters.size(); ++k)
    add(job.parameters[k].free.name,
        [&](const HypothesisResult& hypothesis) { return value_under(job, hypothesis, static_cast<int>(k)); });
  for (const CalibrationMaterial& material : job.materials)
    if (material.rate_factor)
      add("E of " + material.name,
          [&](const HypothesisResult& hypothesis) { return quasi_static_modulus(hypothesis, material.name); });
  for (const std::string& set : set_names(result))
    add(set, [&](const HypothesisResult& hypothesis) { return mean_deviation_of(hypothesis.sets, set); });
  for (std::size_t r = 0; r < job.hypotheses.size(); ++r)
    table.notes.push_back(fmt::format("{}: {}", r + 1, job.hypotheses[r].name));
  table.notes.push_back("moduli as given; E = 3 mu, mu true, quasi-static; of sets the mean deviation of their depths");
  return table;
}

TextTable dehn_table(const CalibrationJob& job, const DehnResult& dehn) {
  TextTable table{"Dehn's closed form, fitted to the same shots",
                  {{"", "value", fmt::format("{:g} % interval", 100 * job.level)}},
                  {}};
  for (std::size_t k = 0; k < dehn.parameters.size(); ++k) {
    const FreeParameter& parameter = dehn.parameters[k];
    const auto word = [&](double value) { return value_of(parameter, value); };
    std::string interval = "-";
    for (const ProfileInterval& one : dehn.intervals)
      if (one.parameter == static_cast<int>(k)) interval = interval_words(one.interval, word);
    table.rows.push_back(
        {parameter.name, word(parameter.natural(dehn.minimum.searched[static_cast<Eigen::Index>(k)])), interval});
  }
  return table;
}

std::vector<TextTable> emulator_tables(const CalibrationResult& result) {
  TextTable table{"emulators",
                  {{"", "runs", "reused", "not of this job", "leave-one-out error", "within its 95 %", "solver's noise",
                    "error at the optimum", "data's error", "stopped because"}},
                  {}};
  std::vector<TextTable> tables;
  for (const EmulatorReport& emulator : result.emulators) {
    table.rows.push_back({emulator.setting, fmt::format("{}", emulator.runs), fmt::format("{}", emulator.reused),
                          fmt::format("{}", emulator.foreign), percent(emulator.leave_one_out),
                          percent(emulator.coverage95), percent(emulator.settings.noise),
                          percent(emulator.error_at_optimum), percent(emulator.data_error), emulator.stopped});
    std::string outcomes;
    for (const auto& [name, count] : emulator.outcomes)
      outcomes += fmt::format("{}{} {}", outcomes.empty() ? "" : ", ", count, name);
    if (!outcomes.empty()) table.notes.push_back(emulator.setting + ": " + outcomes);
  }
  tables.push_back(table);
  for (const EmulatorReport& emulator : result.emulators) {
    TextTable rounds{
        "error against time: " + emulator.setting, {{"runs", "processor time", "error at the optimum"}}, {}};
    for (const auto& round : emulator.rounds)
      rounds.rows.push_back(
          {fmt::format("{}", round.runs), fmt::format("{:.1f} s", round.cpu_seconds), percent(round.error)});
    if (rounds.rows.size() > 2) tables.push_back(rounds);
  }
  return tables;
}

std::vector<std::string> cost_sentences(const CalibrationCost& cost) {
  std::vector<std::string> sentences{
      fmt::format("{} runs, {} from the store, {:.1f} s of processor time, {:.1f} s in all{}{}", cost.runs, cost.reused,
                  cost.cpu_seconds, cost.wall_seconds,
                  cost.budget_seconds ? fmt::format(" of a budget of {:g} s", *cost.budget_seconds) : "",
                  cost.instruction_level.empty() ? "" : ", " + cost.instruction_level)};
  if (!cost.advice.empty()) sentences.push_back(cost.advice);
  return sentences;
}

}  // namespace percal
