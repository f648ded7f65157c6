#include "percal/calibrate/shot_problem.hpp"

#include <algorithm>
#include <cmath>

namespace percal {
namespace {

double number_at(const MaterialNumber& number, const std::vector<double>& natural) {
  if (const auto* shared = std::get_if<SharedParameter>(&number)) return natural[shared->index];
  return std::get<double>(number);
}

// K/mu as reduce() chooses it, and d ln(K/mu)/d ln pi4: K/mu is a straight line in pi4 where the Mach number decides.
struct ChosenBulk {
  double ratio, slope;
};
ChosenBulk chosen_bulk(double pi4) {
  const double subsonic = subsonic_bulk_ratio(pi4);
  if (subsonic <= least_bulk_ratio) return {least_bulk_ratio, 0};
  return {subsonic, (subsonic_bulk_ratio(2 * pi4) - subsonic) / subsonic};
}

}  // namespace

MaterialAt material_at(const CalibrationJob& job, const Hypothesis& hypothesis, int material,
                       const std::vector<double>& natural) {
  const CalibrationMaterial& m = job.materials[material];
  MaterialAt at{.density = m.density,
                .mu_as_given = number_at(m.mu, natural),
                .mu_true = 0,
                .alpha = number_at(m.alpha, natural),
                .erosion_strain = number_at(m.erosion_strain, natural)};
  at.mu_true = true_modulus(at.mu_as_given, at.alpha, hypothesis.convention);
  return at;
}

Problem shot_problem(const CalibrationJob& job, const Hypothesis& hypothesis, const MeasuredShot& shot,
                     const MaterialAt& material, int elements_per_radius) {
  Scene scene;
  scene.source = job.file;
  scene.particle.radius = shot.radius;
  scene.particle.density = shot.density;
  scene.particle.speed = shot.speed;
  scene.particle.elasticity = Elasticity::rigid;
  scene.target = {.density = material.density,
                  .mu_as_given = material.mu_true,
                  .alpha = material.alpha,
                  .volumetric = ChooseBulk{},
                  .depth = shot.layer_depth,
                  .width = shot.layer_width,
                  .erosion = StrainErosion{material.erosion_strain, StrainMeasure::engineering}};
  scene.mesh.elements_per_radius = elements_per_radius;
  scene.solver = job.solver;
  scene.solver.contact_stiffness = hypothesis.contact_stiffness;
  return reduce(scene).problem;
}

ShotInputs shot_inputs(const MeasuredShot& shot, const MaterialAt& material) {
  const double pi4 = material.density * shot.speed * shot.speed / material.mu_true;
  const auto [bulk, slope] = chosen_bulk(pi4);
  ShotInputs inputs;
  inputs.at = {std::log(pi4),           std::log(material.density / shot.density), material.alpha,
               material.erosion_strain, std::log(shot.layer_depth / shot.radius),  std::log(bulk)};
  inputs.derivative.setZero();
  enum { log_mu, alpha, erosion_strain, log_speed };
  inputs.derivative(0, log_mu) = -1;
  inputs.derivative(5, log_mu) = -slope;
  inputs.derivative(0, log_speed) = 2;
  inputs.derivative(5, log_speed) = 2 * slope;
  inputs.derivative(2, alpha) = 1;
  inputs.derivative(3, erosion_strain) = 1;
  return inputs;
}

}  // namespace percal
