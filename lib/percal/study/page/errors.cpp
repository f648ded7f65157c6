// The page of `percal study SCENE --error-vs-time`.                                            docs/theory/errors.md
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/study/page/parts.hpp"

namespace percal::page {
namespace {

constexpr std::array<const char*, 3> counts{"1", "3", "10"};  // replicates whose mean has an error in the result

std::string seconds(const std::optional<double>& value) {
  if (!value) return "-";
  return *value >= 1000 ? fmt::format("{:.0f} s", *value) : shown(value, 3) + " s";
}

std::string mean_words(const std::string& count) { return count == "1" ? "one run" : "mean of " + count; }

// --- error against run time ---------------------------------------------------------------------------------------

void add_noise(Chart& chart, double noise, double low, double high, int colour) {
  Series floor = series(colour == 0 ? "noise alone" : "", Mark::dashes, colour);
  floor.x = {low, high};
  floor.y = {noise, noise};
  if (noise > 0) add(chart, floor);
}

Figure time_figure(const Json& result) {
  Figure figure;
  figure.name = "error_vs_time";
  figure.chart.title = "Error against processor time";
  figure.chart.x = {.label = "processor time of all runs, s", .logarithmic = true, .low = {}, .high = {}, .tics = {}};
  figure.chart.y = {.label = "error of the mean depth, %", .logarithmic = true, .low = {}, .high = {}, .tics = {}};
  const double noise = 100 * number_or(at(result, "convergence"), "spread_of_a_run", NAN);
  for (std::size_t c = 0; c < counts.size(); ++c) {
    const double runs = std::stod(counts[c]);
    Series drawn = series(mean_words(counts[c]), Mark::points_with_bars, static_cast<int>(c)),
           line = series("", Mark::line, static_cast<int>(c));
    for (const Json& mesh : list(result, "meshes")) {
      const Json& error = at(at(mesh, "error_of_mean_of"), counts[c]);
      const double seconds = runs * number_or(mesh, "cpu_s", NAN), value = 100 * number_or(error, "value", NAN);
      add_bar(drawn, seconds, value, 100 * number_or(error, "low", NAN), 100 * number_or(error, "high", NAN));
      add_point(line, seconds, value);
    }
    if (drawn.x.empty()) continue;
    add_noise(figure.chart, noise / std::sqrt(runs), drawn.x.front(), drawn.x.back(), static_cast<int>(c));
    add(figure.chart, line);
    add(figure.chart, drawn);
  }
  figure.caption =
      "Each point is a mesh of the ladder, coarse to fine from left to right; bars are the error's interval. The "
      "dashes are "
      "the noise of erosion, which a finer mesh does not lower and more runs do.";
  figure.alt =
      "Error of the mean depth over processor time, both logarithmic, for one run, three and ten. " + figure.caption;
  return figure;
}

// --- mesh and noise -----------------------------------------------------------------------------------------------

// Of a rung: depth with its standard error over the element size.
void add_rung(Series& drawn, const Json& rung, double unit) {
  const double h = 1 / number_or(rung, "elements_per_radius", NAN), depth = number_or(rung, "depth_m", NAN),
               error = number_or(rung, "depth_standard_error_m", NAN);
  add_bar(drawn, h, depth / unit, (depth - error) / unit, (depth + error) / unit);
}

Figure mesh_figure(const Json& result) {
  Figure figure;
  const Json& found = at(result, "convergence");
  const ShownUnit unit =
      length_unit(number_or(found, "extrapolated_depth_m", number_or(at(result, "double_precision"), "depth_m", 0)));
  figure.name = "mesh_study";
  figure.chart.title = "Depth against element size";
  figure.chart.x = {.label = "element size, radii", .logarithmic = false, .low = 0, .high = {}, .tics = {}};
  figure.chart.y.label = "depth, " + unit.name;
  Series meshes = series("the ladder", Mark::points_with_bars, 1), fitted = series("fitted", Mark::line, 0),
         half = series("half the time step", Mark::points_with_bars, 2),
         precise = series("double precision", Mark::points_with_bars, 3), band = series("extrapolated", Mark::band, 0);
  double largest = 0;
  for (const Json& rung : list(result, "meshes")) {
    add_rung(meshes, rung, unit.size);
    largest = std::max(largest, 1 / number_or(rung, "elements_per_radius", HUGE_VAL));
  }
  for (const Json& rung : list(result, "half_steps")) add_rung(half, rung, unit.size);
  add_rung(precise, at(result, "double_precision"), unit.size);
  const double limit = number_or(found, "extrapolated_depth_m", NAN), a = number_or(found, "a_m", NAN),
               b = number_or(found, "b_m", NAN), order = number_or(found, "order", NAN),
               first = 1 / number_or(found, "fitted_from_elements_per_radius", NAN);
  if (std::isfinite(limit) && std::isfinite(first)) {
    for (const double h : spaced(0, first)) {
      const double error = std::isfinite(order) ? a * std::pow(h, order) : a * h + b * h * h;
      add_point(fitted, h, (limit + error) / unit.size);
    }
    for (const double h : {0.0, largest})
      add_bar(band, h, limit / unit.size, number_or(found, "extrapolated_depth_low_m", NAN) / unit.size,
              number_or(found, "extrapolated_depth_high_m", NAN) / unit.size);
  }
  for (const Series& one : {band, fitted, meshes, half, precise}) add(figure.chart, one);
  figure.caption = fmt::format(
      "Means of {} runs with their standard errors. The line is the fit that is extrapolated to elements of size zero, "
      "the band "
      "the interval of that depth. A run scatters by {}.",
      shown(number(at(result, "ladder"), "replicates")), percent(number(found, "spread_of_a_run"), 2));
  figure.alt = "Depth over element size with standard errors, and the fitted curve. " + figure.caption;
  return figure;
}

// --- tables -------------------------------------------------------------------------------------------------------

void add_mesh_row(Table& table, const Json& rung) {
  const Json& error = at(rung, "error");
  std::vector<std::string> row{shown(number(rung, "elements_per_radius")),
                               shown(number(rung, "time_step_factor"), 3),
                               text(rung, "arithmetic"),
                               text(rung, "outcome"),
                               length(number(rung, "depth_m")),
                               length(number(rung, "depth_standard_error_m"), 2),
                               signed_percent(number(error, "value"), 2),
                               error.is_object() ? signed_percent(number(error, "low"), 1) + " to " +
                                                       (number(error, "high") ? signed_percent(number(error, "high"), 1)
                                                                              : std::string("no bound"))
                                                 : "-"};
  for (const char* count : counts) row.push_back(percent(number(at(at(rung, "error_of_mean_of"), count), "value"), 2));
  row.push_back(shown(number(rung, "cpu_s"), 3) + " s");
  table.rows.push_back(row);
}

Table mesh_table(const Json& result) {
  Table table{.caption = "The ladder of meshes",
              .rows = {{"elements per radius", "time step", "arithmetic", "outcome", "depth", "standard error", "error",
                        "interval", "one run", "mean of 3", "mean of 10", "CPU time of a run"}},
              .notes = {"Error: of the depth against the extrapolated one. The last errors have the noise of that many "
                        "runs in them."}};
  for (const Json& rung : list(result, "meshes")) add_mesh_row(table, rung);
  for (const Json& rung : list(result, "half_steps")) add_mesh_row(table, rung);
  if (at(result, "double_precision").is_object()) add_mesh_row(table, at(result, "double_precision"));
  return table;
}

Table advice_table(const Json& result) {
  Table table{.caption = "The cheapest setting for an error",
              .rows = {{"error asked for", "elements per radius", "runs", "mesh error", "noise", "both", "CPU time",
                        "from", "to", "remark"}},
              .notes = {}};
  for (const Json& one : list(result, "advice"))
    table.rows.push_back(
        {percent(number(one, "target_error"), 0), shown(number(one, "elements_per_radius")),
         shown(number(one, "replicates")), percent(number(one, "discretisation_error"), 2),
         percent(number(one, "noise_error"), 2), percent(number(one, "error"), 2), seconds(number(one, "cpu_s")),
         seconds(number(one, "cpu_low_s")),
         number(one, "cpu_s") && !number(one, "cpu_high_s") ? "no bound" : seconds(number(one, "cpu_high_s")),
         !yes(one, "found")           ? text(one, "why_not")
         : yes(one, "cost_estimated") ? "extrapolated beyond the ladder"
                                      : "-"});
  return table;
}

Table change_table(const Json& result) {
  Table table{
      .caption = "What time step and arithmetic are worth",
      .rows = {{"", "elements per radius", "change of the depth", "standard error", "significant", "time ratio"}},
      .notes = {}};
  const auto row = [&](const char* what, const Json& change) {
    if (change.is_object())
      table.rows.push_back({what, shown(number(change, "elements_per_radius")),
                            signed_percent(number(change, "share"), 2), percent(number(change, "standard_error"), 2),
                            yes(change, "is_significant") ? "yes" : "no", shown(number(change, "cost_ratio"), 3)});
  };
  for (const Json& change : list(result, "change_by_half_the_step")) row("half the time step", change);
  row("double precision", at(result, "change_by_double_precision"));
  return table;
}

std::string summary_of(const Json& result) {
  const Json& found = at(result, "convergence");
  if (!number(found, "extrapolated_depth_m")) return "No error can be given: " + text(found, "outcome") + ".";
  return fmt::format("Extrapolated depth {} ({} to {}); a run scatters by {} of it.",
                     length(number(found, "extrapolated_depth_m")), length(number(found, "extrapolated_depth_low_m")),
                     length(number(found, "extrapolated_depth_high_m")), percent(number(found, "spread_of_a_run"), 2));
}

Section asked_section(const Json& result) {
  Section section{.id = "asked", .title = "What was asked", .blocks = {}};
  std::string meshes;
  for (const double n : numbers(at(at(result, "ladder"), "elements_per_radius")))
    meshes += (meshes.empty() ? "" : ", ") + shown(n);
  add_sentence(section,
               fmt::format("What is each mesh worth for {}? Meshes of {} elements per radius, {} runs on each, time "
                           "step factor {}.",
                           scene_words(result), meshes, shown(number(at(result, "ladder"), "replicates")),
                           shown(number(at(result, "ladder"), "time_step_factor"))));
  return section;
}

Section time_section(const Json& result) {
  Section section{.id = "time", .title = "Error against run time", .blocks = {}};
  add(section, time_figure(result));
  add(section, advice_table(result));
  return section;
}

Section mesh_section_of_study(const Json& result) {
  Section section{.id = "mesh", .title = "Mesh and noise", .blocks = {}};
  const Json& found = at(result, "convergence");
  add(section, mesh_figure(result));
  if (number(found, "extrapolated_depth_m"))
    add_sentence(
        section,
        fmt::format("Where the error comes from: the mesh (error {}, fitted from {} elements per radius, observed "
                    "order {}), and the noise of erosion (a run scatters by {}). Scatter about the fit {}.",
                    text(found, "form"), shown(number(found, "fitted_from_elements_per_radius")),
                    shown(number(found, "observed_order"), 2), percent(number(found, "spread_of_a_run"), 2),
                    length(number(found, "standard_deviation_m"), 2)));
  add(section, mesh_table(result));
  add(section, change_table(result));
  return section;
}

}  // namespace

Page error_vs_time_page(const Json& result) {
  Page page;
  page.title = "Error against run time: " + scene_words(result);
  page.summary = summary_of(result);
  for (auto section :
       {asked_section, time_section, mesh_section_of_study, findings_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal::page
