#include "percal/scene/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percal {

Polygon standing(const ProfileShape& profile) {
  return profile.orientation == 0 ? profile.vertices : turned(profile.vertices, profile.orientation);
}

bool is_mirror_image_of_itself(const ProfileShape& profile) { return mirror_axis(standing(profile)).has_value(); }

bool is_symmetric_about_the_axis(const ProfileShape& profile) {
  const Polygon polygon = standing(profile);
  const auto axis = mirror_axis(polygon);
  return axis && std::abs(*axis) <= mirror_tolerance * half_width(polygon);
}

SolidBody solid_body(const ProfileShape& profile, Geometry geometry) {
  const Polygon polygon = standing(profile);
  return geometry == Geometry::axisymmetric ? body_of_revolution(polygon) : prism(polygon);
}

bool needs_both_halves(const ParticleScene& particle) {
  const auto* profile = std::get_if<ProfileShape>(&particle.shape);
  return profile && (profile->free_rotation || !is_mirror_image_of_itself(*profile));
}

double reach(const ParticleScene& particle, Geometry geometry) {
  const auto* profile = std::get_if<ProfileShape>(&particle.shape);
  if (!profile || !needs_both_halves(particle)) return particle.radius;
  const auto centre = solid_body(*profile, geometry).centre;
  double farthest = 0;
  for (const auto& [x, y] : standing(*profile)) {
    const double across = x - centre[0];
    farthest = std::max(farthest, profile->free_rotation ? std::hypot(across, y - centre[1]) : std::abs(across));
  }
  return farthest;
}

double particle_density(const Scene& scene) {
  const auto* profile = std::get_if<ProfileShape>(&scene.particle.shape);
  if (!profile || !profile->mass) return scene.particle.density;
  const double scale = scene.particle.radius / half_width(standing(*profile));
  const double measure = solid_body(*profile, scene.geometry).measure * scale * scale;
  return *profile->mass / (scene.geometry == Geometry::axisymmetric ? 2 * std::numbers::pi * measure * scale : measure);
}

}  // namespace percal
