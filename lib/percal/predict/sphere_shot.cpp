#include "percal/predict/sphere_shot.hpp"

#include <fmt/format.h>

#include <cmath>

#include "percal/campaign/sphere_runs.hpp"
#include "percal/scene/block_toml.hpp"
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

// What a shot meets of a material: ln mu_true, alpha, erosion strain. By the material's numbers as ShotInputs has them.
enum { met_log_mu, met_alpha, met_strain, met_numbers };
enum { by_log_mu, by_alpha, by_strain, by_log_length, by_rate_exponent, by_size_exponent, by_strain_below };
using ByMet = Eigen::Matrix<double, sphere_inputs, met_numbers>;

Eigen::Matrix<double, met_numbers, 7> met_by_material(const LayerMaterial& of_reference, const SphereShot& shot) {
  const MaterialLaws& laws = of_reference.laws;
  Eigen::Matrix<double, met_numbers, 7> slopes = Eigen::Matrix<double, met_numbers, 7>::Zero();
  slopes(met_log_mu, by_log_mu) = 1;
  slopes(met_log_mu, by_rate_exponent) = std::log(shot.speed / shot.radius / laws.reference_rate);
  slopes(met_alpha, by_alpha) = 1;
  slopes(met_strain, is_below_cell(laws, shot.radius) ? by_strain_below : by_strain) = size_factor(laws, shot.radius);
  slopes(met_strain, by_size_exponent) =
      at_shot(of_reference, shot).erosion_strain * std::log(shot.radius / laws.reference_radius);
  return slopes;
}

// d ln(modulus met)/d ln v: by a power of the rate, or by how fast it relaxes at a/v.
double rate_slope(const MaterialLaws& laws, const SphereShot& shot) {
  if (laws.relaxation.terms.empty()) return laws.rate_exponent;
  return -share_slopes(laws.relaxation, shot.radius / shot.speed).by_log_elapsed;
}

// As ShotInputs has them.                                                                             (3d)
Eigen::RowVectorXd relaxation_slopes(const MaterialLaws& laws, const SphereShot& shot) {
  if (laws.relaxation.terms.empty()) return {};
  return share_slopes(laws.relaxation, shot.radius / shot.speed).by_parameter;
}

// The scene's layer goes below its covers, what they leave of its depth.
void lay_covers_on(Scene& scene, const SphereShot& shot, const std::vector<Cover>& covers) {
  scene.below.clear();
  for (std::size_t k = 0; k < covers.size(); ++k) {
    const LayerMaterial material = at_shot(covers[k].material, shot);
    LayerScene& top = scene.target;
    scene.below.insert(scene.below.begin(), {.name = top.name,
                                             .density = top.density,
                                             .mu_as_given = top.mu_as_given,
                                             .alpha = top.alpha,
                                             .depth = k == 0 ? 0 : covers[k - 1].thickness,  // the layer's own: below
                                             .erosion_limit = std::get<StrainErosion>(top.erosion).limit});
    top.name = covers.size() == 1 ? "cover" : fmt::format("cover {}", k + 1);
    top.density = material.density;
    top.mu_as_given = material.mu_true;
    top.alpha = material.alpha;
    top.erosion = StrainErosion{material.erosion_strain, StrainMeasure::engineering};
  }
  if (covers.empty()) return;
  double on_top = 0;
  for (const Cover& cover : covers) on_top += cover.thickness;
  scene.below.back().depth = shot.layer_depth - on_top;
  scene.target.depth = covers.back().thickness;
}

// The body's outline as large as the shot's radius says.
ParticleShape scaled(ParticleShape shape, double factor) {
  const auto scale = [factor](auto& vertices) {
    for (auto& vertex : vertices)
      for (double& coordinate : vertex) coordinate *= factor;
  };
  if (auto* prism = std::get_if<ProfileShape>(&shape)) {
    scale(prism->vertices);
    prism->thickness *= factor;
  }
  if (auto* body = std::get_if<PolyhedronShape>(&shape)) scale(body->vertices);
  return shape;
}

