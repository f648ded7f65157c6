#include "percal/campaign/sphere_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "percal/base/error.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/problem/domain.hpp"
#include "percal/problem/replicates.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

// Stops after some milliseconds.
Problem quick_shot(double pi4 = 6) {
  Problem p;
  p.pi4 = pi4;
  p.density_ratio = 2;
  p.alpha = 8.5;
  p.depth = 20;
  p.elements_per_radius = 4;
  p.graded_columns = usual_graded_columns(p);
  p.erosion = StrainErosion{0.7};
  return p;
}

class SphereRunsTest : public testing::Test, protected test::TemporaryFolder {
 protected:
  Store store{path("percal.store")};
};

TEST_F(SphereRunsTest, FinishedRunsAreRowsToLearnFrom) {
  Campaign campaign(&store, 1);
  Problem replicate = quick_shot();
  replicate.speed_factor = 1.001;
  const Evaluation first = campaign.evaluate(quick_shot()), second = campaign.evaluate(replicate);
  ASSERT_EQ(first.result.outcome, Outcome::stopped);
  const auto spheres = stored_spheres(store);
  ASSERT_EQ(spheres.size(), 2u);
  EXPECT_EQ(spheres[0].key, evaluation_key(quick_shot(), instruction_level()));
  EXPECT_EQ(spheres[0].outcome, "stopped");
  EXPECT_EQ(spheres[0].reach, first.result.depth);
  EXPECT_EQ(spheres[0].cpu_seconds, first.cpu_seconds);
  EXPECT_EQ(spheres[1].reach, second.result.depth);
  const TrainingRun run = training_run(replicate, second.result.depth);
  EXPECT_EQ(run.h, 0.25);
  EXPECT_EQ(run.log_depth, std::log(second.result.depth));
  EXPECT_NEAR(run.at.log_pi4, std::log(6 * 1.001 * 1.001), 1e-12);
}

TEST_F(SphereRunsTest, ASphereThatDidNotStopHasNoDepth) {
  Campaign campaign(&store, 1);
  Problem thin = quick_shot(100);
  thin.depth = 3;
  thin.density_ratio = 16;
  ASSERT_EQ(campaign.evaluate(thin).result.outcome, Outcome::passed_through);
  ASSERT_EQ(stored_spheres(store).size(), 1u);
  EXPECT_EQ(stored_spheres(store)[0].outcome, "passed through");
  EXPECT_FALSE(stored_spheres(store)[0].reach);
}

TEST_F(SphereRunsTest, OfOneThatWentOnBehindItsLayerTheSpeedLeftIsAReach) {
  Campaign campaign(&store, 1);
  Problem thin = quick_shot(100);
  thin.depth = 3;
  thin.density_ratio = 4;
  thin.until = RunUntil::passage;
  const Evaluation run = campaign.evaluate(replicates_of(thin, 3)[2]);
  ASSERT_EQ(run.result.aftermath->ending, Ending::passed_through);
  const Problem problem = stored_spheres(store)[0].problem;
  const double left = run.result.aftermath->speed / problem.speed_factor;
  EXPECT_NE(problem.speed_factor, 1);
  EXPECT_DOUBLE_EQ(*stored_spheres(store)[0].reach, 3 / (1 - left * left));

  ImpactResult held = run.result;
  held.aftermath->ending = Ending::rests;
  EXPECT_EQ(reach_of(problem, held), 3);
  ImpactResult hardly_slowed = run.result;
  hardly_slowed.aftermath->speed = 0.96 * problem.speed_factor;
  EXPECT_FALSE(reach_of(problem, hardly_slowed));
}

TEST_F(SphereRunsTest, WhatIsNoErodingSphereInLayersThatErodeIsLeftOut) {
  const auto put = [&](auto change, const std::string& level) {
    Problem p = quick_shot();
    change(p);
    store.put(evaluation_key(p, level), {"time up", "{}", 0});
  };
  put([](Problem& p) { p.erosion = NoErosion{}; }, instruction_level());
  put([](Problem& p) { p.erosion = StressErosion{2}; }, instruction_level());
  put([](Problem& p) { p.geometry = Geometry::plane_strain; }, instruction_level());
  put([](Problem& p) { p.particle = ElasticSphere{100, 0.3}; }, instruction_level());
  put([](Problem& p) { p.below = {LowerLayer{.depth = 9, .mu = 1, .alpha = 4, .erosion_limit = INFINITY}}; },
      instruction_level());
  put([](Problem& p) { p.below.resize(3, LowerLayer{.depth = 9, .mu = 1, .alpha = 4, .erosion_limit = 1}); },
      instruction_level());
  put([](Problem&) {}, "another");
  EXPECT_EQ(store.size(), 7);
  EXPECT_TRUE(stored_spheres(store).empty());
}

TEST_F(SphereRunsTest, APayloadThatIsNoneIsAnIoFailure) {
  store.put(evaluation_key(quick_shot(), instruction_level()), {"stopped", "{}", 0});
  EXPECT_THROW(stored_spheres(store), IoFailure);
}

TEST(InputsOf, AreThoseOfTheProblem) {
  Problem p = quick_shot(12);
  p.bulk_ratio = 80;
  const SphereInputs expected{std::log(12.0), -std::log(2.0), 8.5, 0.7, std::log(20.0), std::log(80.0)};
  EXPECT_EQ(inputs_of(p), expected);
}

