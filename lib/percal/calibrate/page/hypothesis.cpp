// One hypothesis of a calibration: parameters, minima, profiles, curves, depths, fresh runs, error budget, advice.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "percal/calibrate/page/parts.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
constexpr double next_to_nothing = 0.002;  // of a variance
constexpr std::size_t most_advice = 6;

Table parameter_table(const Json& result, const Json& hypothesis) {
  Table table{.caption = "Parameters at the best minimum",
              .rows = {{"parameter", "value", level_words(result) + " interval", "bootstrap", "remark"}},
              .notes = {}};
  for (const Json& one : list(hypothesis, "parameters")) {
    std::string remark = yes(one, "at_bound") ? "at its bound" : "";
    const Json& identifiable = at(one, "identifiable");
    if (identifiable.is_boolean() && !identifiable.get<bool>())
      remark += std::string(remark.empty() ? "" : ", ") + "not identifiable";
    table.rows.push_back({text(one, "name"), value_words(one, "value"), interval_words(one, "interval"),
                          interval_words(one, "bootstrap_interval"), remark});
  }
  for (const Json& one : list(hypothesis, "held"))
    table.rows.push_back({text(one, "name"), value_words(one, "value"), "held", "-", ""});
  table.notes.push_back("Intervals by the profile likelihood.");
  return table;
}

Table minima_table(const Json& hypothesis) {
  const Json& minima = list(hypothesis, "minima");
  Table table{.caption = "Minima", .rows = {{"parameter"}}, .notes = {}};
  if (minima.empty()) return table;
  std::vector<std::string> above{"deviance above the best"};
  for (const Json& minimum : minima) {
    table.rows[0].push_back(fmt::format("minimum {}", table.rows[0].size()));
    above.push_back(shown(number_or(minimum, "deviance", nowhere) - number_or(minima.front(), "deviance", 0), 3));
  }
  for (const Json& one : list(minima.front(), "parameters")) {
    std::vector<std::string> row{text(one, "name")};
    for (const Json& minimum : minima)
      for (const Json& same : list(minimum, "parameters"))
        if (text(same, "name") == row.front()) row.push_back(value_words(same, "value"));
    table.rows.push_back(row);
  }
  table.rows.push_back(above);
  if (minima.size() == 1) table.notes.push_back("The global search found no second one.");
  for (const Json& one : list(minima.front(), "scatter"))
    if (const auto scatter = number(one, "standard_deviation"))
      table.notes.push_back(fmt::format("Scatter of the group \"{}\": {}.", text(one, "group"), percent(scatter)));
  return table;
}

