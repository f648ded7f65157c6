// Depths against the impact parameter rho_p v a: what was measured, what the reference computed, what percal predicts.
// Guha 2009, Figures 4-1 and 4-2.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/identify/page/sections.hpp"
#include "percal/math/statistics.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page_of_identify {
namespace {

PageShot shot_of(const Json& entry) {
  const auto value = [&](const char* key) { return number_or(entry, key, nowhere); };
  return {.particle = text(entry, "particle"),
          .particle_density = value("particle_density_kg_m3"),
          .radius = value("radius_m"),
          .speed = value("speed_m_s"),
          .target_density = value("target_density_kg_m3"),
          .mu = value("mu_true_Pa"),
          .measured = value("measured_m"),
          .reference = value("thesis_fe_m"),
          .depth = value("depth_m"),
          .spread = value("depth_spread_m")};
}

bool same_shots(const PageSet& first, const PageSet& second) {
  return std::equal(first.shots.begin(), first.shots.end(), second.shots.begin(), second.shots.end(),
                    [](const PageShot& a, const PageShot& b) {
                      return a.particle == b.particle && a.radius == b.radius && a.speed == b.speed;
                    });
}

// Sets of the same shots belong into one figure.
std::vector<std::vector<PageSet>> families(const std::vector<PageSet>& sets) {
  std::vector<std::vector<PageSet>> all;
  for (const PageSet& set : sets) {
    const auto family = std::find_if(all.begin(), all.end(), [&](const auto& f) { return same_shots(f.front(), set); });
    if (family == all.end())
      all.push_back({set});
    else
      family->push_back(set);
  }
  return all;
}

std::string set_name(const PageSet& set, const std::vector<PageSet>& family) {
  const auto alike =
      std::count_if(family.begin(), family.end(), [&](const PageSet& s) { return s.system == set.system; });
  const std::string density = fmt::format("{:.4g} kg/m3", set.shots.front().target_density);
  if (alike == static_cast<long>(family.size())) return "percal, target of " + density;
  return "percal: " + set.system + (alike > 1 ? ", " + density : "");
}

Series measured_series(const std::string& name, const std::vector<PageShot>& shots, double unit, int colour) {
  Series points = series(name, Mark::points, colour);
  for (const PageShot& shot : shots) add_point(points, shot.impact_parameter(), shot.measured / unit);
  return points;
}

// The straight line through the measured depths, where there are three or more.
Series trend_series(const std::vector<PageShot>& shots, double unit) {
  Series line = series("linear trend of the measured", Mark::dashes, -1);
  std::vector<double> x, y;
  for (const PageShot& shot : shots)
    if (std::isfinite(shot.measured) && std::isfinite(shot.impact_parameter())) {
      x.push_back(shot.impact_parameter());
      y.push_back(shot.measured / unit);
    }
  if (std::set<double>(x.begin(), x.end()).size() < 3) return line;
  const Line trend = linear_trend(x, y);
  for (const double at_x : {*std::min_element(x.begin(), x.end()), *std::max_element(x.begin(), x.end())})
    add_point(line, at_x, trend.at(at_x));
  return line;
}

// Mean of |ours/theirs - 1|; nothing where no shot has both.
std::optional<double> mean_deviation(const std::vector<PageShot>& shots, double PageShot::*theirs) {
  double sum = 0;
  int count = 0;
  for (const PageShot& shot : shots)
    if (std::isfinite(shot.depth) && std::isfinite(shot.*theirs)) {
      sum += std::abs(shot.depth / (shot.*theirs) - 1);
      ++count;
    }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::string deviation_sentence(const PageSet& set, const std::string& name, const std::string& reference) {
  const auto measured = mean_deviation(set.shots, &PageShot::measured);
  const auto theirs = mean_deviation(set.shots, &PageShot::reference);
  if (!measured && !theirs) return "";
  std::vector<std::string> parts;
  if (measured) parts.push_back(percent(measured) + " from the measured depths");
  if (theirs) parts.push_back(percent(theirs) + " from " + reference);
  return fmt::format(" {}: {} in the mean.", name, fmt::join(parts, ", "));
}

// The second axis of a model's shots: the impact parameter of the particle in the tissue that each is similar to.
void add_equivalent_axis(const Json& result, Chart& chart) {
  const auto impact_parameter = [](const Json& sphere) {
    return number_or(sphere, "particle_density_kg_m3", nowhere) * number_or(sphere, "speed_m_s", nowhere) *
           number_or(sphere, "radius_m", nowhere);
  };
  const Json &particle = at(result, "calibration"), &ball = at(result, "model");
  const double factor = impact_parameter(particle) / impact_parameter(ball);
  if (!std::isfinite(factor)) return;
  chart.upper = Axis{.label = fmt::format("rho_p v a of the similar {} in {}, kg/(m s)", text(particle, "particle"),
                                          text(at(result, "skin"), "name"))};
  chart.upper_factor = factor;
}

// What the figures of one family share.
struct Family {
  const std::vector<PageSet>& sets;
  std::string target;
  bool of_model;
  ShownUnit unit;

  const std::vector<PageShot>& shots() const { return sets.front().shots; }
  Chart chart() const {
    return {.title = "Depth in " + target,
            .x = {.label = "rho_p v a, kg/(m s)"},
            .y = {.label = "depth, " + unit.name, .low = 0}};
  }
};

Family family_of(const Json& result, const std::vector<PageSet>& sets) {
  const bool of_model = std::any_of(sets.begin(), sets.end(), [](const PageSet& s) { return s.material == "model"; });
  double deepest = 0;
  for (const PageShot& shot : sets.front().shots)
    for (const double depth : {shot.measured, shot.depth})
      if (std::isfinite(depth)) deepest = std::max(deepest, depth);
  return {sets, of_model ? text(at(result, "model"), "material") : text(at(result, "skin"), "name"), of_model,
          length_unit(deepest)};
}

// Balls of several materials, each in its colour, with the line through all of them.
Figure measured_figure(const Json& result, const Family& family, const std::string& name) {
  const auto balls = by_ball(family.shots());
  Chart chart = family.chart();
  chart.title += ", measured";
  int colour = 0;
  for (const BallGroup& ball : balls) add(chart, measured_series(ball.name, ball.shots, family.unit.size, colour++));
  add(chart, trend_series(family.shots(), family.unit.size));
  if (family.of_model) add_equivalent_axis(result, chart);
  return {.name = name,
          .caption = fmt::format(
              "Measured depths in {} against density times speed times radius of the ball: {} kinds of ball lie "
              "about one straight line.",
              family.target, balls.size()),
          .alt = fmt::format(
              "Depth against the impact parameter for {} shots of {} kinds of ball into {}, about a rising line.",
              family.shots().size(), balls.size(), family.target),
          .chart = chart};
}

Figure predicted_figure(const Family& family, const std::string& name) {
  const std::string reference = "the reference's finite elements";
  const double unit = family.unit.size;
  Chart chart = family.chart();
  int colour = 0;
  add(chart, measured_series("measured", family.shots(), unit, colour++));
  Series theirs = series(reference, Mark::points, colour);
  for (const PageShot& shot : family.shots()) add_point(theirs, shot.impact_parameter(), shot.reference / unit);
  if (!theirs.x.empty()) ++colour;
  add(chart, std::move(theirs));
  std::string finding;
  for (const PageSet& set : family.sets) {
    Series ours = series(set_name(set, family.sets), Mark::points_with_bars, colour++);
    for (const PageShot& shot : set.shots)
      add_bar(ours, shot.impact_parameter(), shot.depth / unit, (shot.depth - shot.spread) / unit,
              (shot.depth + shot.spread) / unit);
    finding += deviation_sentence(set, ours.name, reference);
    add(chart, std::move(ours));
  }
  return {.name = name,
          .caption =
              fmt::format("Depth in {} against density times speed times radius of the particle.{} Bars: spread of the "
                          "replicates.",
                          family.target, finding),
          .alt = fmt::format("Depths of {} shots into {}, rising with the impact parameter.{}", family.shots().size(),
                             family.target, finding),
          .chart = chart};
}

}  // namespace

std::vector<PageSet> prediction_sets(const Json& result) {
  std::vector<PageSet> sets;
  for (const Json& entry : list(result, "predictions")) {
    const PageShot shot = shot_of(entry);
    const std::string system = text(entry, "system");
    if (sets.empty() || sets.back().system != system || sets.back().shots.front().target_density != shot.target_density)
      sets.push_back({.system = system, .material = text(entry, "material"), .shots = {}});
    sets.back().shots.push_back(shot);
  }
  return sets;
}

std::vector<BallGroup> by_ball(const std::vector<PageShot>& shots) {
  std::vector<BallGroup> groups;
  for (const PageShot& shot : shots) {
    const std::string name = fmt::format("{} of {}", shot.particle, length(2 * shot.radius, 3));
    auto group = std::find_if(groups.begin(), groups.end(), [&](const BallGroup& g) { return g.name == name; });
    if (group == groups.end()) group = groups.insert(groups.end(), {.name = name, .shots = {}});
    group->shots.push_back(shot);
  }
  return groups;
}

Section depths_section(const Json& result) {
  Section section{.id = "depths", .title = "Depths: measured, the reference's, predicted", .blocks = {}};
  int figures = 0;
  for (const auto& family : families(prediction_sets(result))) {
    if (family.front().shots.size() < 2) continue;  // the tables have them
    const Family one = family_of(result, family);
    ++figures;
    if (by_ball(one.shots()).size() > 1 && one.of_model)
      add(section, measured_figure(result, one, fmt::format("measured_{}", figures)));
    add(section, predicted_figure(one, fmt::format("depths_{}", figures)));
  }
  return section;
}

}  // namespace percal::page_of_identify
