// The steps of the chain as numbers beside the reference's, and what a reader must know of them.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "percal/identify/identification.hpp"
#include "percal/page/numbers.hpp"
#include "percal/scene/width.hpp"

namespace percal {
namespace {

std::optional<double> reference(const IdentifyJob& job, const std::string& key, double unit) {
  const auto found = job.reference.find(key);
  return found == job.reference.end() ? std::nullopt : std::optional(found->second / unit);
}

// Micrometres for particles, centimetres for balls.
std::pair<const char*, double> length_unit(double radius) {
  return radius < 1e-4 ? std::pair{"um", um} : std::pair{"cm", cm};
}

}  // namespace

ComparedNumbers law_step(const IdentifyJob& job, const Identification& found) {
  const auto& law = found.gelatin.law;
  ComparedNumbers table{
      .name = job.gelatin.name + ": modulus against concentration",
      .note = fmt::format(
          "mu = k c^n; k's error is the fit's standard error; high-rate moduli: the table's where a curve was "
          "measured, {} times the law's elsewhere",
          job.gelatin.rate_factor),
      .rows = {}};
  table.rows.push_back(
      {.what = "k", .unit = "kPa", .ours = law.factor / kPa, .error = over(law.factor_error, kPa), .digits = 5});
  table.rows.push_back({.what = job.gelatin.exponent ? "n (given)" : "n (fitted)",
                        .reference = job.gelatin.exponent,
                        .ours = law.exponent,
                        .error = law.exponent_error});
  for (const Formulation& f : job.gelatin.formulations) {
    const double modulus = law.at(f.concentration);
    table.rows.push_back(
        {.what = fmt::format("quasi-static modulus by the law, {} wt%", f.concentration),
         .unit = "kPa",
         .reference = f.mu_quasi_static / kPa,
         .ours = modulus / kPa,
         .error = law.factor_error ? std::optional(*law.factor_error / law.factor * modulus / kPa) : std::nullopt,
         .remark = f.measured ? "" : "extrapolated"});
    table.rows.push_back({.what = fmt::format("high-rate modulus by the law, {} wt%", f.concentration),
                          .unit = "kPa",
                          .reference = over(f.mu_high_rate, kPa),
                          .ours = high_rate_modulus(modulus, job.gelatin.rate_factor) / kPa});
  }
  return table;
}

ComparedNumbers ridge_step(const IdentifyJob& job, const Identification& found) {
  const auto [unit, scale] = length_unit(job.calibration.radius);
  ComparedNumbers table;
  table.name = fmt::format("ridge: modulus and erosion strain that give {:.4g} {}", job.penetration / scale, unit);
  table.note = fmt::format(
      "moduli as given ({}), {} strain, {} elements per radius; error: solver noise and the standard error of the "
      "measured depth; the mesh's is not in it",
      word(job.convention), word(job.measure), job.ridge.elements_per_radius);
  if (found.alpha_scan) {
    const auto& scan = *found.alpha_scan;
    table.note += fmt::format(
        "; alpha is fitted to the same pairs, so this table is no prediction: least mean deviation {} at {:.2f}, "
        "one standard error ({}) from {:.2f} to {:.2f}, the least of which is taken",
        page::percent(scan.best_score), scan.best, page::percent(scan.score_error), scan.lowest, scan.highest);
  }
  table.rows.push_back(
      {.what = "alpha", .unit = "", .reference = {}, .ours = found.alpha, .error = {}, .digits = 3, .remark = ""});
  for (const RidgePoint& point : found.ridge) {
    const bool is_found = point.inversion.outcome == InversionOutcome::found;
    table.rows.push_back(
        {.what = fmt::format("mu at erosion strain {}", point.erosion_strain),
         .unit = "MPa",
         .reference = point.known ? std::optional(point.known->mu / MPa) : std::nullopt,
         .ours = is_found ? std::optional(point.mu / MPa) : std::nullopt,
         .error =
             is_found ? std::optional(point.mu / MPa * std::hypot(point.solver_error, point.data_error)) : std::nullopt,
         .remark = is_found ? "" : word(point.inversion.outcome)});
  }
  for (const RidgePoint& point : found.ridge)
    if (point.at_known) {
      const Penetration& p = point.at_known->penetration;
      table.rows.push_back(
          {.what = fmt::format("depth at the known pair ({:.4g} MPa, {})", point.known->mu / MPa, point.erosion_strain),
           .unit = unit,
           .reference = job.penetration / scale,
           .ours = over(p.depth, scale),
           .error = over(p.standard_error, scale),
           .remark = p.depth ? "" : word(p.outcome)});
    }
  return table;
}

ComparedNumbers similarity_step(const IdentifyJob& job, const Identification& found) {
  const auto& s = found.similarity;
  ComparedNumbers table{.name = fmt::format("similar model system: {} into {}", job.model.name, job.gelatin.name),
                        .note = "exact consequences of equal pi4, pi5 and pi8; errors are those of the numbers put in",
                        .rows = {}};
  table.rows.push_back({.what = "density that the model material should have",
                        .unit = "kg/m3",
                        .reference = reference(job, "model_density", 1),
                        .ours = s.model.target_density,
                        .digits = 5});
  table.rows.push_back({.what = "density that it has", .unit = "kg/m3", .ours = job.gelatin.density, .digits = 5});
  table.rows.push_back(
      {.what = "modulus, model over tissue", .reference = reference(job, "modulus_ratio", 1), .ours = s.modulus_ratio});
  table.rows.push_back({.what = "depth that the model shot should have",
                        .unit = "cm",
                        .reference = reference(job, "model_penetration", cm),
                        .ours = s.penetration / cm,
                        .error = job.penetration_error
                                     ? std::optional(*job.penetration_error / job.penetration * s.penetration / cm)
                                     : std::nullopt});
  return table;
}

ComparedNumbers formulation_step(const IdentifyJob& job, const Identification& found) {
  const auto& s = found.similarity;
  ComparedNumbers table{
      .name = "formulation whose measured depth is nearest",
      .note = fmt::format("depth that the model shot should have: {:.4g} cm; error: standard deviation of single shots",
                          s.penetration / cm),
      .beside = "wanted",
      .rows = {}};
  for (std::size_t i = 0; i < job.gelatin.formulations.size(); ++i) {
    const Formulation& f = job.gelatin.formulations[i];
    table.rows.push_back({.what = fmt::format("measured depth, {} wt%", f.concentration),
                          .unit = "cm",
                          .reference = s.penetration / cm,
                          .ours = f.penetration / cm,
                          .error = over(f.penetration_sd, cm),
                          .remark = static_cast<int>(i) == s.formulation ? "chosen" : ""});
  }
  table.rows.push_back(
      {.what = "its high-rate modulus as given", .unit = "kPa", .ours = found.gelatin.high_rate[s.formulation] / kPa});
  return table;
}

ComparedNumbers tissue_step(const IdentifyJob& job, const Identification& found) {
  const auto& t = found.tissue;
  ComparedNumbers table{.name = job.tissue.name,
                        .note = fmt::format("true modulus = as given times {:.4g} ({}); the erosion strain's error is "
                                            "the ridge's; the modulus carries the "
                                            "error of the choice of one formulation, {} in depth",
                                            true_modulus(1, found.alpha, job.convention), word(job.convention),
                                            page::percent(std::abs(found.similarity.mismatch))),
                        .rows = {}};
  table.rows.push_back({.what = "high-rate shear modulus as given",
                        .unit = "MPa",
                        .reference = reference(job, "highrate_modulus", MPa),
                        .ours = t.mu / MPa});
  table.rows.push_back({.what = "high-rate shear modulus, true",
                        .unit = "MPa",
                        .ours = true_modulus(t.mu, found.alpha, job.convention) / MPa});
  table.rows.push_back({.what = "erosion strain on the ridge",
                        .reference = reference(job, "erosion_strain", 1),
                        .ours = t.erosion ? std::optional(t.erosion->strain) : std::nullopt,
                        .error = t.erosion ? std::optional(t.erosion->error) : std::nullopt,
                        .digits = 3,
                        .remark = t.erosion ? "" : "the ridge does not reach this modulus"});
  table.rows.push_back({.what = "quasi-static shear modulus as given",
                        .unit = "MPa",
                        .reference = reference(job, "quasistatic_shear_modulus", MPa),
                        .ours = t.mu_quasi_static / MPa});
  table.rows.push_back({.what = "quasi-static Young's modulus as given",
                        .unit = "MPa",
                        .reference = reference(job, "quasistatic_youngs_modulus", MPa),
                        .ours = t.youngs_quasi_static / MPa});
  table.rows.push_back({.what = "quasi-static Young's modulus, true",
                        .unit = "MPa",
                        .ours = true_modulus(t.youngs_quasi_static, found.alpha, job.convention) / MPa});
  return table;
}

ComparedNumbers check_step(const IdentifyJob& job, const Identification& found) {
  const Penetration& p = found.model_check->penetration;
  const auto& s = found.similarity;
  ComparedNumbers table{
      .name = "finite-element check of the model system",
      .note = fmt::format("{:.5g} kg/m3, {:.4g} kPa as given, erosion strain {:.3g}, {} elements per radius, {} runs; "
                          "error: their standard error",
                          *s.model.target_density, found.gelatin.high_rate[s.formulation] / kPa,
                          found.tissue.erosion->strain, job.check_elements_per_radius, job.check_replicates),
      .beside = "other",
      .rows = {}};
  const auto row = [&](const char* what, std::optional<double> other) {
    table.rows.push_back({.what = what,
                          .unit = "cm",
                          .reference = other,
                          .ours = over(p.depth, cm),
                          .error = over(p.standard_error, cm),
                          .remark = p.depth ? "" : word(p.outcome)});
  };
  row("depth, beside the similar one", s.penetration / cm);
  row("depth, beside the measured one", job.gelatin.formulations[s.formulation].penetration / cm);
  if (job.reference.contains("model_fe_penetration"))
    row("depth, beside the reference's finite elements", reference(job, "model_fe_penetration", cm));
  return table;
}

ComparedNumbers mesh_step(const IdentifyJob& job, const Identification& found) {
  const auto [unit, scale] = length_unit(job.calibration.radius);
  ComparedNumbers table{
      .name = "mesh: the calibration impact at the identified pair",
      .note = fmt::format(
          "the ridge was found with {} elements per radius, the predictions have their own; what the depth still "
          "changes here is the mesh error of both. Error: standard error of {} runs",
          job.ridge.elements_per_radius, job.check_replicates),
      .beside = "measured",
      .rows = {}};
  for (std::size_t i = 0; i < found.mesh_study.size(); ++i) {
    const Penetration& p = found.mesh_study[i].penetration;
    table.rows.push_back({.what = fmt::format("{} elements per radius", job.mesh_study[i]),
                          .unit = unit,
                          .reference = job.penetration / scale,
                          .ours = over(p.depth, scale),
                          .error = over(p.standard_error, scale),
                          .remark = p.depth ? "" : word(p.outcome)});
  }
  return table;
}

ComparedNumbers prediction_step(const IdentifyJob& job, const PredictionResult& result) {
  const PredictionSet& set = *result.set;
  ComparedNumbers table{.name = fmt::format("predicted: {} ({:.5g} kg/m3)", set.system, set.target_density),
                        .note = "",
                        .beside = "measured",
                        .rows = {}};
  for (std::size_t i = 0; i < set.shots.size(); ++i) {
    const PredictedShot& shot = set.shots[i];
    const auto [unit, scale] = length_unit(shot.radius);
    const Penetration& p = result.shots[i].penetration;
    std::string remark = p.depth ? "" : word(p.outcome);
    if (shot.reference && p.depth)
      remark = fmt::format("{} {:.4g} ({:+.1f} %)", job.reference_name, *shot.reference / scale,
                           100 * (*p.depth / *shot.reference - 1));
    table.rows.push_back({.what = fmt::format("{}, a = {}, {:.4g} m/s", shot.particle,
                                              format_quantity(shot.radius, dimension::length), shot.speed),
                          .unit = unit,
                          .reference = over(shot.measured, scale),
                          .ours = over(p.depth, scale),
                          .error = over(p.spread, scale),
                          .remark = remark});
  }
  const bool any_joined =
      std::ranges::any_of(result.shots, [](const Shooting& shot) { return shot.penetration.is_joined; });
  table.note = fmt::format("{} elements per radius, error: {}", set.elements_per_radius,
                           any_joined ? "what one run scatters by; means of runs and atlas"
                                      : fmt::format("spread of {} runs", set.replicates));
  if (result.mean_deviation_from_reference)
    table.note += fmt::format("; mean deviation from the {}'s depths {}", job.reference_name,
                              page::percent(result.mean_deviation_from_reference));
  return table;
}

namespace {

// Radii: what usual_width() asks of the shots at the materials that were found.
double width_needed(const IdentifyJob& job, const Identification& found) {
  double widest = 0;
  const auto look_at = [&](const Problem& p) { widest = std::max(widest, usual_width(p.pi4, p.density_ratio)); };
  if (found.complete()) look_at(reduce(identified_scene(job, found)).problem);
  for (const PredictionResult& prediction : found.predictions)
    for (const Shooting& shot : prediction.shots) look_at(shot.reduction.problem);
  return widest;
}

}  // namespace

std::vector<std::string> findings(const IdentifyJob& job, const Identification& found) {
  std::vector<std::string> lines;
  if (job.solver.contact_stiffness_was_given) lines.emplace_back(contact_stiffness_warning);
  if (job.layer.width_was_chosen)
    lines.push_back(fmt::format(
        "the wall is at {:.4g} radii for every sphere: the widest that any shot of the job needs", job.layer.width));
  if (const std::string warning = width_warning(job.layer.width, width_needed(job, found)); !warning.empty())
    lines.push_back(warning);
  if (found.alpha_scan) {
    lines.push_back(
        "alpha is fitted to the ridge's known pairs: the ridge is in-sample. The predictions and the model check are "
        "not.");
    if (found.alpha_scan->at_edge) lines.push_back("the best alpha is at the edge of the scan: scan further");
  }
  if (job.convention == ModulusConvention::mu_over_alpha)
    lines.push_back(
        fmt::format("every modulus is taken as W = (mu/alpha) sum lambda^alpha means it: the true small-strain modulus "
                    "is {:.4g} times "
                    "the one given. A modulus read off a stress-stretch curve is a true one; if {}'s moduli were, the "
                    "{}'s true modulus would "
                    "be {:.4g} MPa, not {:.4g} MPa.",
                    true_modulus(1, found.alpha, job.convention), job.gelatin.name, job.tissue.name,
                    found.tissue.mu / MPa, true_modulus(found.tissue.mu, found.alpha, job.convention) / MPa));
  lines.push_back(fmt::format(
      "mu = k c^n is a law of the blocks of {}: one recipe after 21 h at 10 C and after 100 h at 20 C let a BB go "
      "49.7 and 79.1 mm (Maiden et al. 2015), which is a factor of 2.1 in the modulus. For another block: its own "
      "shots (percal invert, percal calibrate).",
      job.gelatin.table));
  const double has = job.gelatin.density, should = *found.similarity.model.target_density;
  if (std::abs(has / should - 1) > 0.05)
    lines.push_back(
        fmt::format("{} has {:.4g} kg/m3 where similarity asks for {:.4g}: its shots are not similar to the "
                    "calibration impact, and the "
                    "predictions at both densities show what that is worth.",
                    job.gelatin.name, has, should));
  if (!found.complete())
    lines.push_back("the ridge does not reach the modulus that the model material gives: no erosion strain, no card");
  return lines;
}

}  // namespace percal
