// The model material's shots in other scales, the lines through them, and what they say about the tissue.
// Guha 2009, Figures 4-3 to 4-7, 5-1 and 5-2.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/identify/page/sections.hpp"
#include "percal/math/statistics.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page_of_identify {
namespace {

// A straight line through points of which two or more are at different x.
std::optional<Line> line_through(const std::vector<double>& x, const std::vector<double>& y) {
  if (std::set<double>(x.begin(), x.end()).size() < 2) return std::nullopt;
  return linear_trend(x, y);
}

// The line through a series' points, over their range.
Series line_of(const Series& points, const std::string& name, Mark mark) {
  Series drawn = series(name, mark, points.colour);
  if (const auto line = line_through(points.x, points.y))
    for (const double x :
         {*std::min_element(points.x.begin(), points.x.end()), *std::max_element(points.x.begin(), points.x.end())})
      add_point(drawn, x, line->at(x));
  return drawn;
}

// The model material's measured shots, in its own density where sets with several were asked for.
std::optional<PageSet> model_shots(const Json& result) {
  const double density = number_or(at(result, "model"), "density_kg_m3", nowhere);
  std::optional<PageSet> nearest;
  for (const PageSet& set : prediction_sets(result)) {
    if (set.material != "model" || set.shots.size() < 2) continue;
    const auto distance = [&](const PageSet& s) { return std::abs(s.shots.front().target_density - density); };
    if (!nearest || distance(set) < distance(*nearest)) nearest = set;
  }
  if (nearest)
    std::erase_if(nearest->shots, [](const PageShot& s) { return !std::isfinite(s.measured * s.impact_parameter()); });
  return nearest && nearest->shots.size() > 1 ? nearest : std::nullopt;
}

Figure energy_figure(const std::vector<BallGroup>& balls, const std::string& material) {
  Chart chart{.title = "Depth over radius against the energy over the modulus",
              .x = {.label = "rho_t v^2 / mu"},
              .y = {.label = "depth over radius", .low = 0}};
  int colour = 0;
  for (const BallGroup& ball : balls) {
    Series points = series(ball.name, Mark::points, colour++);
    for (const PageShot& shot : ball.shots)
      add_point(points, shot.target_density * shot.speed * shot.speed / shot.mu, shot.measured / shot.radius);
    Series line = line_of(points, "", Mark::line);
    add(chart, std::move(line));
    add(chart, std::move(points));
  }
  return {
      .name = "energy",
      .caption =
          "pi8 = P/a against pi4 = rho_t v^2/mu (mu true): each material has a straight line of its own, because the "
          "ratio of densities, pi5, is another for each material.",
      .alt = fmt::format("Depth over radius against rho_t v^2/mu in {}: {} balls, each on a rising line of its own.",
                         material, balls.size()),
      .chart = chart};
}

// A speed that all balls can be compared at, two digits: the mean of the fastest shots.
double common_speed(const std::vector<BallGroup>& balls) {
  double sum = 0;
  for (const BallGroup& ball : balls) {
    double fastest = 0;
    for (const PageShot& shot : ball.shots) fastest = std::max(fastest, shot.speed);
    sum += fastest / static_cast<double>(balls.size());
  }
  const double digit = std::pow(10, std::floor(std::log10(sum)) - 1);
  return std::round(sum / digit) * digit;
}

std::optional<double> depth_at(const BallGroup& ball, double speed) {
  std::vector<double> x, y;
  for (const PageShot& shot : ball.shots) {
    x.push_back(shot.speed);
    y.push_back(shot.measured);
  }
  const auto line = line_through(x, y);
  return line ? std::optional(line->at(speed)) : std::nullopt;
}

// The material of which there are balls of most sizes.
std::vector<BallGroup> of_most_sizes(const std::vector<BallGroup>& balls) {
  std::vector<BallGroup> most;
  for (const BallGroup& first : balls) {
    std::vector<BallGroup> same;
    for (const BallGroup& ball : balls)
      if (ball.shots.front().particle == first.shots.front().particle) same.push_back(ball);
    if (same.size() > most.size()) most = same;
  }
  return most;
}

Figure radius_figure(const std::vector<BallGroup>& balls, double speed) {
  const auto same = of_most_sizes(balls);
  const std::string particle = same.empty() ? "" : same.front().shots.front().particle;
  Series points = series(particle, Mark::points, 0);
  double deepest = 0;
  for (const BallGroup& ball : same) deepest = std::max(deepest, depth_at(ball, speed).value_or(0));
  const ShownUnit unit = length_unit(deepest);
  for (const BallGroup& ball : same)
    if (const auto depth = depth_at(ball, speed))
      add_point(points, 1e3 * ball.shots.front().radius, *depth / unit.size);
  Chart chart{.title = fmt::format("Depth against radius at {:.4g} m/s", speed),
              .x = {.label = "radius, mm"},
              .y = {.label = "depth, " + unit.name, .low = 0}};
  std::string rise;
  if (points.x.size() > 1) {
    add(chart, line_of(points, "linear trend", Mark::dashes));
    const auto line = line_through(points.x, points.y);
    rise = fmt::format(": {:.3g} {} deeper for each mm of radius", line ? line->slope : 0, unit.name);
    add(chart, points);
  }
  return {.name = "radius",
          .caption = fmt::format("Balls of {} at {:.4g} m/s, each read off its own line over the speed{}.", particle,
                                 speed, rise),
          .alt = fmt::format("Depth against radius of {} balls of {}, rising.", points.x.size(), particle),
          .chart = chart};
}

Figure density_figure(const std::vector<BallGroup>& balls, double speed) {
  Chart chart{.title = fmt::format("Depth over diameter against density at {:.4g} m/s", speed),
              .x = {.label = "density of the ball, kg/m3"},
              .y = {.label = "depth over diameter", .low = 0}};
  Series all = series("linear trend", Mark::dashes, -1);
  int colour = 0;
  std::set<double> densities;
  for (const BallGroup& ball : balls) {
    const auto depth = depth_at(ball, speed);
    const PageShot& one = ball.shots.front();
    Series point = series(ball.name, Mark::points, colour++);
    if (!depth) continue;
    add_point(point, one.particle_density, *depth / (2 * one.radius));
    add_point(all, one.particle_density, *depth / (2 * one.radius));
    densities.insert(one.particle_density);
    add(chart, point);
  }
  if (densities.size() < 2) return {};
  const auto line = line_through(all.x, all.y);
  Series drawn = line_of(all, all.name, Mark::dashes);
  drawn.colour = -1;
  add(chart, drawn);
  return {.name = "density",
          .caption = fmt::format(
              "Depth over diameter of each ball at {:.4g} m/s, read off its own line: it grows with the ball's "
              "density, by {:.3g} for each 1000 kg/m3.",
              speed, line ? 1000 * line->slope : 0),
          .alt = fmt::format("Depth over diameter against density, rising, for {} balls of {} densities.", all.x.size(),
                             densities.size()),
          .chart = chart};
}

Figure collapse_figure(const std::vector<BallGroup>& balls) {
  Chart chart{.title = "Depth over diameter, times the ratio of densities",
              .x = {.label = "speed, m/s"},
              .y = {.label = "P rho_t / (2 a rho_p)", .low = 0}};
  std::vector<double> speeds, values;
  int colour = 0;
  for (const BallGroup& ball : balls) {
    Series points = series(ball.name, Mark::points, colour++);
    for (const PageShot& shot : ball.shots)
      add_point(points, shot.speed, shot.measured * shot.target_density / (2 * shot.radius * shot.particle_density));
    speeds.insert(speeds.end(), points.x.begin(), points.x.end());
    values.insert(values.end(), points.y.begin(), points.y.end());
    add(chart, std::move(points));
  }
  double worst = 0;
  if (const auto line = line_through(speeds, values)) {
    Series mean_line = series("mean of all", Mark::dashes, -1);
    for (const double x :
         {*std::min_element(speeds.begin(), speeds.end()), *std::max_element(speeds.begin(), speeds.end())})
      add_point(mean_line, x, line->at(x));
    for (std::size_t i = 0; i < speeds.size(); ++i)
      worst = std::max(worst, std::abs(values[i] / line->at(speeds[i]) - 1));
    add(chart, std::move(mean_line));
  }
  return {.name = "collapse",
          .caption = fmt::format(
              "Divided by the ratio of densities, all balls lie about one line over the speed, the farthest "
              "{:.0f} % from it.",
              100 * worst),
          .alt = fmt::format("P rho_t/(2 a rho_p) against speed for {} balls, about one rising line.", balls.size()),
          .chart = chart};
}

}  // namespace

