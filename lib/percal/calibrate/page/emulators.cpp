// The emulators: what they were trained on, how their error fell with the time spent, and the fresh runs that check them.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::calibration_page {
namespace {

// The inputs in the order of SphereInputs.
Json lengths_to_json(const std::array<double, sphere_inputs>& length) {
  const char* const names[] = {"ln_pi4", "ln_pi5", "alpha", "erosion_strain", "ln_depth_over_radius", "ln_bulk_ratio"};
  Json all = Json::object();
  for (int i = 0; i < sphere_inputs; ++i) all[names[i]] = finite(length[i]);
  return all;
}

Json settings_to_json(const EmulatorSettings& settings) {
  return {{"amplitude", finite(settings.amplitude)},           {"length", lengths_to_json(settings.length)},
          {"mesh_amplitude", finite(settings.mesh_amplitude)}, {"mesh_length", lengths_to_json(settings.mesh_length)},
          {"mesh_order", finite(settings.mesh_order)},         {"noise", finite(settings.noise)},
          {"noise_order", finite(settings.noise_order)},       {"log_likelihood", finite(settings.log_likelihood)},
          {"likelihood_evaluations", settings.evaluations}};
}

Json emulator_to_json(const CalibrationJob& job, const EmulatorReport& emulator) {
  Json hypotheses = Json::array(), rounds = Json::array(), outcomes = Json::array();
  for (const int r : emulator.hypotheses) hypotheses.push_back(job.hypotheses[r].name);
  for (const auto& round : emulator.rounds)
    rounds.push_back(
        {{"runs", round.runs}, {"cpu_s", finite(round.cpu_seconds)}, {"error_at_optimum", finite(round.error)}});
  for (const auto& [name, count] : emulator.outcomes) outcomes.push_back({{"outcome", name}, {"runs", count}});
  return {{"setting", emulator.setting},
          {"hypotheses", hypotheses},
          {"runs", emulator.runs},
          {"reused", emulator.reused},
          {"foreign", emulator.foreign},
          {"outcomes", outcomes},
          {"settings", settings_to_json(emulator.settings)},
          {"leave_one_out_error", finite(emulator.leave_one_out)},
          {"standardised_deviation", finite(emulator.standardised_deviation)},
          {"coverage95", finite(emulator.coverage95)},
          {"error_at_optimum", finite(emulator.error_at_optimum)},
          {"data_error", finite(emulator.data_error)},
          {"stopped", emulator.stopped},
          {"rounds", rounds}};
}

}  // namespace

Json emulators_to_json(const CalibrationJob& job, const std::vector<EmulatorReport>& emulators) {
  Json all = Json::array();
  for (const EmulatorReport& emulator : emulators) all.push_back(emulator_to_json(job, emulator));
  return all;
}

Json fresh_to_json(const CalibrationJob& job, const std::vector<FreshRun>& runs) {
  Json all = Json::array();
  for (const FreshRun& run : runs)
    all.push_back({{"shot", run.shot},
                   {"label", job.shots[run.shot].label},
                   {"elements_per_radius", run.elements_per_radius},
                   {"outcome", run.outcome},
                   {"depth_m", finite(run.depth)},
                   {"emulated_m", finite(run.emulated)},
                   {"standardised_difference", run.depth ? finite(run.standardised) : Json()}});
  return all;
}

// --- the page -------------------------------------------------------------------------------------------------------

