// The page of `percal campaign`.
#include "percal/sweep/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "percal/observe/page/outcome_row.hpp"
#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"

namespace percal {

using namespace page;

namespace {

constexpr std::size_t rows_unfolded = 24, rows_in_an_answer = 12;

std::string axis_title(const Json& axis) {
  const std::string unit = text(axis, "unit");
  return text(axis, "key") + (unit.empty() ? "" : ", " + unit);
}

// "3 stopped, 1 passed through".
std::string outcomes_in_words(const Json& result) {
  std::string words;
  for (const auto& [outcome, count] : at(result, "outcomes").items())
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", shown(number(count), 9), outcome);
  return words;
}

// Of the points that have this number.
struct NumberRange {
  double low = HUGE_VAL, high = -HUGE_VAL;
  bool is_there() const { return low <= high; }
};

NumberRange range_over(const std::vector<Json>& points, const char* key) {
  NumberRange range;
  for (const Json& point : points)
    if (const auto value = number(point, key)) range = {std::min(range.low, *value), std::max(range.high, *value)};
  return range;
}

std::string range_words(const NumberRange& range, const Dimension& dimension) {
  return range.is_there() ? quantity(range.low, dimension) + " to " + quantity(range.high, dimension) : absent;
}

std::string sweep_summary(const Json& result) {
  std::string words = fmt::format("{}: {}.", counted(static_cast<long>(list(result, "points").size()), "point"),
                                  outcomes_in_words(result));
  const NumberRange depths = range_over(list(result, "points"), outcome_key::depth);
  return depths.is_there() ? words + " Depths from " + range_words(depths, dimension::length) + "." : words;
}

std::string changed_in_words(const Json& axis) {
  return yes(axis, "is_group") ? text(axis, "key") + " by " + text(axis, "changes") : text(axis, "key");
}

Section swept_section(const Json& result) {
  Section section{.id = "swept", .title = "What was changed", .blocks = {}};
  Table table{.caption = "", .rows = {{"of the scene", "values", "from", "to"}}, .notes = {}};
  const Json& axes = list(result, "axes");
  for (std::size_t k = 0; k < axes.size(); ++k) {
    std::vector<double> numbers;
    std::vector<std::string> words;
    for (const Json& point : list(result, "points")) {
      const std::string word = swept_values(point)[k];
      if (std::ranges::find(words, word) == words.end()) words.push_back(word);
      if (const auto value = number(list(point, "values")[k])) numbers.push_back(*value);
    }
    const std::string unit = text(axes[k], "unit");
    const auto with_its_unit = [&](double value) { return shown(value) + (unit.empty() ? "" : " " + unit); };
    table.rows.push_back({changed_in_words(axes[k]), std::to_string(words.size()),
                          numbers.empty() ? words.front() : with_its_unit(std::ranges::min(numbers)),
                          numbers.empty() ? words.back() : with_its_unit(std::ranges::max(numbers))});
  }
  add(section, table);
  add_sentence(section, "The scene: " + text(result, "scene") + "; the design: " + text(result, "design") + ".");
  return section;
}

// How the points ended, and between what.
Section outcomes_section(const Json& result) {
  Section section{.id = "outcomes", .title = "How the points ended", .blocks = {}, .detail = Detail::answer};
  Table table{.caption = "", .rows = {{"outcome", "points", "depth", "speed left"}}, .notes = {}};
  for (const auto& [outcome, count] : at(result, "outcomes").items()) {
    std::vector<Json> points;
    for (const Json& point : list(result, "points"))
      if (text(point, outcome_key::outcome) == outcome) points.push_back(point);
    table.rows.push_back({outcome, shown(number(count), 9),
                          range_words(range_over(points, outcome_key::depth), dimension::length),
                          range_words(range_over(points, outcome_key::speed_left), dimension::speed)});
  }
  add(section, table);
  return section;
}

Section points_section(const Json& result) {
  const bool is_short = list(result, "points").size() <= rows_in_an_answer;
  Section section{
      .id = "points", .title = "The points", .blocks = {}, .detail = is_short ? Detail::answer : Detail::more};
  Table table{.caption = "", .rows = {{"point"}}, .notes = {}};
  for (const Json& axis : list(result, "axes")) table.rows.front().push_back(axis_title(axis));
  for (const char* column : {"outcome", "depth", "95 %", "speed left", "CPU, s"})
    table.rows.front().emplace_back(column);
  for (const Json& point : list(result, "points")) {
    std::vector<std::string> row{shown(number(point, "point"), 9)};
    for (std::string& value : swept_values(point)) row.push_back(std::move(value));
    row.push_back(text(point, outcome_key::outcome));
    row.push_back(length(number(point, outcome_key::depth)));
    row.push_back(length(number(point, outcome_key::depth_error), 2));
    row.push_back(quantity(number(point, outcome_key::speed_left), dimension::speed));
    row.push_back(shown(number(point, outcome_key::cpu_seconds), 3));
    table.rows.push_back(std::move(row));
  }
  table.folded = table.rows.size() > rows_unfolded;
  table.notes = {"95 %: half width of the depth's error by all sources that have a number; points.csv has each."};
  add(section, table);
  return section;
}

// What the runs of a point say besides; failures have their reasons here.
Section notes_section(const Json& result) {
  Section section{.id = "notes", .title = "What to know about single points", .blocks = {}};
  Table table{.caption = "", .rows = {{"point", "outcome", "note"}}, .notes = {}};
  for (const Json& point : list(result, "points"))
    if (const std::string notes = text(point, outcome_key::notes); !notes.empty())
      table.rows.push_back({shown(number(point, "point"), 9), text(point, outcome_key::outcome), notes});
  table.folded = table.rows.size() > rows_unfolded;
  if (table.rows.size() > 1) add(section, table);
  return section;
}

// The file that the scene was in.
Section scene_section(const Json& result) {
  Section section{.id = "scene", .title = "The scene", .blocks = {}};
  if (const std::string toml = text(result, "scene_toml"); !toml.empty())
    section.blocks.emplace_back(Code{text(result, "scene"), toml});
  return section;
}

}  // namespace

std::vector<std::string> swept_values(const Json& point) {
  std::vector<std::string> words;
  for (const Json& value : list(point, "values"))
    words.push_back(value.is_string() ? text(value) : shown(number(value), 6));
  return words;
}

Page sweep_page(const Json& result) {
  Page page;
  page.title = "Campaign: " + std::filesystem::path(text(at(result, "input"), "job")).stem().string();
  page.summary = sweep_summary(result);
  for (auto section : {outcomes_section, points_section, sweep_figures, findings_section, notes_section, swept_section,
                       provenance_section, input_section, scene_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
