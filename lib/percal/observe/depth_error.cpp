#include "percal/observe/depth_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/math/distributions.hpp"
#include "percal/observe/depth_error_rules.hpp"
#include "percal/scene/erosion_length.hpp"

namespace percal {
namespace {

double student(int runs) { return student_quantile(0.5 + depth_error_level / 2, runs - 1); }

double normal_half_width(double standard_error) {
  return normal_quantile(0.5 + depth_error_level / 2) * standard_error;
}

// The rest of an effect's series: a step of second order, K by the square of the Mach number, a wall without an order.
double whole_over_measured(DepthErrorSource source) {
  if (source == DepthErrorSource::time_step) return 1 / (1 - finer_step * finer_step);
  if (source == DepthErrorSource::bulk) return 1 / (1 - 1 / stiffer_bulk);
  return 1;
}

std::string setting_words(DepthErrorSource source) {
  if (source == DepthErrorSource::time_step) return fmt::format("{:g} of the time step", finer_step);
  if (source == DepthErrorSource::bulk) return fmt::format("{:g} K", stiffer_bulk);
  return fmt::format("{:g} times the width", farther_wall);
}

ErrorPart measured_part(const MeasuredEffect& effect, double depth) {
  const double whole = whole_over_measured(effect.source);
  return {effect.source, whole * std::hypot(effect.difference, student(effect.pairs) * effect.standard_error),
          fmt::format("measured: {} moves the depth by {:+.2f} %, standard error {:.2f} % ({} pairs of runs)",
                      setting_words(effect.source), 100 * effect.difference / depth,
                      100 * effect.standard_error / depth, effect.pairs)};
}

ErrorPart rule_part(DepthErrorSource source, const RuledShare& rule, double depth) {
  return {source, rule.share ? std::optional(*rule.share * depth) : std::nullopt, rule.how, rule.share.has_value()};
}

ErrorPart phase_part(const Penetration& penetration, const ErrorEvidence& evidence) {
  if (const auto& line = evidence.extrapolation)
    return {DepthErrorSource::mesh_phase, phase_half_width(line->standard_error, line->replicates),
            fmt::format("standard error of (4 d({:.4g}) - d({:.4g}))/3, {} runs on each mesh, times Student's t",
                        line->finer_elements_per_radius, line->elements_per_radius, line->replicates)};
  const int runs = static_cast<int>(penetration.depths.size());
  if (penetration.is_joined)
    return {
        DepthErrorSource::mesh_phase, normal_half_width(*penetration.standard_error),
        fmt::format("{} run{} over the mesh phase and the atlas, each by its certainty", runs, runs == 1 ? "" : "s")};
  if (evidence.noise)
    return {DepthErrorSource::mesh_phase, normal_half_width(*evidence.noise * *penetration.depth),
            fmt::format("the scene's study of error against time: what {} run{} scatter{} by on this mesh", runs,
                        runs == 1 ? "" : "s", runs == 1 ? "s" : "")};
  if (runs < 2)
    return {DepthErrorSource::mesh_phase, std::nullopt, "one run does not show it: two replicates or more do"};
  return {DepthErrorSource::mesh_phase, phase_half_width(penetration.standard_error, runs),
          fmt::format("standard error of the mean of {} runs over the mesh phase, times Student's t {:.3g}", runs,
                      student(runs))};
}

ErrorPart size_part(const Scene& scene, double depth, const ErrorEvidence& evidence) {
  const double per_radius = scene.mesh.elements_per_radius;
  if (const auto& line = evidence.extrapolation)
    return {DepthErrorSource::mesh_size, line->model_error, "how much farther a line in h would go, and 1 % at least"};
  if (evidence.discretisation)
    return {DepthErrorSource::mesh_size, normal_half_width(*evidence.discretisation * depth),
            "the scene's study of error against time, by the fitted curve to h = 0"};
  if (const auto share = element_over_erosion_length(scene))
    return {
        DepthErrorSource::mesh_size, std::nullopt,
        fmt::format("belongs to elements of {:.2g} of the erosion length; their bias has a line of its own", *share)};
  if (std::holds_alternative<NoErosion>(scene.target.erosion))
    return {DepthErrorSource::mesh_size, std::nullopt, "not measured: percal study --error-vs-time does"};
  return {DepthErrorSource::mesh_size, std::nullopt,
          fmt::format("belongs to elements of 1/{:.4g} radius: erosion by the element's own strain has no limit in h",
                      per_radius)};
}

}  // namespace

std::string word(DepthErrorSource source) {
  switch (source) {
    case DepthErrorSource::mesh_phase: return "mesh phase";
    case DepthErrorSource::mesh_size: return "mesh size";
    case DepthErrorSource::wall: return "wall";
    case DepthErrorSource::time_step: return "time step";
    case DepthErrorSource::bulk: return "K";
  }
  return "";
}

std::optional<double> phase_half_width(std::optional<double> standard_error, int runs) {
  if (!standard_error || runs < 2) return std::nullopt;
  return student(runs) * *standard_error;
}

std::optional<double> DepthError::half_width() const {
  double squares = 0;
  bool any = false;
  for (const ErrorPart& part : parts)
    if (part.half_width) {
      squares += *part.half_width * *part.half_width;
      any = true;
    }
  return any ? std::optional(std::sqrt(squares)) : std::nullopt;
}

const ErrorPart& DepthError::of(DepthErrorSource source) const {
  return *std::ranges::find(parts, source, &ErrorPart::source);
}

DepthError depth_error(const Scene& scene, const Reduction& reduction, const Penetration& penetration,
                       const ErrorEvidence& evidence) {
  const double depth = evidence.extrapolation ? evidence.extrapolation->depth : *penetration.depth;
  DepthError error{
      .parts = {phase_part(penetration, evidence), size_part(scene, depth, evidence)}, .belongs_to = "", .bias = {}};
  if (!error.of(DepthErrorSource::mesh_size).half_width) {
    if (const auto share = element_over_erosion_length(scene))
      error.bias = rule_part(DepthErrorSource::mesh_size, bias_share(reduction.problem, *share), depth);
    if (!std::holds_alternative<NoErosion>(scene.target.erosion))
      error.belongs_to = fmt::format("elements of 1/{:.4g} radius", scene.mesh.elements_per_radius);
  }
  const auto measured = [&](DepthErrorSource source) {
    return std::ranges::find(evidence.effects, source, &MeasuredEffect::source);
  };
  const auto add = [&](DepthErrorSource source, const RuledShare& rule) {
    const auto found = measured(source);
    error.parts.push_back(found == evidence.effects.end() ? rule_part(source, rule, depth)
                                                          : measured_part(*found, depth));
  };
  add(DepthErrorSource::wall, wall_share(scene, reduction.problem));
  add(DepthErrorSource::time_step, time_step_share(reduction.problem, penetration.worst_closure));
  add(DepthErrorSource::bulk, bulk_share(reduction));
  return error;
}

}  // namespace percal
