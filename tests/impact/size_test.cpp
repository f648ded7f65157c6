#include "percal/impact/target/size.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "percal/base/error.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/target/block.hpp"
#include "percal/impact/target/constants.hpp"
#include "percal/problem/domain.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

std::string refusal_of(const Problem& problem) {
  try {
    refuse_what_is_too_large(problem, "scene.toml");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(RunSize, IsThatOfTheRun) {
  Problem p;
  p.pi4 = 6.6;
  p.density_ratio = 2;
  p.alpha = 8.5;
  p.depth = 20;
  p.erosion = StrainErosion{0.7};
  for (const double n : {4.0, 4.34}) {
    p.elements_per_radius = n;
    const RunSize size = size_of(p);
    const ImpactResult run = run_impact(p, 1);
    EXPECT_EQ(size.elements, static_cast<double>(run.elements)) << n;
    EXPECT_GT(size.steps, 0.5 * static_cast<double>(run.steps)) << "an estimate from above";
    EXPECT_LT(size.steps, 100 * static_cast<double>(run.steps));
  }
}

TEST(RunSize, HasTheMemoryOfTheBlock) {
  Problem p;
  p.pi4 = 1;
  for (const int rates : {1, 2}) {
    p.rates = rates;
    const Block<float> block(p, mesh_of(p), 8);
    EXPECT_NEAR(size_of(p).bytes, static_cast<double>(block.bytes()), 0.1 * size_of(p).bytes) << "but for padding";
  }
}

TEST(RunSize, CountsBothHalvesOfAWholeMesh) {
  Problem p;
  p.pi4 = 1;
  const double half = size_of(p).elements;
  p.whole = true;
  EXPECT_EQ(size_of(p).elements, 2 * half);
}

// A depth of 1 km under a sphere of 1 um once wrapped to a mesh of 6 elements.
TEST(RunSize, WhatDoesNotFitIsRefusedByItsKeyAndNumber) {
  Problem deep;
  deep.pi4 = 6.6;
  deep.depth = 1e9;
  EXPECT_THAT(refusal_of(deep), HasSubstr("scene.toml: target.depth: found"));
  EXPECT_THAT(refusal_of(deep), HasSubstr("1e+10 rows"));
  Problem wide = deep;
  wide.depth = 75;
  wide.width = wide.fine_width = 1e9;
  EXPECT_THAT(refusal_of(wide), HasSubstr("mesh.fine_width: found"));
  Problem fine = deep;
  fine.depth = 2e4;
  fine.width = fine.fine_width = 50;
  fine.end_time = 1;
  EXPECT_EQ(refusal_of(fine), "");
  fine.elements_per_radius = 1000;
  EXPECT_THAT(refusal_of(fine), HasSubstr("mesh.elements_per_radius: found"));
}

TEST(RunSize, ARunOfTooManyStepsIsRefused) {
  Problem p;
  p.pi4 = 6.6;
  EXPECT_EQ(refusal_of(p), "");
  p.depth = 3e5;
  p.end_time = 1e9;
  EXPECT_THAT(refusal_of(p), HasSubstr("target.depth: found"));
  EXPECT_THAT(refusal_of(p), HasSubstr("steps"));
  p.end_time = 10;
  EXPECT_EQ(refusal_of(p), "") << "it ends before";
}

}  // namespace
}  // namespace percal
