#include "percal/observe/penetration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace percal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Scales micrometres{.radius = 1e-6, .speed = 600, .target_density = 1000};

Evaluation ended(Outcome outcome, double depth) {
  Evaluation run;
  run.result.outcome = outcome;
  run.result.depth = depth;
  run.result.steps = 100;
  run.result.energy.elastic = 1;
  return run;
}

Penetration of(const std::vector<Evaluation>& runs) {
  Problem problem;
  problem.depth = 75;
  return summarise(runs, problem, micrometres);
}

std::vector<std::string> told(const std::vector<Evaluation>& runs) { return warnings(of(runs), runs); }

TEST(Penetration, IsTheMeanOfTheReplicatesWithTheirSampleDeviation) {
  const Penetration p = of({ended(Outcome::stopped, 25), ended(Outcome::stopped, 26), ended(Outcome::stopped, 30)});
  EXPECT_EQ(p.outcome, Outcome::stopped);
  EXPECT_FALSE(p.mixed);
  EXPECT_NEAR(*p.depth, 27e-6, 1e-18);
  EXPECT_NEAR(*p.spread, std::sqrt((4 + 1 + 9) / 2.0) * 1e-6, 1e-18);
  EXPECT_NEAR(*p.standard_error, *p.spread / std::sqrt(3), 1e-18);
  EXPECT_FALSE(p.at_least);
  EXPECT_EQ(p.depths.size(), 3u);
}

TEST(Penetration, OneRunHasADepthAndNoSpread) {
  const Penetration p = of({ended(Outcome::stopped, 25)});
  EXPECT_TRUE(p.depth);
  EXPECT_FALSE(p.spread);
  EXPECT_FALSE(p.standard_error);
}

TEST(Penetration, RunsThatPassedThroughGiveABoundAndNoDepth) {
  const Penetration p = of({ended(Outcome::passed_through, 75.01), ended(Outcome::passed_through, 75.02)});
  EXPECT_EQ(p.outcome, Outcome::passed_through);
  EXPECT_FALSE(p.depth);
  EXPECT_FALSE(p.spread);
  EXPECT_DOUBLE_EQ(*p.at_least, 75e-6);
}

TEST(Penetration, WhatWentThroughSeveralLayersWentThroughThemAll) {
  Problem problem;
  problem.depth = 5;
  problem.below = {LowerLayer{}};
  problem.below.front().depth = 60;
  const Penetration p = summarise({ended(Outcome::passed_through, 65.01)}, problem, micrometres);
  EXPECT_NEAR(*p.at_least, 65e-6, 1e-18);
}

TEST(Penetration, OutcomesOfDifferentKindsAreNeverAveraged) {
  for (const Outcome other : {Outcome::passed_through, Outcome::time_up, Outcome::unstable})
    for (const bool first : {true, false}) {
      const Evaluation stopped = ended(Outcome::stopped, 70), odd = ended(other, 75);
      const Penetration p = first ? of({odd, stopped, stopped}) : of({stopped, stopped, odd});
      EXPECT_TRUE(p.mixed);
      EXPECT_EQ(p.outcome, other) << "the one that is not stopped";
      EXPECT_FALSE(p.depth);
      EXPECT_FALSE(p.spread);
      EXPECT_EQ(p.at_least.has_value(), other == Outcome::passed_through);
    }
}

TEST(Penetration, RunsThatWereStoppedByTheClockHaveNoDepth) {
  const Penetration p = of({ended(Outcome::time_up, 10)});
  EXPECT_FALSE(p.depth);
  EXPECT_THAT(p.depths, ElementsAre(testing::DoubleEq(10e-6)));
}

TEST(Penetration, EnergySharesAreMeansAndTheWorstClosureIsKept) {
  Evaluation one = ended(Outcome::stopped, 25), other = ended(Outcome::stopped, 26);
  one.result.energy = {.elastic = 0.6, .viscosity = 0.38};
  other.result.energy = {.elastic = 0.8, .viscosity = 0.21};
  const Penetration p = of({one, other});
  EXPECT_DOUBLE_EQ(p.energy.elastic, 0.7);
  EXPECT_DOUBLE_EQ(p.energy.viscosity, 0.295);
  EXPECT_NEAR(p.worst_closure, 0.02, 1e-15);
}