// Of three layers the lowest is the one that the others cover; their faces are those of the rows, of four in a radius.
TEST(InputsOf, TheLayersAboveTheLowestAreItsCovers) {
  Problem p = quick_shot(12);
  p.depth = 0.6;
  p.erosion = StrainErosion{0.2};
  p.below = {LowerLayer{.depth = 1.7, .density = 1.1, .mu = 0.05, .alpha = 4, .erosion_limit = 0.5},
             LowerLayer{.depth = 18, .density = 0.9, .mu = 0.02, .alpha = 6, .bulk_ratio = 60, .erosion_limit = 1.1}};
  const SphereInputs found = inputs_of(p);
  SphereInputs expected{std::log(0.9 / 0.02), std::log(0.9 / p.density_ratio), 6, 1.1, std::log(20.3), std::log(60)};
  lay_on(expected, cover_members[0],
         {.thickness = 1.75, .density = 1.1 / 0.9, .mu = 0.05 / 0.02, .alpha = 4, .erosion_strain = 0.5});
  lay_on(expected, cover_members[1],
         {.thickness = 0.5, .density = 1 / 0.9, .mu = p.mu() / 0.02, .alpha = 8.5, .erosion_strain = 0.2});
  EXPECT_LT((in_order(found) - in_order(expected)).norm(), 1e-12) << in_order(found).transpose();
}

// The sizes and the materials of all layers are inputs.
TEST(SettingOf, IsTheSameWithCoversAndWithout) {
  Problem p = quick_shot(12);
  const std::string bare = setting_of(p);
  p.below = {LowerLayer{.depth = 18, .density = 0.9, .mu = 0.02, .alpha = 6, .erosion_limit = 1.1}};
  EXPECT_EQ(setting_of(p), bare);
}

TEST(InputsOf, ALengthIsOneOfThemAndElementsAreSharesOfIt) {
  Problem p = quick_shot();
  EXPECT_EQ(element_size(p), 0.25);
  p.erosion_average = AverageWithin{0.5};
  EXPECT_EQ(inputs_of(p).log_erosion_length, std::log(0.5));
  EXPECT_EQ(element_size(p), 0.5);
  EXPECT_EQ(training_run(p, 9).h, 0.5);
}

TEST(InputsOf, ALimitIsTheSameInEveryMeasure) {
  Problem p = quick_shot();
  for (const auto measure : {StrainMeasure::true_strain, StrainMeasure::green_lagrange}) {
    p.erosion = StrainErosion{strain_at(1.7, measure), measure};
    EXPECT_NEAR(inputs_of(p).erosion_strain, 0.7, 1e-14);
  }
}

// A replicate at f v is the impact at that speed: the depths are the same but for rounding.
TEST(InputsOf, AReplicatesSpeedIsPartOfPi4) {
  Problem replicate = quick_shot(), other = quick_shot();
  replicate.speed_factor = 1.3;
  other.pi4 = quick_shot().pi4 * 1.3 * 1.3;
  replicate.arithmetic = other.arithmetic = Arithmetic::double_precision;
  replicate.erosion = other.erosion = StrainErosion{50};  // one that erodes doubles every rounding
  replicate.density_ratio = other.density_ratio = 0.2;
  EXPECT_NEAR(inputs_of(replicate).log_pi4, inputs_of(other).log_pi4, 1e-12);
  Campaign campaign(nullptr, 1);
  const double depth = campaign.evaluate(replicate).result.depth;
  EXPECT_NEAR(campaign.evaluate(other).result.depth, depth, 1e-3 * depth);
  EXPECT_GT(std::abs(campaign.evaluate(quick_shot()).result.depth - depth), 0.01 * depth);
}

TEST(SettingOf, TwoSystemsOnTwoMeshesShareOne) {
  Problem other = quick_shot(40);
  other.density_ratio = 7;
  other.alpha = 3;
  other.bulk_ratio = 500;
  other.depth = 126;
  other.erosion = StrainErosion{0.4, StrainMeasure::true_strain};
  other.elements_per_radius = 16;
  other.graded_columns = usual_graded_columns(other);
  other.speed_factor = 0.999;
  EXPECT_EQ(setting_of(other), setting_of(quick_shot()));
  Problem shorter = quick_shot();
  shorter.erosion_average = AverageWithin{0.3};
  other.erosion_average = AverageWithin{0.9};
  EXPECT_EQ(setting_of(other), setting_of(shorter));
}

TEST(SettingOf, ARunThatGoesOnToRestTellsTheSameDepth) {
  Problem on = quick_shot();
  on.until = RunUntil::rest;
  EXPECT_EQ(setting_of(on), setting_of(quick_shot()));
}

TEST(SettingOf, WhatTheEmulatorDoesNotKnowTellsThemApart) {
  const auto differs = [](auto change) {
    Problem p = quick_shot();
    change(p);
    return setting_of(p) != setting_of(quick_shot());
  };
  EXPECT_TRUE(differs([](Problem& p) { p.hourglass = 0.156; }));
  EXPECT_TRUE(differs([](Problem& p) { p.width = 10; }));
  EXPECT_TRUE(differs([](Problem& p) { p.bottom = Bottom::fixed; }));
  EXPECT_TRUE(differs([](Problem& p) { p.fine_width = 2; }));
  EXPECT_TRUE(differs([](Problem& p) { p.graded_columns += 1; }));
  EXPECT_TRUE(differs([](Problem& p) { p.linear_viscosity = 0; }));
  EXPECT_TRUE(differs([](Problem& p) { p.arithmetic = Arithmetic::double_precision; }));
  EXPECT_TRUE(differs([](Problem& p) { p.rates = 1; }));
  EXPECT_TRUE(differs([](Problem& p) { p.erosion_average = AverageWithin{0.3}; }));
}

}  // namespace
}  // namespace percal
