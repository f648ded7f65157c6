#include "percal/impact/march/march.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "impact/impulse.hpp"
#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/recorder.hpp"

namespace percal {
namespace {

TEST(March, TheSameProblemGivesTheSameBits) { same_bits(run_impact(setting_s(5)), run_impact(setting_s(5))); }

TEST(March, AHistoryChangesNoBit) {
  Problem p = setting_s(5);
  const ImpactResult without = run_impact(p);
  p.history_samples = 400;
  same_bits(run_impact(p), without);
  EXPECT_TRUE(without.history.empty());
}

TEST(March, ADeeperLayerWhoseAddedRowsNoWaveReachesChangesNoBit) {
  Problem p = setting_s(5);
  p.end_time = 1;
  const ImpactResult shallow = run_impact(p);
  p.depth = 150;
  const ImpactResult deep = run_impact(p);
  EXPECT_EQ(deep.elements, 2 * shallow.elements);
  EXPECT_EQ(deep.element_steps, shallow.element_steps) << "and costs nothing";
  same_motion(deep, shallow);
}

TEST(March, ASoftThinLayerIsPassedThrough) {
  Problem p = setting_s();
  p.depth = 8;
  const ImpactResult result = run_impact(p);
  EXPECT_EQ(result.outcome, Outcome::passed_through);
  EXPECT_GE(result.depth, 8);
  EXPECT_GT(result.end_speed, 0);
  EXPECT_LT(result.end_speed, 1);
}

TEST(March, AShortEndTimeComesFirst) {
  Problem p = setting_s();
  p.end_time = 1;
  const ImpactResult result = run_impact(p);
  EXPECT_EQ(result.outcome, Outcome::time_up);
  EXPECT_NEAR(result.end_time, 1, 0.05);  // a long step is 0.045
  EXPECT_GT(result.depth, 0.9);
  EXPECT_LT(result.depth, 1.05);
}

// Beyond the stable step, with nothing that damps or erodes.
TEST(March, AnElementThatTurnsInsideOutEndsTheRunAsUnstable) {
  Problem p = dent();
  p.alpha = 2;
  p.pi4 = 30;
  p.hourglass = p.linear_viscosity = p.quadratic_viscosity = 0;
  p.time_step_factor = 1.2;
  const ImpactResult result = run_impact(p);
  EXPECT_EQ(result.outcome, Outcome::unstable);
  EXPECT_EQ(result.reason, "an element turned inside out");
}

// Without viscosity, near and beyond the stable step, the scheme makes energy out of nothing.
TEST(March, EnergyThatIsMadeIsNotPassedOffAsAResult) {
  Problem p = dent();
  p.alpha = 2;
  p.pi4 = 30;
  p.linear_viscosity = p.quadratic_viscosity = 0;
  p.end_time = 1000;
  int caught = 0;
  for (const double factor : {0.6, 0.85, 0.88, 0.9, 0.92, 0.94, 0.95, 0.96, 0.98, 1.0}) {
    p.time_step_factor = factor;
    const ImpactResult result = run_impact(p);
    caught += result.reason == "energy was not conserved";
    EXPECT_TRUE(result.outcome != Outcome::unstable || !result.reason.empty()) << factor;
    EXPECT_TRUE(result.outcome == Outcome::unstable || std::abs(result.energy.closure()) < 0.05) << factor;
  }
  EXPECT_GE(caught, 1);
}

TEST(March, AFixedBottomStopsWhatAFreeOneLetsThrough) {
  Problem p = dent();
  p.alpha = 8.5;
  p.depth = 2;
  p.time_step_factor = 0.5;
  p.end_time = 1000;
  EXPECT_EQ(run_impact(p).outcome, Outcome::passed_through);
  p.bottom = Bottom::fixed;
  EXPECT_EQ(run_impact(p).outcome, Outcome::stopped);
}

TEST(March, ABottomFarBelowChangesNoBit) {
  Problem p = dent();
  const ImpactResult free = run_impact(p);
  p.bottom = Bottom::fixed;
  same_bits(run_impact(p), free);
}

TEST(March, WithoutErosionAllElementsStay) {
  Problem p = dent();
  p.alpha = 8.5;
  p.end_time = 1000;
  const ImpactResult result = run_impact(p);
  EXPECT_EQ(result.outcome, Outcome::stopped);
  EXPECT_EQ(result.eroded, 0);
  EXPECT_EQ(result.energy.eroded, 0);
  EXPECT_EQ(result.energy.freed_mass, 0);
}

TEST(March, AnErosionStrainOutOfReachChangesNoBit) {
  Problem p = dent();
  p.rates = 1;
  const ImpactResult without = run_impact(p);
  p.erosion = StrainErosion{100};
  same_bits(run_impact(p), without);
}

// At alpha -6 elements ahead of the sphere are squeezed flat long before they are stretched a hundredfold.
TEST(March, ElementsTakenOutForTheirDistortionAreCountedApart) {
  Problem p = setting_s(5);
  p.alpha = -6;
  p.pi4 = 20;
  p.end_time = 20;
  p.erosion = StrainErosion{100};
  const ImpactResult result = run_impact(p);
  EXPECT_GT(result.distorted, 0);
  EXPECT_EQ(result.distorted, result.eroded) << "none was stretched so far";
  for (const Arithmetic arithmetic : {Arithmetic::single_precision, Arithmetic::double_precision}) {
    Problem eroding = setting_s(5);
    eroding.arithmetic = arithmetic;
    const ImpactResult by_strain = run_impact(eroding);
    EXPECT_GT(by_strain.eroded, 100);
    EXPECT_EQ(by_strain.distorted, 0);
  }
}

TEST(March, EachStrainMeasureAtTheSameStretchGivesTheSameBits) {
  Problem p = setting_s(5);
  p.erosion = StrainErosion{0.5, StrainMeasure::engineering};
  const ImpactResult engineering = run_impact(p);
  p.erosion = StrainErosion{std::log(1.5), StrainMeasure::true_strain};
  same_bits(run_impact(p), engineering);
  p.erosion = StrainErosion{(1.5 * 1.5 - 1) / 2, StrainMeasure::green_lagrange};
  same_bits(run_impact(p), engineering);
  p.erosion = StrainErosion{0.5, StrainMeasure::true_strain};
  EXPECT_NE(run_impact(p).depth, engineering.depth);
}

TEST(March, TheDepthFallsWithTheModulus) {
  Problem p = setting_s(4);
  double last = 1e9;
  for (const double stiffer : {1.0, 2.0, 4.0}) {
    p.pi4 = 6.6474 / stiffer;
    const ImpactResult result = run_impact(p);
    ASSERT_EQ(result.outcome, Outcome::stopped);
    EXPECT_LT(result.depth, 0.8 * last) << stiffer;
    last = result.depth;
  }
}

TEST(History, StartsAtTheImpactSpeedAndEndsAtTheDepth) {
  Problem p = setting_s(5);
  p.history_samples = 400;
  p.speed_factor = 1.001;
  const ImpactResult result = run_impact(p);
  ASSERT_GE(result.history.size(), 400u);
  EXPECT_LE(result.history.size(), 801u);
  EXPECT_EQ(result.history.front().time, 0);
  EXPECT_EQ(result.history.front().tip, 0);
  EXPECT_EQ(result.history.front().speed, 1.001);
  EXPECT_EQ(result.history.front().force, 0);
  EXPECT_NEAR(result.history.back().tip, result.depth, 1e-5);
  EXPECT_EQ(result.history.back().time, result.end_time);
  for (std::size_t k = 1; k < result.history.size(); ++k) EXPECT_GT(result.history[k].time, result.history[k - 1].time);
}

TEST(History, KeepsEvenlySpacedPointsHoweverLongTheRun) {
  for (const int steps : {50, 399, 1000, 123456}) {
    const long first_stride = Recorder::usual_steps / 100;
    Recorder recorder(100);
    int made = 0;
    for (int step = 0; step < steps; ++step)
      if (recorder.is_due()) {
        ++made;
        recorder.keep({.time = static_cast<double>(step), .tip = 0, .speed = 0, .force = 0});
      }
    const auto points = recorder.take();
    EXPECT_LE(made, 200 + 100 * std::max(0.0, std::log2(steps / 1600.0))) << "a point is made only to be kept";
    EXPECT_GE(points.size(), static_cast<std::size_t>(std::min(steps / first_stride, 100L)));
    EXPECT_LE(points.size(), 200u);
    const double stride = points[1].time;
    for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(points[k].time, k * stride) << steps << " steps";
    EXPECT_GT(points.back().time + stride, steps - 1);
  }
}

// The force is what slows the sphere: its mass is (2/3) rho_p/rho_t per radian.
TEST(History, TheForcesImpulseIsTheSpeedLost) {
  Problem p = dent();
  p.history_samples = 100000;
  const ImpactResult result = run_impact(p);
  EXPECT_LT(result.end_speed, 0.95);
  expect_that_the_force_slows_it(result.history, 2.0 / 3 * 16.8);
}

TEST(Outcome, HasAWordThatReadsBack) {
  for (const Outcome outcome : {Outcome::stopped, Outcome::passed_through, Outcome::time_up, Outcome::unstable})
    EXPECT_EQ(outcome_from(word(outcome)), outcome);
  EXPECT_EQ(word(Outcome::passed_through), "passed through");
  EXPECT_THROW(outcome_from("fine"), std::invalid_argument);
}

}  // namespace
}  // namespace percal
