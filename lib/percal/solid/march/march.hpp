// Runs a problem of geometry block: explicit dynamics of a block of bricks in three dimensions under a rigid body.
#pragma once
#include "percal/impact/frame.hpp"
#include "percal/impact/result.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// As run_impact(), which leaves this geometry to it. The same problem gives the same bits for any number of threads. A frame shows the cut
// in the plane y = 0. docs/theory/solid.md.
ImpactResult run_solid(const Problem& problem, int threads = 1);
ImpactResult run_solid(const Problem& problem, FrameObserver& observer, int threads = 1);

}  // namespace percal
