#include "percal/observe/page/field_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/observe/field_errors.hpp"
#include "percal/observe/stored_run.hpp"
#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/problem/particle.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

Json layers_to_json(const FieldMeasures& measures, const FieldErrors& errors, const Scene& scene) {
  Json layers = Json::array();
  double face = 0;
  const auto add = [&](const std::string& name, double depth) {
    const MeanOfRuns& speed = measures.speeds_behind.at(layers.size());
    const auto& error = errors.speeds_behind.at(layers.size());
    layers.push_back({{"name", name},
                      {"lower_face_m", face += depth},
                      {"speed_behind_m_s", finite(speed.mean)},
                      {"speed_behind_spread_m_s", finite(speed.spread)},
                      {"speed_behind_standard_error_m_s", finite(speed.standard_error)},
                      {"speed_behind_error_m_s", finite(error)}});
  };
  add(scene.target.name, scene.target.depth);
  for (const LowerLayerScene& layer : scene.below) add(layer.name, layer.depth);
  return layers;
}

Json final_to_json(const std::optional<FinalState>& final, const FieldErrors& errors) {
  if (!final) return nullptr;
  return {{"ending", word(final->ending)},
          {"mixed", final->mixed},
          {"depth_m", finite(final->depth.mean)},
          {"half_width_m", finite(final->half_width)},
          {"depth_spread_m", finite(final->depth.spread)},
          {"depth_standard_error_m", finite(final->depth.standard_error)},
          {"depth_error_m", finite(errors.final_depth)},
          {"speed_m_s", finite(final->speed.mean)},
          {"speed_spread_m_s", finite(final->speed.spread)},
          {"speed_standard_error_m_s", finite(final->speed.standard_error)},
          {"speed_error_m_s", finite(errors.final_speed)},
          {"energy", energy_to_json(final->energy)},
          {"energy_worst_closure", finite(final->worst_closure)}};
}

Json list_of(const std::vector<std::optional<double>>& numbers) {
  Json list = Json::array();
  for (const auto& number : numbers) list.push_back(finite(number));
  return list;
}

Json list_of(const std::vector<MeanOfRuns>& radii, std::optional<double> MeanOfRuns::*part) {
  Json list = Json::array();
  for (const MeanOfRuns& radius : radii) list.push_back(finite(radius.*part));
  return list;
}

// The outline is the middle replicate's.
Json channel_to_json(const std::optional<ChannelOfRuns>& channel, const FieldErrors& errors, const Reduction& reduction,
                     const std::vector<Evaluation>& runs) {
  if (!channel) return nullptr;
  const ImpactResult& middle = runs[middle_replicate(static_cast<int>(runs.size()))].result;
  Json distances = Json::array(), depths = Json::array();
  for (const auto& [distance, depth] : particle_outline(middle, reduction.problem, reduction.scales)) {
    distances.push_back(finite(distance));
    depths.push_back(finite(depth));
  }
  return {{"share_of_depth", channel_shares},
          {"depth_m", channel->depths},
          {"largest_radius_m", list_of(channel->largest, &MeanOfRuns::mean)},
          {"largest_radius_spread_m", list_of(channel->largest, &MeanOfRuns::spread)},
          {"largest_radius_error_m", list_of(errors.largest)},
          {"end_radius_m", list_of(channel->end, &MeanOfRuns::mean)},
          {"end_radius_spread_m", list_of(channel->end, &MeanOfRuns::spread)},
          {"end_radius_error_m", list_of(errors.end)},
          {"particle", {{"distance_m", distances}, {"depth_m", depths}}}};
}

}  // namespace

