// The figures of a study of error against processor time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/study/page/error_vs_time.hpp"

namespace percal {

using namespace page;

namespace {

// Of a rung: depth with its standard error over the element size.
void add_rung(Series& drawn, const Json& rung, double unit) {
  const double h = 1 / number_or(rung, "elements_per_radius", NAN), depth = number_or(rung, "depth_m", NAN),
               error = number_or(rung, "depth_standard_error_m", NAN);
  add_bar(drawn, h, depth / unit, (depth - error) / unit, (depth + error) / unit);
}

}  // namespace

Figure error_against_time(const Json& result) {
  Figure figure;
  figure.name = "error_against_time";
  figure.chart.title = "Error against processor time";
  figure.chart.x = {.label = "processor time of all runs, s", .logarithmic = true, .low = {}, .high = {}, .tics = {}};
  figure.chart.y = {.label = "error of the mean depth, %", .logarithmic = true, .low = {}, .high = {}, .tics = {}};
  int colour = 0;
  for (const int count : replicate_counts) {
    const std::string name = count == 1 ? "one run" : fmt::format("mean of {}", count);
    Series drawn = series(name, Mark::points_with_bars, colour), line = series("", Mark::line, colour),
           floor = series(colour == 0 ? "noise alone" : "", Mark::dashes, colour);
    for (const Json& mesh : list(result, "meshes")) {
      const Json& error = at(at(mesh, "error_of_mean_of"), std::to_string(count));
      const double seconds = count * number_or(mesh, "cpu_s", NAN), value = 100 * number_or(error, "value", NAN);
      add_bar(drawn, seconds, value, 100 * number_or(error, "low", NAN), 100 * number_or(error, "high", NAN));
      add_point(line, seconds, value);
      add_point(floor, seconds, 100 * number_or(mesh, "spread_of_a_run", NAN) / std::sqrt(count));
    }
    if (drawn.x.empty()) continue;
    for (const Series& one : {floor, line, drawn}) add(figure.chart, one);
    ++colour;
  }
  figure.caption =
      "Each point is a mesh of the ladder, coarse to fine from left to right; bars are the error's interval. The "
      "dashes are the noise of the runs alone, which more runs lower.";
  figure.alt =
      "Error of the mean depth over processor time, both logarithmic, for one run, three and ten. " + figure.caption;
  return figure;
}

Figure depth_against_element_size(const Json& result) {
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
  figure.caption =
      fmt::format("Means of {} runs with their standard errors.{} A run scatters by {}.",
                  shown(number(at(result, "ladder"), "replicates")),
                  std::isfinite(limit)
                      ? " The line is the fit that is extrapolated to elements of size zero, the band the interval "
                        "of that depth."
                      : "",
                  percent(number(found, "spread_of_a_run"), 2));
  figure.alt = "Depth over element size with standard errors. " + figure.caption;
  return figure;
}

}  // namespace percal
