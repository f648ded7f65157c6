#include <gtest/gtest.h>

#include "impact/plain_march.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march.hpp"

namespace percal {
namespace {

// So wide and deep that in this time no wave comes near wall or bottom: the fastest runs 2.8 radii.
Problem unbounded() {
  Problem p = dent();
  p.elements_per_radius = 4;
  p.width = p.fine_width = 12;
  p.depth = 40;
  p.end_time = 1;
  return p;
}

TEST(Momentum, WhatTheSphereLosesTheBlockGains) {
  PlainMarch march(unbounded());
  march.run();
  const double lost = march.sphere().mass * (1 - march.sphere().speed);
  EXPECT_GT(lost, 0.1);
  EXPECT_NEAR(march.block_momentum(), lost, 1e-12 * march.sphere().mass);
}

// The rows left at rest move by less than rest_speed = 1e-6 of the impact speed.
TEST(March, RowsAtRestAndTheContactSearchLeaveNothingOutThatMatters) {
  Problem p = unbounded();
  p.fine_width = 1;
  p.end_time = 3;  // by then the sphere is in the block up to its top
  PlainMarch plain(p);
  plain.run();
  const ImpactResult real = run_impact(p);
  EXPECT_EQ(real.outcome, Outcome::time_up);
  EXPECT_NEAR(real.end_speed, plain.sphere().speed, 1e-6);
  EXPECT_NEAR(real.depth, plain.sphere().tip, 1e-6);
  EXPECT_LT(real.element_steps, 0.7 * static_cast<double>(real.elements * real.steps))
      << "a good part of the work is left out";
}

}  // namespace
}  // namespace percal
