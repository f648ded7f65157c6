#include "percal/scene/profile.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace percal
