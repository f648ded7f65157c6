#include "percal/observe/field_errors.hpp"

#include <algorithm>
#include <cmath>

#include "percal/observe/depth_error_rules.hpp"

namespace percal {
namespace {

// Wall, time step and K together, as a share of a depth; nothing where one of them is not known.
std::optional<double> ruled_share(const Scene& scene, const Reduction& reduction, double worst_closure) {
  double squares = 0;
  for (const RuledShare& rule : {wall_share(scene, reduction.problem),
                                 time_step_share(reduction.problem, worst_closure), bulk_share(reduction)}) {
    if (!rule.share) return std::nullopt;
    squares += *rule.share * *rule.share;
  }
  return std::sqrt(squares);
}

// With whatever else there is, in the unit of the mean.
std::optional<double> with_phase(const MeanOfRuns& mean, int runs, std::initializer_list<double> others) {
  const auto phase = phase_half_width(mean.standard_error, runs);
  if (!phase) return std::nullopt;
  double squares = *phase * *phase;
  for (const double other : others) squares += other * other;
  return std::sqrt(squares);
}

}  // namespace

double speed_half_width(double speed, double impact_speed, double share) {
  const double left = speed * speed, off = share * std::abs(impact_speed * impact_speed - left);
  return std::max(std::abs(speed) - std::sqrt(std::max(0.0, left - off)), std::sqrt(left + off) - std::abs(speed));
}

FieldErrors field_errors(const FieldMeasures& measures, const Scene& scene, const Reduction& reduction,
                         const Penetration& penetration) {
  const int runs = static_cast<int>(penetration.outcomes.size());
  const auto share = ruled_share(scene, reduction, penetration.worst_closure);
  const auto of_speed = [&](const MeanOfRuns& speed) -> std::optional<double> {
    if (!speed.mean || !share) return std::nullopt;
    return with_phase(speed, runs, {speed_half_width(*speed.mean, scene.particle.speed, *share)});
  };
  FieldErrors errors;
  for (const MeanOfRuns& speed : measures.speeds_behind) errors.speeds_behind.push_back(of_speed(speed));
  errors.exit_speed = of_speed(measures.exit_speed);
  if (measures.final) {
    errors.final_speed = of_speed(measures.final->speed);
    const MeanOfRuns& depth = measures.final->depth;
    if (depth.mean && share)
      errors.final_depth = with_phase(depth, runs, {*share * *depth.mean, measures.final->half_width.value_or(0)});
  }
  if (!measures.channel) return errors;
  const double half_an_element = 0.5 * scene.particle.radius / reduction.problem.elements_per_radius;
  for (const auto& [radii, half_widths] :
       {std::pair(&measures.channel->largest, &errors.largest), std::pair(&measures.channel->end, &errors.end)})
    for (const MeanOfRuns& radius : *radii) half_widths->push_back(with_phase(radius, runs, {half_an_element}));
  return errors;
}

}  // namespace percal
