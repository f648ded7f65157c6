#include "percal/page/sections.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "percal/page/numbers.hpp"

namespace percal::page {

Series series(const std::string& name, Mark mark, int colour) {
  Series made;
  made.name = name;
  made.mark = mark;
  made.colour = colour;
  return made;
}

void add_point(Series& series, double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  series.x.push_back(x);
  series.y.push_back(y);
}

void add_bar(Series& series, double x, double y, double low, double high) {
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  add_point(series, x, y);
  series.low.push_back(std::isfinite(low) ? low : y);
  series.high.push_back(std::isfinite(high) ? high : y);
}

void add(Chart& chart, Series series) {
  if (!series.x.empty()) chart.series.push_back(std::move(series));
}

bool drawable(const Chart& chart) { return !chart.series.empty(); }

bool worth_a_logarithm(double low, double high) { return low > 0 && high > 4 * low; }

std::vector<double> spaced(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(low + (high - low) * i / (count - 1));
  return values;
}

void add(Section& section, Figure figure) {
  if (drawable(figure.chart)) section.blocks.push_back(std::move(figure));
}

void add(Section& section, Table table) {
  if (table.rows.size() > 1) section.blocks.push_back(std::move(table));
}

void add(Section& section, List list) {
  if (!list.items.empty()) section.blocks.push_back(std::move(list));
}

void add_sentence(Section& section, const std::string& text) {
  if (!text.empty()) section.blocks.push_back(Sentence{text});
}

void add(Page& page, Section section) {
  if (!section.blocks.empty()) page.sections.push_back(std::move(section));
}

Section findings_section(const Json& result) {
  Section section{.id = "findings", .title = "What a reader must know", .blocks = {}, .detail = Detail::answer};
  add(section, List{texts(at(result, "findings")), Tone::note});
  return section;
}

Section left_out_section(const Json& result) {
  Section section{.id = "left-out", .title = "What was left out", .blocks = {}};
  List omissions;
  for (const Json& omission : list(result, "left_out"))
    omissions.items.push_back(text(omission, "what") + ": " + text(omission, "why"));
  add(section, std::move(omissions));
  return section;
}

Section provenance_section(const Json& result) {
  Section section{.id = "provenance", .title = "Provenance and cost", .blocks = {}};
  const Json &cost = at(result, "cost"), &input = at(result, "input");
  Table table{.caption = "Where these numbers come from", .rows = {{"", ""}}, .notes = {}};
  const auto row = [&](const std::string& what, const std::string& value) {
    if (!value.empty() && value != absent) table.rows.push_back({what, value});
  };
  const auto seconds = [&](const char* what, const char* key) {
    if (const auto found = number(cost, key)) row(what, fmt::format("{:.4g} s", *found));
  };
  row("percal", text(result, "percal"));
  row("command", "percal " + text(result, "command"));
  row("job", text(maybe(input, "job")));
  row("scene", text(maybe(input, "scene")));
  row("seed", shown(number(maybe(result, "seed")), 12));
  row("processor's instruction level", text(cost, "isa"));
  row("runs done", shown(number(cost, "runs"), 9));
  row("runs taken from the store", shown(number(cost, "reused"), 9));
  seconds("processor time", "cpu_s");
  seconds("time in all", "wall_s");
  seconds("budget", "budget_s");
  add(section, std::move(table));
  return section;
}

Section input_section(const Json& result) {
  const Json& input = at(result, "input");
  const std::string toml = text(maybe(input, "toml"));
  const std::string name = text(maybe(input, "job")) + text(maybe(input, "scene"));
  return {.id = "input",
          .title = "The input",
          .blocks = {toml.empty() ? Code{"arguments", input.dump(2)} : Code{name, toml}}};
}

}  // namespace percal::page
