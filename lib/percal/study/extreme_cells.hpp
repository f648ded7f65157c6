// The fixed matrix of stiff and extreme impacts: what the solver must survive, each one short.
#pragma once
#include <string>
#include <vector>

#include "percal/scene/scene.hpp"

namespace percal {

struct ExtremeCell {
  std::string group;  // what is varied: "alpha", "erosion", ...
  std::string what;   // "alpha = -20"
  Scene scene;        // as it was built: it may be one that the scene reader refuses
};

// Around a gold sphere into skin (radius 1 um, 651 m/s, true mu 63.75 MPa, alpha 8.5, erosion strain 0.7) on 7 elements per
// radius in a layer of 40 radii, for 200 radii of time at most. Names are different from each other.
std::vector<ExtremeCell> extreme_cells();

}  // namespace percal