Section model_section(const Json& result) {
  const std::string material = text(at(result, "model"), "material");
  Section section{.id = "model", .title = "The shots into " + material + " in other scales", .blocks = {}};
  const auto set = model_shots(result);
  if (!set) return section;
  const auto balls = by_ball(set->shots);
  const double speed = common_speed(balls);
  add_sentence(section, "Measured depths alone; percal's are in the figure against the impact parameter.");
  add(section, energy_figure(balls, material));
  add(section, radius_figure(balls, speed));
  add(section, density_figure(balls, speed));
  add(section, collapse_figure(balls));
  return section;
}

Section scaled_section(const Json& result) {
  const std::string tissue = text(at(result, "skin"), "name"), material = text(at(result, "model"), "material");
  Section section{.id = "scaled", .title = "Depths carried over from " + material + " to " + tissue, .blocks = {}};
  const Json& line = at(result, "scaled_line");
  double deepest = 0;
  for (const Json& one : list(line, "cases")) deepest = std::max(deepest, number_or(one, "depth_m", 0));
  const ShownUnit unit = length_unit(deepest);
  Series measured = series("measured in " + tissue, Mark::points, 0),
         theirs = series("the reference's scaled line", Mark::points, 1);
  std::vector<Series> lines;
  double sum = 0;
  int count = 0;
  for (const Json& one : list(line, "cases")) {
    const double radius = number_or(one, "radius_m", nowhere), depth = number_or(one, "depth_m", nowhere);
    const double x = number_or(one, "particle_density_kg_m3", nowhere) * number_or(one, "speed_m_s", nowhere) * radius;
    const auto found = number(one, "measured_m");
    add_point(measured, x, found.value_or(nowhere) / unit.size);
    add_point(theirs, x, number_or(one, "reference_m", nowhere) / unit.size);
    const std::string name = fmt::format("{} line, radius {}", material, length(radius, 3));
    if (lines.empty() || lines.back().name != name)
      lines.push_back(series(name, Mark::line, 2 + static_cast<int>(lines.size())));
    add_point(lines.back(), x, depth / unit.size);
    if (found) {
      sum += std::abs(depth / *found - 1);
      ++count;
    }
  }
  Chart chart{.title = "Depth in " + tissue + " from the line through the shots into " + material,
              .x = {.label = "rho_p v a, kg/(m s)"},
              .y = {.label = "depth, " + unit.name, .low = 0}};
  for (const Series& one : lines) add(chart, one);
  add(chart, measured);
  add(chart, theirs);
  add(section,
      Figure{.name = "scaled",
             .caption = fmt::format("The straight line of depth over rho_p v a in {}, {:.4g} cm per 1000 kg/(m s), "
                                    "carried over by similarity without any finite elements: {} from the measured "
                                    "depths in the mean.",
                                    material, 1e5 * number_or(line, "slope_m2_s_kg", nowhere),
                                    count > 0 ? percent(sum / count) : "-"),
             .alt = fmt::format("Depth in {} against the impact parameter: {} measured points about {} scaled lines.",
                                tissue, measured.x.size(), lines.size()),
             .chart = chart});
  return section;
}