namespace {

Figure fresh_figure(const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  Series runs = series("fresh runs", Mark::points, 0);
  int within = 0;
  double finest = nowhere, low = HUGE_VAL, high = 0;
  const Json& shots = list(at(result, "data"), "shots");
  for (const Json& run : list(hypothesis, "fresh_runs")) {
    const auto shot = static_cast<std::size_t>(std::max(number_or(run, "shot", 0), 0.0));
    const auto z = number(run, "standardised_difference");
    if (!z || shot >= shots.size()) continue;
    const double depth = number_or(run, "depth_m", nowhere) / number_or(shots[shot], "radius_m", nowhere);
    add_point(runs, depth, *z);
    low = std::min(low, depth);
    high = std::max(high, depth);
    within += std::abs(*z) <= 2;
    finest = number_or(run, "elements_per_radius", finest);
  }
  Chart chart{.title = "Fresh runs at the best point against the emulator",
              .x = {.label = "depth, radii", .logarithmic = worth_a_logarithm(low, high)},
              .y = {.label = "run less emulator, in stated standard errors"}};
  const auto count = runs.x.size();
  if (count > 1)
    for (const double side : {-2.0, 2.0}) {
      Series limit = series(side < 0 ? "two standard errors" : "", Mark::dashes, -1);
      add_point(limit, low, side);
      add_point(limit, high, side);
      add(chart, std::move(limit));
    }
  add(chart, std::move(runs));
  return {.name = fmt::format("fresh_{}", number_of_hypothesis),
          .caption = fmt::format(
              "The fitted shots run again at the best point on {} elements per radius: {} of {} lie within two "
              "of the emulator's stated standard errors.",
              shown(finest), within, count),
          .alt = fmt::format("Differences of {} fresh runs from the emulator, {} of them within two standard errors.",
                             count, within),
          .chart = chart};
}

Table fresh_table(const Json& hypothesis) {
  Table table{.caption = "Fresh runs at the best point",
              .rows = {{"shot", "run", "emulator", "in stated errors"}},
              .notes = {}};
  for (const Json& run : list(hypothesis, "fresh_runs")) {
    const auto depth = number(run, "depth_m");
    table.rows.push_back({text(run, "label"), depth ? length(depth) : text(run, "outcome"),
                          length(number(run, "emulated_m")), shown(number(run, "standardised_difference"), 2)});
  }
  return table;
}

// One emulator as a column.
std::vector<std::string> column_of(const Json& one) {
  std::string outcomes;
  for (const Json& outcome : list(one, "outcomes"))
    outcomes +=
        fmt::format("{}{} {}", outcomes.empty() ? "" : ", ", shown(number(outcome, "runs")), text(outcome, "outcome"));
  return {text(one, "setting"),
          shown(number(one, "runs")),
          shown(number(one, "reused")),
          shown(number(one, "foreign")),
          outcomes,
          percent(number(one, "leave_one_out_error")),
          percent(number(one, "coverage95")),
          percent(number(at(one, "settings"), "noise")),
          percent(number(one, "error_at_optimum")),
          percent(number(one, "data_error")),
          text(one, "stopped")};
}

Table round_table(const Json& emulator) {
  Table table{.caption = "Error after each round: " + text(emulator, "setting"),
              .rows = {{"runs", "processor time", "error at the optimum"}},
              .notes = {}};
  for (const Json& round : list(emulator, "rounds")) {
    const double error = number_or(round, "error_at_optimum", 0);  // 0: nothing was fitted yet
    table.rows.push_back({shown(number(round, "runs")), fmt::format("{:.1f} s", number_or(round, "cpu_s", 0)),
                          error > 0 ? percent(error) : absent});
  }
  return table;
}

}  // namespace

void add_fresh_runs(Section& section, const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  add(section, fresh_figure(result, hypothesis, number_of_hypothesis));
  add(section, fresh_table(hypothesis));
}

Section emulators_section(const Json& result) {
  Section section{.id = "emulators", .title = "Error against run time", .blocks = {}};
  Chart chart{.title = "The emulators' error at the optimum against processor time",
              .x = {.label = "processor time of the runs, s", .logarithmic = true},
              .y = {.label = "error of a depth, %", .logarithmic = true}};
  Table table{.caption = "Emulators",
              .rows = {{""},
                       {"runs done"},
                       {"runs from the store"},
                       {"runs of other jobs"},
                       {"outcomes"},
                       {"leave-one-out error"},
                       {"within its 95 %"},
                       {"solver's noise"},
                       {"error at the optimum"},
                       {"data's error"},
                       {"stopped because"}},
              .notes = {}};
  int colour = 0;
  std::string finding;
  for (const Json& one : list(result, "emulators")) {
    const auto column = column_of(one);
    const std::string& name = column.front();
    for (std::size_t row = 0; row < column.size(); ++row) table.rows[row].push_back(column[row]);
    const auto error = number(one, "error_at_optimum"), data = number(one, "data_error");
    Series line = series("", Mark::line, colour), points = series(name, Mark::points, colour),
           of_data = series("the data's, " + name, Mark::dashes, colour);
    for (const Json& round : list(one, "rounds")) {
      const double seconds = number_or(round, "cpu_s", 0), share = number_or(round, "error_at_optimum", 0);
      if (!(seconds > 0 && share > 0)) continue;
      add_point(line, seconds, 100 * share);
      add_point(points, seconds, 100 * share);
    }
    if (points.x.size() > 1)
      for (const double end : {points.x.front(), points.x.back()})
        if (data && *data > 0) add_point(of_data, end, 100 * *data);
    if (error && data)
      finding += fmt::format(" {}: {} at the end, beside {} of the data.", name, percent(error), percent(data));
    ++colour;
    if (line.x.size() > 1) add(chart, line);
    add(chart, points);
    add(chart, of_data);
  }
  add(section, Figure{.name = "error_vs_time",
                      .caption = "What a depth's error was after each round of runs." + finding,
                      .alt = "Error of the emulators against processor time, falling from round to round." + finding,
                      .chart = chart});
  if (colour > 0) add(section, std::move(table));
  for (const Json& one : list(result, "emulators")) add(section, round_table(one));
  return section;
}

}  // namespace percal::calibration_page
