// The explicit time integration of one impact.
#pragma once
#include "percal/impact/frame.hpp"
#include "percal/impact/result.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Runs one problem on `threads` threads, the calling one among them. The same problem gives the same bits at every call and with
// any number of threads (for one instruction level), whoever looks on. docs/theory/impact.md.
ImpactResult run_impact(const Problem& problem, int threads = 1);
ImpactResult run_impact(const Problem& problem, FrameObserver& observer, int threads = 1);

}  // namespace percal
