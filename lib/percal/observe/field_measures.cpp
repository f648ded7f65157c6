#include "percal/observe/field_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "percal/math/polygon.hpp"

namespace percal {
namespace {

constexpr int outline_corners = 72;  // of a round particle

using Runs = std::vector<Evaluation>;

// What value(result) is of each run, times the unit, where every run has one.
template <class Value>
MeanOfRuns mean_where_all_have(const Runs& runs, double unit, const Value& value) {
  std::vector<double> values;
  for (const Evaluation& run : runs) {
    const std::optional<double> one = value(run.result);
    if (!one) return {};
    values.push_back(*one * unit);
  }
  return mean_of_runs(values);
}

std::optional<double> exit_speed_of(const ImpactResult& run) {
  if (run.outcome != Outcome::passed_through) return std::nullopt;
  if (!run.aftermath) return run.speeds_behind.empty() ? std::nullopt : std::optional(run.speeds_behind.back());
  return run.aftermath->ending == Ending::passed_through ? std::optional(run.aftermath->speed) : std::nullopt;
}

std::optional<FinalState> final_state(const Runs& runs, const Scales& scales) {
  FinalState final;
  std::vector<EnergyLedger> energies;
  for (const Evaluation& run : runs) {
    if (!run.result.aftermath) return std::nullopt;
    const Aftermath& after = *run.result.aftermath;
    if (!final.mixed) final.ending = after.ending;
    final.mixed |= after.ending != runs.front().result.aftermath->ending;
    energies.push_back(after.energy);
    final.worst_closure = std::max(final.worst_closure, std::abs(after.energy.closure()));
  }
  if (energies.empty()) return std::nullopt;
  final.energy = mean_energy(energies);
  if (final.mixed) return final;
  if (final.ending == Ending::rests) {
    final.depth = mean_where_all_have(runs, scales.radius,
                                      [](const ImpactResult& r) { return std::optional(r.aftermath->depth); });
    double widest = 0;
    for (const Evaluation& run : runs) widest = std::max(widest, run.result.aftermath->half_width);
    final.half_width = widest * scales.radius;
  } else if (final.ending == Ending::left_upwards || final.ending == Ending::ricochets ||
             final.ending == Ending::passed_through) {
    final.speed = mean_where_all_have(runs, scales.speed,
                                      [](const ImpactResult& r) { return std::optional(r.aftermath->speed); });
  }
  return final;
}

std::optional<ChannelOfRuns> channel_of(const Runs& runs, const Problem& problem, const Scales& scales) {
  double depth = 0;
  for (const Evaluation& run : runs) {
    if (run.result.channel.largest.size() != channel_shares.size()) return std::nullopt;
    depth += std::min(run.result.depth, problem.whole_depth()) / static_cast<double>(runs.size());
  }
  if (runs.empty()) return std::nullopt;
  ChannelOfRuns channel;
  for (std::size_t k = 0; k < channel_shares.size(); ++k) {
    const auto radius = [&](std::vector<double> Channel::*when) {
      return mean_where_all_have(runs, scales.radius,
                                 [&](const ImpactResult& r) { return std::optional((r.channel.*when)[k]); });
    };
    channel.depths.push_back(channel_shares[k] * depth * scales.radius);
    channel.largest.push_back(radius(&Channel::largest));
    channel.end.push_back(radius(&Channel::end));
  }
  return channel;
}

}  // namespace

FieldMeasures field_measures(const Runs& replicates, const Problem& problem, const Scales& scales) {
  FieldMeasures measures;
  for (std::size_t layer = 0; layer <= problem.below.size(); ++layer)
    measures.speeds_behind.push_back(mean_where_all_have(replicates, scales.speed, [&](const ImpactResult& r) {
      return layer < r.speeds_behind.size() ? std::optional(r.speeds_behind[layer]) : std::nullopt;
    }));
  measures.exit_speed = mean_where_all_have(replicates, scales.speed, exit_speed_of);
  measures.final = final_state(replicates, scales);
  measures.channel = channel_of(replicates, problem, scales);
  return measures;
}

std::vector<std::string> warnings(const FieldMeasures& measures, const Runs& replicates) {
  std::vector<std::string> lines;
  if (!measures.final) return lines;
  if (measures.final->mixed) {
    std::string list;
    for (const Evaluation& run : replicates) list += (list.empty() ? "" : ", ") + word(run.result.aftermath->ending);
    lines.push_back("past the deepest point the replicates ended differently (" + list +
                    "): neither final depths nor speeds are averaged");
  }
  for (const Evaluation& run : replicates)
    if (!run.result.aftermath->reason.empty())
      lines.push_back("past the deepest point, " + word(run.result.aftermath->ending) + ": " +
                      run.result.aftermath->reason);
  return lines;
}

std::vector<Point> particle_outline(const ImpactResult& run, const Problem& problem, const Scales& scales) {
  Polygon corners;  // from the particle's middle, y upwards
  if (const auto* profile = std::get_if<RigidPolygon>(&problem.particle)) {
    corners = turned(profile->vertices, run.turn);
  } else {
    for (int k = 0; k < outline_corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / outline_corners;
      corners.push_back({std::sin(angle), -std::cos(angle)});
    }
  }
  double lowest = HUGE_VAL;
  for (const Point& corner : corners) lowest = std::min(lowest, corner[1]);
  std::vector<Point> outline;
  for (const Point& corner : corners)
    outline.push_back({(corner[0] + run.sideways) * scales.radius, (run.depth - (corner[1] - lowest)) * scales.radius});
  outline.push_back(outline.front());
  return outline;
}

}  // namespace percal
