// The tables of one hypothesis.
#include <algorithm>

#include "percal/calibrate/result_text.hpp"
#include "percal/calibrate/text_parts.hpp"

namespace percal {
namespace {

using namespace calibration_text;
constexpr double next_to_nothing = 0.002;  // of a variance
using Rows = std::vector<std::vector<std::string>>;

std::string level_words(const CalibrationJob& job) { return fmt::format("{:g} %", 100 * job.level); }

TextTable parameter_table(const CalibrationJob& job, const HypothesisResult& hypothesis) {
  const Hypothesis& read = job.hypotheses[hypothesis.index];
  TextTable table{"parameters", {{"", "value", level_words(job) + " interval", "bootstrap", ""}}, {}};
  const Minimum& best = hypothesis.minima.front();
  for (std::size_t k = 0; k < hypothesis.parameters.size(); ++k) {
    const FreeParameter& parameter = job.parameters[hypothesis.parameters[k]].free;
    const auto word = [&](double value) { return value_of(parameter, value); };
    std::vector<std::string> row{parameter.name, word(parameter.natural(best.searched[static_cast<Eigen::Index>(k)])),
                                 "-", "-", best.at_bound[k] ? "at its bound" : ""};
    for (const ProfileInterval& interval : hypothesis.intervals) {
      if (interval.parameter != static_cast<int>(k)) continue;
      row[2] = interval_words(interval.interval, word);
      if (!interval.identifiable) row[4] += row[4].empty() ? "not identifiable" : ", not identifiable";
    }
    if (hypothesis.bootstrap && k < hypothesis.bootstrap->intervals.size())
      row[3] = interval_words(hypothesis.bootstrap->intervals[k], word);
    table.rows.push_back(row);
  }
  for (const auto& [k, value] : read.held)
    table.rows.push_back({job.parameters[k].free.name, value_of(job.parameters[k].free, value), "held", "-", ""});
  if (hypothesis.bootstrap && hypothesis.bootstrap->failed > 0)
    table.notes.push_back(fmt::format("{} of {} bootstrap replicates did not converge and are left out",
                                      hypothesis.bootstrap->failed,
                                      hypothesis.bootstrap->searched.rows() + hypothesis.bootstrap->failed));
  return table;
}

// Minima besides the best one.
TextTable minima_table(const CalibrationJob& job, const HypothesisResult& hypothesis) {
  TextTable table{"minima", {{"", "deviance above the best"}}, {}};
  for (const int k : hypothesis.parameters) table.rows[0].push_back(job.parameters[k].free.name);
  for (std::size_t m = 0; m < hypothesis.minima.size(); ++m) {
    const Minimum& minimum = hypothesis.minima[m];
    std::vector<std::string> row{fmt::format("{}", m + 1),
                                 fmt::format("{:.3g}", minimum.deviance - hypothesis.minima.front().deviance)};
    for (std::size_t k = 0; k < hypothesis.parameters.size(); ++k) {
      const FreeParameter& parameter = job.parameters[hypothesis.parameters[k]].free;
      row.push_back(value_of(parameter, parameter.natural(minimum.searched[static_cast<Eigen::Index>(k)])));
    }
    table.rows.push_back(row);
  }
  return table;
}

TextTable moduli_table(const CalibrationJob& job, const HypothesisResult& hypothesis) {
  TextTable table{"moduli, true and as LS-DYNA's MU1 = 2 mu/alpha",
                  {{"", "mu true", level_words(job) + " interval", "MU1", level_words(job) + " interval", "curve's mu",
                    "quasi-static E = 3 mu", level_words(job) + " interval", "3 MU1"}},
                  {}};
  for (const MaterialModuli& m : hypothesis.moduli) {
    std::vector<std::string> row{m.material,
                                 pressure(m.mu_true.value),
                                 interval_words(m.mu_true.interval, pressure),
                                 pressure(m.mu_over_alpha.value),
                                 interval_words(m.mu_over_alpha.interval, pressure),
                                 m.curve_modulus ? pressure(*m.curve_modulus) : "-"};
    const auto& e = m.youngs_quasi_static_true;
    const auto& as_mu1 = m.youngs_quasi_static_over_alpha;
    row.push_back(e ? pressure(e->value) : "-");
    row.push_back(e ? interval_words(e->interval, pressure) : "-");
    row.push_back(as_mu1 ? pressure(as_mu1->value) : "-");
    table.rows.push_back(row);
  }
  return table;
}

std::string mean_of(const Deviation& deviation) { return deviation.shots > 0 ? percent(deviation.mean_absolute) : "-"; }

const Deviation* by_name(const std::vector<Deviation>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Deviation& d) { return d.name == name; });
  return found == all.end() ? nullptr : &*found;
}

