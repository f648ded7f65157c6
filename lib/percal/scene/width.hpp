// How far away the wall must be that it does not move the depth.     docs/decisions/0012-mesh-and-phase.md
#pragma once
#include <string>

#include "percal/scene/scene.hpp"

namespace percal {

inline constexpr double farthest_wall = 20;  // radii: far enough for every shot

// In particle radii: 5 for slow shots, 12 for fast ones, farthest_wall for those that are heavy as well. pi4: rho_t v^2/mu of the layer with
// the largest; density_ratio: particle over target.     docs/theory/impact.md (8c)
double usual_width(double pi4, double density_ratio);

// The same of a scene: of its layer with the largest pi4.
double usual_width_in_reaches(const Scene& scene);

// m: in what a width is counted: the particle's radius, or how far a profile reaches where that is more.
double reach_of(const Scene& scene);

// m: what usual_width() says of this scene, in reaches.
double usual_width(const Scene& scene);

// m, of the outer wall: as the scene gives it, else the usual one.
double width_of(const Scene& scene);

// What a wall at `width` radii is expected to cost where `usual` is wanted; empty where it is far enough.
std::string width_warning(double width, double usual);

}  // namespace percal
