// The explicit time integration of one impact.
#pragma once
#include "percal/impact/result.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Runs one problem on the calling thread. A problem whose impact is faster than the target's waves is not run: the outcome is
// supersonic. The same problem gives the same bits at every call (for one instruction level).
ImpactResult run_impact(const Problem& problem);

}  // namespace percal