TextTable set_table(const CalibrationJob& job, const CalibrationResult& result, const HypothesisResult& hypothesis) {
  TextTable table{"depths by set: model over measured, less 1",
                  {{"", "shots", "mean deviation", "signed", "within " + level_words(job), "Dehn's"}},
                  {}};
  for (const Deviation& set : hypothesis.sets) {
    const Deviation* dehn = result.dehn ? by_name(result.dehn->sets, set.name) : nullptr;
    table.rows.push_back({set.name, fmt::format("{}", set.shots), mean_of(set),
                          set.shots > 0 ? signed_percent(set.mean_signed) : "-",
                          fmt::format("{} of {}", set.within, set.shots), dehn ? mean_of(*dehn) : "-"});
  }
  return table;
}

TextTable shot_table(const CalibrationJob& job, const CalibrationResult& result, const HypothesisResult& hypothesis) {
  TextTable table{
      "shots", {{"", "measured", "model", "deviation", level_words(job) + " of one shot", "Dehn's", ""}}, {}};
  for (const ShotDepth& depth : hypothesis.shots) {
    const MeasuredShot& shot = job.shots[depth.shot];
    std::string dehn = "-";
    if (result.dehn)
      for (const ShotDepth& theirs : result.dehn->shots)
        if (theirs.shot == depth.shot)
          dehn = theirs.deviation ? signed_percent(*theirs.deviation) : length(theirs.depth);
    table.rows.push_back({shot.label, (shot.at_least ? "at least " : "") + length(shot.depth), length(depth.depth),
                          depth.deviation ? signed_percent(*depth.deviation) : "-",
                          length(depth.low) + " to " + length(depth.high), dehn, depth.fitted ? "" : "predicted"});
  }
  return table;
}

std::string beside_goal(const CrossValidationResult& one) {
  if (!one.goal) return "-";
  if (one.prediction.shots == 0) return percent(*one.goal);
  return percent(*one.goal) + (one.prediction.mean_absolute <= *one.goal ? ", met" : ", missed");
}

void add_predictions(const std::vector<CrossValidationResult>& ours, const std::vector<CrossValidationResult>* dehn,
                     Rows& rows) {
  for (const CrossValidationResult& one : ours) {
    std::string theirs = "-";
    if (dehn)
      for (const CrossValidationResult& other : *dehn)
        if (other.name == one.name) theirs = mean_of(other.prediction);
    rows.push_back({one.name, one.fitted > 0 ? fmt::format("{}", one.fitted) : "-", mean_of(one.fit),
                    fmt::format("{}", one.prediction.shots), mean_of(one.prediction),
                    one.prediction.shots > 0 ? signed_percent(one.prediction.mean_signed) : "-", beside_goal(one),
                    theirs, fmt::format("{} of {}", one.prediction.within, one.prediction.shots)});
  }
}

TextTable prediction_table(const CalibrationJob& job, const CalibrationResult& result,
                           const HypothesisResult& hypothesis) {
  TextTable table{"predicted from the others",
                  {{"", "fitted", "their deviation", "predicted", "their deviation", "signed", "goal", "Dehn's",
                    "within " + level_words(job)}},
                  {}};
  add_predictions(hypothesis.cross_validations, result.dehn ? &result.dehn->cross_validations : nullptr, table.rows);
  add_predictions(hypothesis.leave_one_out, result.dehn ? &result.dehn->leave_one_out : nullptr, table.rows);
  return table;
}

