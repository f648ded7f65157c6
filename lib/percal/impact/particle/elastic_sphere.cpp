#include "percal/impact/particle/elastic_sphere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "percal/impact/settings.hpp"
#include "percal/impact/target/constants.hpp"

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

// Its lowest point is at the origin.
Disc sphere_mesh(const Problem& problem) {
  Disc disc = half_disc(elements_on_particle_radius(problem));
  for (Point& node : disc.mesh.nodes) node[1] += 1;
  return disc;
}

// So that the outline is the circle that its points lie on.
double bulge_of(const Disc& disc) {
  const double edges = static_cast<double>(disc.boundary.size()) - 1;
  return std::tan(std::numbers::pi / edges / 4) / 2;
}

// Denser than the sphere by what the polygon lacks of its volume.
BodySolid solid_of(const Problem& problem, const Disc& disc) {
  const auto& sphere = std::get<ElasticSphere>(problem.particle);
  BodySolid solid = elastic_solid(sphere.youngs_modulus, sphere.poisson_ratio,
                                  problem.density_ratio * 2 / 3 / volume_of_revolution(disc));
  solid.linear_viscosity = problem.linear_viscosity;
  solid.quadratic_viscosity = problem.quadratic_viscosity;
  return solid;
}

}  // namespace

int elements_on_particle_radius(const Problem& problem) {
  return std::max(static_cast<int>(std::lround(problem.elements_per_radius)), fewest_particle_elements);
}

ElasticContact& ElasticContact::operator+=(const ElasticContact& other) {
  ContactReport::operator+=(other);
  loads.resize(std::max(loads.size(), other.loads.size()));
  for (std::size_t b = 0; b < other.loads.size(); ++b) {
    loads[b].stiffness += other.loads[b].stiffness;
    for (int d = 0; d < 2; ++d) loads[b].force[d] += other.loads[b].force[d];
  }
  return *this;
}

ElasticSphereRun::ElasticSphereRun(const Problem& problem) : ElasticSphereRun(problem, sphere_mesh(problem)) {}

ElasticSphereRun::ElasticSphereRun(const Problem& problem, const Disc& disc)
    : body_(disc.mesh, Geometry::axisymmetric, solid_of(problem, disc)),
      boundary_(disc.boundary),
      outline_(bulge_of(disc)),
      target_springs_(step_limits(problem).largest_contact_stiffness_per_mass) {
  for (int n = 0; n < body_.nodes(); ++n) {
    body_.set_velocity(n, {0, -problem.speed_factor});
    mass_ += body_.mass(n);
  }
  blow_.resize(body_.nodes());
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
        "an elastic particle so stiff takes {:.0f} of its own steps for one of the target's, and at most {} are run; "
        "its strain would be about {:.1g}: a rigid one will do",
        steps, most_particle_steps, (1 + 10 * problem.mu()) / sphere.youngs_modulus);
  }
}

// Undamped springs on the nodes add to the square of the body's frequency what they have over the masses on both sides.
double ElasticSphereRun::steps_in(double time) const {
  const double inverse = std::sqrt(own_inverse_square_step_ + (target_springs_ + spring_stiffness_per_mass_) / 4);
  return std::max(1.0, std::ceil(time * inverse / particle_step_factor));
}

void ElasticSphereRun::look_at_step() {
  const double before = own_inverse_square_step_, step = body_.stable_step();
  own_inverse_square_step_ = 1 / (step * step);
  const bool is_steady = std::abs(own_inverse_square_step_ - before) < particle_step_change * before;
  moves_to_look_ = (is_steady ? particle_step_interval : 1) - 1;
  if (!std::isfinite(speed())) failure_ = "the particle's speed is not finite";
  if (!(body_.smallest_jacobian() > inverted_jacobian)) failure_ = "an element of the particle turned inside out";
}

void ElasticSphereRun::follow_outline() {
  std::vector<Point> points;
  for (const int node : boundary_) points.push_back(body_.position(node));
  outline_.set(std::move(points));
}

// A node inside the outline by `gap` is pushed out with force stiffness gap along the gap's gradient; the edge is pushed back.
Point ElasticSphereRun::meet(const Point& at, double stiffness, ElasticContact& contact) const {
  const Inside inside = outline_.inside(at);
  if (inside.ways == 0) return {};
  contact.loads.resize(boundary_.size());
  Point push{};
  for (int w = 0; w < inside.ways; ++w) {
    const WayOut& way = inside.way[w];
    const double part = stiffness / inside.ways, f = part * inside.gap;
    for (int d = 0; d < 2; ++d) push[d] += f * way.away[d];
    for (int end = 0; end < 2; ++end) {
      OutlineLoad& load = contact.loads[way.edge + end];
      for (int d = 0; d < 2; ++d) load.force[d] -= f * way.by_end[end][d];
      load.stiffness += part * (end == 0 ? 1 - way.share : way.share);
    }
  }
  contact.force -= push[1];
  contact.spring_energy += 0.5 * stiffness * inside.gap * inside.gap;
  contact.largest_gap = std::max(contact.largest_gap, inside.gap);
  return push;
}

// What moves the sphere as a whole is given to all nodes at once, as to a rigid one. What is left, which only deforms it, has
// no sum; drift() gives it out evenly, for a blow on light nodes at the outline would make them ring.
void ElasticSphereRun::kick(const Contact& contact, double time) {
  if (contact.loads.empty()) return;
  const double whole = time * contact.force / mass_;  // change of velocity, upwards
  for (int n = 0; n < body_.nodes(); ++n) {
    body_.set_velocity(n, {body_.velocity(n)[0], body_.velocity(n)[1] + whole});
    blow_[n][1] -= whole;
  }
  for (std::size_t b = 0; b < contact.loads.size(); ++b) {
    const int node = boundary_[b];
    const double mass = body_.mass(node);
    for (int d = 0; d < 2; ++d)
      if (!body_.held(node, d)) blow_[node][d] += time * contact.loads[b].force[d] / mass;
    spring_stiffness_per_mass_ =
        std::max(spring_stiffness_per_mass_, particle_spring_margin * contact.loads[b].stiffness / mass);
  }
}

void ElasticSphereRun::give_out(double share) {
  for (int n = 0; n < body_.nodes(); ++n) {
    const Point& v = body_.velocity(n);
    body_.set_velocity(n, {v[0] + share * blow_[n][0], v[1] + share * blow_[n][1]});
  }
}

// The body's velocities stand at the time of its displacements before and after, but for what kick() gives.
void ElasticSphereRun::drift(double time) {
  if (time > 0 && --moves_to_look_ < 0) look_at_step();
  const double needed = steps_in(time);
  if (failure_.empty() && !(needed <= most_particle_steps)) failure_ = "the particle's time step collapsed";
  if (!failure_.empty()) return;
  const int steps = static_cast<int>(needed);
  const double step = time / steps;
  for (int k = 0; k < steps; ++k) {
    give_out(1.0 / steps);
    if (step == 0) continue;
    body_.step(k == 0 ? 0.5 * step : step, step);
    body_.forces();
  }
  std::fill(blow_.begin(), blow_.end(), Point{});
  if (step == 0) return;
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
  const Point away = inside.away();
  return {inside.gap, away[0], -away[1]};
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
