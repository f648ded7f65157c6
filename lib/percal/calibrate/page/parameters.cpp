// What was looked for and what a hypothesis found: parameters, minima, profiles, what determines what.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/page/sections.hpp"
#include "percal/fit/page/fit_json.hpp"
#include "percal/page/numbers.hpp"
#include "percal/units/words.hpp"

namespace percal::calibration_page {
namespace {

Json value_to_json(const FreeParameter& parameter, double searched) {
  return {{"name", parameter.name}, {key_of("value", parameter), finite(parameter.natural(searched))}};
}

Json profile_to_json(const FreeParameter& parameter, const ProfileInterval& interval) {
  std::vector<double> values, rises;
  for (const ProfilePoint& point : interval.profile) {
    values.push_back(parameter.natural(point.searched));
    rises.push_back(point.rise);
  }
  return {{key_of("value", parameter), numbers_to_json(values)}, {"rise", numbers_to_json(rises)}};
}

Json combinations_to_json(const std::vector<FreeParameter>& parameters, const std::vector<Combination>& combinations) {
  Json all = Json::array();
  for (const Combination& combination : combinations) {
    Json weights = Json::array();
    for (std::size_t k = 0; k < parameters.size(); ++k)
      weights.push_back(
          {{"name", parameters[k].name}, {"weight", finite(combination.weight[static_cast<Eigen::Index>(k)])}});
    all.push_back({{"weights", weights},
                   {"standard_deviation", finite(combination.standard_deviation)},
                   {"determined", combination.determined}});
  }
  return all;
}

// Rows and columns in the order of the parameters.
Json correlation_to_json(const Minimum& minimum) {
  const Eigen::MatrixXd matrix = correlation(minimum);
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(finite(matrix(i, j)));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::string key_of(const std::string& key, const FreeParameter& parameter) {
  return parameter.unit.empty() ? key : key + "_" + parameter.unit;
}

Json numbers_to_json(const std::vector<double>& values) {
  Json all = Json::array();
  for (const double value : values) all.push_back(finite(value));
  return all;
}

Json interval_to_json(const Interval& interval) {
  return {{"low", finite(interval.low)},
          {"high", finite(interval.high)},
          {"low_open", interval.low_open},
          {"high_open", interval.high_open}};
}

std::vector<FreeParameter> fitted_parameters(const CalibrationJob& job, const HypothesisResult& result) {
  std::vector<FreeParameter> parameters;
  for (const int k : result.parameters) parameters.push_back(job.parameters[k].free);
  return parameters;
}

Json searched_to_json(const CalibrationJob& job) {
  Json all = Json::array();
  for (const auto& [kind, free] : job.parameters)
    all.push_back({{"name", free.name},
                   {"kind", word(kind)},
                   {key_of("low", free), free.low},
                   {key_of("high", free), free.high},
                   {"logarithmic", free.logarithmic},
                   {key_of("prior", free), finite(free.prior)},
                   {"prior_error", free.prior ? finite(free.prior_error) : Json()}});
  return all;
}

Json minimum_to_json(const CalibrationJob& job, const std::vector<FreeParameter>& parameters, const Minimum& minimum) {
  Json values = Json::array(), scatter = Json::array();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    values.push_back(value_to_json(parameters[k], minimum.searched[static_cast<Eigen::Index>(k)]));
    values.back()["at_bound"] = static_cast<bool>(minimum.at_bound[k]);
  }
  for (std::size_t g = 0; g < minimum.scatter.size() && g < job.groups.size(); ++g)
    scatter.push_back({{"group", job.groups[g].name}, {"standard_deviation", finite(minimum.scatter[g])}});
  return {{"parameters", values},
          {"objective", finite(minimum.objective)},
          {"deviance", finite(minimum.deviance)},
          {"degrees_of_freedom", minimum.degrees_of_freedom},
          {"scatter", scatter},
          {"converged", minimum.converged},
          {"evaluations", minimum.evaluations}};
}

Json parameters_to_json(const std::vector<FreeParameter>& parameters, const Minimum& best,
                        const std::vector<ProfileInterval>& intervals, const std::optional<Bootstrap>& bootstrap) {
  Json all = Json::array();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const FreeParameter& parameter = parameters[k];
    const auto i = static_cast<Eigen::Index>(k);
    Json entry = value_to_json(parameter, best.searched[i]);
    entry.update({{"at_bound", static_cast<bool>(best.at_bound[k])},
                  {"standard_error_searched", finite(std::sqrt(best.covariance(i, i)))},
                  {key_of("interval", parameter), nullptr},
                  {key_of("region", parameter), nullptr},
                  {"identifiable", nullptr},
                  {"profile", nullptr},
                  {key_of("bootstrap_interval", parameter), nullptr}});
    for (const ProfileInterval& interval : intervals) {
      if (interval.parameter != static_cast<int>(k)) continue;
      entry[key_of("interval", parameter)] = interval_to_json(interval.interval);
      entry[key_of("region", parameter)] = region_to_json(interval.region);
      entry["identifiable"] = interval.identifiable;
      entry["profile"] = profile_to_json(parameter, interval);
    }
    if (bootstrap && k < bootstrap->intervals.size())
      entry[key_of("bootstrap_interval", parameter)] = interval_to_json(bootstrap->intervals[k]);
    all.push_back(entry);
  }
  return all;
}

Json fit_to_json(const CalibrationJob& job, const HypothesisResult& result) {
  const auto parameters = fitted_parameters(job, result);
  const bool found = !result.minima.empty();
  Json held = Json::array(), minima = Json::array();
  for (const auto& [k, value] : job.hypotheses[result.index].held) {
    const FreeParameter& free = job.parameters[k].free;
    held.push_back({{"name", free.name}, {key_of("value", free), value}});
  }
  for (const Minimum& minimum : result.minima) minima.push_back(minimum_to_json(job, parameters, minimum));
  return {{"held", held},
          {"minima", minima},
          {"parameters",
           found ? parameters_to_json(parameters, result.minima.front(), result.intervals, result.bootstrap) : Json()},
          {"correlation", found ? correlation_to_json(result.minima.front()) : Json()},
          {"bootstrap", result.bootstrap ? Json{{"replicates", result.bootstrap->searched.rows()},
                                                {"failed", result.bootstrap->failed}}
                                         : Json()},
          {"combinations", combinations_to_json(parameters, result.combinations)}};
}

// --- the page -------------------------------------------------------------------------------------------------------

std::string allowed_words(const Json& parameter) {
  return with_unit(parameter, "region").size() > 1 ? region_words(parameter, "region")
                                                   : interval_words(parameter, "interval");
}

Table searched_table(const Json& result) {
  Table table{.caption = "Parameters",
              .rows = {{"parameter", "kind", "searched from", "to", "expected beforehand"}},
              .notes = {}};
  for (const Json& one : list(at(result, "data"), "parameters"))
    table.rows.push_back({text(one, "name"), text(one, "kind"), value_words(one, "low"), value_words(one, "high"),
                          value_words(one, "prior")});
  return table;
}

namespace {

std::string verdict_on(const Json& parameter) {
  std::string verdict = yes(parameter, "at_bound") ? "at its bound" : "";
  if (at(parameter, "identifiable") == Json(false))
    verdict += std::string(verdict.empty() ? "" : ", ") + "not identifiable";
  return verdict;
}

Table parameter_table(const Json& result, const Json& hypothesis) {
  Table table{.caption = "Parameters at the best minimum",
              .rows = {{"parameter", "value", level_words(result) + " interval", "bootstrap", "remark"}},
              .notes = {"Intervals by the profile likelihood."}};
  for (const Json& one : list(hypothesis, "parameters"))
    table.rows.push_back({text(one, "name"), value_words(one, "value"), allowed_words(one),
                          interval_words(one, "bootstrap_interval"), verdict_on(one)});
  for (const Json& one : list(hypothesis, "held"))
    table.rows.push_back({text(one, "name"), value_words(one, "value"), "held", "-", ""});
  const Json& bootstrap = at(hypothesis, "bootstrap");
  if (const double failed = number(bootstrap, "failed").value_or(0); failed > 0)
    table.notes.push_back(fmt::format("{} of {} bootstrap replicates did not converge and are left out.", failed,
                                      failed + number_or(bootstrap, "replicates", 0)));
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
      table.notes.push_back(
          fmt::format("Scatter of the group \"{}\": {}.", text(one, "group"), rough_percent(scatter)));
  return table;
}

// Every parameter over its best value, so that all share a figure.
Figure profile_figure(const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  Chart chart{.title = "Profile likelihoods",
              .x = {.label = "parameter over its best value"},
              .y = {.label = "rise of the objective", .low = 0, .high = 10}};
  int colour = 0;
  std::vector<std::string> flat, known;
  double low = 1, high = 1;
  for (const Json& one : list(hypothesis, "parameters")) {
    const auto best = number(with_unit(one, "value"));
    const Json& profile = at(one, "profile");
    const auto values = numbers(with_unit(profile, "value")), rises = numbers(at(profile, "rise"));
    Series line = series(text(one, "name"), Mark::line, colour++);
    if (!best || *best == 0) continue;
    for (std::size_t i = 0; i < std::min(values.size(), rises.size()); ++i)
      if (values[i] / *best > 0 && rises[i] <= 12) {
        add_point(line, values[i] / *best, rises[i]);
        low = std::min(low, values[i] / *best);
        high = std::max(high, values[i] / *best);
      }
    (at(one, "identifiable") == Json(false) ? flat : known).push_back(text(one, "name"));
    if (line.x.size() > 1) add(chart, std::move(line));
  }
  chart.x.logarithmic = worth_a_logarithm(low, high);
  std::string caption = "How much the fit worsens when one parameter is held and all others are fitted anew.";
  if (!flat.empty()) caption += " Too flat to be known: " + listed(flat) + ".";
  if (!known.empty()) caption += " Known within " + level_words(result) + " intervals: " + listed(known) + ".";
  return {.name = fmt::format("profiles_{}", number_of_hypothesis),
          .caption = caption,
          .alt = fmt::format(
              "Rise of the objective against {} parameters over their best values; steep curves are well known "
              "parameters.{}",
              chart.series.size(), flat.empty() ? "" : " Flat: " + listed(flat) + "."),
          .chart = chart};
}

}  // namespace

void add_fit(Section& section, const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  add(section, parameter_table(result, hypothesis));
  add(section, minima_table(hypothesis));
  add(section, profile_figure(result, hypothesis, number_of_hypothesis));
}

}  // namespace percal::calibration_page
