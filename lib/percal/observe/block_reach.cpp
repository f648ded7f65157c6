#include "percal/observe/block_reach.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/problem/domain.hpp"

namespace percal {

std::vector<std::string> warnings_of_reach(const Problem& problem, const std::vector<Evaluation>& runs) {
  if (problem.geometry != Geometry::block) return {};
  const BoxGridOptions box = box_options(problem);
  double deepest = 0, right = 0, left = 0, across = 0;
  for (const Evaluation& run : runs) {
    deepest = std::max(deepest, std::min(run.result.depth, problem.whole_depth()));
    right = std::max(right, run.result.sideways);
    left = std::max(left, -run.result.sideways);
    if (run.result.in_space) across = std::max(across, std::abs(run.result.in_space->across));
  }
  std::vector<std::string> warnings;
  if (deepest > box.down.fine * (1 + 1e-9))
    warnings.push_back(
        fmt::format("the particle went {:.4g} radii deep, the cubes reach {:.4g}: below them cells are longer, and "
                    "their error is in none of "
                    "the figures; fine_depth = {:.3g} holds the path",
                    deepest, box.down.fine, 1.1 * deepest));
  if (right > box.right.fine || (problem.whole && left > box.left.fine))
    warnings.push_back(
        fmt::format("the particle went {:.4g} radii aside, beyond the cubes, which reach {:.4g} to the left and {:.4g} "
                    "to the right: "
                    "fine_width holds it",
                    std::max(left, right), box.left.fine, box.right.fine));
  if (across > box.along.fine)
    warnings.push_back(
        fmt::format("the particle went {:.4g} radii across, beyond the cubes, which reach {:.4g} to both sides: "
                    "fine_thickness holds it",
                    across, box.along.fine));
  return warnings;
}

}  // namespace percal
