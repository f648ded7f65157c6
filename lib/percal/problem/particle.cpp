#include "percal/problem/particle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "percal/scene/profile.hpp"

namespace percal {
namespace {

// Digits behind the point: coordinates near zero have no 12 digits that mean anything.
double to_12_places(double x) {
  return round_to_12_digits(std::round(x * 1e12) / 1e12) + 0.0;  // never -0
}

// A symmetric polygon, its line of symmetry at x = 0, with left and right the same to the last bit.
Polygon mirrored_exactly(const Polygon& polygon) {
  const double near = mirror_tolerance * half_width(polygon);
  const std::size_t count = polygon.size();
  const auto corner = [&](std::size_t i) { return polygon[i % count]; };
  std::size_t first = 0;  // of the right side, anticlockwise
  while (!(corner(first)[0] > near && corner(first + count - 1)[0] <= near)) ++first;
  Polygon result, right;
  for (std::size_t i = first; corner(i)[0] > near; ++i) right.push_back(corner(i));
  if (const auto low = corner(first + count - 1); std::abs(low[0]) <= near) result.push_back({0, low[1]});
  result.insert(result.end(), right.begin(), right.end());
  if (const auto high = corner(first + right.size()); std::abs(high[0]) <= near) result.push_back({0, high[1]});
  for (auto mirrored = right.rbegin(); mirrored != right.rend(); ++mirrored)
    result.push_back({-(*mirrored)[0], (*mirrored)[1]});
  return result;
}

// As it stands, in half widths from the centre of mass, from its lowest corner up; numbers to 12 places.
Vertices reduced_vertices(const PolyhedronShape& shape) {
  Vertices vertices = standing(shape);
  const auto [low, high] = extent(vertices, 0);
  const auto centre = mass_properties(convex_polyhedron(vertices)).centre;
  for (auto& vertex : vertices)
    for (int d = 0; d < 3; ++d) vertex[d] = (vertex[d] - centre[d]) / ((high - low) / 2);
  for (const int axis : {0, 1})
    if (mirror_plane(vertices, axis)) vertices = exactly_mirrored(vertices, axis);
  for (auto& vertex : vertices)
    for (double& coordinate : vertex) coordinate = to_12_places(coordinate);
  std::ranges::sort(vertices, {}, [](const auto& v) { return std::array{v[2], v[0], v[1]}; });
  return vertices;
}

SolidBody body_of(const Polygon& polygon, Geometry geometry) {
  return geometry == Geometry::axisymmetric ? body_of_revolution(polygon) : prism(polygon);
}

// As it stands, in half widths from the centre of mass, beginning with its lowest corner; numbers to 12 places.
Polygon reduced_outline(const ProfileShape& profile, Geometry geometry) {
  Polygon polygon = standing(profile);
  const double scale = half_width(polygon);
  const auto centre = body_of(polygon, geometry).centre;
  const auto axis = mirror_axis(polygon);
  for (auto& [x, y] : polygon) {
    x = (x - axis.value_or(centre[0])) / scale;
    y = (y - centre[1]) / scale;
  }
  if (axis) polygon = mirrored_exactly(polygon);
  for (auto& [x, y] : polygon) {
    x = to_12_places(x);
    y = to_12_places(y);
  }
  const auto lower = [](const auto& a, const auto& b) { return std::pair(a[1], a[0]) < std::pair(b[1], b[0]); };
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end(), lower), polygon.end());
  return polygon;
}

}  // namespace

std::optional<double> stress_over_particle_stiffness(const Scene& scene) {
  const auto& particle = scene.particle;
  const auto& target = scene.target;
  if (!particle.youngs_modulus) return std::nullopt;
  const auto stress = [&](double density, double mu_as_given, double alpha) {
    return density * particle.speed * particle.speed + 10 * true_modulus(mu_as_given, alpha, target.convention);
  };
  double largest = stress(target.density, target.mu_as_given, target.alpha);
  for (const auto& layer : scene.below)
    largest = std::max(largest, stress(layer.density, layer.mu_as_given, layer.alpha));
  return largest / *particle.youngs_modulus;
}

bool is_elastic(const Scene& scene) {
  const bool sphere =
      std::holds_alternative<RoundShape>(scene.particle.shape) && scene.geometry == Geometry::axisymmetric;
  const auto ratio = stress_over_particle_stiffness(scene);
  if (!sphere || !ratio || scene.particle.elasticity == Elasticity::rigid) return false;
  return scene.particle.elasticity == Elasticity::elastic || *ratio >= rigid_below;
}

// A round particle over pi a^2 or 2 a is what its mean thickness along the way weighs; a profile's mass is per radian or per thickness, in
// a block the whole of it, as a polyhedron's.
double sectional_density(const Problem& problem, const Scales& scales) {
  const bool plane = problem.geometry == Geometry::plane_strain;
  const auto* profile = std::get_if<RigidPolygon>(&problem.particle);
  const double mean_thickness = plane ? std::numbers::pi / 2 : 4.0 / 3;  // radii
  double over_density = problem.density_ratio * mean_thickness;          // over rho_t a
  if (const auto* body = std::get_if<RigidPolyhedron>(&problem.particle))
    over_density = body->mass / shadow_area(convex_polyhedron(body->vertices));
  if (profile && problem.geometry == Geometry::block)
    over_density = profile->mass / (4 * profile->half_thickness);
  else if (profile)
    over_density = profile->mass * (plane ? 0.5 : 2);
  return over_density * scales.target_density * scales.radius;
}

double impact_parameter(const Problem& problem, const Scales& scales) {
  return problem.density_ratio * scales.target_density * scales.speed * scales.radius;
}

Particle reduced_particle(const Scene& scene, double density_ratio) {
  if (is_elastic(scene)) {
    const double stress = scene.target.density * scene.particle.speed * scene.particle.speed;
    return ElasticSphere{.youngs_modulus = round_to_12_digits(*scene.particle.youngs_modulus / stress),
                         .poisson_ratio = round_to_12_digits(scene.particle.poisson_ratio)};
  }
  if (const auto* body = std::get_if<PolyhedronShape>(&scene.particle.shape)) {
    RigidPolyhedron reduced{.vertices = reduced_vertices(*body), .free_rotation = body->free_rotation};
    reduced.mass = round_to_12_digits(density_ratio * mass_properties(convex_polyhedron(reduced.vertices)).volume);
    return reduced;
  }
  const auto* profile = std::get_if<ProfileShape>(&scene.particle.shape);
  if (!profile) return RigidSphere{};
  RigidPolygon reduced;
  reduced.vertices = reduced_outline(*profile, scene.geometry);
  const SolidBody body = body_of(reduced.vertices, scene.geometry);
  double thickness = 1;  // or a radian
  if (scene.geometry == Geometry::block) {
    reduced.half_thickness = round_to_12_digits(profile->thickness / 2 / half_width(standing(*profile)));
    thickness = 2 * reduced.half_thickness;
  }
  reduced.mass = round_to_12_digits(density_ratio * body.measure * thickness);
  reduced.inertia = round_to_12_digits(density_ratio * body.inertia * thickness);
  reduced.free_rotation = profile->free_rotation;
  return reduced;
}

}  // namespace percal
