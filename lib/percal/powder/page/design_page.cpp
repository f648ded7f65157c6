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
              .rows = {{"radius", "speed", "in the band", "bounced", "passed", "beyond the fitted"}},
              .notes = {}};
  for (const Json& point : list(result, "line"))
    table.rows.push_back({value_words(point, "radius_m"), value_words(point, "speed_m_s"),
                          percent(number(point, "dose")), percent(number(point, "bounced")),
                          percent(number(point, "passed")), percent(number(point, "beyond_fitted"))});
  return table;
}

double map_speed(const Json& point) { return number_or(point, "speed_m_s", NAN); }
double map_radius_um(const Json& point) { return 1e6 * number_or(point, "radius_m", NAN); }
double map_dose(const Json& point) { return number_or(point, "dose", NAN); }

// The points of the map by their radii, each row in the order of its speeds.
std::vector<std::vector<const Json*>> map_rows(const Json& result) {
  std::vector<std::vector<const Json*>> rows;
  for (const Json& point : list(result, "map")) {
    if (rows.empty() || map_radius_um(*rows.back().front()) != map_radius_um(point)) rows.emplace_back();
    rows.back().push_back(&point);
  }
  return rows;
}

// The speeds of a row between which the dose is at least this one; straight lines between its points.
void add_speeds_above(Series& band, const std::vector<const Json*>& row, double least) {
  double low = NAN, high = NAN;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const auto crossing = [&](std::size_t other) {
      const double share = (least - map_dose(*row[k])) / (map_dose(*row[other]) - map_dose(*row[k]));
      return map_speed(*row[k]) + share * (map_speed(*row[other]) - map_speed(*row[k]));
    };
    if (!(map_dose(*row[k]) >= least)) continue;
    if (!std::isfinite(low)) low = k == 0 ? map_speed(*row[k]) : crossing(k - 1);
    high = k + 1 == row.size() ? map_speed(*row[k]) : crossing(k + 1);
  }
  add_bar(band, map_radius_um(*row.front()), (low + high) / 2, low, high);
}

// Where the dose is some shares of the most of the map; what the limits forbid; the line of the best speeds, the best.
Figure map_figure(const Json& result) {
  double most = 0;
  for (const Json& point : list(result, "map")) most = std::max(most, number_or(point, "dose", 0));
  Chart chart{.title = "Of the mass " + band_of(result),
              .x = {.label = "median radius, um", .logarithmic = true},
              .y = {.label = "median speed, m/s"}};
  const auto rows = map_rows(result);
  int colour = 2;
  for (const double share : {0.5, 0.75, 0.9}) {
    Series band = series(fmt::format("{:.0f} % or more", 100 * share * most), Mark::band, colour++);
    for (const auto& row : rows) add_speeds_above(band, row, share * most);
    add(chart, std::move(band));
  }
  Series forbidden = series("beyond the limits", Mark::points, -1), line = series("best speed", Mark::line, 0),
         best = series("best", Mark::points_with_bars, 1);
  for (const Json& point : list(result, "map"))
    if (!yes(point, "allowed")) add_point(forbidden, map_radius_um(point), map_speed(point));
  for (const Json& point : list(result, "line")) add_point(line, map_radius_um(point), map_speed(point));
  if (const Json& point = at(result, "best"); !point.is_null()) {
    const Json& tolerance = at(point, "speed_tolerance_m_s");
    add_bar(best, map_radius_um(point), map_speed(point), number_or(tolerance, "low", NAN),
            number_or(tolerance, "high", NAN));
  }
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