// Every parameter over its best value, so that all share a figure.
Figure profile_figure(const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  Chart chart{.title = "Profile likelihoods",
              .x = {.label = "parameter over its best value"},
              .y = {.label = "rise of the objective", .low = 0, .high = 10}};
  int colour = 0;
  std::string flat, known;
  for (const Json& one : list(hypothesis, "parameters")) {
    const auto best = number(with_unit(one, "value"));
    const Json& profile = at(one, "profile");
    const auto values = numbers(with_unit(profile, "value")), rises = numbers(at(profile, "rise"));
    Series line = series(text(one, "name"), Mark::line, colour++);
    if (!best || *best == 0) continue;
    for (std::size_t i = 0; i < std::min(values.size(), rises.size()); ++i)
      if (values[i] / *best > 0 && rises[i] <= 12) add_point(line, values[i] / *best, rises[i]);
    const Json& identifiable = at(one, "identifiable");
    std::string& names = identifiable.is_boolean() && !identifiable.get<bool>() ? flat : known;
    names += (names.empty() ? "" : ", ") + text(one, "name");
    if (line.x.size() > 1) add(chart, std::move(line));
  }
  double low = 1, high = 1;
  for (const Series& line : chart.series)
    for (const double x : line.x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  chart.x.logarithmic = worth_a_logarithm(low, high);
  std::string caption = "How much the fit worsens when one parameter is held and all others are fitted anew.";
  if (!flat.empty()) caption += " Too flat to be known: " + flat + ".";
  if (!known.empty()) caption += " Known within " + level_words(result) + " intervals: " + known + ".";
  return {.name = fmt::format("profiles_{}", number_of_hypothesis),
          .caption = caption,
          .alt = fmt::format(
              "Rise of the objective against {} parameters over their best values; steep curves are well known "
              "parameters.{}",
              chart.series.size(), flat.empty() ? "" : " Flat: " + flat + "."),
          .chart = chart};
}

Table set_table(const Json& result, const Json& hypothesis) {
  Table table{
      .caption = "Depths by set: model over measured, less 1",
      .rows = {{"set", "shots", "mean size", "signed mean", "within " + level_words(result), "Dehn's mean size"}},
      .notes = {}};
  for (const Json& set : list(hypothesis, "sets")) {
    std::string dehn = "-";
    for (const Json& theirs : list(at(result, "dehn"), "sets"))
      if (text(theirs, "name") == text(set, "name")) dehn = percent(number(theirs, "mean_deviation"));
    table.rows.push_back({text(set, "name"), shown(number(set, "shots")), percent(number(set, "mean_deviation")),
                          signed_percent(number(set, "mean_signed_deviation")),
                          fmt::format("{} of {}", shown(number(set, "within_interval")), shown(number(set, "shots"))),
                          dehn});
  }
  return table;
}

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

// Sources as rows, quantities as columns: shares of each quantity's variance.
Table budget_table(const Json& result, const Json& hypothesis) {
  const Json& budgets = list(hypothesis, "error_budgets");
  Table table{.caption = "Where the errors come from: shares of the variance", .rows = {{"source"}}, .notes = {}};
  std::vector<std::string> sources;
  std::map<std::string, std::map<std::string, double>> shares;  // by quantity and source
  for (const Json& budget : budgets) {
    const std::string quantity_name = text(budget, "quantity");
    table.rows[0].push_back(quantity_name);
    std::string largest;
    double most = 0;
    for (const Json& source : list(budget, "sources")) {
      const double share = number_or(source, "share", 0);
      shares[quantity_name][text(source, "name")] = share;
      if (share >= next_to_nothing && std::find(sources.begin(), sources.end(), text(source, "name")) == sources.end())
        sources.push_back(text(source, "name"));
      if (share > most) {
        most = share;
        largest = text(source, "name");
      }
    }
    const Json& total = at(budget, "total");
    std::string note =
        fmt::format("{}: {} ({}, {}), standard deviation {}; {} of its variance is \"{}\"", quantity_name,
                    value_words(total, "value"), interval_words(total, "interval"), level_words(result),
                    percent(number(budget, "standard_deviation")), percent(most), largest);
    if (const std::string datum = text(budget, "most_influential"); !datum.empty())
      note += fmt::format("; what moves it most is {}, by {} % for each % of depth", datum,
                          shown(number(budget, "influence"), 2));
    table.notes.push_back(note + ".");
  }
  for (const std::string& source : sources) {
    std::vector<std::string> row{source};
    for (std::size_t k = 1; k < table.rows[0].size(); ++k) {
      const auto& of_quantity = shares[table.rows[0][k]];
      const auto share = of_quantity.find(source);
      row.push_back(share != of_quantity.end() && share->second >= next_to_nothing ? percent(share->second) : "-");
    }
    table.rows.push_back(row);
  }
  return table;
}

Table advice_table(const Json& hypothesis) {
  Table table{
      .caption = "What to measure next", .rows = {{"measurement", "interval afterwards over now"}}, .notes = {}};
  std::map<std::string, std::size_t> of_quantity;  // the best few for each
  for (const Json& one : list(hypothesis, "advice")) {
    const std::string measurement = text(one, "measurement");
    if (++of_quantity[measurement.substr(0, measurement.find(':'))] > most_advice) continue;
    table.rows.push_back({measurement, shown(number(one, "interval_width_ratio"), 3)});
  }
  return table;
}

}  // namespace

Section hypothesis_section(const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  Section section{.id = fmt::format("hypothesis-{}", number_of_hypothesis),
                  .title = fmt::format("Hypothesis {}: {}", number_of_hypothesis, text(hypothesis, "name")),
                  .blocks = {}};
  add(section, parameter_table(result, hypothesis));
  add(section, minima_table(hypothesis));
  add(section, profile_figure(result, hypothesis, number_of_hypothesis));
  for (Figure& figure : curve_figures(result, hypothesis, number_of_hypothesis)) add(section, std::move(figure));
  add(section, depths_figure(result, hypothesis, number_of_hypothesis));
  add(section, set_table(result, hypothesis));
  add(section, fresh_figure(result, hypothesis, number_of_hypothesis));
  if (const auto deviation = number(hypothesis, "fresh_mean_deviation"))
    add_sentence(section,
                 fmt::format("The fresh runs lie {} from the measured depths in the mean. Extrapolated to no mesh the "
                             "depths would change by {}.",
                             percent(deviation), signed_percent(number(hypothesis, "mesh_error"), 2)));
  add(section, budget_table(result, hypothesis));
  add(section, advice_table(hypothesis));
  const auto findings = texts(at(hypothesis, "findings"));
  if (!findings.empty()) section.blocks.push_back(List{findings});
  return section;
}

}  // namespace percal::page
