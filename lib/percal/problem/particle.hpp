// The scene's particle without dimensions.
#pragma once
#include "percal/problem/problem.hpp"

namespace percal {

// (rho_t v^2 + 10 mu)/E from which on a particle's own elasticity counts: docs/theory/impact.md.
inline constexpr double rigid_below = 0.02;

// The largest (rho_t v^2 + 10 mu)/E over the target's layers; nullopt where the scene gives no E.
std::optional<double> stress_over_particle_stiffness(const Scene& scene);

// Whether the scene asks for an elastic particle, or leaves it to the rule and the rule says so. Only a sphere in an
// axisymmetric scene can be one.
bool is_elastic(const Scene& scene);

// Mass over the area that faces the target: m/(pi a^2), of a polyhedron over its shadow; in plane strain mass over 2 a, both of a metre's thickness. kg/m2
double sectional_density(const Problem& problem, const Scales& scales);
// rho_p v a, kg/(m s); rho_p the density, or the one that makes the given mass.
double impact_parameter(const Problem& problem, const Scales& scales);

// `density_ratio` rounded, as the problem holds it.
Particle reduced_particle(const Scene& scene, double density_ratio);

}  // namespace percal
