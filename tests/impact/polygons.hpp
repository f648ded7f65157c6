// Rigid profiles that tests shoot, their half width 1.
#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "percal/problem/problem.hpp"

namespace percal {

using Corners = std::vector<std::array<double, 2>>;

// Anticlockwise, x to the right and y upwards from the centre of mass.
inline RigidPolygon prism_of(const Corners& corners, double density_ratio) {
  RigidPolygon profile{.vertices = corners};
  double area = 0, inertia = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [x0, y0] = corners[k];
    const auto& [x1, y1] = corners[(k + 1) % corners.size()];
    const double cross = x0 * y1 - x1 * y0;
    area += cross / 2;
    inertia += cross * (x0 * x0 + x0 * x1 + x1 * x1 + y0 * y0 + y0 * y1 + y1 * y1) / 12;
  }
  profile.mass = density_ratio * area;
  profile.inertia = density_ratio * inertia;
  return profile;
}

// Two corners opposite each other and their mirror images through the centre.
inline Corners parallelogram(std::array<double, 2> right, std::array<double, 2> top) {
  return {right, top, {-right[0], -right[1]}, {-top[0], -top[1]}};
}
inline Corners square_on_its_corner() { return parallelogram({1, 0}, {0, 1}); }
inline Corners square_on_its_side() { return {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}; }

inline Corners turned(const Corners& corners, double angle) {
  Corners result;
  for (const auto& [x, y] : corners)
    result.push_back({std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y});
  return result;
}

inline RigidPolygon mirror_image(RigidPolygon profile) {
  Corners corners(profile.vertices.rbegin(), profile.vertices.rend());
  for (auto& [x, y] : corners) x = -x;
  profile.vertices = corners;
  return profile;
}

// Setting S in plane strain, both halves, shot at with a prism of half the sphere's density.
inline Problem prism_impact(const Corners& corners, int elements_per_radius = 5) {
  Problem p;
  p.pi4 = 6.6474;
  p.density_ratio = 8.4;
  p.alpha = 8.5;
  p.erosion = StrainErosion{0.7};
  p.elements_per_radius = elements_per_radius;
  p.graded_columns = 3;
  p.depth = 20;
  p.geometry = Geometry::plane_strain;
  p.whole = true;
  p.particle = prism_of(corners, p.density_ratio);
  return p;
}

}  // namespace percal
