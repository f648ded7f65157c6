#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/problem/problem.hpp"

namespace percal {
namespace {

constexpr double smallest_chosen_ratio = 50;
constexpr double rigid_below = 0.02;  // (rho_t v^2 + 10 mu)/E: docs/theory/impact.md

struct BulkRatio {
  double pi4;
  double operator()(const ChooseBulk&) const { return std::max(smallest_chosen_ratio, subsonic_bulk_ratio(pi4)); }
  double operator()(const PoissonRatio& given) const { return bulk_to_shear(given.nu); }
  double operator()(const BulkToShear& given) const { return given.ratio; }
};

void leave_out_the_particles_elasticity(const Scene& scene, double mu_true, Reduction& reduction) {
  const auto& particle = scene.particle;
  if (!particle.youngs_modulus) {
    reduction.left_out.push_back({"elastic particle", "the scene gives no Young's modulus: the particle is rigid"});
    return;
  }
  const double ratio =
      (scene.target.density * particle.speed * particle.speed + 10 * mu_true) / *particle.youngs_modulus;
  const auto figure = fmt::format("(rho_t v^2 + 10 mu)/E = {:.2g}", ratio);
  if (ratio < rigid_below) {
    reduction.left_out.push_back({"elastic particle", figure + fmt::format(" is below {}: rigid", rigid_below)});
  } else {
    reduction.left_out.push_back({"elastic particle", "only a rigid particle can be run"});
    reduction.warnings.push_back(
        figure + fmt::format(" is not below {}: the particle's elasticity, left out here, may matter", rigid_below));
  }
}

void list_what_is_left_out(const Scene& scene, Reduction& reduction) {
  leave_out_the_particles_elasticity(scene, reduction.mu_true, reduction);
  if (std::holds_alternative<NoErosion>(scene.target.erosion))
    reduction.left_out.push_back({"erosion", "the scene gives no erosion strain"});
  if (!scene.output.history) reduction.left_out.push_back({"history", "nobody asked for it"});
  reduction.left_out.push_back({"rate dependence", "the scene gives none"});
  reduction.left_out.push_back({"further layers", "the scene has one"});
  reduction.left_out.push_back({"rows at rest", "rows that the wave has not reached are not advanced"});
  reduction.left_out.push_back(
      {"contact away from the particle", "only nodes within reach of the sphere are searched"});
}

}  // namespace

Reduction reduce(const Scene& scene) {
  const auto& particle = scene.particle;
  const auto& target = scene.target;
  Reduction reduction;
  reduction.scales = {particle.radius, particle.speed, target.density};
  reduction.mu_true = true_modulus(target.mu_as_given, target.alpha, target.convention);
  const double pi4 = target.density * particle.speed * particle.speed / reduction.mu_true;

  Problem& p = reduction.problem;
  p.pi4 = round_to_12_digits(pi4);
  p.density_ratio = round_to_12_digits(particle.density / target.density);
  p.alpha = round_to_12_digits(target.alpha);
  p.bulk_ratio = round_to_12_digits(std::visit(BulkRatio{p.pi4}, target.volumetric));
  p.depth = round_to_12_digits(target.depth / particle.radius);
  p.width = round_to_12_digits(target.width / particle.radius);
  p.bottom = target.bottom;
  p.erosion = target.erosion;
  p.elements_per_radius = scene.mesh.elements_per_radius;
  p.fine_width = round_to_12_digits(scene.mesh.fine_width);
  const int fine_columns = std::max(1, static_cast<int>(std::lround(p.fine_width * p.elements_per_radius)));
  p.graded_columns = scene.mesh.graded_columns.value_or(std::max(2, (fine_columns + 1) / 2));
  p.contact_stiffness = scene.solver.contact_stiffness;
  p.hourglass = scene.solver.hourglass;
  p.linear_viscosity = scene.solver.linear_viscosity;
  p.quadratic_viscosity = scene.solver.quadratic_viscosity;
  p.time_step_factor = scene.solver.time_step_factor;
  p.arithmetic = scene.solver.arithmetic;
  if (scene.solver.end_time) p.end_time = round_to_12_digits(*scene.solver.end_time * particle.speed / particle.radius);
  if (scene.output.history) p.history = History{};

  reduction.bulk_modulus = p.bulk_ratio * reduction.mu_true;
  reduction.mach = mach_number(p);
  reduction.bulk_was_chosen = std::holds_alternative<ChooseBulk>(target.volumetric);
  list_what_is_left_out(scene, reduction);
  return reduction;
}

}  // namespace percal
