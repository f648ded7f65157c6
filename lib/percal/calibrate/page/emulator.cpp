// The emulator: what it was trained on, how its error fell with the time spent, and the fresh runs that check it.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::calibration_page {
Json emulator_to_json(const EmulatorReport& emulator) {
  Json rounds = Json::array(), outcomes = Json::array();
  for (const auto& round : emulator.rounds)
    rounds.push_back(
        {{"runs", round.runs}, {"cpu_s", finite(round.cpu_seconds)}, {"error_at_optimum", finite(round.error)}});
  for (const auto& [name, count] : emulator.outcomes) outcomes.push_back({{"outcome", name}, {"runs", count}});
  Json json{{"runs", emulator.runs},
            {"reused", emulator.reused},
            {"foreign", emulator.foreign},
            {"from_atlas", emulator.from_atlas},
            {"outcomes", outcomes},
            {"noise", finite(emulator.settings.noise)},
            {"leave_one_out_error", finite(emulator.leave_one_out)},
            {"standardised_deviation", finite(emulator.standardised_deviation)},
            {"coverage95", finite(emulator.coverage95)},
            {"error_at_optimum", finite(emulator.error_at_optimum)},
            {"data_error", finite(emulator.data_error)},
            {"stopped", emulator.stopped},
            {"rounds", rounds}};
  for (const BesideReport& beside : emulator.beside)
    if (beside.of.body == 0)
      json["beside"][kind_of(beside.of.number).key] = {{"learns", kind_of(beside.of.number).learnt},
                                                       {"runs", beside.runs},
                                                       {"runs_without", beside.without},
                                                       {"mean", finite(beside.mean)},
                                                       {"noise", finite(beside.noise)},
                                                       {"leave_one_out_error", finite(beside.leave_one_out)}};
    else
      json["bodies"].push_back({{"name", beside.body},
                                {"runs", beside.runs},
                                {"noise", finite(beside.noise)},
                                {"leave_one_out_error", finite(beside.leave_one_out)}});
  return json;
}

Json fresh_to_json(const CalibrationJob& job, const std::vector<FreshRun>& runs) {
  Json all = Json::array();
  for (const FreshRun& run : runs) {
    all.push_back({{"shot", run.shot},
                   {"label", job.shots[run.shot].label},
                   {"elements_per_radius", run.elements_per_radius},
                   {"runs", run.runs},
                   {"outcome", run.outcome},
                   {"depth_m", finite(run.depth)},
                   {"emulated_m", finite(run.emulated)},
                   {"standardised_difference", run.depth ? finite(run.standardised) : Json()}});
    if (run.elements_in_length) all.back()["elements_in_erosion_length"] = *run.elements_in_length;
  }
  return all;
}

// --- the page -------------------------------------------------------------------------------------------------------

namespace {

Figure fresh_figure(const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  Series runs = series("fresh runs", Mark::points, 0);
  int within = 0;
  std::string mesh = absent;
  double fewest = HUGE_VAL,
         most = 0;  // elements per radius: bodies of other shapes than spheres have numbers of their own
  double low = HUGE_VAL, high = 0;
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
    const auto in_length = number(maybe(run, "elements_in_erosion_length"));
    fewest = std::min(fewest, number_or(run, "elements_per_radius", nowhere));
    most = std::max(most, number_or(run, "elements_per_radius", nowhere));
    mesh = in_length       ? shown(in_length) + " elements in the erosion length"
           : fewest < most ? shown(fewest) + " to " + shown(most) + " elements per radius"
                           : shown(number(run, "elements_per_radius")) + " elements per radius";
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
          .caption = fmt::format("The fitted shots run again at the best point on {}: {} of {} lie within two "
                                 "of the emulator's stated standard errors.",
                                 mesh, within, count),
          .alt = fmt::format("Differences of {} fresh runs from the emulator, {} of them within two standard errors.",
                             count, within),
          .chart = chart};
}

Table fresh_table(const Json& hypothesis) {
  Table table{.caption = "Fresh runs at the best point",
              .rows = {{"shot", "mean of", "depth", "emulator", "in stated errors"}},
              .notes = {}};
  for (const Json& run : list(hypothesis, "fresh_runs")) {
    const auto depth = number(run, "depth_m");
    table.rows.push_back({text(run, "label"), counted(static_cast<long>(number_or(run, "runs", 0)), "run"),
                          depth ? length(depth) : text(run, "outcome"), length(number(run, "emulated_m")),
                          shown(number(run, "standardised_difference"), 2)});
  }
  return table;
}

