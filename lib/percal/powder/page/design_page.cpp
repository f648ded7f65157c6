// The page of `percal design`.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/powder/page/page.hpp"

namespace percal {

using namespace page;

namespace {

std::string band_of(const Json& result) {
  const Json& band = at(result, "band");
  return fmt::format("between {} and {} of {}", value_words(band, "from_m"), value_words(band, "to_m"),
                     text(result, "material"));
}

std::string design_summary(const Json& result) {
  const Json& best = at(result, "best");
  if (best.is_null()) return fmt::format("Nothing that was searched puts mass {} within the limits.", band_of(result));
  return fmt::format("A median radius of {} ({}) at {} puts most of the mass {}: {} ({} {}).",
                     value_words(best, "radius_m"), value_words(best, "density_kg_m3"), value_words(best, "speed_m_s"),
                     band_of(result), share_words(best, "dose"), level_words(result),
                     share_interval_words(best, "dose"));
}

Table best_table(const Json& result) {
  Table table{.caption = "The best", .rows = {{"", "value", level_words(result)}}, .notes = {}};
  const Json& best = at(result, "best");
  if (best.is_null()) return table;
  table.rows.push_back({"radius", value_words(best, "radius_m"), ""});
  table.rows.push_back({"density", value_words(best, "density_kg_m3"), ""});
  table.rows.push_back({"speed", value_words(best, "speed_m_s"), interval_words(best, "best_speed_interval_m_s")});
  table.rows.push_back({"density speed radius", value_words(best, "impact_kg_m_s"), ""});
  for (const auto& [name, key] : {std::pair{"in the band", "dose"}, {"bounced", "bounced"}, {"passed", "passed"}})
    table.rows.push_back({name, share_words(best, key), share_interval_words(best, key)});
  if (const Json& limits = at(result, "limits"); number(limits, "deeper_than_m"))
    table.rows.push_back({"deeper than " + value_words(limits, "deeper_than_m"), share_words(best, "deeper"),
                          share_interval_words(best, "deeper")});
  table.notes = {"Radius, density and speed are the powder's medians, by number; shares are of the mass.",
                 "The speed's interval: the best one at this radius, for all parameters that are not ruled out."};
  return table;
}

Table tolerance_table(const Json& result) {
  const std::string enough = percent(number(result, "enough"), 0);
  Table table{.caption = "How far one number may be off and leave " + enough + " of that dose",
              .rows = {{"", "from", "to"}},
              .notes = {}};
  const Json& best = at(result, "best");
  if (best.is_null()) return table;
  const auto row = [&](const std::string& name, const char* key, const Dimension& dimension) {
    const Json& tolerance = at(best, key);
    const auto end = [&](const char* side, const char* open) {
      return (yes(tolerance, open) ? "the end looked at, " : "") + quantity(number(tolerance, side), dimension, 3);
    };
    table.rows.push_back({name, end("low", "low_open"), end("high", "high_open")});
  };
  row("median radius", "radius_tolerance_m", dimension::length);
  row("median speed", "speed_tolerance_m_s", dimension::speed);
  return table;
}

Table other_spread_table(const Json& result) {
  Table table{.caption = "The same with other spreads of sizes and of the device's speeds",
              .rows = {{"of", "geometric standard deviation", "of the mass in the band"}},
              .notes = {}};
  for (const Json& one : list(result, "spreads"))
    table.rows.push_back({text(one, "of"), shown(number(one, "geometric_deviation"), 3), percent(number(one, "dose"))});
  return table;
}

Table density_table(const Json& result) {
  Table table{
      .caption = "The best of each density", .rows = {{"density", "radius", "speed", "in the band"}}, .notes = {}};
  for (const Json& point : list(result, "by_density"))
    table.rows.push_back({value_words(point, "density_kg_m3"), value_words(point, "radius_m"),
                          value_words(point, "speed_m_s"), percent(number(point, "dose"))});
  if (table.rows.size() < 3) table.rows.clear();
  return table;
}

Table line_table(const Json& result) {
  Table table{.caption = "The best speed for each radius",
              .rows = {{"radius", "speed", "in the band", "bounced", "passed"}},
              .notes = {}};
  for (const Json& point : list(result, "line"))
    table.rows.push_back({value_words(point, "radius_m"), value_words(point, "speed_m_s"),
                          percent(number(point, "dose")), percent(number(point, "bounced")),
                          percent(number(point, "passed"))});
  return table;
}

// Classes of the dose by colour, from none to the most; the line of the best speeds, the best.
Figure map_figure(const Json& result) {
  constexpr int classes = 5;
  double most = 0;
  for (const Json& point : list(result, "map")) most = std::max(most, number_or(point, "dose", 0));
  std::vector<Series> by_class;
  for (int k = 0; k < classes; ++k)
    by_class.push_back(series(
        fmt::format("{:.0f} to {:.0f} %", 100 * most * k / classes, 100 * most * (k + 1) / classes), Mark::points, k));
  Series forbidden = series("beyond the limits", Mark::points, -1), line = series("best speed", Mark::line, 5),
         best = series("best", Mark::points_with_bars, 6);
  const auto x = [](const Json& point) { return 1e6 * number_or(point, "radius_m", NAN); };
  const auto y = [](const Json& point) { return number_or(point, "speed_m_s", NAN); };
  for (const Json& point : list(result, "map")) {
    const int which = std::min(classes - 1, static_cast<int>(classes * number_or(point, "dose", 0) / most));
    add_point(yes(point, "allowed") ? by_class[static_cast<std::size_t>(which)] : forbidden, x(point), y(point));
  }
  for (const Json& point : list(result, "line")) add_point(line, x(point), y(point));
  if (const Json& point = at(result, "best"); !point.is_null()) {
    const Json& tolerance = at(point, "speed_tolerance_m_s");
    add_bar(best, x(point), y(point), number_or(tolerance, "low", NAN), number_or(tolerance, "high", NAN));
  }
  Chart chart{.title = "Of the mass " + band_of(result),
              .x = {.label = "median radius, um", .logarithmic = true},
              .y = {.label = "median speed, m/s"}};
  for (Series& one : by_class) add(chart, std::move(one));
  for (Series* one : {&forbidden, &line, &best}) add(chart, std::move(*one));
  return {
      .name = "map",
      .caption = fmt::format("The share of the mass {}, over radius and speed. The bar of the best leaves {} of its "
                             "dose.",
                             band_of(result), percent(number(result, "enough"), 0)),
      .alt = "Map of the dose in the band over radius and speed, with the best point and the line of best speeds.",
      .chart = chart};
}

Section design_answer_section(const Json& result) {
  Section section{.id = "answer", .title = "Design", .blocks = {}, .detail = Detail::answer};
  add(section, List{texts(at(result, "findings")), Tone::warning});
  add(section, best_table(result));
  add(section, tolerance_table(result));
  add(section, density_table(result));
  return section;
}

Section design_map(const Json& result) {
  Section section{.id = "map", .title = "Over radius and speed", .blocks = {}};
  add(section, map_figure(result));
  add(section, line_table(result));
  return section;
}

Section spread_section(const Json& result) {
  Section section{.id = "spread", .title = "What the spread is worth", .blocks = {}};
  add(section, other_spread_table(result));
  return section;
}

}  // namespace

page::Page design_page(const Json& result) {
  Page page{.title = text(result, "title"), .summary = design_summary(result), .sections = {}};
  for (auto section : {design_answer_section, design_map, spread_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
