// Whole runs in three dimensions: against the axisymmetric solver, momentum, energy, symmetry, threads.
#include "percal/impact/march/march.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "percal/scene/scene_toml.hpp"
#include "percal/solid/march/march.hpp"
#include "solid/solid_problems.hpp"

namespace percal {
namespace {

// The square box of the cylinder's area. Measured: 4 % at four elements, 2 % at eight, 1 % at twelve (docs/verification/three_dimensions.md).
TEST(SolidMarch, ADentIsAsDeepAsTheAxisymmetricOne) {
  Problem round = block_dent(8);
  round.geometry = Geometry::axisymmetric;
  round.hourglass = 0.5;
  round.graded_columns = 8;
  Problem block = block_dent(8);
  block.width = 0.5 * std::sqrt(std::numbers::pi) * round.width;
  const ImpactResult expected = run_impact(round), found = run_solid(block);
  ASSERT_EQ(found.outcome, Outcome::stopped);
  EXPECT_NEAR(found.depth, expected.depth, 0.04 * expected.depth);
  EXPECT_LT(std::abs(found.energy.closure()), 1e-3);
  EXPECT_LT(found.energy.hourglass, 0.03);
}

// Phases of a coarse mesh move the depth by several per cent; their mean does not.
TEST(SlowSolidMarch, AnErodingSphereGoesAsDeepAsTheAxisymmetricOneWithinAFewPerCent) {
  const auto mean_depth = [](Problem p, auto run) {
    double sum = 0;
    for (const double phase : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
      p.elements_per_radius = 8 + phase;
      p.speed_factor = 1 + 0.001 * phase;
      sum += run(p).depth / 5;
    }
    return sum;
  };
  Problem round = block_setting_s(8);
  round.geometry = Geometry::axisymmetric;
  round.hourglass = 0.5;
  round.graded_columns = 8;
  const double expected = mean_depth(round, [](const Problem& p) { return run_impact(p); });
  const double found = mean_depth(block_setting_s(8), [](const Problem& p) { return run_solid(p); });
  EXPECT_NEAR(found, expected, 0.1 * expected);
}

TEST(SolidMarch, AnErodingRunKeepsItsEnergy) {
  const ImpactResult result = run_solid(block_setting_s());
  EXPECT_EQ(result.outcome, Outcome::stopped);
  EXPECT_GT(result.eroded, 100);
  EXPECT_EQ(result.distorted, 0);
  EXPECT_LT(std::abs(result.energy.closure()), 0.01);
}

// Freed nodes fly far, and what is left of elements around them must not be heard of again: this run once ended with no energy.
TEST(SolidMarch, NodesThatFlyFarDoNoHarm) {
  Scene scene = read_scene(PERCAL_DATA "/guha2009/rhombus_block.toml");
  scene.particle.speed = 33;
  scene.target.convention = ModulusConvention::true_shear;
  scene.target.alpha = 16;
  scene.target.erosion = StrainErosion{0.5219};
  const ImpactResult result = run_solid(reduce(scene).problem);
  EXPECT_EQ(result.outcome, Outcome::stopped) << result.reason;
  EXPECT_LT(std::abs(result.energy.closure()), 0.01);
}

// So wide and deep that in this time no wave comes near wall or bottom: the fastest runs 2.8 radii.
Problem unbounded() {
  Problem p = block_dent(4);
  p.arithmetic = Arithmetic::double_precision;
  p.pi4 = 6.6474;
  p.width = 9, p.fine_width = p.block.fine_thickness = 3;
  p.depth = p.block.fine_depth = 14;
  p.end_time = 1;
  return p;
}

TEST(SolidMarch, WhatTheParticleLosesTheTargetGains) {
  Problem eroding = unbounded();
  eroding.erosion = StrainErosion{0.3};
  Problem half = eroding;
  half.whole = true;
  for (const Problem& p : {unbounded(), eroding, half})
    for (const int threads : {1, 2}) {
      const ImpactResult result = run_solid(p, threads);
      EXPECT_GT(result.target_momentum, 0.01);
      EXPECT_NEAR(result.end_speed + result.target_momentum, 1, 1e-12);
      EXPECT_EQ(result.eroded > 0, !std::holds_alternative<NoErosion>(p.erosion));
    }
}

TEST(SolidMarch, BothHalvesGoAsDeepAsAQuarter) {
  Problem half = block_setting_s();
  half.whole = true;
  const ImpactResult one = run_solid(block_setting_s()), two = run_solid(half);
  EXPECT_NEAR(two.depth, one.depth, 1e-6 * one.depth);
  EXPECT_NEAR(two.eroded, 2 * one.eroded, 0.01 * one.eroded);
  EXPECT_LT(std::abs(two.sideways), 1e-6);
}

TEST(SolidMarch, TheSameBitsForAnyNumberOfThreads) {
  Problem p = block_setting_s();
  p.whole = true;
  p.end_time = 6;
  const ImpactResult one = run_solid(p, 1);
  for (const int threads : {2, 7}) {
    const ImpactResult more = run_solid(p, threads);
    EXPECT_EQ(more.depth, one.depth);
    EXPECT_EQ(more.steps, one.steps);
    EXPECT_EQ(more.energy.sum(), one.energy.sum());
  }
}

TEST(SolidMarch, ASphereThatGrazesASoftTargetRicochets) {
  Problem p = block_dent(3);
  p.whole = true;
  p.pi4 = 2;
  p.alpha = 2;
  p.depth = p.block.fine_depth = 5;
  p.block.angle = 75 * std::numbers::pi / 180;
  p.until = RunUntil::rest;
  const ImpactResult result = run_solid(p);
  ASSERT_TRUE(result.aftermath);
  EXPECT_EQ(result.aftermath->ending, Ending::ricochets);
  EXPECT_LT(result.aftermath->speed, 0);
  EXPECT_GT(result.sideways, result.depth);
}

TEST(SolidMarch, ARunIntoASideWallIsNoResult) {
  Problem p = block_setting_s(3);
  p.whole = true;
  p.width = 2;
  p.block.angle = 70 * std::numbers::pi / 180;
  p.block.fine_depth = 0.5;
  const ImpactResult result = run_solid(p);
  EXPECT_EQ(result.outcome, Outcome::unstable);
  EXPECT_NE(result.reason.find("side wall"), std::string::npos) << result.reason;
}

// Two layers of the same solid are one.
TEST(SolidMarch, ALayerThatIsNoneChangesNothing) {
  Problem one = block_setting_s(), two = one;
  one.end_time = two.end_time = 10;
  two.depth = 5;
  two.below = {{.depth = 40,
                .density = 1,
                .mu = one.mu(),
                .alpha = one.alpha,
                .bulk_ratio = one.bulk_ratio,
                .erosion_limit = 0.7}};
  const ImpactResult whole = run_solid(one), layered = run_solid(two);
  EXPECT_NEAR(layered.depth, whole.depth, 0.01 * whole.depth);  // a step's rounding is a run of another phase
  EXPECT_LT(std::abs(layered.energy.closure()), 0.01);
  EXPECT_EQ(layered.speeds_behind.size(), 1u);
}

TEST(SolidMarch, ASofterLayerBelowLetsTheParticleGoDeeper) {
  Problem p = block_setting_s();
  p.depth = 4;
  p.below = {{.depth = 41, .density = 1, .mu = p.mu() / 3, .alpha = p.alpha, .bulk_ratio = 150, .erosion_limit = 0.7}};
  const ImpactResult soft = run_solid(p);
  p.below[0].mu = p.mu() * 3, p.below[0].bulk_ratio = 50;
  const ImpactResult stiff = run_solid(p);
  EXPECT_GT(soft.depth, 1.3 * stiff.depth);
  for (const ImpactResult& result : {soft, stiff}) EXPECT_LT(std::abs(result.energy.closure()), 0.01);
}

TEST(SolidMarch, StretchedFibresMakeADentShallower) {
  Problem p = block_dent();
  p.alpha = 2;
  const ImpactResult bare = run_solid(p);
  p.fibres = FibreFamilies{.k1 = 2, .k2 = 1, .kappa = 0, .angle = std::numbers::pi / 4};
  const ImpactResult woven = run_solid(p);
  p.stretch = 1.1;
  const ImpactResult stretched = run_solid(p);
  EXPECT_LT(woven.depth, 0.95 * bare.depth);
  EXPECT_LT(stretched.depth, woven.depth);
  for (const ImpactResult& result : {woven, stretched}) {
    EXPECT_EQ(result.outcome, Outcome::stopped);
    EXPECT_LT(std::abs(result.energy.closure()), 0.01);
  }
}

TEST(SolidMarch, ErosionByEnergyAndByStressStopsTheParticleSomewhere) {
  const double deep = run_solid(block_setting_s()).depth;
  Problem by_energy = block_setting_s(), by_stress = by_energy, several = by_energy;
  by_energy.erosion = EnergyErosion{0.5};
  by_stress.erosion = StressErosion{1.5};
  several.further_erosion = {.stress = 1.5, .energy = 0.5};
  for (const Problem& p : {by_energy, by_stress, several}) {
    const ImpactResult result = run_solid(p);
    EXPECT_EQ(result.outcome, Outcome::stopped);
    EXPECT_GT(result.eroded, 50);
    EXPECT_LT(std::abs(result.energy.closure()), 0.01);
  }
  const ImpactResult all = run_solid(several);
  EXPECT_EQ(all.eroded_by.strain + all.eroded_by.stress + all.eroded_by.energy, all.eroded - all.distorted);
  EXPECT_GT(all.depth, 0.9 * deep);  // a further limit only makes holes
}

// A dent by a prism as thick as it is wide.
Problem cube() {
  Problem p = block_dent(5);
  p.alpha = 2;
  p.particle = cube_prism(p.density_ratio);
  return p;
}

TEST(SolidMarch, APrismMakesADentToo) {
  const ImpactResult result = run_solid(cube());
  EXPECT_EQ(result.outcome, Outcome::stopped);
  EXPECT_GT(result.depth, 1);
  EXPECT_LT(std::abs(result.energy.closure()), 0.01);
}

// Of the same mass and profile; gelatin goes round its ends.
TEST(SolidMarch, AThinnerPrismGoesDeeper) {
  Problem thin = cube();
  std::get<RigidPolygon>(thin.particle).half_thickness = 0.4;
  EXPECT_GT(run_solid(thin).depth, 1.2 * run_solid(cube()).depth);
}

TEST(SolidMarch, APrismThatIsFreeToTurnAndStandsStraightGoesStraight) {
  Problem free = cube();
  free.whole = true;
  std::get<RigidPolygon>(free.particle).free_rotation = true;
  const ImpactResult held = run_solid(cube()), found = run_solid(free);
  EXPECT_NEAR(found.depth, held.depth, 1e-5 * held.depth);
  EXPECT_LT(std::abs(found.sideways), 1e-4);
  EXPECT_LT(std::abs(found.turn), 1e-4);
}

// Mirrored, it turns the other way.
TEST(SolidMarch, APrismThatStandsAslantTurns) {
  Problem p = cube();
  p.whole = true;
  auto& prism = std::get<RigidPolygon>(p.particle);
  prism.free_rotation = true;
  const auto tilted = [&](double angle) {
    for (auto& [x, y] : prism.vertices) {
      const double at = std::atan2(y, x) + angle, far = std::hypot(x, y);
      x = far * std::cos(at);
      y = far * std::sin(at);
    }
    return run_solid(p);
  };
  const double tilt = 10 * std::numbers::pi / 180;
  const ImpactResult right = tilted(tilt), left = tilted(-2 * tilt);
  EXPECT_GT(std::abs(right.turn), 0.02);
  EXPECT_NEAR(left.turn, -right.turn, 1e-3);
  EXPECT_NEAR(left.depth, right.depth, 1e-4 * right.depth);
}

// From 30 degrees the path goes on about as it began.
TEST(SolidMarch, ASphereThatComesAslantGoesAslant) {
  Problem p = block_setting_s();
  p.whole = true;
  p.depth = 12, p.block.fine_depth = 12;
  p.end_time = 4;
  p.block.angle = std::numbers::pi / 6;
  const ImpactResult result = run_solid(p);
  const double path = std::atan2(result.sideways, result.depth) * 180 / std::numbers::pi;
  EXPECT_NEAR(path, 30, 3);
  EXPECT_LT(std::abs(result.energy.closure()), 0.01);
}

}  // namespace
}  // namespace percal