Table emulator_table(const Json& one) {
  std::string outcomes;
  for (const Json& outcome : list(one, "outcomes"))
    outcomes +=
        fmt::format("{}{} {}", outcomes.empty() ? "" : ", ", shown(number(outcome, "runs")), text(outcome, "outcome"));
  Table table{.caption = "The emulator",
              .rows = {{"", ""},
                       {"runs done", shown(number(one, "runs"))},
                       {"runs from the store", shown(number(one, "reused"))},
                       {"runs of other jobs", shown(number(one, "foreign"))},
                       {"runs of the atlas", shown(number(one, "from_atlas"))},
                       {"outcomes", outcomes},
                       {"leave-one-out error", percent(number(one, "leave_one_out_error"))},
                       {"within its 95 %", percent(number(one, "coverage95"))},
                       {"solver's noise", percent(number(one, "noise"))},
                       {"error at the optimum", percent(number(one, "error_at_optimum"))},
                       {"data's error", percent(number(one, "data_error"))},
                       {"stopped because", text(one, "stopped")}},
              .notes = {}};
  const Json& all_beside = maybe(one, "beside");
  if (all_beside.is_object())
    for (const Json& beside : all_beside)
      table.rows.insert(
          table.rows.end() - 1,
          {text(beside, "learns"),
           fmt::format("{}, one run scatters by {}; told by {} of {}", shown(number(beside, "mean"), 2),
                       rough_percent(number(beside, "noise")), shown(number(beside, "runs")),
                       counted(static_cast<long>(number_or(beside, "runs", 0) + number_or(beside, "runs_without", 0)),
                               "run"))});
  return table;
}

// Nothing of a job with spheres alone.
Table bodies_table(const Json& one) {
  Table table{.caption = "Emulators of other bodies",
              .rows = {{"body", "runs", "leave-one-out error", "solver's noise"}},
              .notes = {}};
  const Json& bodies = maybe(one, "bodies");
  if (!bodies.is_array()) return {};
  for (const Json& body : bodies)
    table.rows.push_back({text(body, "name"), shown(number(body, "runs")), percent(number(body, "leave_one_out_error")),
                          percent(number(body, "noise"))});
  return table;
}

Figure error_figure(const Json& emulator) {
  Chart chart{.title = "The emulator's error at the optimum against processor time",
              .x = {.label = "processor time of the runs, s", .logarithmic = true},
              .y = {.label = "error of a depth, %", .logarithmic = true}};
  const auto error = number(emulator, "error_at_optimum"), data = number(emulator, "data_error");
  Series line = series("", Mark::line, 0), points = series("the emulator's", Mark::points, 0),
         of_data = series("the data's", Mark::dashes, 0);
  for (const Json& round : list(emulator, "rounds")) {
    const double seconds = number_or(round, "cpu_s", 0), share = number_or(round, "error_at_optimum", 0);
    if (!(seconds > 0 && share > 0)) continue;
    add_point(line, seconds, 100 * share);
    add_point(points, seconds, 100 * share);
  }
  if (points.x.size() > 1)
    for (const double end : {points.x.front(), points.x.back()})
      if (data && *data > 0) add_point(of_data, end, 100 * *data);
  if (line.x.size() > 1) add(chart, line);
  add(chart, points);
  add(chart, of_data);
  const std::string finding =
      error && data ? fmt::format(" At the end {}, beside {} of the data.", percent(error), percent(data)) : "";
  return {.name = "error_vs_time",
          .caption = "What a depth's error was after each round of runs." + finding,
          .alt = "Error of the emulator against processor time, falling from round to round." + finding,
          .chart = chart};
}

Table round_table(const Json& emulator) {
  Table table{
      .caption = "Error after each round", .rows = {{"runs", "processor time", "error at the optimum"}}, .notes = {}};
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

Section emulator_section(const Json& result) {
  Section section{.id = "emulator", .title = "Error against run time", .blocks = {}};
  const Json& emulator = at(result, "emulator");
  if (list(at(result, "data"), "shots").empty()) return section;  // nothing was run
  add(section, error_figure(emulator));
  add(section, emulator_table(emulator));
  add(section, bodies_table(emulator));
  add(section, round_table(emulator));
  return section;
}

}  // namespace percal::calibration_page
