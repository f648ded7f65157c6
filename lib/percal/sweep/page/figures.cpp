// The figures of a campaign: depth over the first number that was swept, a line for each value of the second; or, where the points make
// no lines, a map of the depth over two numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "percal/observe/page/outcome_row.hpp"
#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/sweep/page/page.hpp"

namespace percal {

using namespace page;

namespace {

constexpr std::size_t most_lines = 7, most_figures = 6;
constexpr int depth_classes = 5;

// Points that one figure shows, and what the figure's title says of the axes that it does not have.
struct Shown {
  std::vector<const Json*> points;
  std::string others;
};

// An axis of the plan with more than one value.
struct Swept {
  std::size_t index;
  std::string label, key, unit;
  bool is_number;
  std::set<std::string> words;
};

std::vector<Swept> varying_axes(const Json& result) {
  std::vector<Swept> varying;
  const Json& axes = list(result, "axes");
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const std::string key = text(axes[k], "key"), unit = text(axes[k], "unit");
    Swept axis{k, key + (unit.empty() ? "" : ", " + unit), key, unit, yes(axes[k], "is_number"), {}};
    for (const Json& point : list(result, "points")) axis.words.insert(swept_values(point)[k]);
    if (axis.words.size() > 1) varying.push_back(std::move(axis));
  }
  return varying;
}

std::string value_word(const Json& point, const Swept& axis) {
  return swept_values(point)[axis.index] + (axis.unit.empty() ? "" : " " + axis.unit);
}
double value_number(const Json& point, const Swept& axis) {
  return number(list(point, "values")[axis.index]).value_or(NAN);
}

Axis axis_of_numbers(const Swept& swept, const std::vector<const Json*>& points) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Json* point : points) {
    low = std::min(low, value_number(*point, swept));
    high = std::max(high, value_number(*point, swept));
  }
  return {.label = swept.label, .logarithmic = low > 0 && worth_a_logarithm(low, high)};
}

// What the shown points without a depth ended as; empty where all have one.
std::string without_depth(const std::vector<const Json*>& points) {
  std::map<std::string, int> counts;
  for (const Json* point : points)
    if (!number(*point, outcome_key::depth)) ++counts[text(*point, outcome_key::outcome)];
  std::string words;
  for (const auto& [outcome, count] : counts)
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, outcome);
  return words.empty() ? "" : " Without a depth: " + words + ".";
}

ShownUnit unit_of_depths(const Json& result) {
  double typical = 0;
  for (const Json& point : list(result, "points"))
    typical = std::max({typical, number_or(point, outcome_key::depth, 0), number_or(point, outcome_key::at_least, 0)});
  return length_unit(typical);
}

void add_depth(Series& drawn, Series& line, Series& passed, const Json& point, double x, double unit) {
  const double depth = number_or(point, outcome_key::depth, NAN), error = number_or(point, outcome_key::depth_error, 0);
  if (std::isfinite(depth)) {
    add_bar(drawn, x, depth / unit, std::max(0.0, depth - error) / unit, (depth + error) / unit);
    add_point(line, x, depth / unit);
  } else if (const auto at_least = number(point, outcome_key::at_least)) {
    add_point(passed, x, *at_least / unit);
  }
}

// The points by the value of an axis, in the order in which values come; all of them under "" without one.
std::vector<std::pair<std::string, std::vector<const Json*>>> by_value(const std::vector<const Json*>& points,
                                                                       const Swept* axis) {
  std::vector<std::pair<std::string, std::vector<const Json*>>> groups;
  for (const Json* point : points) {
    const std::string word = axis ? axis->key + " " + value_word(*point, *axis) : "";
    auto group = std::ranges::find(groups, word, &std::pair<std::string, std::vector<const Json*>>::first);
    if (group == groups.end()) group = groups.insert(groups.end(), {word, {}});
    group->second.push_back(point);
  }
  return groups;
}

Figure depth_over(const Shown& shown, const Swept& x, const Swept* lines, const ShownUnit& unit) {
  Figure figure;
  figure.chart.title = "Depth over " + x.key + shown.others;
  figure.chart.x = axis_of_numbers(x, shown.points);
  figure.chart.y.label = "depth, " + unit.name;
  int colour = 0;
  Series passed = series("passed through: deeper than", Mark::points, -1);
  for (auto& [name, points] : by_value(shown.points, lines)) {
    std::ranges::stable_sort(points, {}, [&](const Json* point) { return value_number(*point, x); });
    Series drawn = series(name.empty() ? "depth" : name, Mark::points_with_bars, colour),
           line = series("", Mark::line, colour);
    for (const Json* point : points) add_depth(drawn, line, passed, *point, value_number(*point, x), unit.size);
    for (const Series& one : {line, drawn}) add(figure.chart, one);
    ++colour;
  }
  add(figure.chart, passed);
  figure.caption = "Mean depths of each point's runs; bars are the depth's error, 95 %." + without_depth(shown.points);
  figure.alt = figure.chart.title + (lines ? ", a line for each " + lines->key : "") + ". " + figure.caption;
  return figure;
}

