#include "percal/scaling/trend.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "percal/base/error.hpp"
#include "percal/scaling/similar.hpp"
#include "systems.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ImpactParameter, IsDensityTimesSpeedTimesRadius) {
  EXPECT_DOUBLE_EQ(impact_parameter({.density = 7800, .radius = 2e-3, .speed = 50, .depth = 1}), 780);
}

TEST(Shots, AreReadWithTheirUnitsFromADiameterOrARadius) {
  auto table = parse_csv("density_kg_m3,diameter_mm,radius_mm,velocity_m_s,penetration_cm\n7800,3.18,1.59,83,4.04\n",
                         "shots.csv");
  auto by_diameter = read_shots(table, {});
  ASSERT_EQ(by_diameter.size(), 1u);
  EXPECT_DOUBLE_EQ(by_diameter[0].radius, 1.59e-3);
  EXPECT_DOUBLE_EQ(by_diameter[0].depth, 4.04e-2);
  EXPECT_DOUBLE_EQ(read_shots(table, {.radius = "radius"})[0].radius, 1.59e-3);
}

TEST(Shots, RefuseANumberThatIsNotPositiveByItsLine) {
  auto table = parse_csv(
      "density_kg_m3,diameter_mm,velocity_m_s,penetration_cm\n7800,3.18,83,4.04\n7800,-3.18,83,4.04\n", "shots.csv");
  EXPECT_THAT([&] { read_shots(table, {}); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("shots.csv:3"), HasSubstr("diameter"), HasSubstr("positive"))));
}

TEST(DepthTrend, OfShotsOnALineIsThatLine) {
  std::vector<Shot> shots;
  for (double speed : {40.0, 60.0, 90.0})
    shots.push_back({7800, 1.59e-3, speed, 5e-5 * (7800 * speed * 1.59e-3) - 0.008});
  auto line = depth_trend(shots);
  EXPECT_NEAR(line.slope, 5e-5, 1e-16);
  EXPECT_NEAR(line.intercept, -0.008, 1e-13);
}

// Depths of similar systems differ by the radii only, so a line through the model's own shot gives the prototype's
// depth.
TEST(DepthFromTheModel, OfTheSimilarShotIsThePrototypesDepth) {
  auto gold = gold_in_skin(), steel = complete(gold, steel_ball()).model;
  Line line;
  line.slope = *steel.penetration / impact_parameter(7800, 83, 1.59e-3);
  EXPECT_NEAR(depth_from_model(line, steel, 83.0 / 651, gold), 26e-6, 1e-18);
}

TEST(EqualMass, KeepsTheMass) {
  double radius = equal_mass_radius(0.7027e-3, 7800);
  EXPECT_NEAR(4.0 / 3 * std::numbers::pi * radius * radius * radius * 7800, 0.7027e-3, 1e-15);
  EXPECT_NEAR(radius, 2.78e-3, 0.005e-3);
  EXPECT_NEAR(5.83e-3 * equal_mass_prism_scale(0.7509e-3, 0.7027e-3), 5.64e-3, 0.005e-3);
}

}  // namespace
}  // namespace percal
