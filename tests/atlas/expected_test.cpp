// What the atlas expects of an impact before it is run.
#include "percal/atlas/expected.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "percal/campaign/sphere_runs.hpp"

namespace percal {
namespace {

// 2 um gold into skin, whose wall the program puts at 5 radii.
Scene gold_into_skin() {
  Scene scene;
  scene.particle.radius = 1e-6;
  scene.particle.density = 16800;
  scene.particle.speed = 651;
  scene.target.density = 1000;
  scene.target.mu_as_given = 63.75e6;
  scene.target.alpha = 8.5;
  scene.target.volumetric = BulkToShear{50};
  scene.target.depth = 75e-6;
  scene.target.erosion = StrainErosion{0.7};
  return scene;
}
Problem problem_of(const Scene& scene) { return reduce(scene).problem; }

TEST(AtlasAbout, IsTheOneOfTheSettingWhereverAFarEnoughWallIs) {
  Scene scene = gold_into_skin();
  const Atlas* atlas = atlas_about(problem_of(scene));
  ASSERT_TRUE(atlas);
  scene.target.width = 8e-6;
  EXPECT_EQ(atlas_about(problem_of(scene)), atlas);
  scene.target.width = 4.9e-6;
  EXPECT_FALSE(atlas_about(problem_of(scene))) << "a wall that is felt";
}

TEST(AtlasAbout, IsNoneForAnotherSetting) {
  Scene scene = gold_into_skin();
  scene.solver.arithmetic = Arithmetic::double_precision;
  EXPECT_FALSE(atlas_about(problem_of(scene)));
  scene = gold_into_skin();
  scene.target.bottom = Bottom::fixed;
  EXPECT_FALSE(atlas_about(problem_of(scene)));
  Problem covered = problem_of(gold_into_skin());
  covered.below.push_back({.depth = 5, .mu = covered.mu(), .alpha = 8, .bulk_ratio = 50, .erosion_limit = 0.7});
  EXPECT_FALSE(atlas_about(covered));
}

TEST(ExpectedDepth, IsThatOfTheRunsWithTheirScatter) {
  const auto expected = expected_depth(problem_of(gold_into_skin()));
  ASSERT_TRUE(expected);
  EXPECT_NEAR(std::exp(expected->log_depth), 26, 3) << "docs/verification/guha2009_skin.md";
  EXPECT_LT(expected->deviation, 0.04);
  EXPECT_NEAR(expected->noise, 0.03, 0.012);
}

TEST(ExpectedDepth, IsNotSaidWhereNothingIsNear) {
  Scene scene = gold_into_skin();
  scene.mesh.elements_per_radius = 20;
  EXPECT_FALSE(expected_depth(problem_of(scene))) << "no run has so small elements";
  scene = gold_into_skin();
  scene.particle.speed = 65100;
  scene.target.width = 20e-6;
  ASSERT_TRUE(atlas_about(problem_of(scene)));
  EXPECT_FALSE(expected_depth(problem_of(scene))) << "pi4 of 66,000";
}

TEST(ExpectedRoot, IsWhereTheExpectedDepthIsTheOneLookedFor) {
  const auto problem = [](double log_modulus) {
    Scene scene = gold_into_skin();
    scene.target.mu_as_given = std::exp(log_modulus);
    return problem_of(scene);
  };
  const double log_depth = std::log(26);
  const auto found = expected_root(problem, log_depth, std::log(5e6), 6);
  ASSERT_TRUE(found);
  EXPECT_NEAR(std::exp(found->log_value), 65e6, 10e6);
  EXPECT_NEAR(found->slope, -0.75, 0.2);
  const auto there = expected_depth(problem(found->log_value));
  ASSERT_TRUE(there);
  EXPECT_NEAR(there->log_depth, log_depth, 0.02);
  EXPECT_NEAR(expected_root(problem, log_depth, std::log(600e6), 6)->log_value, found->log_value, 0.03);
  EXPECT_FALSE(expected_root(problem, std::log(2000), std::log(5e6), 6)) << "deeper than any layer";
  EXPECT_FALSE(expected_root(problem, log_depth, std::log(5e6), 1)) << "not so near";
}

TEST(BeginAt, AsksForTheAnswersThatTheErrorNeeds) {
  const ExpectedRoot root{.log_value = 3, .slope = -0.8, .at = {.log_depth = 3, .deviation = 0.02, .noise = 0.03}};
  const auto answers = [&](double others) {
    InversionOptions options{.fewest_in_line = 10};
    begin_at(root, others, options);
    EXPECT_EQ(options.start, 3);
    EXPECT_EQ(options.expected_slope, 0.8);
    EXPECT_EQ(options.noise, 0.03);
    return options.fewest_in_line;
  };
  EXPECT_EQ(answers(0), 10) << "nothing else is to be unsure of";
  EXPECT_EQ(answers(0.3), 5);
  EXPECT_EQ(answers(0.04), 7)
      << "2.57 times 3 % over the root of 7 is below 0.4 times 1.96 times 4 %; 2.78 over that of 6 is not";
}

}  // namespace
}  // namespace percal
