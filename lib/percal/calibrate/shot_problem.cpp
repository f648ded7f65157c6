#include "percal/calibrate/shot_problem.hpp"

#include <algorithm>
#include <cmath>

#include "percal/campaign/sphere_runs.hpp"

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

std::vector<double> natural_values(const CalibrationJob& job, const Hypothesis& hypothesis,
                                   const std::vector<int>& fitted, const Eigen::VectorXd& searched) {
  std::vector<double> natural(job.parameters.size(), 0.0);
  for (const auto& [parameter, value] : hypothesis.held) natural[parameter] = value;
  for (std::size_t k = 0; k < fitted.size(); ++k)
    natural[fitted[k]] = job.parameters[fitted[k]].free.natural(searched[static_cast<Eigen::Index>(k)]);
  return natural;
}

MaterialAt material_at(const CalibrationJob& job, const Hypothesis& hypothesis, int material,
                       const std::vector<double>& natural) {
  const CalibrationMaterial& m = job.materials[material];
  MaterialAt at{.density = m.density,
                .mu_as_given = number_at(m.mu, natural),
                .mu_true = 0,
                .alpha = number_at(m.alpha, natural),
                .erosion_strain = number_at(m.erosion_strain, natural)};
  if (m.erosion_length) at.erosion_length = number_at(*m.erosion_length, natural);
  at.mu_true = true_modulus(at.mu_as_given, at.alpha, hypothesis.convention);
  return at;
}

double mesh_of(const MeasuredShot& shot, const MaterialAt& material, double elements) {
  return material.erosion_length ? elements * shot.radius / *material.erosion_length : elements;
}

Scene shot_scene(const CalibrationJob& job, const MeasuredShot& shot, const MaterialAt& material,
                 double elements_per_radius) {
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
  if (material.erosion_length) scene.target.erosion_average = AverageWithin{*material.erosion_length};
  scene.mesh.elements_per_radius = elements_per_radius;
  scene.solver = job.solver;
  return scene;
}

Problem shot_problem(const CalibrationJob& job, const MeasuredShot& shot, const MaterialAt& material,
                     double elements_per_radius) {
  return reduce(shot_scene(job, shot, material, elements_per_radius)).problem;
}

ShotInputs shot_inputs(const MeasuredShot& shot, const MaterialAt& material) {
  const double pi4 = material.density * shot.speed * shot.speed / material.mu_true;
  const auto [bulk, slope] = chosen_bulk(pi4);
  const auto in_radii = material.erosion_length ? std::optional(*material.erosion_length / shot.radius) : std::nullopt;
  ShotInputs inputs;
  inputs.at = {.log_pi4 = std::log(pi4),
               .log_pi5 = std::log(material.density / shot.density),
               .alpha = material.alpha,
               .erosion_strain = material.erosion_strain,
               .log_layer_depth = std::log(shot.layer_depth / shot.radius),
               .log_bulk_ratio = std::log(bulk),
               .log_erosion_length = log_erosion_length(in_radii)};
  Eigen::Vector<double, sphere_inputs> by_log_pi4 = Eigen::Vector<double, sphere_inputs>::Zero();
  by_log_pi4[index_of(&SphereInputs::log_pi4)] = 1;
  by_log_pi4[index_of(&SphereInputs::log_bulk_ratio)] = slope;
  enum { log_mu, alpha, erosion_strain, log_length };
  inputs.by_material.setZero();
  inputs.by_material.col(log_mu) = -by_log_pi4;
  inputs.by_material(index_of(&SphereInputs::alpha), alpha) = 1;
  inputs.by_material(index_of(&SphereInputs::erosion_strain), erosion_strain) = 1;
  if (in_radii) inputs.by_material(index_of(&SphereInputs::log_erosion_length), log_length) = 1;
  inputs.by_log_speed = 2 * by_log_pi4;
  return inputs;
}

}  // namespace percal
