// The page of `percal invert`.
#include "percal/one_depth/page/page.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"

namespace percal {

using namespace page;

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
// Behind "true modulus" and "erosion strain" in a result.
struct Keys {
  const char *value, *interval, *words;
};
constexpr Keys mu_keys{"mu_Pa", "mu_interval_Pa", "true modulus"},
    strain_keys{"erosion_strain", "erosion_strain_interval", "erosion strain"};

bool looks_for_mu(const Json& result) { return text(result, "looked_for") == mu_keys.words; }
Keys sought_of(const Json& result) { return looks_for_mu(result) ? mu_keys : strain_keys; }
Keys given_of(const Json& result) { return looks_for_mu(result) ? strain_keys : mu_keys; }

std::string value_of(const Json& pair, const Keys& keys) {
  return quantity(number(pair, keys.value), dimension_of_key(keys.value), 3);
}

std::string interval_of(const Json& pair, const Keys& keys) {
  return interval_words(at(pair, keys.interval), dimension_of_key(keys.value));
}

std::string summary_of(const Json& result) {
  const Json& pair = at(result, "pair");
  const Keys sought = sought_of(result), given = given_of(result);
  const auto radius = number(result, "radius_m");
  const std::string shot =
      fmt::format("a sphere of {} and {} at {}", length(radius ? std::optional(2 * *radius) : radius),
                  value_words(result, "particle_density_kg_m3", 4), value_words(result, "speed_m_s", 4));
  const std::string depth = value_words(result, "measured_depth_m"),
                    belongs = fmt::format("the {} is {}, with elements of 1/{} radius", given.words,
                                          value_of(pair, given), shown(number(result, "elements_per_radius")));
  const std::string a = sought.words[0] == 'e' ? "An" : "A";
  if (!yes(result, "found"))
    return fmt::format("No {} was found that stops {} at {} if {}: {}.", sought.words, shot, depth, belongs,
                       text(pair, "why_not"));
  return fmt::format("{} {} of {} ({} {}) stops {} at {} if {}.", a, sought.words, value_of(pair, sought),
                     level_words(result), interval_of(pair, sought), shot, depth, belongs);
}

Table ridge_table(const Json& result) {
  const Keys sought = sought_of(result), given = given_of(result);
  Table table{.caption = "The ridge: pairs that give this depth",
              .rows = {{given.words, sought.words, level_words(result), "runs", ""}},
              .notes = {}};
  const auto asked = number(at(result, "pair"), given.value);
  for (const Json& pair : list(result, "ridge")) {
    const bool is_asked = number(pair, given.value) == asked;
    table.rows.push_back({value_of(pair, given), value_of(pair, sought), interval_of(pair, sought),
                          shown(number(pair, "runs")),
                          is_asked && text(pair, "why_not").empty() ? "as given" : text(pair, "why_not")});
  }
  return table;
}

Table error_table(const Json& result) {
  Table table{
      .caption = fmt::format("Where the error of the {} comes from: standard deviations", sought_of(result).words),
      .rows = {{"source", "depth", sought_of(result).words, "from"}},
      .notes = {}};
  for (const Json& share : list(result, "errors"))
    table.rows.push_back({text(share, "source"), rough_percent(number(share, "of_depth")),
                          rough_percent(number(share, "of_value")), text(share, "how")});
  if (table.rows.size() == 1) table.rows.clear();
  return table;
}

Figure ridge_figure(const Json& result) {
  const Keys sought = sought_of(result), given = given_of(result);
  const Json& pair = at(result, "pair");
  const auto asked = number(pair, given.value);
  const ShownUnit unit = pressure_unit(number_or(pair, "mu_Pa", number_or(list(result, "ridge").back(), "mu_Pa", 1)));
  const auto in_unit = [&](const Keys& keys, double value) {
    return looks_for_mu(result) == (keys.value == sought.value) ? value / unit.size : value;
  };
  Series line = series("", Mark::dashes, 0), points = series("other pairs", Mark::points_with_bars, 0),
         own = series("as given", Mark::points_with_bars, 3);
  for (const Json& one : list(result, "ridge")) {
    if (number(one, sought.value) == std::nullopt) continue;
    const double x = in_unit(given, number_or(one, given.value, nowhere)),
                 y = in_unit(sought, number_or(one, sought.value, nowhere));
    const Json& ends = at(one, sought.interval);
    add_point(line, x, y);
    add_bar(number(one, given.value) == asked ? own : points, x, y, in_unit(sought, number_or(ends, "low", nowhere)),
            in_unit(sought, number_or(ends, "high", nowhere)));
  }
  const auto axis = [&](const Keys& keys) {
    return Axis{.label = std::string(keys.words) + (std::string(keys.value) == mu_keys.value ? ", " + unit.name : ""),
                .logarithmic = true};
  };
  Chart chart{.title = "Pairs that give this depth", .x = axis(given), .y = axis(sought)};
  for (Series* one : {&line, &points, &own}) add(chart, std::move(*one));
  return {
      .name = "ridge",
      .caption = fmt::format("Pairs of modulus and erosion strain that stop the sphere at {}, with {} intervals; the "
                             "one that was asked for is marked.",
                             value_words(result, "measured_depth_m"), level_words(result)),
      .alt = "The ridge, falling from a low erosion strain and a stiff layer to a high one and a soft layer.",
      .chart = chart};
}

// The runs of the search, and the line that its answer is the root of.
Figure search_figure(const Json& result) {
  const Keys sought = sought_of(result);
  const Json& pair = at(result, "pair");
  const double depth = number_or(result, "measured_depth_m", nowhere), root = number_or(pair, sought.value, nowhere),
               slope = number_or(pair, "slope", nowhere);
  const ShownUnit metres = length_unit(depth), pascals = pressure_unit(root);
  const double size = looks_for_mu(result) ? pascals.size : 1;
  Series used = series("runs", Mark::points, 0), far = series("farther away", Mark::points, -1),
         line = series("their line", Mark::line, 0), measured = series("measured", Mark::dashes, 3);
  double low = root, high = root;
  for (const Json& trial : list(result, "trials")) {
    const double value = number_or(trial, sought.value, nowhere);
    const bool is_used = yes(trial, "in_line");
    add_point(is_used ? used : far, value / size, number_or(trial, "depth_m", nowhere) / metres.size);
    if (is_used) low = std::min(low, value), high = std::max(high, value);
  }
  if (yes(result, "found"))
    for (const double value : {low, high}) {
      add_point(line, value / size, depth * std::pow(value / root, slope) / metres.size);
      add_point(measured, value / size, depth / metres.size);
    }
  Chart chart{.title = "The search",
              .x = {.label = sought.words + (looks_for_mu(result) ? ", " + pascals.name : ""), .logarithmic = true},
              .y = {.label = "depth, " + metres.name, .logarithmic = true}};
  for (Series* one : {&far, &used, &line, &measured}) add(chart, std::move(*one));
  return {
      .name = "search",
      .caption = "Runs of the search, each of another phase of the mesh, and the line through those near the answer.",
      .alt = "Depth falling with the number that is looked for; the line meets the measured depth at the answer.",
      .chart = chart};
}

Section answer_section(const Json& result) {
  Section section{.id = "answer", .title = "Found", .blocks = {}, .detail = Detail::answer};
  add(section, ridge_table(result));
  add(section, error_table(result));
  add(section, List{texts(at(result, "warnings")), Tone::warning});
  add(section, List{texts(at(result, "findings")), Tone::note});
  return section;
}

Section figures_section(const Json& result) {
  Section section{.id = "ridge", .title = "The ridge", .blocks = {}};
  add(section, ridge_figure(result));
  add(section, search_figure(result));
  return section;
}

}  // namespace

page::Page invert_page(const Json& result) {
  Page page{.title = text(result, "title"), .summary = summary_of(result), .sections = {}};
  add(page, answer_section(result));
  add(page, figures_section(result));
  add(page, provenance_section(result));
  add(page, input_section(result));
  return page;
}

}  // namespace percal