Section trends_section(const Json& result) {
  Section section{.id = "shapes", .title = "Other shapes", .blocks = {}};
  int figures = 0;
  for (const Json& trend : list(result, "trends")) {
    const auto x = numbers(at(trend, "x")), y = numbers(at(trend, "y")), theirs = numbers(at(trend, "reference_y"));
    const auto slope = number(trend, "slope"), intercept = number(trend, "intercept");
    if (x.empty() || x.size() != y.size() || !slope || !intercept) continue;
    Series measured = series("measured", Mark::points, 0),
           reference = series("the reference's finite elements", Mark::points, 1),
           line = series("linear trend", Mark::line, 0), published = series("published trend", Mark::dashes, 1);
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      add_point(measured, x[i], y[i]);
      if (i >= theirs.size()) continue;
      add_point(reference, x[i], theirs[i]);
      worst = std::max(worst, std::abs(theirs[i] / y[i] - 1));
    }
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    for (const double end : {*low, *high}) {
      add_point(line, end, *slope * end + *intercept);
      add_point(published, end,
                number_or(trend, "reference_slope", nowhere) * end + number_or(trend, "reference_intercept", nowhere));
    }
    Chart chart{.title = text(trend, "name"),
                .x = {.label = column_label(text(trend, "x_name"))},
                .y = {.label = column_label(text(trend, "y_name")), .low = 0}};
    for (const Series& one : {line, published, measured, reference}) add(chart, one);
    std::string caption = fmt::format("Straight line through the measured depths: {} x {:+.4g}.",
                                      with_error(shown(slope), shown(number(trend, "slope_error"), 2)), *intercept);
    if (!theirs.empty())
      caption += fmt::format(" The reference's finite elements lie within {:.0f} % of them.", 100 * worst);
    add(section, Figure{.name = fmt::format("shape_{}", ++figures),
                        .caption = caption,
                        .alt = fmt::format("{} against {}: {} measured points on a rising line.", chart.y.label,
                                           chart.x.label, x.size()),
                        .chart = chart});
  }
  return section;
}

}  // namespace percal::page_of_identify
