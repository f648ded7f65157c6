// The page of `percal study --extremes`.
#include <fmt/core.h>

#include <cmath>
#include <map>

#include "percal/page/numbers.hpp"
#include "percal/study/page/parts.hpp"

namespace percal::page {
namespace {

Section outcomes_section(const Json& result) {
  Section section{.id = "outcomes", .title = "How the cells ended", .blocks = {}};
  Table table{.caption = "Cells by their outcome", .rows = {{"outcome", "cells"}}, .notes = {}};
  for (const auto& [outcome, count] : at(result, "outcomes").items())
    table.rows.push_back({outcome, shown(number(count), 9)});
  add(section, table);
  const Json& summary = at(result, "summary");
  Table worst{.caption = "The worst of those that ran and are not unstable", .rows = {{"", ""}}, .notes = {}};
  worst.rows.push_back({"energy error", percent(number(summary, "worst_closure"), 3)});
  worst.rows.push_back({"smallest Jacobian of any element", shown(number(summary, "smallest_jacobian"), 3)});
  worst.rows.push_back({"smallest step over the first", shown(number(summary, "smallest_step"), 3)});
  worst.rows.push_back({"cells with troubles", shown(number(summary, "cells_with_troubles"), 9)});
  section.blocks.push_back(worst);
  List troubles;
  for (const Json& cell : list(result, "cells"))
    for (const std::string& trouble : texts(at(cell, "troubles")))
      troubles.items.push_back(text(cell, "group") + ", " + text(cell, "cell") + ": " + trouble);
  if (!troubles.items.empty()) section.blocks.push_back(troubles);
  return section;
}

Figure closure_figure(const Json& result) {
  Figure figure;
  figure.name = "energy_errors";
  figure.chart.title = "Energy error of every cell";
  figure.chart.x.label = "number of the cell in the table";
  figure.chart.y = {.label = "energy error, %", .logarithmic = true, .low = {}, .high = {}, .tics = {}};
  std::map<std::string, Series> of;
  int number_of_cell = 0, colour = 0;
  for (const Json& cell : list(result, "cells")) {
    ++number_of_cell;
    const auto closure = number(cell, "energy_closure");
    if (!closure || *closure == 0) continue;
    const std::string outcome = text(cell, "outcome");
    if (!of.contains(outcome)) of[outcome] = series(outcome, Mark::points, colour++);
    add_point(of[outcome], number_of_cell, 100 * std::abs(*closure));
  }
  for (const auto& [outcome, drawn] : of) add(figure.chart, drawn);
  figure.caption = "How far each run's energy ledger is from closing. Above 5 % a run must say that it is unstable.";
  figure.alt = "Energy errors of all cells, logarithmic. " + figure.caption;
  return figure;
}

Section cells_section(const Json& result) {
  Section section{.id = "cells", .title = "The cells", .blocks = {}};
  add(section, closure_figure(result));
  Table table{.caption = "One thing or two changed in a gold sphere into skin",
              .rows = {{"cell", "number", "group", "outcome", "tip, radii", "energy error", "smallest J",
                        "smallest step", "Mach", "steps", "CPU time", "reason"}},
              .notes = {"A refused cell was not run: the reason has the scene reader's words."}};
  int number_of_cell = 0;
  for (const Json& cell : list(result, "cells"))
    table.rows.push_back({text(cell, "cell"), std::to_string(++number_of_cell), text(cell, "group"),
                          text(cell, "outcome"), shown(number(cell, "tip_over_radius")),
                          signed_percent(number(cell, "energy_closure"), 3),
                          shown(number(cell, "smallest_jacobian"), 2), shown(number(cell, "smallest_step"), 2),
                          shown(number(cell, "mach"), 2), shown(number(cell, "steps"), 9),
                          number(cell, "cpu_s") ? shown(number(cell, "cpu_s"), 2) + " s" : "-",
                          text(cell, "reason").empty() ? "-" : text(cell, "reason")});
  add(section, table);
  return section;
}

}  // namespace

Page extremes_page(const Json& result) {
  Page page;
  page.title = "Stiff and extreme impacts";
  page.summary =
      fmt::format("{} cells, {} with troubles; the worst energy error of a run that is not unstable is {}.",
                  list(result, "cells").size(), shown(number(at(result, "summary"), "cells_with_troubles"), 9),
                  percent(number(at(result, "summary"), "worst_closure"), 2));
  for (auto section : {outcomes_section, cells_section, provenance_section, input_section}) add(page, section(result));
  return page;
}

}  // namespace percal::page
