#include "percal/impact/elastic_sphere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/impact/constants.hpp"
#include "percal/impact/settings.hpp"

namespace percal {
namespace {

// Per radian: int r^2/2 dz along the outline.
double volume_of_revolution(const Disc& disc) {
  double volume = 0;
  for (std::size_t k = 0; k + 1 < disc.boundary.size(); ++k) {
    const Point &from = disc.mesh.nodes[disc.boundary[k]], &to = disc.mesh.nodes[disc.boundary[k + 1]];
    volume += (to[1] - from[1]) * (from[0] * from[0] + from[0] * to[0] + to[0] * to[0]) / 6;
  }
  return volume;
}

// The polygon has the sphere's volume, so that mass and mean radius are right; its lowest point is at the origin.
Disc sphere_mesh(const Problem& problem) {
  Disc disc = half_disc(std::max(problem.elements_per_radius, fewest_particle_elements));
  const double scale = std::cbrt(2.0 / 3 / volume_of_revolution(disc));
  for (Point& node : disc.mesh.nodes) node = {scale * node[0], scale * (node[1] + 1)};
  return disc;
}

BodySolid solid_of(const Problem& problem) {
  const auto& sphere = std::get<ElasticSphere>(problem.particle);
  BodySolid solid = elastic_solid(sphere.youngs_modulus, sphere.poisson_ratio, problem.density_ratio);
  solid.linear_viscosity = problem.linear_viscosity;
  solid.quadratic_viscosity = problem.quadratic_viscosity;
  return solid;
}

}  // namespace

ElasticContact& ElasticContact::operator+=(const ElasticContact& other) {
  ContactReport::operator+=(other);
  loads.resize(std::max(loads.size(), other.loads.size()));
  for (std::size_t b = 0; b < other.loads.size(); ++b) {
    loads[b].stiffness += other.loads[b].stiffness;
    for (int d = 0; d < 2; ++d) loads[b].force[d] += other.loads[b].force[d];
  }
  return *this;
}

ElasticSphereRun::ElasticSphereRun(const Problem& problem)
    : body_(sphere_mesh(problem).mesh, Geometry::axisymmetric, solid_of(problem)),
      boundary_(sphere_mesh(problem).boundary),
      target_springs_(step_limits(problem).largest_contact_stiffness_per_mass) {
  for (int n = 0; n < body_.nodes(); ++n) {
    body_.set_velocity(n, {0, -problem.speed_factor});
    mass_ += body_.mass(n);
  }
  body_.forces();
  follow_outline();
  look_at_step();
  const StepLimits limits = step_limits(problem);
  const double steps = steps_in(limits.time_step_factor * limits.first_step / problem.rates);
  if (problem.geometry != Geometry::axisymmetric)
    failure_ = "only a sphere in an axisymmetric scene can be elastic";
  else if (!(steps <= most_particle_steps)) {
    const auto& sphere = std::get<ElasticSphere>(problem.particle);
    failure_ = fmt::format(
        "an elastic particle so stiff takes {:.0f} of its own steps for one of the target's, and at most {} are run; its strain would be "
        "about {:.1g}: a rigid one will do",
        steps, most_particle_steps, (1 + 10 * problem.mu()) / sphere.youngs_modulus);
  }
}

// Undamped springs on the nodes add to the square of the body's frequency what they have over the masses on both sides.
double ElasticSphereRun::steps_in(double time) const {
  const double inverse = std::sqrt(own_inverse_square_step_ + (target_springs_ + spring_stiffness_per_mass_) / 4);
  return std::max(1.0, std::ceil(time * inverse / particle_step_factor));
}

void ElasticSphereRun::look_at_step() {
  const double step = body_.stable_step();
  own_inverse_square_step_ = 1 / (step * step);
  if (!(body_.smallest_jacobian() > inverted_jacobian)) failure_ = "an element of the particle turned inside out";
}

void ElasticSphereRun::follow_outline() {
  std::vector<Point> points;
  for (const int node : boundary_) points.push_back(body_.position(node));
  outline_.set(std::move(points));
}

// A node inside the outline by `gap` is pushed out the shortest way, with force stiffness gap. The edge is pushed back.
Point ElasticSphereRun::meet(const Point& at, double stiffness, ElasticContact& contact) const {
  const Inside inside = outline_.inside(at);
  if (inside.ways == 0) return {};
  contact.loads.resize(boundary_.size());
  Point push{};
  for (int w = 0; w < inside.ways; ++w) {
    const WayOut& way = inside.way[w];
    OutlineLoad* const ends = &contact.loads[way.edge];
    const double shares[2] = {1 - way.share, way.share}, part = stiffness / inside.ways;
    for (int d = 0; d < 2; ++d) {
      const double f = part * inside.gap * way.normal[d];
      push[d] += f;
      for (int end = 0; end < 2; ++end) ends[end].force[d] -= shares[end] * f;
    }
    for (int end = 0; end < 2; ++end) ends[end].stiffness += shares[end] * part;
  }
  contact.force -= push[1];
  contact.spring_energy += 0.5 * stiffness * inside.gap * inside.gap;
  contact.largest_gap = std::max(contact.largest_gap, inside.gap);
  return push;
}

void ElasticSphereRun::kick(const Contact& contact, double time) {
  for (std::size_t b = 0; b < contact.loads.size(); ++b) {
    const int node = boundary_[b];
    const double mass = body_.mass(node);
    Point v = body_.velocity(node);
    for (int d = 0; d < 2; ++d)
      if (!body_.held(node, d)) v[d] += time * contact.loads[b].force[d] / mass;
    body_.set_velocity(node, v);
    spring_stiffness_per_mass_ = std::max(spring_stiffness_per_mass_, contact.loads[b].stiffness / mass);
  }
}

// The body's velocities stand at the time of its displacements before and after, but for what kick() gives.
void ElasticSphereRun::drift(double time) {
  if (time == 0) return;
  if (drifts_++ % particle_step_interval == 0) look_at_step();
  const double needed = steps_in(time);
  if (failure_.empty() && !(needed <= most_particle_steps)) failure_ = "the particle's time step collapsed";
  if (!failure_.empty()) return;
  const int steps = static_cast<int>(needed);
  const double step = time / steps;
  for (int k = 0; k < steps; ++k) {
    body_.step(k == 0 ? 0.5 * step : step, step);
    body_.forces();
  }
  body_.step(0.5 * step, 0);
  follow_outline();
}

Point ElasticSphereRun::outline_velocity(const WayOut& way) const {
  const Point &from = body_.velocity(boundary_[way.edge]), &to = body_.velocity(boundary_[way.edge + 1]);
  return {(1 - way.share) * from[0] + way.share * to[0], (1 - way.share) * from[1] + way.share * to[1]};
}

Overlap ElasticSphereRun::overlap(double x, double z) const {
  const Inside inside = outline_.inside({x, -z});
  if (inside.ways == 0) return {};
  const Point normal = inside.normal();
  return {inside.gap, normal[0], -normal[1]};
}

PointVelocity ElasticSphereRun::velocity_at(double x, double z) const {
  const Inside inside = outline_.inside({x, -z});
  if (inside.ways == 0) return {0, speed()};
  const Point v = outline_velocity(inside.way[0]);
  return {v[0], -v[1]};
}

ParticleEnergy ElasticSphereRun::energy() const {
  const BodyEnergy energy = body_.energy();
  return {energy.kinetic, energy.elastic + energy.hourglass, energy.viscous};
}

}  // namespace percal