// Of its own mesh the scene keeps how fine it is.
void take_body(Scene& scene, const SphereShot& shot) {
  const Scene& body = shot.body->scene;
  scene.geometry = body.geometry;
  scene.particle = body.particle;
  scene.particle.shape = scaled(scene.particle.shape, shot.radius / body.particle.radius);
  const double elements = scene.mesh.elements_per_radius;
  scene.mesh = body.mesh;
  scene.mesh.elements_per_radius = elements;
  scene.solver = body.solver;
}

}  // namespace

std::string words_of(const SphereShot& shot) {
  if (shot.body) return shot.body->name() + " at " + format_quantity(shot.speed, dimension::speed);
  return format_quantity(2 * shot.radius, dimension::length) + " at " + format_quantity(shot.speed, dimension::speed);
}

double mesh_of(const SphereShot& shot, const LayerMaterial& material, double elements) {
  if (shot.body) return elements * usual_mesh(shot.body->scene).elements_per_radius / usual_elements_on_smaller_half;
  return material.erosion_length ? elements * shot.radius / *material.erosion_length : elements;
}

double rate_factor(const MaterialLaws& laws, double rate) {
  if (!laws.relaxation.terms.empty()) return share_left(laws.relaxation, 1 / rate);
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

Scene scene_of_shot(Scene scene, const SphereShot& shot, const CoveredMaterial& of_reference) {
  const LayerMaterial material = at_shot(of_reference, shot);
  if (shot.body) take_body(scene, shot);
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
  lay_covers_on(scene, shot, of_reference.covers);
  return scene;
}

ShotInputs shot_inputs(const SphereShot& shot, const CoveredMaterial& of_reference) {
  const LayerMaterial material = at_shot(of_reference, shot);
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
  ByMet by_layer = ByMet::Zero();
  by_layer(index_of(&SphereInputs::log_pi4), met_log_mu) = -1;
  by_layer(index_of(&SphereInputs::log_bulk_ratio), met_log_mu) = -slope;
  by_layer(index_of(&SphereInputs::alpha), met_alpha) = 1;
  by_layer(index_of(&SphereInputs::erosion_strain), met_strain) = 1;
  inputs.by_log_speed = -(2 - rate_slope(of_reference.laws, shot)) * by_layer.col(met_log_mu);
  inputs.by_material.resize(1 + of_reference.covers.size());
  inputs.log_mu_by_relaxation.push_back(relaxation_slopes(of_reference.laws, shot));
  for (std::size_t k = 0; k < of_reference.covers.size(); ++k) {
    const auto& [cover, thickness] = of_reference.covers[k];
    const LayerMaterial met = at_shot(cover, shot);
    const CoverMembers& members = cover_members[k];
    lay_on(inputs.at, members,
           {.thickness = thickness / shot.radius,
            .density = met.density / material.density,
            .mu = met.mu_true / material.mu_true,
            .alpha = met.alpha,
            .erosion_strain = met.erosion_strain});
    ByMet by_cover = ByMet::Zero();
    by_cover(index_of(members.log_mu), met_log_mu) = 1;
    by_cover(index_of(members.alpha), met_alpha) = 1;
    by_cover(index_of(members.strain), met_strain) = 1;
    by_layer(index_of(members.log_mu), met_log_mu) = -1;
    inputs.by_log_speed[index_of(members.log_mu)] = rate_slope(cover.laws, shot) - rate_slope(of_reference.laws, shot);
    inputs.by_material[k + 1] = by_cover * met_by_material(cover, shot);
    inputs.log_mu_by_relaxation.push_back(relaxation_slopes(cover.laws, shot));
  }
  inputs.by_material[0] = by_layer * met_by_material(of_reference, shot);
  if (in_radii) inputs.by_material[0](index_of(&SphereInputs::log_erosion_length), by_log_length) = 1;
  return inputs;
}

}  // namespace percal
