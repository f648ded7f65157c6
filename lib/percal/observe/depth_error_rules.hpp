// What wall, time step and K are expected to cost in depth where nobody measured it: bounds from runs that were made once.
// docs/theory/errors.md, The error of one depth.  For the .cpp files of this folder.
#pragma once
#include <optional>
#include <string>

#include "percal/problem/problem.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// A half width as a share of the depth, which 95 of 100 depths keep; nothing where no run tells.
struct RuledShare {
  std::optional<double> share;
  std::string how;
};

RuledShare wall_share(const Scene& scene, const Problem& problem);
RuledShare time_step_share(const Problem& problem, double worst_closure);
RuledShare bulk_share(const Reduction& reduction);

// What elements of so large a share of the erosion length leave in a depth that is not extrapolated.
RuledShare bias_share(const Problem& problem, double element_over_length);

}  // namespace percal
