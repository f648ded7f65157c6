// A body under pressures, and how it comes to rest under them.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "percal/impact/particle/body.hpp"

namespace percal {

inline double sum_of(const BodyEnergy& e) { return e.kinetic + e.elastic + e.hourglass + e.viscous; }

class PressedBody : public Body {
 public:
  PressedBody(const QuadMesh& mesh, Geometry geometry, const BodySolid& solid)
      : Body(mesh, geometry, solid), geometry_(geometry), pressure_force_(mesh.nodes.size()) {}

  // Pressure on a chain of boundary edges, the body on the left; it follows the surface. Returns the chain's number for
  // set_pressure.
  int press(std::vector<int> chain, double pressure) {
    chains_.push_back({std::move(chain), pressure});
    return static_cast<int>(chains_.size()) - 1;
  }
  void set_pressure(int chain, double pressure) { chains_[chain].pressure = pressure; }

  void forces() {
    Body::forces();
    find_pressure_forces();
    for (int n = 0; n < nodes(); ++n) {
      pressure_work_ += last_drift_ / 2 * power(n);  // second half of the last step's
      add_force(n, pressure_force_[n]);
    }
    last_drift_ = 0;
  }
  void step(double kick, double drift) {
    Body::step(kick, drift);
    for (int n = 0; n < nodes(); ++n) pressure_work_ += drift / 2 * power(n);
    last_drift_ = drift;
  }
  void scale_velocities(double factor) {
    for (int n = 0; n < nodes(); ++n) set_velocity(n, {factor * velocity(n)[0], factor * velocity(n)[1]});
  }

  double pressure_work() const { return pressure_work_; }  // done on the body by its pressures up to now
  // What stays constant when nothing else acts on the body.
  double balance() const { return sum_of(energy()) - pressure_work_; }
  // The free forces over the pressures and reactions that they should balance, both as root sums of squares.
  double unbalance() const {
    double free = 0, against = 0;
    for (int n = 0; n < nodes(); ++n)
      for (int d = 0; d < 2; ++d) {
        (held(n, d) ? against : free) += force(n)[d] * force(n)[d];
        if (!held(n, d)) against += pressure_force_[n][d] * pressure_force_[n][d];
      }
    return free == 0 ? 0 : std::sqrt(free / against);
  }

 private:
  struct Chain {
    std::vector<int> nodes;
    double pressure;
  };

  double power(int n) const { return pressure_force_[n][0] * velocity(n)[0] + pressure_force_[n][1] * velocity(n)[1]; }
  // -p int N_a n w dl along each edge, n outwards: the body is on the left of the chain.
  void find_pressure_forces() {
    std::fill(pressure_force_.begin(), pressure_force_.end(), Point{});
    for (const auto& chain : chains_)
      for (std::size_t k = 0; k + 1 < chain.nodes.size(); ++k) {
        const int ends[2] = {chain.nodes[k], chain.nodes[k + 1]};
        const Point from = position(ends[0]), to = position(ends[1]);
        for (int end = 0; end < 2; ++end) {
          const double weight =
              geometry_ == Geometry::plane_strain ? 0.5 : (from[0] + to[0] + (end == 0 ? from[0] : to[0])) / 6;
          pressure_force_[ends[end]][0] -= chain.pressure * weight * (to[1] - from[1]);
          pressure_force_[ends[end]][1] += chain.pressure * weight * (to[0] - from[0]);
        }
      }
  }

  Geometry geometry_;
  std::vector<Chain> chains_;
  std::vector<Point> pressure_force_;
  double last_drift_ = 0, pressure_work_ = 0;
};

struct Settling {
  bool settled;  // false: too many steps, or the body turned inside out
  long steps;
  double unbalance;
};

// omega^2 of the motion v: what its forces changed by in the last step over what they would have to move, Rayleigh's
// quotient.
inline double square_frequency(const Body& body, const std::vector<Point>& old_force, double dt) {
  double stiffness = 0, mass = 0;
  for (int n = 0; n < body.nodes(); ++n)
    for (int d = 0; d < 2; ++d)
      if (!body.held(n, d)) {
        const double v = body.velocity(n)[d];
        stiffness += v * (old_force[n][d] - body.force(n)[d]) / dt;
        mass += body.mass(n) * v * v;
      }
  return mass > 0 ? std::max(stiffness / mass, 0.0) : 0;
}

// Moves the free nodes to where the forces on them balance to `unbalance`, and leaves them at rest. Needs pressures or
// held nodes that have been moved. Damping follows the motion: critical for the frequency that the motion itself shows
// (Underwood, in Computational Methods for Transient Analysis, North-Holland 1983).
inline Settling settle(PressedBody& body, double unbalance) {
  constexpr double step_factor = 0.9;  // of the stable step
  constexpr long most_steps = 200000;
  body.scale_velocities(0);
  body.forces();
  double dt = step_factor * body.stable_step(), omega = 0;
  std::vector<Point> old_force(body.nodes());
  Settling end{false, 0, body.unbalance()};
  for (; end.steps < most_steps; ++end.steps) {
    end.unbalance = body.unbalance();
    if (end.unbalance < unbalance) end.settled = true;
    if (end.settled || !std::isfinite(end.unbalance)) break;
    if (end.steps % 20 == 0) {
      if (!(body.smallest_jacobian() > 0)) break;
      dt = step_factor * body.stable_step();
    }
    for (int n = 0; n < body.nodes(); ++n) old_force[n] = body.force(n);
    // m (v_new - v)/dt + 2 omega m (v_new + v)/2 = f
    body.scale_velocities((1 - omega * dt) / (1 + omega * dt));
    body.step(dt / (1 + omega * dt), dt);
    body.forces();
    omega = std::min(std::sqrt(square_frequency(body, old_force, dt)), 1 / dt);
  }
  body.scale_velocities(0);
  return end;
}

}  // namespace percal