Json field_measures_to_json(const FieldMeasures& measures, const Scene& scene, const Reduction& reduction,
                            const Penetration& penetration, const std::vector<Evaluation>& runs) {
  const FieldErrors errors = field_errors(measures, scene, reduction, penetration);
  return {{"impact_parameter_kg_m_s", impact_parameter(reduction.problem, reduction.scales)},
          {"sectional_density_kg_m2", sectional_density(reduction.problem, reduction.scales)},
          {"layers", layers_to_json(measures, errors, scene)},
          {"exit_speed_m_s", finite(measures.exit_speed.mean)},
          {"exit_speed_spread_m_s", finite(measures.exit_speed.spread)},
          {"exit_speed_standard_error_m_s", finite(measures.exit_speed.standard_error)},
          {"exit_speed_error_m_s", finite(errors.exit_speed)},
          {"final", final_to_json(measures.final, errors)},
          {"channel", channel_to_json(measures.channel, errors, reduction, runs)}};
}

Json speeds_behind_to_json(const ImpactResult& run, const Scales& scales) {
  Json speeds = Json::array();
  for (const double speed : run.speeds_behind) speeds.push_back(finite(speed * scales.speed));
  return speeds;
}

Json aftermath_to_json(const std::optional<Aftermath>& after, const Scales& scales) {
  if (!after) return nullptr;
  return {{"ending", word(after->ending)},
          {"reason", after->reason.empty() ? Json(nullptr) : Json(after->reason)},
          {"depth_m", finite(after->depth * scales.radius)},
          {"half_width_m", finite(after->half_width * scales.radius)},
          {"speed_m_s", finite(after->speed * scales.speed)},
          {"time_s", finite(after->time * scales.radius / scales.speed)},
          {"eroded", after->eroded},
          {"energy_closure", finite(after->energy.closure())}};
}

