// Setting S of docs/theory/impact.md: gold at 651 m/s into skin, the case that most tests start from.
#pragma once
#include "percal/problem/problem.hpp"

namespace percal {

inline Problem setting_s(int elements_per_radius = 7) {
  Problem p;
  p.pi4 = 6.6474;
  p.density_ratio = 16.8;
  p.alpha = 8.5;
  p.erosion = StrainErosion{0.7};
  p.elements_per_radius = elements_per_radius;
  p.graded_columns = (elements_per_radius + 1) / 2;
  return p;
}

// A short dent without erosion: two radii of travel into a soft solid, in double.
inline Problem dent() {
  Problem p = setting_s(6);
  p.alpha = 3;
  p.erosion = NoErosion{};
  p.depth = 20;
  p.end_time = 2;
  p.arithmetic = Arithmetic::double_precision;
  return p;
}

}  // namespace percal
