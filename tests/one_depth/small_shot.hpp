// A shot on a coarse mesh, whose runs take some hundredths of a second.
#pragma once
#include "percal/one_depth/one_depth.hpp"

namespace percal::test {

inline InvertWords small_shot() {
  return {.depth = "20 mm",
          .sphere = {.diameter = "4.5 mm", .density = "2500 kg/m3"},
          .speed = "100 m/s",
          .density = "1000 kg/m3",
          .alpha = "5",
          .erosion_strain = "1",
          .layer_depth = "40 mm",
          .layer_width = "11.25 mm",
          .elements_per_radius = "4"};
}

}  // namespace percal::test