namespace page {
namespace {

constexpr double room_beside =
    0.2;  // of the depth, on either side: so that a long thin channel leaves room for the axis' numbers

std::string speed_words(const std::optional<double>& speed, const std::optional<double>& half_width = {}) {
  const std::string mean = quantity(speed, dimension::speed);
  return half_width ? with_error(mean, quantity(half_width, dimension::speed, 2)) : mean;
}

std::string rest_words(const Json& final) {
  const auto error = number(final, "depth_error_m");
  return with_error(length(number(final, "depth_m")), length(error ? error : number(final, "half_width_m"), 2));
}

// Both sides of the middle line, one after the other.
void add_walls(Chart& chart, const Json& channel, const char* key, const std::string& name, Mark mark, int colour,
               double unit) {
  const auto depths = numbers(at(channel, "depth_m")), radii = numbers(at(channel, key));
  for (const int side : {1, -1}) {
    Series wall = series(side > 0 ? name : "", mark, colour);
    for (std::size_t k = 0; k < depths.size() && k < radii.size(); ++k)
      add_point(wall, depths[k] / unit, side * radii[k] / unit);
    add(chart, wall);
  }
}

Figure channel_figure(const Json& channel) {
  const auto depths = numbers(at(channel, "depth_m")), largest = numbers(at(channel, "largest_radius_m")),
             end = numbers(at(channel, "end_radius_m"));
  const Json& particle = at(channel, "particle");
  const auto distance = numbers(at(particle, "distance_m")), depth = numbers(at(particle, "depth_m"));
  Figure figure;
  figure.name = "channel";
  const ShownUnit unit = length_unit(depths.empty() ? 0 : depths.back());
  Series outline = series("particle, deepest", Mark::line, -1);
  for (std::size_t k = 0; k < distance.size() && k < depth.size(); ++k)
    add_point(outline, depth[k] / unit.size, distance[k] / unit.size);
  figure.chart.title = "The channel and the particle";
  figure.chart.x.label = "depth, " + unit.name;
  figure.chart.y.label = "from the middle line, " + unit.name;
  figure.chart.equal_scales = true;
  double widest_drawn = room_beside * (depths.empty() ? 0 : depths.back()) / unit.size;
  for (const double radius : largest) widest_drawn = std::max(widest_drawn, 1.2 * radius / unit.size);
  for (const double at : distance) widest_drawn = std::max(widest_drawn, 1.2 * std::abs(at) / unit.size);
  figure.chart.y.low = -widest_drawn;
  figure.chart.y.high = widest_drawn;
  add_walls(figure.chart, channel, "largest_radius_m", "channel at its widest", Mark::line, 0, unit.size);
  add_walls(figure.chart, channel, "end_radius_m", "channel at the end", Mark::dashes, 1, unit.size);
  add(figure.chart, outline);
  const auto widest = std::max_element(largest.begin(), largest.end()), last = std::max_element(end.begin(), end.end());
  if (largest.empty() || end.empty()) return figure;
  figure.caption = fmt::format(
      "Walls that erosion has left, means of the runs at their undeformed depth, shot from the left; at most {} from "
      "the middle line, "
      "at the end {}. 0: nothing was taken out there.",
      length(*widest, 3), length(*last, 3));
  figure.alt =
      "The channel's walls on both sides of the middle line along the depth, and the particle at its deepest. " +
      figure.caption;
  return figure;
}

Table channel_table(const Json& channel) {
  Table table{.caption = "Radius of the channel along the depth",
              .rows = {{"share of the depth", "undeformed depth", "at its widest", "error", "at the end", "error"}},
              .notes = {"Half the distance of the walls. Error, 95 %: of the runs' mean, and half an element."}};
  const auto column = [&](const char* key) { return numbers(at(channel, key)); };
  const auto shares = column("share_of_depth"), depths = column("depth_m"), largest = column("largest_radius_m"),
             error = column("largest_radius_error_m"), end = column("end_radius_m"),
             end_error = column("end_radius_error_m");
  for (std::size_t k = 0; k < shares.size(); ++k)
    table.rows.push_back({percent(shares[k], 0), length(depths.at(k)), length(largest.at(k), 3), length(error.at(k), 2),
                          length(end.at(k), 3), length(end_error.at(k), 2)});
  return table;
}

}  // namespace

std::string final_words(const Json& result) {
  const Json& final = at(result, "final");
  if (final.is_null() || yes(final, "mixed")) return "";
  if (number(final, "depth_m")) return "; it comes to rest at " + rest_words(final);
  const auto speed = number(final, "speed_m_s");
  if (!speed) return "; past the deepest point it ended as: " + text(final, "ending");
  const auto error = number(final, "speed_error_m_s");
  return *speed < 0 ? "; it leaves upwards with " + speed_words(-*speed, error)
                    : "; it leaves below with " + speed_words(speed, error);
}

std::string exit_words(const Json& result) {
  const auto speed = number(result, "exit_speed_m_s");
  return speed ? ", left with " + speed_words(speed, number(result, "exit_speed_error_m_s")) : "";
}

std::vector<std::pair<std::string, std::string>> field_rows(const Json& result) {
  std::vector<std::pair<std::string, std::string>> rows;
  rows.emplace_back("impact parameter rho v a",
                    quantity(number(result, "impact_parameter_kg_m_s"), dimension::impact_parameter));
  rows.emplace_back("sectional density, mass over area",
                    quantity(number(result, "sectional_density_kg_m2"), dimension::sectional_density));
  for (const Json& layer : list(result, "layers"))
    rows.emplace_back("speed behind " + text(layer, "name"),
                      speed_words(number(layer, "speed_behind_m_s"), number(layer, "speed_behind_error_m_s")));
  const Json& final = at(result, "final");
  if (final.is_null()) return rows;
  if (number(final, "depth_m"))
    rows.emplace_back("final depth", fmt::format("{}; it still swings by {}", rest_words(final),
                                                 length(number(final, "half_width_m"), 2)));
  else if (const auto speed = number(final, "speed_m_s"))
    rows.emplace_back(*speed < 0 ? "speed upwards, thrown back" : "speed in free flight below",
                      speed_words(std::abs(*speed), number(final, "speed_error_m_s")));
  return rows;
}

Section channel_section(const Json& result) {
  Section section{.id = "channel", .title = "The channel", .blocks = {}};
  const Json& channel = at(result, "channel");
  if (channel.is_null()) return section;
  add(section, channel_figure(channel));
  add(section, channel_table(channel));
  return section;
}

}  // namespace page
}  // namespace percal
