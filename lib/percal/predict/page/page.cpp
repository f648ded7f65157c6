// The page of `percal predict`.
#include "percal/predict/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"

namespace percal {

using namespace page;

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

std::string sphere_words(const Json& shot) {
  if (const Json& body = maybe(shot, "body"); body.is_string()) return text(shot, "body");
  const auto radius = number(shot, "radius_m");
  return fmt::format("a sphere of {} and {}", length(radius ? std::optional(2 * *radius) : radius),
                     quantity(number(shot, "density_kg_m3"), dimension::density));
}

// Where the layer is passed, the speed left.
std::string depth_words(const Json& point) {
  const Json& left = at(point, "speed_left");
  if (left.is_null() || number_or(left, "speed_left_m_s", 0) == 0) return value_words(point, "depth_m");
  return value_words(left, "speed_left_m_s") + " left";
}
std::string depth_interval_words(const Json& point, const std::string& of) {
  const Json& left = at(point, "speed_left");
  const std::string key = of + "_interval_m", key_left = "speed_left_" + of + "_interval_m_s";
  if (left.is_null() || number_or(at(left, key_left), "high", 0) == 0) return interval_words(point, key);
  if (number_or(at(left, key_left), "low", 0) > 0) return interval_words(left, key_left) + " left";
  return length(number(at(point, key), "low")) + " to " +
         quantity(number(at(left, key_left), "high"), dimension::speed) + " left";
}

std::string solved_words(const Json& result) {
  const Json& solved = at(result, "solved");
  const std::string number_of = text(solved, "looked_for");
  if (yes(solved, "passing")) {
    const std::string layer = value_words(solved, "wanted_depth_m");
    if (!yes(solved, "found"))
      return fmt::format("No {} passes {} of {} within a factor of {:g} of where the search began.", number_of, layer,
                         text(result, "material"), solved_within);
    return fmt::format("At a {} of {} half of the shots pass {} of {} ({} {}); that of one shot: {}.", number_of,
                       value_words(solved, "value", 4), layer, text(result, "material"), level_words(result),
                       interval_words(solved, "value_mean_interval"), interval_words(solved, "value_shot_interval"));
  }
  if (!yes(solved, "found"))
    return fmt::format("No {} gives {} within a factor of {:g} of where the search began.", number_of,
                       value_words(solved, "wanted_depth_m"), solved_within);
  return fmt::format("A {} of {} gives {} in the mean ({} {}, of one shot {}).", number_of,
                     value_words(solved, "value", 4), value_words(solved, "wanted_depth_m"), level_words(result),
                     interval_words(solved, "value_mean_interval"), interval_words(solved, "value_shot_interval"));
}

std::string summary_of(const Json& result) {
  if (!at(result, "solved").is_null()) return solved_words(result);
  const Json& shots = list(result, "shots");
  if (shots.size() == 1) {
    const Json& shot = shots[0];
    if (const Json& left = at(shot, "speed_left"); !left.is_null() && number_or(left, "speed_left_m_s", 0) > 0)
      return fmt::format("Through {} of {}, {} at {} passes with {} left; {} of such shots: {}. {} of them pass.",
                         value_words(shot, "layer_depth_m"), text(result, "material"), sphere_words(shot),
                         value_words(shot, "speed_m_s", 4), value_words(left, "speed_left_m_s"), level_words(result),
                         depth_interval_words(shot, "shot"), percent(number(shot, "passes_probability")));
    std::string words = fmt::format("Into {}, {} at {} goes {} deep; {} of such shots: {}.", text(result, "material"),
                                    sphere_words(shot), value_words(shot, "speed_m_s", 4), value_words(shot, "depth_m"),
                                    level_words(result), depth_interval_words(shot, "shot"));
    for (const RunNumber of : numbers_beside)
      if (const Json& beside = maybe(shot, kind_of(of).key); !beside.is_null())
        words += fmt::format(" Its {}: {} ({}).", kind_of(of).words, value_words(beside, "value_m"),
                             interval_words(beside, "shot_interval_m"));
    return words;
  }
  const Json& curve = list(result, "curve");
  if (shots.empty() && !curve.empty())
    return fmt::format("Into {}, {} goes {} deep at {} and {} at {}.", text(result, "material"),
                       sphere_words(at(result, "like")), value_words(curve.front(), "depth_m"),
                       value_words(curve.front(), "speed_m_s"), value_words(curve.back(), "depth_m"),
                       value_words(curve.back(), "speed_m_s"));
  return fmt::format("{} into {}.", counted(static_cast<long>(shots.size()), "shot"), text(result, "material"));
}

Table shot_table(const Json& result) {
  Table table{.caption = "Depths",
              .rows = {{"shot", "depth", level_words(result) + " of the mean", level_words(result) + " of one shot"}},
              .notes = {"The mean: of many such shots; parameters and emulator. One shot: its scatter, too."}};
  bool knows_passage = false;
  for (const Json& shot : list(result, "shots")) knows_passage |= !at(shot, "speed_left").is_null();
  if (knows_passage) table.rows[0].push_back("passes");
  for (const Json& shot : list(result, "shots")) {
    table.rows.push_back({text(shot, "label"), depth_words(shot), depth_interval_words(shot, "mean"),
                          depth_interval_words(shot, "shot")});
    if (knows_passage) table.rows.back().push_back(percent(number(shot, "passes_probability")));
  }
  return table;
}

Table numbers_table(const Json& result) {
  Table table{
      .caption = "Besides the depth",
      .rows = {{"shot", "number", "value", level_words(result) + " of the mean", level_words(result) + " of one shot"}},
      .notes = {}};
  for (const Json& shot : list(result, "shots"))
    for (const RunNumber of : numbers_beside)
      if (const Json& beside = maybe(shot, kind_of(of).key); !beside.is_null())
        table.rows.push_back({text(shot, "label"), kind_of(of).words, value_words(beside, "value_m"),
                              interval_words(beside, "mean_interval_m"), interval_words(beside, "shot_interval_m")});
  if (table.rows.size() == 1) table.rows.clear();
  return table;
}

Table curve_table(const Json& result) {
  Table table{.caption = "Depth over speed",
              .rows = {{"speed", "depth", level_words(result) + " of the mean", level_words(result) + " of one shot"}},
              .notes = {}};
  const Json& curve = list(result, "curve");
  constexpr std::size_t every = 4;  // the figure has them all
  for (std::size_t k = 0; k < curve.size(); k += every)
    table.rows.push_back({value_words(curve[k], "speed_m_s", 4), depth_words(curve[k]),
                          depth_interval_words(curve[k], "mean"), depth_interval_words(curve[k], "shot")});
  return table;
}

// Standard deviations of a depth, of its size.
Table error_table(const Json& shots) {
  Table table{.caption = "Where the error comes from: standard deviations of a depth",
              .rows = {{"shot", "parameters", "emulator", "scatter", "speed"}},
              .notes = {}};
  for (const Json& shot : shots) {
    const Json& errors = at(shot, "errors");
    table.rows.push_back({text(shot, "label"), rough_percent(number(errors, "parameters")),
                          rough_percent(number(errors, "emulator")), rough_percent(number(errors, "scatter")),
                          rough_percent(number(errors, "speed"))});
  }
  return table;
}

Table checked_table(const Json& shots) {
  Table table{
      .caption = "Checked by runs",
      .rows = {{"shot", "runs", "the runs", "predicted", "in stated errors"}},
      .notes = {
          "Runs at the best point, on the mesh that the prediction is of; errors: the emulator's and the runs' own."}};
  for (const Json& shot : shots) {
    const Json& checked = at(shot, "checked");
    if (checked.is_null()) continue;
    const auto depth = number(checked, "run_depth_m");
    const bool passes =
        !at(shot, "speed_left").is_null() && depth && *depth > number_or(shot, "layer_depth_m", HUGE_VAL);
    const std::string found = passes  ? value_words(checked, "run_speed_left_m_s") + " left"
                              : depth ? with_error(length(depth), value_words(checked, "run_standard_error_m", 2))
                                      : text(checked, "outcome");
    table.rows.push_back({text(shot, "label"), shown(number(checked, "runs")), found, depth_words(shot),
                          shown(number(checked, "standardised_difference"), 2)});
  }
  if (table.rows.size() == 1) table.rows.clear();
  return table;
}

Table elsewhere_table(const Json& result) {
  Table table{.caption = "Under the other hypotheses", .rows = {{"shot", "depth"}}, .notes = {}};
  for (const Json& shot : list(result, "shots")) {
    std::string depths;
    for (const double depth : numbers(at(shot, "elsewhere_m")))
      depths += (depths.empty() ? "" : ", ") + length(depth, 3);
    if (!depths.empty()) table.rows.push_back({text(shot, "label"), depths});
  }
  if (table.rows.size() == 1) table.rows.clear();
  return table;
}

Figure curve_figure(const Json& result) {
  const Json& curve = list(result, "curve");
  const bool knows_passage = !at(curve.front(), "speed_left").is_null();
  const double layer = knows_passage ? number_or(at(result, "like"), "layer_depth_m", HUGE_VAL) : HUGE_VAL;
  double deepest = 0;
  for (const Json& point : curve) deepest = std::max(deepest, number_or(point, "depth_m", 0));
  const ShownUnit unit = length_unit(std::min(deepest, layer));
  const auto depth_of = [&](const Json& of, const char* key) {
    return std::min(layer, number_or(of, key, nowhere)) / unit.size;
  };
  Series shot = series(level_words(result) + " of single shots", Mark::band, 1),
         mean = series(level_words(result) + " of the mean", Mark::band, 0), line = series("predicted", Mark::line, 0),
         fitted = series("fired", Mark::points, 2), least = series("fired, or deeper", Mark::points, -1),
         asked = series("", Mark::points_with_bars, 3);
  const auto bar = [&](Series& series, const Json& point, const char* interval) {
    const Json& ends = at(point, interval);
    add_bar(series, number_or(point, "speed_m_s", nowhere), depth_of(point, "depth_m"), depth_of(ends, "low"),
            depth_of(ends, "high"));
  };
  for (const Json& point : curve) {
    bar(shot, point, "shot_interval_m");
    bar(mean, point, "mean_interval_m");
    add_point(line, number_or(point, "speed_m_s", nowhere), depth_of(point, "depth_m"));
  }
  for (const Json& point : list(result, "fired"))
    add_point(text(point, "seen") == "depth" ? fitted : least, number_or(point, "speed_m_s", nowhere),
              number_or(point, "measured_depth_m", nowhere) / unit.size);
  for (const Json& point : list(result, "shots")) {
    asked.name = "this shot";
    bar(asked, point, "shot_interval_m");
  }
  Chart chart{.title = "Depth over speed in " + text(result, "material"),
              .x = {.label = "speed, m/s"},
              .y = {.label = "depth, " + unit.name, .low = 0}};
  const std::size_t measured = fitted.x.size() + least.x.size();
  for (Series* one : {&shot, &mean, &line, &fitted, &least, &asked}) add(chart, std::move(*one));
  return {.name = "depth_over_speed",
          .caption = fmt::format("Depth over speed of {}. Bands: where {} of single shots, and their mean, would lie. "
                                 "Points: {} of such spheres that the calibration knows.",
                                 sphere_words(at(result, "like")), level_words(result),
                                 counted(static_cast<long>(measured), "shot")),
          .alt = fmt::format("Depth over speed with its bands; {} beside it.",
                             counted(static_cast<long>(measured), "measured point")),
          .chart = chart};
}

// The chance of passing, with what became of the shots that were fired.
Figure passing_figure(const Json& result) {
  Series chance = series("predicted", Mark::line, 0), passed = series("passed", Mark::points, 2),
         stopped = series("stopped", Mark::points, 1);
  for (const Json& point : list(result, "curve"))
    add_point(chance, number_or(point, "speed_m_s", nowhere), 100 * number_or(point, "passes_probability", nowhere));
  for (const Json& point : list(result, "fired")) {
    const std::string seen = text(point, "seen");
    const double speed = number_or(point, "speed_m_s", nowhere);
    if (seen == "passed" || seen == "speed left") add_point(passed, speed, 100);
    if (seen == "stopped" || seen == "depth") add_point(stopped, speed, 0);
  }
  const std::size_t fired = passed.x.size() + stopped.x.size();
  Chart chart{.title = "Passing the layer", .x = {.label = "speed, m/s"}, .y = {.label = "of the shots pass, %"}};
  for (Series* one : {&chance, &passed, &stopped}) add(chart, std::move(*one));
  const std::string layer = value_words(at(result, "like"), "layer_depth_m") + " of " + text(result, "material");
  return {.name = "passing_over_speed",
          .caption = fmt::format(
              "How many shots pass {}, over their speed: the chance of one. Points: {} that passed (above) or "
              "stopped (below).",
              layer, counted(static_cast<long>(fired), "shot")),
          .alt = fmt::format("The chance of passing {} rises with the speed.", layer),
          .chart = chart};
}

Figure speed_left_figure(const Json& result) {
  Series shot = series(level_words(result) + " of single shots", Mark::band, 1),
         mean = series(level_words(result) + " of the mean", Mark::band, 0), line = series("predicted", Mark::line, 0);
  for (const Json& point : list(result, "curve")) {
    const Json& left = at(point, "speed_left");
    const double speed = number_or(point, "speed_m_s", nowhere), value = number_or(left, "speed_left_m_s", nowhere);
    add_point(line, speed, value);
    for (auto [series, key] :
         {std::pair{&shot, "speed_left_shot_interval_m_s"}, {&mean, "speed_left_mean_interval_m_s"}})
      add_bar(*series, speed, value, number_or(at(left, key), "low", nowhere),
              number_or(at(left, key), "high", nowhere));
  }
  Chart chart{.title = "Speed left behind the layer",
              .x = {.label = "speed, m/s"},
              .y = {.label = "speed left, m/s", .low = 0}};
  for (Series* one : {&shot, &mean, &line}) add(chart, std::move(*one));
  const std::string layer = value_words(at(result, "like"), "layer_depth_m") + " of " + text(result, "material");
  return {.name = "speed_left_over_speed",
          .caption = "The speed left behind " + layer + ", over the speed at impact; 0: held.",
          .alt = "The speed left behind " + layer + " rises with that at impact, with its bands.",
          .chart = chart};
}

Section answer_section(const Json& result) {
  Section section{.id = "answer", .title = "Predicted", .blocks = {}, .detail = Detail::answer};
  add(section, List{texts(at(result, "findings")), Tone::warning});
  const Json& shots = list(result, "shots");
  if (!shots.empty()) {
    add(section, shot_table(result));
    add(section, numbers_table(result));
  }
  if (yes(result, "speed_was_a_range")) add(section, curve_table(result));
  if (!shots.empty()) add(section, checked_table(shots));
  return section;
}

Section curve_section(const Json& result) {
  Section section{.id = "curve", .title = "Over speed", .blocks = {}};
  const Json& curve = list(result, "curve");
  if (curve.empty()) return section;
  add(section, curve_figure(result));
  if (at(curve.front(), "speed_left").is_null()) return section;
  add(section, passing_figure(result));
  add(section, speed_left_figure(result));
  return section;
}

Section errors_section(const Json& result) {
  Section section{.id = "errors", .title = "How sure it is", .blocks = {}};
  const Json& shots = list(result, "shots");
  if (shots.empty()) return section;
  add(section, error_table(shots));
  add(section, elsewhere_table(result));
  return section;
}

}  // namespace

page::Page predict_page(const Json& result) {
  Page page{.title = text(result, "title"), .summary = summary_of(result), .sections = {}};
  add(page, answer_section(result));
  add(page, curve_section(result));
  add(page, errors_section(result));
  add(page, provenance_section(result));
  add(page, input_section(result));
  return page;
}

}  // namespace percal
