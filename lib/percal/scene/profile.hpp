// What follows from a profile or a polyhedron as a scene holds it: how it stands, whether half of it is enough, and the solid that it is.
#pragma once
#include "percal/math/polygon.hpp"
#include "percal/math/polyhedron.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// The polygon turned by its orientation, where the file put it.
Polygon standing(const ProfileShape& profile);
Vertices standing(const PolyhedronShape& body);

// As it stands, its own mirror image in a vertical line; in the axis x = 0.
bool is_mirror_image_of_itself(const ProfileShape& profile);
bool is_symmetric_about_the_axis(const ProfileShape& profile);

// Area, or volume per radian, centre of mass and inertia of the solid as it stands.
SolidBody solid_body(const ProfileShape& profile, Geometry geometry);

// Plane strain and block: whether x < 0 must be meshed too, since the particle is not symmetric or may turn.
bool needs_both_halves(const ParticleScene& particle);
// Block: whether y < 0 must be.
bool needs_both_sides_across(const ParticleScene& particle);

// How far a polyhedron reaches from its centre of mass: along an axis as it stands; in all directions.
double reach_along(const PolyhedronShape& body, int axis);
double reach_around(const PolyhedronShape& body);

// The largest horizontal distance of a point of the particle from the line on which its centre of mass comes down; where it
// may turn, in any position.
double reach(const ParticleScene& particle, Geometry geometry);

// kg/m3; of a profile with a mass: what makes that mass.
double particle_density(const Scene& scene);

}  // namespace percal
