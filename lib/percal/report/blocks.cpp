#include "percal/report/blocks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "percal/report/show.hpp"

namespace percal::report_parts {

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

void add(PageSection& section, PageFigure figure) {
  if (drawable(figure.chart)) section.blocks.push_back(std::move(figure));
}

void add(PageSection& section, PageTable table) {
  if (table.rows.size() > 1) section.blocks.push_back(std::move(table));
}

void add_paragraph(PageSection& section, const std::string& text) {
  if (!text.empty()) section.blocks.push_back(Paragraph{text});
}

void add(Page& page, PageSection section) {
  if (!section.blocks.empty()) page.sections.push_back(std::move(section));
}

PageTable comparison_table(const Json& table) {
  const Json& rows = list(table, "rows");
  const bool remarks =
      std::any_of(rows.begin(), rows.end(), [](const Json& row) { return !text(row, "remark").empty(); });
  PageTable shown_table{.caption = text(table, "name"), .rows = {}, .notes = {}};
  shown_table.rows.push_back({"", "unit", text(table, "reference"), "percal", "difference", "error"});
  if (remarks) shown_table.rows.back().push_back("remark");
  for (const Json& row : rows) {
    const std::string unit = text(row, "unit");
    shown_table.rows.push_back({text(row, "what"), unit.empty() ? "-" : unit, shown(number(row, "reference")),
                                shown(number(row, "ours")), signed_percent(number(row, "difference")),
                                shown(number(row, "error"), 2)});
    if (remarks) shown_table.rows.back().push_back(text(row, "remark"));
  }
  if (const std::string note = text(table, "note"); !note.empty()) shown_table.notes.push_back(note);
  if (const auto mean = number(table, "mean_difference"); mean && rows.size() > 1)
    shown_table.notes.push_back("mean size of the differences " + percent(mean));
  return shown_table;
}

PageSection findings_section(const Json& result) {
  PageSection section{.id = "findings", .title = "What a reader must know", .blocks = {}};
  const auto findings = texts(at(result, "findings"));
  if (!findings.empty()) section.blocks.push_back(Bullets{findings});
  return section;
}

PageSection left_out_section(const Json& result) {
  PageSection section{.id = "left-out", .title = "What was left out", .blocks = {}};
  Bullets bullets;
  for (const Json& omission : list(result, "left_out"))
    bullets.items.push_back(text(omission, "what") + ": " + text(omission, "why"));
  if (!bullets.items.empty()) section.blocks.push_back(bullets);
  return section;
}

PageSection provenance_section(const Json& result) {
  PageSection section{.id = "provenance", .title = "Provenance and cost", .blocks = {}};
  const Json& cost = at(result, "cost").is_object() ? at(result, "cost") : result;
  PageTable table{.caption = "Where these numbers come from", .rows = {{"", ""}}, .notes = {}};
  const auto row = [&](const std::string& what, const std::string& value) {
    if (!value.empty() && value != "-") table.rows.push_back({what, value});
  };
  row("percal", text(result, "percal").empty() ? text(result, "version") : text(result, "percal"));
  row("command", "percal " + text(result, "command"));
  row("job", text(at(result, "input"), "job").empty() ? text(result, "job") : text(at(result, "input"), "job"));
  row("scene", text(at(result, "input"), "scene"));
  row("seed of the bootstrap", shown(number(at(result, "uncertainty"), "seed"), 12));
  row("processor's instruction level", text(result, "isa"));
  row("runs done", shown(number(cost, "runs"), 9));
  row("runs taken from the store", shown(number(cost, "reused"), 9));
  if (const auto seconds = number(cost, "cpu_s")) row("processor time of the runs", fmt::format("{:.4g} s", *seconds));
  if (const auto seconds = number(cost, "wall_s")) row("time in all", fmt::format("{:.4g} s", *seconds));
  if (const auto seconds = number(cost, "budget_s")) row("budget", fmt::format("{:.4g} s", *seconds));
  add(section, std::move(table));
  add_paragraph(section, text(cost, "advice"));
  return section;
}

PageSection input_section(const Json& result) {
  PageSection section{.id = "input", .title = "The input", .blocks = {}};
  const Json& input = at(result, "input");
  const std::string toml = input.is_string() ? input.get<std::string>() : text(input, "toml");
  const std::string name = text(input, "job").empty() ? text(input, "scene") : text(input, "job");
  if (!toml.empty())
    section.blocks.push_back(Preformatted{!name.empty() ? name : text(result, "job"), toml});
  else if (input.is_object())
    section.blocks.push_back(Preformatted{"arguments", input.dump(2)});
  return section;
}

}  // namespace percal::report_parts
