// The numerical settings of a scene in words, for whoever repeats the run in another program.
#pragma once
#include <string>

#include "percal/scene/scene.hpp"

namespace percal {

// "bulk viscosity 0.06 (linear) and 0.6 (quadratic), hourglass stiffness of 0.5 mu"
std::string in_words(const SolverScene& solver);

}  // namespace percal
