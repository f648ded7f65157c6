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

ElasticSphereRun::ElasticSphereRun(const Problem& problem) : ElasticSphereRun(problem, sphere_mesh(problem)) {}

ElasticSphereRun::ElasticSphereRun(const Problem& problem, const Disc& disc)
    : body_(disc.mesh, Geometry::axisymmetric, solid_of(problem, disc)),
      boundary_(disc.boundary),
      outline_(bulge_of(disc)) {
  for (int n = 0; n < body_.nodes(); ++n) {
    body_.set_velocity(n, {0, -problem.speed_factor});
    mass_ += body_.mass(n);
  }
  blow_.resize(body_.nodes());
  body_.forces();
  follow_outline();
  look_at_step();
  first_inverse_step_ = std::sqrt(own_inverse_square_step_);
  const StepLimits limits = step_limits(problem);
  const double steps = steps_in(limits.time_step_factor * limits.first_step / rates_of(problem));
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

double ElasticSphereRun::steps_in(double time) const {
  return std::max(1.0, std::ceil(time * std::sqrt(own_inverse_square_step_) / particle_step_factor));
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

void ElasticSphereRun::foresee(double time) {
  ahead_ = time;
  way_ahead_ = speed() * time;
}

OutlineTouch ElasticSphereRun::on_outline(const Touch& touch) const {
  const Inside inside = outline_.inside(seen_from_here(touch.x, touch.z));
  OutlineTouch on;
  for (int w = 0; w < inside.ways; ++w)
    for (int end = 0; end < 2; ++end) {
      const Point& by = inside.way[w].by_end[end];
      on.node[on.count] = inside.way[w].edge + end;
      on.by[on.count++] = {by[0] / inside.ways, by[1] / inside.ways};
    }
  return on;
}

namespace {

constexpr int most_sweeps = 50;
constexpr double settled = 1e-9;  // of the impact speed

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }

}  // namespace

// Within the step a wave of the sphere at rest crosses as many elements as it takes steps at its limit: so much mass stands behind a
// node of the outline, at most all of it. Projected Gauss-Seidel.
double ElasticSphereRun::meet(std::vector<Touch>& touches, ContactColumns) {
  if (touches.empty()) return 0;
  const double depth = std::max(1.0, ahead_ * first_inverse_step_), whole_speed = -speed();  // upwards
  std::vector<OutlineTouch> on;
  std::vector<Point> velocity, impulse(boundary_.size(), Point{});
  std::vector<double> mass;
  for (const int node : boundary_) {
    velocity.push_back(body_.velocity(node));
    mass.push_back(std::min(mass_, depth * body_.mass(node)));
  }
  std::vector<double> compliance;
  for (Touch& touch : touches) {
    on.push_back(on_outline(touch));
    double sum = touch.steepness() / touch.mass, closing = -touch.now, ends = 0;
    for (int k = 0; k < on.back().count; ++k) {
      const int b = on.back().node[k];
      const Point& by = on.back().by[k];
      sum += dot(by, by) / mass[b];
      closing += dot(by, velocity[b]);
      ends += dot(by, {velocity[b][0], velocity[b][1] - whole_speed});
    }
    if (ahead_ > 0) {
      const double had = outline_.inside({touch.from_x, -touch.from_z}).gap / ahead_;
      const double foreseen = touch.rate + ends - (1 - overlap_taken_back) * had;
      const double believed = most_over_closing * std::max(0.0, closing) + overlap_taken_back * had;
      touch.rate = std::min(foreseen, believed);
    }
    compliance.push_back(sum);
  }
  for (int sweep = 0, moved = 1; sweep < most_sweeps && moved; ++sweep) {
    moved = 0;
    for (std::size_t t = 0; t < touches.size(); ++t) {
      double rate = touches[t].rate - touches[t].steepness() * touches[t].impulse / touches[t].mass;
      for (int k = 0; k < on[t].count; ++k) {
        const int b = on[t].node[k];
        rate += dot(on[t].by[k], {impulse[b][0] / mass[b], impulse[b][1] / mass[b]});
      }
      const double more = std::max(-touches[t].impulse, rate / compliance[t]);
      touches[t].impulse += more;
      moved |= std::abs(more * compliance[t]) > settled;
      for (int k = 0; k < on[t].count; ++k)
        for (int d = 0; d < 2; ++d) impulse[on[t].node[k]][d] -= more * on[t].by[k][d];
    }
  }
  double lost = 0;
  for (const Touch& touch : touches) lost -= touch.impulse * touch.mean_velocity();
  const double before = body_.kinetic_energy();
  kick(impulse);
  return lost - (body_.kinetic_energy() - before);
}

// What moves the sphere as a whole is given to all nodes at once, as to a rigid one. What is left, which only deforms it, has
// no sum; drift() gives it out evenly, for a blow on light nodes at the outline would make them ring.
void ElasticSphereRun::kick(const std::vector<Point>& impulses) {
  double sum = 0;
  for (const Point& impulse : impulses) sum += impulse[1];
  const double whole = sum / mass_;  // change of velocity, upwards
  for (int n = 0; n < body_.nodes(); ++n) {
    body_.set_velocity(n, {body_.velocity(n)[0], body_.velocity(n)[1] + whole});
    blow_[n][1] -= whole;
  }
  for (std::size_t b = 0; b < impulses.size(); ++b)
    for (int d = 0; d < 2; ++d)
      if (!body_.held(boundary_[b], d)) blow_[boundary_[b]][d] += impulses[b][d] / body_.mass(boundary_[b]);
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
    std::vector<Point> before(body_.nodes());
    for (int n = 0; n < body_.nodes(); ++n) before[n] = body_.velocity(n);
    const auto count_work = [&] {
      for (int n = 0; n < body_.nodes(); ++n)
        rest_work_ += body_.mass(n) / steps / 2 *
                      dot(blow_[n], {before[n][0] + body_.velocity(n)[0], before[n][1] + body_.velocity(n)[1]});
    };
    give_out(1.0 / steps);
    if (k == 0) count_work();
    if (step > 0) body_.step(k == 0 ? 0.5 * step : step, step);
    if (k > 0) count_work();
    if (step > 0) body_.forces();
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
  const Inside inside = outline_.inside(seen_from_here(x, z));
  if (inside.ways == 0) return {};
  const Point away = inside.away();
  return {inside.gap, away[0], -away[1]};
}

PointVelocity ElasticSphereRun::velocity_at(double x, double z) const {
  const Inside inside = outline_.inside(seen_from_here(x, z));
  if (inside.ways == 0) return {0, speed()};
  const Point v = outline_velocity(inside.way[0]);
  return {v[0], -v[1]};
}

ParticleEnergy ElasticSphereRun::energy() const {
  const BodyEnergy energy = body_.energy();
  return {energy.kinetic, energy.elastic + energy.hourglass, energy.viscous, -rest_work_};
}

}  // namespace percal
