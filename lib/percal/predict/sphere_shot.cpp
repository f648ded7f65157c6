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

double rate_factor(const MaterialLaws& laws, double rate) {
  return laws.rate_exponent == 0 ? 1 : std::pow(rate / laws.reference_rate, laws.rate_exponent);
}

double size_factor(const MaterialLaws& laws, double radius) {
  return laws.size_exponent == 0 ? 1 : std::pow(radius / laws.reference_radius, laws.size_exponent);
}

LayerMaterial at_shot(const LayerMaterial& material, const SphereShot& shot) {
  LayerMaterial there = material;
  there.mu_true *= rate_factor(material.laws, shot.speed / shot.radius);
  if (is_below_cell(material.laws, shot.radius)) there.erosion_strain = material.laws.erosion_strain_below;
  there.erosion_strain *= size_factor(material.laws, shot.radius);
  there.laws = {};
  return there;
}

Scene scene_of_shot(Scene scene, const SphereShot& shot, const LayerMaterial& of_reference) {
  const LayerMaterial material = at_shot(of_reference, shot);
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

ShotInputs shot_inputs(const SphereShot& shot, const LayerMaterial& of_reference) {
  const LayerMaterial material = at_shot(of_reference, shot);
  const MaterialLaws& laws = of_reference.laws;
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
  enum { log_mu, alpha, erosion_strain, log_length, rate_exponent, size_exponent, strain_below };
  inputs.by_material.setZero();
  inputs.by_material.col(log_mu) = -by_log_pi4;
  inputs.by_material(index_of(&SphereInputs::alpha), alpha) = 1;
  const auto strain_met = is_below_cell(laws, shot.radius) ? strain_below : erosion_strain;
  inputs.by_material(index_of(&SphereInputs::erosion_strain), strain_met) = size_factor(laws, shot.radius);
  if (in_radii) inputs.by_material(index_of(&SphereInputs::log_erosion_length), log_length) = 1;
  inputs.by_material.col(rate_exponent) = -by_log_pi4 * std::log(shot.speed / shot.radius / laws.reference_rate);
  inputs.by_material(index_of(&SphereInputs::erosion_strain), size_exponent) =
      material.erosion_strain * std::log(shot.radius / laws.reference_radius);
  inputs.by_log_speed = (2 - laws.rate_exponent) * by_log_pi4;
  return inputs;
}

}  // namespace percal
