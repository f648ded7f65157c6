// What concerns all hypotheses of a calibration: the ridges, predictions beside Dehn's closed form, the emulators.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/page/parts.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

// Moduli that have a ridge in some hypothesis, in the order of the data.
std::vector<std::string> moduli_with_ridge(const Json& result) {
  std::vector<std::string> names;
  for (const Json& hypothesis : list(result, "hypotheses"))
    for (const Json& ridge : list(hypothesis, "ridges"))
      if (const std::string name = text(ridge, "y_parameter");
          std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  return names;
}

double best_value(const Json& hypothesis, const std::string& parameter) {
  for (const Json& one : list(hypothesis, "parameters"))
    if (text(one, "name") == parameter) return number(one, "value_Pa").value_or(number_or(one, "value", nowhere));
  return nowhere;
}

struct Extent {
  double low = HUGE_VAL, high = 0;
  void take(double value) {
    if (!(value > 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Figure ridge_figure(const Json& result, const std::string& modulus, int figure_number) {
  Extent pascals;
  for (const Json& hypothesis : list(result, "hypotheses")) pascals.take(best_value(hypothesis, modulus));
  const ShownUnit unit = pressure_unit(pascals.low);
  Chart chart{.title = "What the data allow: " + modulus + " over the erosion strain",
              .x = {.label = "erosion strain (engineering)"},
              .y = {.label = modulus + " as given, " + unit.name}};
  std::string finding;
  Extent drawn;
  int colour = 0;
  for (const Json& hypothesis : list(result, "hypotheses")) {
    const std::string name = text(hypothesis, "name");
    for (const Json& ridge : list(hypothesis, "ridges")) {
      if (text(ridge, "y_parameter") != modulus) continue;
      Extent range;
      bool first = true;
      for (const Json& contour : list(ridge, "contours")) {
        const auto x = numbers(at(contour, "x")), y = numbers(at(contour, "y_Pa"));
        Series line = series(first ? name : "", Mark::line, colour);
        for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
          add_point(line, x[i], y[i] / unit.size);
          range.take(y[i]);
          drawn.take(y[i]);
        }
        first = false;
        add(chart, std::move(line));
      }
      Series best = series(first ? name : "", Mark::points, colour);
      add_point(best, best_value(hypothesis, text(ridge, "x_parameter")), best_value(hypothesis, modulus) / unit.size);
      add(chart, std::move(best));
      if (range.low < range.high)
        finding += fmt::format(" {}: from {} to {}.", name, pressure(range.low, 3), pressure(range.high, 3));
    }
    ++colour;
  }
  int published = 0;
  for (const Json& points : list(at(result, "data"), "ridge_points")) {
    if (text(points, "parameter") != modulus) continue;
    Series pairs = series(text(points, "name"), Mark::points, -1);
    for (const Json& pair : list(points, "pairs")) {
      const double mu = number_or(pair, "mu_as_given_Pa", nowhere);
      drawn.take(mu);
      add_point(pairs, number_or(pair, "erosion_strain", nowhere), mu / unit.size);
    }
    published += static_cast<int>(pairs.x.size());
    add(chart, std::move(pairs));
  }
  chart.y.logarithmic = worth_a_logarithm(drawn.low, drawn.high);
  return {.name = fmt::format("ridge_{}", figure_number),
          .caption = "Allowed in 95 % regions:" + (finding.empty() ? " the best points alone were found." : finding),
          .alt = fmt::format("Outlines of the allowed region of {} over the erosion strain.{}{}", modulus, finding,
                             published > 0 ? fmt::format(" {} published pairs beside them.", published) : ""),
          .chart = chart};
}

// The entry of this name in a list; null where there is none.
const Json& by_name(const Json& entries, const std::string& name) {
  static const Json nothing = nullptr;
  for (const Json& entry : entries)
    if (text(entry, "name") == name) return entry;
  return nothing;
}

std::string prediction_words(const Json& one) { return percent(number(at(one, "prediction"), "mean_deviation")); }

}  // namespace

Section ridges_section(const Json& result) {
  Section section{.id = "ridges", .title = "The ridges", .blocks = {}};
  int n = 0;
  const auto moduli = moduli_with_ridge(result);
  if (!moduli.empty())
    add_sentence(
        section,
        "Outlines of the 95 % regions and best points of each hypothesis, all other parameters fitted anew at every "
        "point. Where a region is long and slanted, modulus and erosion strain change against each other and the "
        "data hardly tell.");
  for (const std::string& modulus : moduli) add(section, ridge_figure(result, modulus, ++n));
  return section;
}

Section predictions_section(const Json& result) {
  Section section{.id = "predictions", .title = "Predicted from the others", .blocks = {}};
  const Json& hypotheses = list(result, "hypotheses");
  Table table{.caption = "Mean size of the deviations of depths that the fit did not see",
              .rows = {{"validation", "predicted", "goal", "Dehn's closed form"}},
              .notes = {}};
  for (std::size_t n = 1; n <= hypotheses.size(); ++n) table.rows[0].push_back(fmt::format("hypothesis {}", n));
  int better = 0, compared = 0;
  for (const char* kind : {"cross_validations", "leave_one_out"}) {
    std::vector<std::string> names;
    for (const Json& hypothesis : hypotheses)
      for (const Json& one : list(hypothesis, kind))
        if (std::find(names.begin(), names.end(), text(one, "name")) == names.end()) names.push_back(text(one, "name"));
    for (const std::string& name : names) {
      const Json& dehn = by_name(list(at(result, "dehn"), kind), name);
      std::vector<std::string> row{name, "-", "-", prediction_words(dehn)};
      for (const Json& hypothesis : hypotheses) {
        const Json& one = by_name(list(hypothesis, kind), name);
        row.push_back(prediction_words(one));
        if (const auto shots = number(at(one, "prediction"), "shots")) row[1] = shown(shots);
        if (const auto goal = number(one, "goal")) row[2] = percent(goal);
        const auto ours = number(at(one, "prediction"), "mean_deviation"),
                   theirs = number(at(dehn, "prediction"), "mean_deviation");
        if (!ours || !theirs) continue;
        ++compared;
        better += *ours < *theirs;
      }
      table.rows.push_back(row);
    }
  }
  if (compared > 0)
    table.notes.push_back(fmt::format(
        "The finite-element model predicts better than Dehn's closed form in {} of {} cases.", better, compared));
  add(section, std::move(table));
  Table dehn{.caption = "Dehn's closed form, fitted to the same shots",
             .rows = {{"parameter", "value", level_words(result) + " interval"}},
             .notes = {}};
  for (const Json& one : list(at(result, "dehn"), "parameters"))
    dehn.rows.push_back({text(one, "name"), value_words(one, "value"), interval_words(one, "interval")});
  add(section, std::move(dehn));
  return section;
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
    const std::string name = text(one, "setting");
    const auto error = number(one, "error_at_optimum"), data = number(one, "data_error");
    const std::vector<std::string> column{name,
                                          shown(number(one, "runs")),
                                          shown(number(one, "reused")),
                                          percent(number(one, "leave_one_out_error")),
                                          percent(number(one, "coverage95")),
                                          percent(number(at(one, "settings"), "noise")),
                                          percent(error),
                                          percent(data),
                                          text(one, "stopped")};
    for (std::size_t row = 0; row < column.size(); ++row) table.rows[row].push_back(column[row]);
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
  return section;
}

}  // namespace percal::page
