// What replicates say together besides the depth; the numbers of the shot; the particle's outline.
#include "percal/observe/field_errors.hpp"
#include "percal/observe/field_measures.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "percal/problem/particle.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Scales shot_scales{.radius = 2e-3, .speed = 100, .target_density = 1000};

Problem two_layers() {
  Problem p;
  p.depth = 10;
  p.below = {LowerLayer{.depth = 5}};
  return p;
}

Evaluation passed(double behind_first, double behind_second) {
  Evaluation run;
  run.result.outcome = Outcome::passed_through;
  run.result.depth = 15;
  run.result.speeds_behind = {behind_first, behind_second};
  return run;
}

Evaluation rested(double deepest, double depth, double half_width) {
  Evaluation run;
  run.result.outcome = Outcome::stopped;
  run.result.depth = deepest;
  run.result.aftermath = {.ending = Ending::rests, .depth = depth, .half_width = half_width, .energy = {.elastic = 0.99}};
  return run;
}

TEST(FieldMeasures, ASpeedIsTheMeanWhereAllRunsCrossedTheFace) {
  const auto both = field_measures({passed(0.6, 0.3), passed(0.7, 0.4)}, two_layers(), shot_scales);
  ASSERT_EQ(both.speeds_behind.size(), 2u);
  EXPECT_NEAR(*both.speeds_behind[0].mean, 65, 1e-12);
  EXPECT_NEAR(*both.speeds_behind[0].spread, 10 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(*both.speeds_behind[0].standard_error, 5, 1e-12);
  EXPECT_NEAR(*both.exit_speed.mean, 35, 1e-12);
  Evaluation held = passed(0.5, 0);
  held.result.outcome = Outcome::stopped;
  held.result.speeds_behind.pop_back();
  const auto one = field_measures({passed(0.6, 0.3), held}, two_layers(), shot_scales);
  EXPECT_NEAR(*one.speeds_behind[0].mean, 55, 1e-12);
  EXPECT_FALSE(one.speeds_behind[1].mean);
  EXPECT_FALSE(one.exit_speed.mean);
  EXPECT_FALSE(one.final);
}

TEST(FieldMeasures, WhereARunGoesOnTheExitSpeedIsThatOfFreeFlight) {
  Evaluation run = passed(0.6, 0.3);
  run.result.aftermath = {.ending = Ending::passed_through, .speed = 0.25};
  EXPECT_NEAR(*field_measures({run}, two_layers(), shot_scales).exit_speed.mean, 25, 1e-12);
  run.result.aftermath->ending = Ending::rests;
  EXPECT_FALSE(field_measures({run}, two_layers(), shot_scales).exit_speed.mean) << "it hangs in the lower face";
}

TEST(FieldMeasures, FinalDepthsOfRunsThatRestAreAveragedAndTheLargestSwingCounts) {
  const auto final = *field_measures({rested(9, 6, 0.1), rested(9, 8, 0.2)}, two_layers(), shot_scales).final;
  EXPECT_EQ(final.ending, Ending::rests);
  EXPECT_FALSE(final.mixed);
  EXPECT_NEAR(*final.depth.mean, 14e-3, 1e-15);
  EXPECT_NEAR(*final.half_width, 0.4e-3, 1e-15);
  EXPECT_NEAR(*final.depth.standard_error, 2e-3, 1e-15);
  EXPECT_NEAR(final.worst_closure, 0.01, 1e-12);
  EXPECT_FALSE(final.speed.mean);
}

TEST(FieldMeasures, DifferentEndingsAreNotAveraged) {
  std::vector<Evaluation> runs{rested(9, 6, 0.1), rested(9, -2, 0), rested(9, 7, 0.1)};
  runs[1].result.aftermath->ending = Ending::left_upwards;
  runs[2].result.aftermath->ending = Ending::time_up;
  runs[2].result.aftermath->reason = "the time step collapsed";
  const auto measures = field_measures(runs, two_layers(), shot_scales);
  EXPECT_TRUE(measures.final->mixed);
  EXPECT_EQ(measures.final->ending, Ending::left_upwards);
  EXPECT_FALSE(measures.final->depth.mean);
  EXPECT_FALSE(measures.final->speed.mean);
  EXPECT_THAT(warnings(measures, runs), ElementsAre(HasSubstr("(rests, left upwards, time up)"),
                                                    HasSubstr("time up: the time step collapsed")));
  runs[1].result.aftermath.reset();
  EXPECT_FALSE(field_measures(runs, two_layers(), shot_scales).final) << "one had no deepest point";
}

TEST(FieldMeasures, TheChannelIsAlongTheMeanDepth) {
  std::vector<Evaluation> runs{rested(8, 6, 0.1), rested(12, 6, 0.1)};
  for (auto& run : runs) run.result.channel = {std::vector<double>(10, 0.1 * run.result.depth), std::vector<double>(10, 0.5)};
  const auto channel = *field_measures(runs, two_layers(), shot_scales).channel;
  EXPECT_NEAR(channel.depths[0], 0.05 * 10 * 2e-3, 1e-15);
  EXPECT_NEAR(channel.depths[9], 0.95 * 10 * 2e-3, 1e-15);
  EXPECT_NEAR(*channel.largest[3].mean, 2e-3, 1e-15);
  EXPECT_NEAR(*channel.end[3].mean, 1e-3, 1e-15);
  EXPECT_NEAR(*channel.end[3].spread, 0, 1e-15);
  runs[0].result.channel = {};
  EXPECT_FALSE(field_measures(runs, two_layers(), shot_scales).channel);
}

// --- the shot -----------------------------------------------------------------------------------------------------

Reduction shot(const std::string& geometry, const std::string& particle) {
  return reduce(parse_scene("geometry = \"" + geometry + "\"\n[particle]\n" + particle +
                                "\nspeed = \"50 m/s\"\n[target]\ndensity = \"1000 kg/m3\"\nmu = \"100 kPa\"\nalpha = 8\n"
                                "depth = \"90 mm\"\nwidth = \"40 mm\"\n",
                            "s.toml"));
}
double density_over_area(const Reduction& r) { return sectional_density(r.problem, r.scales); }

TEST(SectionalDensity, IsMassOverTheAreaThatFacesTheTarget) {
  const Reduction ball = shot("axisymmetric", "radius = \"2 mm\"\ndensity = \"7800 kg/m3\"");
  const double mass = 4.0 / 3 * std::numbers::pi * 8e-9 * 7800;
  EXPECT_NEAR(density_over_area(ball) / (mass / (std::numbers::pi * 4e-6)), 1, 1e-12);
  EXPECT_NEAR(impact_parameter(ball.problem, ball.scales), 7800 * 50 * 2e-3, 1e-9);
  const Reduction cone = shot("axisymmetric", "shape = \"cone\"\nradius = \"2 mm\"\ntip_angle = \"90 deg\"\nmass = \"3 g\"");
  EXPECT_NEAR(density_over_area(cone) / (3e-3 / (std::numbers::pi * 4e-6)), 1, 1e-9);
  const Reduction rod = shot("plane strain", "radius = \"2 mm\"\ndensity = \"7800 kg/m3\"");
  EXPECT_NEAR(density_over_area(rod) / (std::numbers::pi * 4e-6 * 7800 / 4e-3), 1, 1e-12);
  const Reduction prism = shot("plane strain", "shape = \"rhombus\"\nside = \"4 mm\"\ntip_angle = \"90 deg\"\ndensity = \"464 kg/m3\"");
  EXPECT_NEAR(density_over_area(prism) / (16e-6 * 464 / (4e-3 * std::sqrt(2))), 1, 1e-9);
}

TEST(ParticleOutline, TouchesTheDepthAndIsClosed) {
  ImpactResult run;
  run.depth = 7;
  for (const Reduction& r : {shot("axisymmetric", "radius = \"2 mm\"\ndensity = \"7800 kg/m3\""),
                             shot("plane strain", "shape = \"rhombus\"\nside = \"4 mm\"\ntip_angle = \"60 deg\"\ndensity = \"464 kg/m3\"")}) {
    double deepest = 0, widest = 0;
    const auto outline = particle_outline(run, r.problem, r.scales);
    for (const auto& [distance, depth] : outline) {
      deepest = std::max(deepest, depth);
      widest = std::max(widest, distance);
    }
    EXPECT_EQ(outline.front(), outline.back());
    EXPECT_NEAR(deepest, 7 * r.scales.radius, 1e-12);
    EXPECT_NEAR(widest, r.scales.radius, 1e-12);
  }
}

// What is left of 100 m/s when the energy lost is a tenth more or less than thought.
TEST(SpeedHalfWidth, IsTheEnergysErrorAtTheSpeed) {
  EXPECT_NEAR(speed_half_width(80, 100, 0.1), 80 - std::sqrt(6400 - 360), 1e-12);
  EXPECT_NEAR(speed_half_width(5, 100, 0.1), std::sqrt(25 + 997.5) - 5, 1e-12) << "it may have been held";
  EXPECT_NEAR(speed_half_width(-5, 100, 0.1), speed_half_width(5, 100, 0.1), 1e-12);
  EXPECT_EQ(speed_half_width(100, 100, 0.1), 0);
  EXPECT_EQ(speed_half_width(40, 100, 0), 0);
}

}  // namespace
}  // namespace percal
