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

Vertices standing(const PolyhedronShape& body) { return turned_about_y(body.vertices, body.orientation); }

bool needs_both_halves(const ParticleScene& particle) {
  if (const auto* body = std::get_if<PolyhedronShape>(&particle.shape))
    return body->free_rotation || !mirror_plane(standing(*body), 0);
  const auto* profile = std::get_if<ProfileShape>(&particle.shape);
  return profile && (profile->free_rotation || !is_mirror_image_of_itself(*profile));
}

bool needs_both_sides_across(const ParticleScene& particle) {
  const auto* body = std::get_if<PolyhedronShape>(&particle.shape);
  return body && !mirror_plane(body->vertices, 1);
}

namespace {

Vertices from_centre_of_mass(const PolyhedronShape& body) {
  Vertices vertices = standing(body);
  const auto centre = mass_properties(convex_polyhedron(vertices)).centre;
  for (auto& vertex : vertices)
    for (int d = 0; d < 3; ++d) vertex[d] -= centre[d];
  return vertices;
}

}  // namespace

double reach_along(const PolyhedronShape& body, int axis) {
  const auto [low, high] = extent(from_centre_of_mass(body), axis);
  return std::max(-low, high);
}

double reach_around(const PolyhedronShape& body) { return greatest_distance(from_centre_of_mass(body)); }

double reach(const ParticleScene& particle, Geometry geometry) {
  if (const auto* body = std::get_if<PolyhedronShape>(&particle.shape))
    return body->free_rotation ? reach_around(*body) : std::max(reach_along(*body, 0), reach_along(*body, 1));
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
  if (const auto* body = std::get_if<PolyhedronShape>(&scene.particle.shape); body && body->mass) {
    const Vertices vertices = standing(*body);
    const auto [low, high] = extent(vertices, 0);
    const double scale = scene.particle.radius / ((high - low) / 2);
    return *body->mass / (mass_properties(convex_polyhedron(vertices)).volume * scale * scale * scale);
  }
  const auto* profile = std::get_if<ProfileShape>(&scene.particle.shape);
  if (!profile || !profile->mass) return scene.particle.density;
  const double scale = scene.particle.radius / half_width(standing(*profile));
  const double measure = solid_body(*profile, scene.geometry).measure * scale * scale;
  return *profile->mass / (scene.geometry == Geometry::axisymmetric ? 2 * std::numbers::pi * measure * scale : measure);
}

}  // namespace percal
