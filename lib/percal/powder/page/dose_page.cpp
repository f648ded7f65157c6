// The page of `percal dose`.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/powder/page/page.hpp"

namespace percal {

using namespace page;

namespace {

constexpr double never = 1e-9;  // a share

double best(const Json& object, const std::string& key) { return number_or(at(object, key), "best", NAN); }

std::string dose_summary(const Json& result) {
  const Json &mass = at(result, "by_mass"), &depths = at(result, "depths_by_mass");
  std::string words;
  if (const Json& band = at(result, "band"); !band.is_null())
    words = fmt::format("{} of the mass ({} {}) ends between {} and {}. ", share_words(mass, "in_band"),
                        level_words(result), share_interval_words(mass, "in_band"), value_words(band, "from_m"),
                        value_words(band, "to_m"));
  words += fmt::format("Into {} the mass goes {} deep in the mean ({} {}), with a standard deviation of {}",
                       text(result, "material"), length_words(depths, "mean_m"), level_words(result),
                       interval_words(depths, "mean_m"), length_words(depths, "deviation_m"));
  if (best(mass, "bounced") > never) words += fmt::format("; {} of it bounces", share_words(mass, "bounced"));
  if (best(mass, "passed") > 1e-3) words += fmt::format("; {} passes", share_words(mass, "passed"));
  return words + ".";
}

Table share_table(const Json& result) {
  Table table{.caption = "Where it ends",
              .rows = {{"", "down to", "mass", level_words(result), "number", level_words(result)}},
              .notes = {}};
  const Json &mass = at(result, "by_mass"), &number_of = at(result, "by_number");
  const auto row = [&](const std::string& name, const std::string& end, const Json& of_mass, const Json& of_number,
                       const std::string& key) {
    table.rows.push_back({name, end, share_words(of_mass, key), share_interval_words(of_mass, key),
                          share_words(of_number, key), share_interval_words(of_number, key)});
  };
  const auto row_if_any = [&](const std::string& name, const std::string& key) {
    if (number_or(at(mass, key), "high", 0) + number_or(at(number_of, key), "high", 0) > never)
      row(name, "", mass, number_of, key);
  };
  row_if_any("bounced", "bounced");
  const Json &layers = list(mass, "layers"), &number_layers = list(number_of, "layers");
  for (std::size_t k = 0; k < layers.size(); ++k)
    row(text(layers[k], "name"), value_words(layers[k], "to_m"), layers[k], number_layers[k], "share");
  row(layers.empty() ? "in the target" : "below the layers", value_words(result, "layer_depth_m"), mass, number_of,
      "deeper");
  row_if_any("passed", "passed");
  if (const Json& band = at(result, "band"); !band.is_null())
    row("band from " + value_words(band, "from_m"), value_words(band, "to_m"), mass, number_of, "in_band");
  return table;
}

Table depth_table(const Json& result) {
  Table table{
      .caption = "Depth of what stays inside",
      .rows = {{"", "by mass", level_words(result), "by number", level_words(result)}},
      .notes = {"Intervals: of these numbers, by the parameters and the emulator. What single particles scatter "
                "is in the spread itself."}};
  const Json &mass = at(result, "depths_by_mass"), &number_of = at(result, "depths_by_number");
  const std::vector<std::pair<std::string, std::string>> rows{{"mean", "mean_m"},
                                                              {"standard deviation", "deviation_m"},
                                                              {"10 % end above", "tenth_m"},
                                                              {"half end above", "median_m"},
                                                              {"90 % end above", "ninetieth_m"}};
  for (const auto& [name, key] : rows)
    table.rows.push_back({name, length_words(mass, key), interval_words(mass, key), length_words(number_of, key),
                          interval_words(number_of, key)});
  return table;
}

Table spread_table(const Json& result) {
  Table table{.caption = "What spreads the depths, each source alone, by number",
              .rows = {{"source", "standard deviation", level_words(result), "mean depth"}},
              .notes = {}};
  for (const Json& source : list(result, "spread"))
    table.rows.push_back({text(source, "source"), length_words(source, "spread_m"), interval_words(source, "spread_m"),
                          length_words(source, "spread_mean_m")});
  if (const Json& measured = at(result, "measured"); !measured.is_null())
    table.rows.push_back({"measured", length_words(measured, "measured_deviation_m"),
                          interval_words(measured, "measured_deviation_m"), value_words(measured, "measured_mean_m")});
  return table;
}

Table powder_table(const Json& result) {
  const Json &powder = at(result, "powder"), &middle = at(powder, "middle");
  const auto spread = [&](const char* key) {
    const double deviation = number_or(powder, key, 0);
    return deviation > 0 ? fmt::format("{:.3g}", std::exp(deviation)) : "all the same";
  };
  Table table{.caption = "The powder, by number",
              .rows = {{"", "median", "geometric standard deviation"},
                       {"radius", value_words(middle, "radius_m"), spread("radius_log_deviation")},
                       {"density", value_words(middle, "density_kg_m3"), spread("density_log_deviation")},
                       {"speed", value_words(middle, "speed_m_s"), spread("speed_log_deviation")},
                       {"density speed radius", value_words(middle, "impact_kg_m_s"), ""}},
              .notes = {}};
  if (yes(powder, "speed_by_size"))
    table.notes.push_back("Speeds go by size; their deviation is about that of the size.");
  return table;
}

ShownUnit unit_of_curve(const Json& result) {
  return length_unit(number_or(list(result, "curve").back(), "depth_m", 1));
}

// Shares that end above each depth.
Figure dose_figure(const Json& result) {
  const ShownUnit unit = unit_of_curve(result);
  Chart chart{.title = "Dose above each depth in " + text(result, "material"),
              .x = {.label = "depth, " + unit.name, .low = 0},
              .y = {.label = "of all ends above it, %", .low = 0, .high = 100}};
  int colour = 0;
  for (const auto& [key, name] : {std::pair{"mass_above", "mass"}, {"number_above", "number"}}) {
    Series band = series(level_words(result) + " of the " + name, Mark::band, colour),
           line = series(name, Mark::line, colour);
    for (const Json& point : list(result, "curve")) {
      const Json& share = at(point, key);
      const double x = number_or(point, "depth_m", NAN) / unit.size;
      add_bar(band, x, 100 * number_or(share, "best", NAN), 100 * number_or(share, "low", NAN),
              100 * number_or(share, "high", NAN));
      add_point(line, x, 100 * number_or(share, "best", NAN));
    }
    add(chart, band);
    add(chart, line);
    ++colour;
  }
  return {.name = "dose",
          .caption =
              "Share of the mass, and of the number, that has ended above each depth; what bounces never does. "
              "Bands: by the parameters and the emulator.",
          .alt = "Dose above each depth, by mass and by number, with bands.",
          .chart = chart};
}

// Differences of the dose, per unit of depth.
Figure density_figure(const Json& result) {
  const ShownUnit unit = unit_of_curve(result);
  Chart chart{.title = "Dose at each depth",
              .x = {.label = "depth, " + unit.name, .low = 0},
              .y = {.label = "of all, % per " + unit.name, .low = 0}};
  const Json& curve = list(result, "curve");
  int colour = 0;
  for (const auto& [key, name] : {std::pair{"mass_above", "mass"}, {"number_above", "number"}}) {
    Series line = series(name, Mark::line, colour++);
    for (std::size_t k = 1; k < curve.size(); ++k) {
      const double from = number_or(curve[k - 1], "depth_m", NAN) / unit.size,
                   to = number_or(curve[k], "depth_m", NAN) / unit.size;
      add_point(line, (from + to) / 2, 100 * (best(curve[k], key) - best(curve[k - 1], key)) / (to - from));
    }
    add(chart, line);
  }
  return {.name = "dose_density",
          .caption = "Where the mass, and the number, ends: share per depth.",
          .alt = "Share of mass and of number per depth, over depth.",
          .chart = chart};
}

Figure size_figure(const Json& result) {
  const Json& sizes = list(at(result, "powder"), "sizes");
  Chart chart{
      .title = "Sizes", .x = {.label = "radius, um", .logarithmic = true}, .y = {.label = "% per factor of 1.1"}};
  for (const auto& [key, colour] : {std::pair{"mass", 0}, {"number", 1}}) {
    Series line = series(key, Mark::line, colour);
    for (const Json& cell : sizes) {
      const double from = number_or(cell, "from_m", NAN), to = number_or(cell, "to_m", NAN);
      if (to > from && number_or(cell, "mass", 0) + number_or(cell, "number", 0) > 1e-5)
        add_point(line, 1e6 * std::sqrt(from * to),
                  100 * number_or(cell, key, NAN) * std::log(1.1) / std::log(to / from));
    }
    add(chart, line);
  }
  return {.name = "sizes",
          .caption = "The powder's radii, by mass and by number.",
          .alt = "Distribution of radii by mass and by number.",
          .chart = chart};
}

Section dose_answer_section(const Json& result) {
  Section section{.id = "answer", .title = "Dose", .blocks = {}, .detail = Detail::answer};
  add(section, List{texts(at(result, "findings")), Tone::warning});
  add(section, share_table(result));
  add(section, depth_table(result));
  add(section, spread_table(result));
  return section;
}

Section dose_figures(const Json& result) {
  Section section{.id = "curve", .title = "Over depth", .blocks = {}};
  add(section, dose_figure(result));
  add(section, density_figure(result));
  return section;
}

Section powder_section(const Json& result) {
  Section section{.id = "powder", .title = "The powder", .blocks = {}};
  add(section, powder_table(result));
  add(section, size_figure(result));
  add_sentence(section,
               fmt::format("By {} under \"{}\"; single particles scatter by {} of ln depth about the mean of "
                           "their like. Shares are integrated to {}.",
                           text(result, "calibration"), text(result, "hypothesis"), shown(number(result, "scatter"), 2),
                           rough_percent(number(result, "integration_error"))));
  return section;
}

}  // namespace

std::string share_words(const Json& object, const std::string& key) { return percent(number(at(object, key), "best")); }

std::string share_interval_words(const Json& object, const std::string& key) {
  const Json& share = at(object, key);
  const auto low = number(share, "low"), high = number(share, "high");
  return low && high ? fmt::format("{:.1f} to {:.1f} %", 100 * *low, 100 * *high) : absent;
}

std::string length_words(const Json& object, const std::string& key) {
  return length(number(at(object, key), "best"), 3);
}

page::Page dose_page(const Json& result) {
  Page page{.title = text(result, "title"), .summary = dose_summary(result), .sections = {}};
  for (auto section : {dose_answer_section, dose_figures, powder_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
