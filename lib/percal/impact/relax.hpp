// Static equilibrium of a Body by its own explicit march with damping.
#pragma once
#include "percal/impact/body.hpp"

namespace percal {

struct RelaxOptions {
  double unbalance = 1e-8;  // settled below it: Body::unbalance()
  long most_steps = 200000;
  double step_factor = 0.9;  // of the stable step
};

struct Settling {
  bool settled;  // false: most_steps were not enough, or the body turned inside out
  long steps;
  double unbalance;
};

// Moves the free nodes to where the forces on them balance, and leaves them at rest. Needs pressures or held nodes that have been
// moved. Damping follows the motion: critical for the frequency that the motion itself shows (Underwood, in Computational
// Methods for Transient Analysis, North-Holland 1983).
Settling relax(Body& body, const RelaxOptions& options = {});

}  // namespace percal
