// What a plan will cost, from a few runs on coarser meshes.     docs/formats/campaign.md, What it will cost
#pragma once
#include <vector>

#include "percal/campaign/campaign.hpp"

namespace percal {

struct CostEstimate {
  long runs = 0, stored = 0;  // of the plan, and of these in the store
  double element_steps = 0;   // of those that are not
  double cpu_seconds = 0, longest_seconds = 0;
  double wall_seconds = 0;  // on `threads`
  int threads = 1;
  int side_by_side = 1;  // at most, as many as fit into memory
  double bytes = 0;      // of the process at its largest
  int measured_runs = 0;
  double measured_cpu_seconds = 0;
};

// Of the problems of each point that are not in the store, out of `runs`. On a coarser mesh a run takes about the same share of the
// steps and rows that its size allows for as on its own, and as long for an element and step: a run of each point, or of points spread
// evenly over their sizes, says both. These are done `threads` side by side, and not kept.
CostEstimate estimate_cost(const std::vector<std::vector<Problem>>& to_run, long runs, int threads);

}  // namespace percal
