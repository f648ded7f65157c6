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
  std::string value, interval, words;
};
const Keys mu_keys{"mu_Pa", "mu_interval_Pa", "true modulus"},
    strain_keys{"erosion_strain", "erosion_strain_interval", "erosion strain"};

Keys sought_of(const Json& result) { return text(result, "looked_for") == mu_keys.words ? mu_keys : strain_keys; }
Keys given_of(const Json& result) { return text(result, "looked_for") == mu_keys.words ? strain_keys : mu_keys; }

// On the axis of a figure, in a unit for moduli of this size.
class Scaled {
 public:
  Scaled(const Keys& keys, double typical_modulus)
      : keys_(keys), unit_(keys.words == mu_keys.words ? pressure_unit(typical_modulus) : ShownUnit{"", 1}) {}
  double operator()(const Json& pair) const { return of(number(pair, keys_.value)); }
  double of(const std::optional<double>& value) const { return value.value_or(nowhere) / unit_.size; }
  Axis axis(bool logarithmic) const {
    return {.label = keys_.words + (unit_.name.empty() ? "" : ", " + unit_.name), .logarithmic = logarithmic};
  }

 private:
  Keys keys_;
  ShownUnit unit_;
};

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
  const std::string sphere = fmt::format("a sphere of {} and {}", length(radius ? std::optional(2 * *radius) : radius),
                                         value_words(result, "particle_density_kg_m3", 4)),
                    particle = text(result, "particle").empty() ? sphere : "the " + text(result, "particle"),
                    shot = particle + " at " + value_words(result, "speed_m_s", 4);
  const std::string depth = value_words(result, "measured_depth_m"),
                    belongs = fmt::format("the {} is {}, with elements of 1/{} radius", given.words,
                                          value_of(pair, given), shown(number(result, "elements_per_radius")));
  const std::string a = sought.words == strain_keys.words ? "An" : "A";
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
  const Json& asked = at(result, "pair");
  const double modulus = number_or(asked, "mu_Pa", 1);
  const Scaled x(given, modulus), y(sought, modulus);
  Series line = series("", Mark::dashes, 0), points = series("other pairs", Mark::points_with_bars, 0),
         own = series("as given", Mark::points_with_bars, 2);
  for (const Json& pair : list(result, "ridge")) {
    if (!number(pair, sought.value)) continue;
    const Json& ends = at(pair, sought.interval);
    add_point(line, x(pair), y(pair));
    add_bar(number(pair, given.value) == number(asked, given.value) ? own : points, x(pair), y(pair),
            y.of(number(ends, "low")), y.of(number(ends, "high")));
  }
  Chart chart{.title = "Pairs that give this depth", .x = x.axis(true), .y = y.axis(true)};
  for (Series* one : {&line, &points, &own}) add(chart, std::move(*one));
  return {.name = "ridge",
          .caption = fmt::format("Pairs of modulus and erosion strain that stop the particle at {}, with {} intervals.",
                                 value_words(result, "measured_depth_m"), level_words(result)),
          .alt = "The ridge falls from a stiff layer that erodes early to a soft one that erodes late.",
          .chart = chart};
}

// The runs of the search, and the line that its answer is the root of.
Figure search_figure(const Json& result) {
  const Keys sought = sought_of(result);
  const Json &pair = at(result, "pair"), &trials = list(result, "trials");
  const double depth = number_or(result, "measured_depth_m", nowhere);
  const auto root = number(pair, sought.value), slope = number(pair, "slope");
  const ShownUnit metres = length_unit(depth);
  const Scaled x(sought, number_or(trials.front(), "mu_Pa", 1));
  Series used = series("runs", Mark::points, 0), far = series("farther away", Mark::points, -1),
         line = series("their line", Mark::line, 0), measured = series("measured", Mark::dashes, 2);
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Json& trial : trials) {
    const double value = number_or(trial, sought.value, nowhere);
    low = std::min(low, value);
    high = std::max(high, value);
    add_point(yes(trial, "in_line") ? used : far, x(trial), number_or(trial, "depth_m", nowhere) / metres.size);
  }
  if (root)
    for (const double value : spaced(std::max(low, *root * 0.6), std::min(high, *root * 1.6)))
      add_point(line, x.of(value), depth * std::pow(value / *root, *slope) / metres.size);
  for (const double value : {low, high}) add_point(measured, x.of(value), depth / metres.size);
  Chart chart{
      .title = "The search", .x = x.axis(worth_a_logarithm(low, high)), .y = {.label = "depth, " + metres.name}};
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
