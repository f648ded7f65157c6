#include "percal/predict/sphere_shot.hpp"

#include <cmath>

#include "percal/campaign/sphere_runs.hpp"
#include "percal/units/quantity.hpp"

namespace percal {
namespace {

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

std::string words_of(const SphereShot& shot) {
  return format_quantity(2 * shot.radius, dimension::length) + " at " + format_quantity(shot.speed, dimension::speed);
}

double mesh_of(const SphereShot& shot, const LayerMaterial& material, double elements) {
  return material.erosion_length ? elements * shot.radius / *material.erosion_length : elements;
}

Scene scene_of_shot(Scene scene, const SphereShot& shot, const LayerMaterial& material) {
  scene.particle.radius = shot.radius;
  scene.particle.density = shot.density;
  scene.particle.speed = shot.speed;
  scene.particle.elasticity = Elasticity::rigid;
  scene.target = {.name = scene.target.name,
                  .density = material.density,
                  .mu_as_given = material.mu_true,
                  .alpha = material.alpha,
                  .volumetric = ChooseBulk{},
                  .depth = shot.layer_depth,
                  .width = shot.layer_width,
                  .erosion = StrainErosion{material.erosion_strain, StrainMeasure::engineering}};
  if (material.erosion_length) scene.target.erosion_average = AverageWithin{*material.erosion_length};
  return scene;
}

ShotInputs shot_inputs(const SphereShot& shot, const LayerMaterial& material) {
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
