#include "percal/scaling/similar_scene.hpp"

#include <cmath>

#include "percal/scaling/similar.hpp"
#include "percal/scene/erosion_size.hpp"
#include "percal/scene/width.hpp"

namespace percal {
namespace {

void scale(FurtherErosion& further, double pressure) {
  if (further.stress) *further.stress *= pressure;
  if (further.energy) *further.energy *= pressure;
}

void scale(ErosionBySize& by_size, double length) {
  if (auto* small = std::get_if<SmallerThanCell>(&by_size)) small->cell *= length;
}

void scale(Fibres& fibres, double pressure) {
  if (auto* planar = std::get_if<PlanarFibres>(&fibres)) planar->k1 *= pressure;
  if (auto* families = std::get_if<FibreFamilies>(&fibres)) families->k1 *= pressure;
}

// Profile, lower layers, erosion and times: lengths by pi1, densities by pi5, pressures by pi4, times by pi10.
void scale_the_rest(Scene& scene, const System& prototype, const System& model) {
  const auto ratio = [&](auto member) { return required(model, member) / required(prototype, member); };
  const double length = ratio(&System::radius), density = ratio(&System::target_density), pressure = ratio(&System::mu);
  if (auto* profile = std::get_if<ProfileShape>(&scene.particle.shape)) {
    for (auto& vertex : profile->vertices)
      for (double& coordinate : vertex) coordinate *= length;
    const int dimensions = scene.geometry == Geometry::plane_strain ? 2 : 3;
    if (profile->mass) *profile->mass *= ratio(&System::particle_density) * std::pow(length, dimensions);
  }
  if (auto* body = std::get_if<PolyhedronShape>(&scene.particle.shape)) {
    for (auto& vertex : body->vertices)
      for (double& coordinate : vertex) coordinate *= length;
    if (body->mass) *body->mass *= ratio(&System::particle_density) * std::pow(length, 3);
  }
  for (LowerLayerScene& layer : scene.below) {
    layer.density *= density;
    layer.mu_as_given *= pressure;
    layer.depth *= length;
    if (layer.erosion_limit && !std::holds_alternative<StrainErosion>(scene.target.erosion))
      *layer.erosion_limit *= pressure;
    scale(layer.further_erosion, pressure);
    scale(layer.erosion_by_size, length);
    scale(layer.fibres, pressure);
  }
  scale(scene.target.further_erosion, pressure);
  scale(scene.target.erosion_by_size, length);
  scale(scene.target.fibres, pressure);
  if (auto* stress = std::get_if<StressErosion>(&scene.target.erosion)) stress->limit *= pressure;
  if (auto* energy = std::get_if<EnergyErosion>(&scene.target.erosion)) energy->limit *= pressure;
  if (auto* average = std::get_if<AverageWithin>(&scene.target.erosion_average)) average->length *= length;
  if (auto* series = std::get_if<PronySeries>(&scene.target.relaxation))
    for (PronyTerm& term : series->terms) term.time = map_time(term.time, prototype, model);
  if (scene.solver.end_time) scene.solver.end_time = map_time(*scene.solver.end_time, prototype, model);
}

}  // namespace

SystemInput system_of(const Scene& scene) {
  SystemInput input;
  const auto& layer = scene.target;
  input.convention = layer.convention;
  auto& system = input.system;
  system.particle = scene.particle.name;
  system.target = layer.name;
  system.radius = scene.particle.radius;
  system.particle_density = scene.particle.density;
  system.particle_modulus = scene.particle.youngs_modulus;
  system.speed = scene.particle.speed;
  system.target_density = layer.density;
  system.mu = true_modulus(layer.mu_as_given, layer.alpha, layer.convention);
  system.alpha = layer.alpha;
  system.depth = layer.depth;
  system.width = width_of(scene);
  const Erosion in_force = erosion_in_force(scene);
  if (const auto* erosion = std::get_if<StrainErosion>(&in_force)) {
    input.measure = erosion->measure;
    system.erosion_strain = erosion->limit;
    if (erosion->measure != StrainMeasure::engineering)
      system.erosion_strain = strain_at(stretch_at(erosion->limit, erosion->measure), StrainMeasure::engineering);
  }
  return input;
}

Scene similar_scene(const Scene& prototype_scene, const System& prototype, const System& model) {
  Scene scene = prototype_scene;
  scene.particle.name = model.particle;
  scene.particle.radius = required(model, &System::radius);
  scene.particle.density = required(model, &System::particle_density);
  scene.particle.speed = required(model, &System::speed);
  scene.particle.youngs_modulus = model.particle_modulus;
  scene.target.name = model.target;
  scene.target.density = required(model, &System::target_density);
  scene.target.mu_as_given =
      modulus_as_given(required(model, &System::mu), scene.target.alpha, scene.target.convention);
  scene.target.depth = required(model, &System::depth);
  if (scene.target.width) scene.target.width = required(model, &System::width);  // else the same rule finds it
  scale_the_rest(scene, prototype, model);
  return scene;
}

}  // namespace percal
