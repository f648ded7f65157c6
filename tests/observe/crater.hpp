// An impact that is over soon, for tests of what is drawn and written of it.
#pragma once
#include "impact/setting_s.hpp"
#include "percal/problem/problem.hpp"

namespace percal::test {

inline const Scales scales{.radius = 2e-6, .speed = 300, .target_density = 1100};

// Ten radii of travel into a layer of two.
inline Problem crater() {
  Problem p = setting_s(5);
  p.end_time = 5;
  return p;
}

}  // namespace percal::test
