// What a run does without, and why: said with every result.
#pragma once
#include "percal/problem/problem.hpp"

namespace percal {

// Of a scene and the problem that it became.
std::vector<LeftOut> list_what_is_left_out(const Scene& scene, const Problem& problem);

}  // namespace percal