// Classes of depth of the same width, from the least to the largest.
struct DepthClasses {
  double low = HUGE_VAL, high = -HUGE_VAL;
  int of(double depth) const {
    return high > low ? std::min(depth_classes - 1, static_cast<int>(depth_classes * (depth - low) / (high - low))) : 0;
  }
  double edge(int k) const { return low + (high - low) * k / depth_classes; }
};

DepthClasses classes_of(const std::vector<const Json*>& points) {
  DepthClasses classes;
  for (const Json* point : points)
    if (const auto depth = number(*point, outcome_key::depth)) {
      classes.low = std::min(classes.low, *depth);
      classes.high = std::max(classes.high, *depth);
    }
  return classes;
}

Figure depth_map(const Shown& shown, const Swept& x, const Swept& y, const ShownUnit& unit) {
  Figure figure;
  figure.chart.title = "Depth over " + x.key + " and " + y.key + shown.others;
  figure.chart.x = axis_of_numbers(x, shown.points);
  figure.chart.y = axis_of_numbers(y, shown.points);
  const DepthClasses classes = classes_of(shown.points);
  std::vector<Series> by_class;
  for (int k = 0; k < depth_classes; ++k)
    by_class.push_back(series(
        fmt::format("{:.3g} to {:.3g} {}", classes.edge(k) / unit.size, classes.edge(k + 1) / unit.size, unit.name),
        Mark::points, k));
  std::map<std::string, Series> others;
  for (const Json* point : shown.points) {
    const auto depth = number(*point, outcome_key::depth);
    const std::string outcome = text(*point, outcome_key::outcome);
    if (!depth && !others.contains(outcome))
      others[outcome] =
          series(outcome, Mark::points, others.empty() ? -1 : depth_classes + static_cast<int>(others.size()));
    Series& drawn = depth ? by_class[static_cast<std::size_t>(classes.of(*depth))] : others[outcome];
    add_point(drawn, value_number(*point, x), value_number(*point, y));
  }
  for (const Series& one : by_class) add(figure.chart, one);
  for (const auto& [outcome, one] : others) add(figure.chart, one);
  figure.caption = "Each mark is a point of the plan; its colour says the depth." + without_depth(shown.points);
  figure.alt = figure.chart.title + ". " + figure.caption;
  return figure;
}

// One for each combination of the axes that a figure does not have.
std::vector<Shown> shown_by(const Json& result, const std::vector<Swept>& others) {
  std::vector<Shown> all;
  for (const Json& point : list(result, "points")) {
    std::string words;
    for (const Swept& axis : others) words += (words.empty() ? ": " : ", ") + axis.key + " " + value_word(point, axis);
    auto shown = std::ranges::find(all, words, &Shown::others);
    if (shown == all.end()) shown = all.insert(all.end(), {{}, words});
    shown->points.push_back(&point);
  }
  return all;
}

bool has_a_number_to_show(const Shown& shown) {
  return std::ranges::any_of(shown.points, [](const Json* point) {
    return number(*point, outcome_key::depth) || number(*point, outcome_key::at_least);
  });
}

// The first number goes along the axis; then what makes lines or the other side of a map, then the rest.
void put_numbers_first(std::vector<Swept>& axes, bool makes_lines) {
  std::stable_partition(axes.begin(), axes.end(), [](const Swept& axis) { return axis.is_number; });
  if (makes_lines && axes.size() > 2 && axes[1].words.size() > most_lines)
    std::stable_partition(axes.begin() + 1, axes.end(),
                          [](const Swept& axis) { return axis.words.size() <= most_lines; });
}

}  // namespace

Section sweep_figures(const Json& result) {
  Section section{.id = "figures", .title = "Depth over what was changed", .blocks = {}};
  std::vector<Swept> axes = varying_axes(result);
  const bool makes_lines = text(result, "design") == word(Design::grid) && text(result, "list").empty();
  put_numbers_first(axes, makes_lines);
  if (axes.empty() || !axes.front().is_number) return section;
  const ShownUnit unit = unit_of_depths(result);
  const bool is_map = axes.size() > 1 && axes[1].is_number && !(makes_lines && axes[1].words.size() <= most_lines);
  const auto all = shown_by(
      result, makes_lines && axes.size() > 2 ? std::vector<Swept>(axes.begin() + 2, axes.end()) : std::vector<Swept>{});
  std::size_t drawn = 0;
  for (const Shown& shown : all) {
    if (!is_map && !has_a_number_to_show(shown)) continue;
    if (drawn == most_figures) break;
    Figure figure = is_map ? depth_map(shown, axes[0], axes[1], unit)
                           : depth_over(shown, axes[0], axes.size() > 1 ? &axes[1] : nullptr, unit);
    figure.name = fmt::format("depths{}", ++drawn);
    add(section, figure);
  }
  if (all.size() > drawn)
    add_sentence(section, fmt::format("{} of {} figures are shown; points.csv has all points.", drawn, all.size()));
  return section;
}

}  // namespace percal
