// The force of a history is what slows the particle.
#pragma once
#include <gtest/gtest.h>

#include <vector>

#include "percal/impact/result.hpp"

namespace percal {

// Of a history that has every step, each force is the mean over the step that led there. The last point is left out: its velocities
// are those of its displacements, half a step on.
inline void expect_that_the_force_slows_it(std::vector<HistoryPoint> history, double mass) {
  history.pop_back();
  double impulse = 0;
  for (std::size_t k = 1; k < history.size(); ++k)
    impulse += history[k].force * (history[k].time - history[k - 1].time);
  EXPECT_NEAR(impulse, mass * (history.front().speed - history.back().speed), 1e-11 * mass);
}

}  // namespace percal