TEST(Penetration, ARunWithoutAStepHasNoEnergyErrorToTellOf) { EXPECT_EQ(of({Evaluation{}}).worst_closure, 0); }

TEST(Joined, IsTheMeanOfRunsAndAtlasByTheirCertainty) {
  const AtlasDepth atlas{.depth = 26e-6, .deviation = 0.02, .noise = 0.04, .width = 20};
  EXPECT_NEAR(joined_error(atlas, 4), 0.02 / std::sqrt(2), 1e-15) << "four runs are as sure as it is";
  const Evaluation run = ended(Outcome::stopped, 27);
  const Penetration four = joined(of({run, run, run, run}), atlas);
  EXPECT_TRUE(four.is_joined);
  EXPECT_NEAR(*four.depth, std::sqrt(26 * 27.0) * 1e-6, 1e-17);
  EXPECT_NEAR(*four.standard_error, *four.depth * 0.02 / std::sqrt(2), 1e-17);
  EXPECT_EQ(*four.spread, 0);
  const Penetration one = joined(of({run}), atlas);
  EXPECT_NEAR(std::log(*one.depth / 26e-6), std::log(27.0 / 26) / 5, 1e-12) << "a run has a quarter of its weight";
  EXPECT_NEAR(*one.spread, *one.depth * 0.04, 1e-17) << "what the atlas says a run scatters by";
  EXPECT_EQ(one.depths.size(), 1u);
}

TEST(Joined, TheyMayBeApartByBothHalfWidths) {
  const AtlasDepth atlas{.depth = 26e-6, .deviation = 0.02, .noise = 0.04, .width = 20};
  EXPECT_NEAR(allowed_apart(atlas, 4), 1.959964 * 0.04, 1e-8);
  EXPECT_NEAR(std::log(atlas.high() / 26e-6), 1.959964 * std::hypot(0.02, 0.04), 1e-8);
  EXPECT_NEAR(atlas.low() * atlas.high(), 26e-6 * 26e-6, 1e-24);
}

TEST(Warnings, CollisionsAndViscosityAboveHalfOfTheEnergyAreTold) {
  Evaluation run = ended(Outcome::stopped, 25);
  run.result.energy = {.elastic = 0.51, .viscosity = 0.3, .collisions = 0.19};
  EXPECT_THAT(told(std::vector{run}), IsEmpty());
  run.result.energy = {.elastic = 0.48, .viscosity = 0.3, .collisions = 0.22};
  const auto lines = told(std::vector{run});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_THAT(lines[0], HasSubstr("(22 %)"));
  EXPECT_THAT(lines[0], HasSubstr("(30 %)"));
  EXPECT_THAT(lines[0], HasSubstr("more than half"));
}

TEST(Warnings, MixedOutcomesAreListedOneByOne) {
  const std::vector<Evaluation> runs{ended(Outcome::stopped, 70), ended(Outcome::passed_through, 75)};
  const auto lines = told(runs);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_THAT(lines[0], HasSubstr("(stopped, passed through)"));
  EXPECT_THAT(lines[0], HasSubstr("not averaged"));
}

TEST(Warnings, ATimeThatIsUpForAReasonIsTold) {
  Evaluation run = ended(Outcome::time_up, 3);
  EXPECT_THAT(told({run}), IsEmpty());
  run.result.reason = "the time step collapsed";
  EXPECT_THAT(told({run}), ElementsAre("time up: the time step collapsed"));
}

TEST(Warnings, UnstableRunsAndDistortedElementsAreNamed) {
  Evaluation run = ended(Outcome::unstable, 3);
  run.result.reason = "a force is not finite";
  run.result.distorted = 12;
  run.result.energy.collisions = 1e30;  // means nothing where energy was not kept
  const auto lines = told(std::vector{run});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "unstable: a force is not finite");
  EXPECT_THAT(lines[1], HasSubstr("12 elements"));
}

}  // namespace
}  // namespace percal
