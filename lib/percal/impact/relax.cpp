#include "percal/impact/relax.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace percal {
namespace {

// omega^2 of the motion v: what its forces changed by in the last step over what they would have to move, Rayleigh's quotient.
double square_frequency(const Body& body, const std::vector<Point>& old_force, double dt) {
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

}  // namespace

Settling relax(Body& body, const RelaxOptions& options) {
  body.scale_velocities(0);
  body.forces();
  double dt = options.step_factor * body.stable_step(), omega = 0;
  std::vector<Point> old_force(body.nodes());
  Settling end{false, 0, body.unbalance()};
  for (; end.steps < options.most_steps; ++end.steps) {
    end.unbalance = body.unbalance();
    if (end.unbalance < options.unbalance) end.settled = true;
    if (end.settled || !std::isfinite(end.unbalance)) break;
    if (end.steps % 20 == 0) {
      if (!(body.smallest_jacobian() > 0)) break;
      dt = options.step_factor * body.stable_step();
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
