#include "percal/observe/block_reach.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percal {
namespace {

using testing::HasSubstr;

Problem block() {
  Problem p;
  p.geometry = Geometry::block;
  p.whole = true;
  p.width = 5;
  p.depth = 40;
  p.block.fine_depth = 20;
  return p;
}

std::vector<Evaluation> run_to(double depth, double sideways) {
  Evaluation run;
  run.result.depth = depth;
  run.result.sideways = sideways;
  return {Evaluation{}, run};
}

TEST(BlockReach, APathAmongTheCubesIsNotMentioned) { EXPECT_TRUE(warnings_of_reach(block(), run_to(19, 0.5)).empty()); }

TEST(BlockReach, APathBeyondTheCubesIs) {
  EXPECT_THAT(warnings_of_reach(block(), run_to(21, 0)),
              testing::ElementsAre(HasSubstr("went 21 radii deep, the cubes reach 20")));
  EXPECT_THAT(warnings_of_reach(block(), run_to(3, -2)), testing::ElementsAre(HasSubstr("2 radii aside")));
}

TEST(BlockReach, APathAcrossBeyondTheCubesIs) {
  Problem whole = block();
  whole.block.whole_across = true;
  auto runs = run_to(3, 0);
  runs[1].result.in_space = {.across = -1.5, .axis = {}};
  EXPECT_THAT(warnings_of_reach(whole, runs), testing::ElementsAre(HasSubstr("1.5 radii across")));
}

TEST(BlockReach, OtherGeometriesHaveNoCubes) {
  Problem p = block();
  p.geometry = Geometry::axisymmetric;
  EXPECT_TRUE(warnings_of_reach(p, run_to(100, 0)).empty());
}

}  // namespace
}  // namespace percal