TextTable fresh_table(const CalibrationJob& job, const HypothesisResult& hypothesis) {
  TextTable table{"fresh runs at the best point",
                  {{"", "elements per radius", "run", "emulator", "in stated errors", "measured"}},
                  {}};
  for (const FreshRun& run : hypothesis.fresh)
    table.rows.push_back({job.shots[run.shot].label, fmt::format("{}", run.elements_per_radius),
                          run.depth ? length(*run.depth) : run.outcome, length(run.emulated),
                          run.depth ? fmt::format("{:+.2f}", run.standardised) : "-",
                          length(job.shots[run.shot].depth)});
  return table;
}

// Sources that are next to nothing are one row.
TextTable budget_table(const CalibrationJob& job, const ErrorBudget& budget) {
  TextTable table{
      fmt::format("where the error of {} comes from: {} ({}, {})", budget.quantity, pressure(budget.total.value),
                  interval_words(budget.total.interval, pressure), level_words(job)),
      {{"", "standard deviation", "share of the variance"}},
      {}};
  double rest_of_variance = 0, rest_of_shares = 0;
  for (const ErrorShare& source : budget.sources) {
    if (source.share < next_to_nothing) {
      rest_of_variance += source.standard_deviation * source.standard_deviation;
      rest_of_shares += source.share;
      continue;
    }
    table.rows.push_back({source.name, rough_percent(source.standard_deviation), rough_percent(source.share)});
  }
  if (rest_of_shares > 0)
    table.rows.push_back(
        {"everything else", rough_percent(std::sqrt(rest_of_variance)), rough_percent(rest_of_shares)});
  table.rows.push_back({"together", rough_percent(budget.standard_deviation), ""});
  return table;
}

TextTable advice_table(const HypothesisResult& hypothesis) {
  TextTable table{"what to measure next", {{"", "interval afterwards over now"}}, {}};
  for (const Advice& one : hypothesis.advice) table.rows.push_back({one.label, fmt::format("{:.2f}", one.width_ratio)});
  return table;
}

TextTable summary(const HypothesisResult& hypothesis) {
  TextTable table{"", {}, {}};
  if (!hypothesis.fresh.empty())
    table.notes.push_back(
        fmt::format("fresh runs lie {} from the measured depths in the mean", percent(hypothesis.fresh_deviation)));
  table.notes.push_back(fmt::format("extrapolated to no mesh the depths would change by {} in the mean",
                                    signed_percent(hypothesis.mesh_error)));
  for (const std::string& finding : hypothesis.findings) table.notes.push_back("note: " + finding);
  return table;
}

}  // namespace

std::vector<TextTable> hypothesis_tables(const CalibrationJob& job, const CalibrationResult& result,
                                         const HypothesisResult& hypothesis, ShotTables shots) {
  const bool details = shots == ShotTables::all;
  std::vector<TextTable> tables;
  if (!hypothesis.minima.empty()) tables.push_back(parameter_table(job, hypothesis));
  if (hypothesis.minima.size() > 1) tables.push_back(minima_table(job, hypothesis));
  tables.push_back(moduli_table(job, hypothesis));
  tables.push_back(set_table(job, result, hypothesis));
  if (details || job.shots.size() <= few_shots) tables.push_back(shot_table(job, result, hypothesis));
  tables.push_back(prediction_table(job, result, hypothesis));
  if (details) tables.push_back(fresh_table(job, hypothesis));
  for (const ErrorBudget& budget : hypothesis.budgets) tables.push_back(budget_table(job, budget));
  tables.push_back(advice_table(hypothesis));
  tables.push_back(summary(hypothesis));
  std::erase_if(tables, [](const TextTable& table) { return table.rows.size() < 2 && table.notes.empty(); });
  return tables;
}

}  // namespace percal
