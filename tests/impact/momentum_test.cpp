// What the particle loses the target gains; and the march against one without its shortcuts.
#include <gtest/gtest.h>

#include <cmath>

#include "impact/plain_march.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"

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

Problem eroding() {
  Problem p = unbounded();
  p.alpha = 8.5;
  p.erosion = StrainErosion{0.3};
  return p;
}

// The numbers added are of the order of the particle's momentum, some thousands of times.
TEST(Momentum, WhatTheParticleLosesTheTargetGains) {
  Problem plane = unbounded();
  plane.geometry = Geometry::plane_strain;
  Problem softly = eroding();
  softly.eroded_nodes = ErodedNodes::in_contact;
  for (Problem p : {unbounded(), eroding(), softly, plane})
    for (const int rates : {1, 2})
      for (const int threads : {1, 2}) {
        p.rates = rates;
        const ImpactResult result = run_impact(p, threads);
        EXPECT_GT(result.target_momentum, 0.01);
        EXPECT_NEAR(result.end_speed + result.target_momentum, 1, 1e-13)
            << rates << " rates, " << threads << " threads";
        EXPECT_EQ(result.eroded > 0, !std::holds_alternative<NoErosion>(p.erosion));
      }
}

// The rows left at rest move by less than rest_speed = 1e-6 of the impact speed.
TEST(March, RowsAtRestAndTheContactSearchLeaveNothingOutThatMatters) {
  Problem p = unbounded();
  p.rates = 1;
  p.fine_width = 1;
  p.end_time = 3;  // by then the sphere is in the block up to its top
  PlainMarch plain(p);
  plain.run();
  const ImpactResult real = run_impact(p);
  EXPECT_EQ(real.outcome, Outcome::time_up);
  EXPECT_NEAR(real.end_speed, plain.speed(), 1e-6);
  EXPECT_NEAR(real.depth, plain.tip(), 1e-6);
  EXPECT_LT(real.element_steps, 0.7 * static_cast<double>(real.elements * real.steps))
      << "a good part of the work is left out";
}

TEST(March, TakesOutTheElementsThatAPlainReadingOfTheRuleDoes) {
  Problem p = eroding();
  p.rates = 1;
  p.fine_width = 1;
  p.end_time = 2;
  PlainMarch plain(p);
  plain.run();
  const ImpactResult real = run_impact(p);
  EXPECT_GT(plain.eroded(), 20);
  EXPECT_EQ(real.eroded, plain.eroded());
  EXPECT_NEAR(real.end_speed, plain.speed(), 1e-6);
  EXPECT_NEAR(real.depth, plain.tip(), 1e-6);
}

}  // namespace
}  // namespace percal
