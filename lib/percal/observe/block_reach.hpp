// Whether the path of a particle in a block stayed among the cubes that were laid for it.     docs/theory/solid.md (1)
#pragma once
#include <string>
#include <vector>

#include "percal/observe/stored_run.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// In words, where some run left them; nothing of other geometries.
std::vector<std::string> warnings_of_reach(const Problem& problem, const std::vector<Evaluation>& runs);

}  // namespace percal
