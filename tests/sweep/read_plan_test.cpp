// Plans: which points they have, and what they are refused for.
#include <gmock/gmock.h>

#include <cmath>

#include "percal/scene/scene_toml.hpp"
#include "sweep/small_plan.hpp"

namespace percal {
namespace {

using test::listed_sweep;
using test::ranged;
using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PlanTest : public test::PlanFolder {};

TEST_F(PlanTest, AGridHasAllCombinationsTheLastSweepFastest) {
  const Plan p = plan(listed_sweep("particle.speed", "[\"100 m/s\", \"200 m/s\"]") +
                      ranged("target.alpha", "5", "8", "count = 3\n"));
  EXPECT_THAT(numbers(p, 0), ElementsAre(100, 100, 100, 200, 200, 200));
  EXPECT_THAT(numbers(p, 1), ElementsAre(5, 6.5, 8, 5, 6.5, 8));
  EXPECT_EQ(p.axes[0].column(), "particle.speed [m/s]");
  const auto points = points_to_run(p);
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(points[4].scene.particle.speed, 200);
  EXPECT_EQ(points[4].scene.target.alpha, 6.5);
  EXPECT_EQ(points[4].scene.replicates, 1);
  EXPECT_EQ(points[4].scene.target.depth, read_scene(path("scene.toml")).target.depth);
}

TEST_F(PlanTest, ALogarithmicRangeHasEqualRatios) {
  const auto speeds =
      numbers(plan(ranged("particle.speed", "\"10 m/s\"", "\"0.16 km/s\"", "count = 5\nspacing = \"log\"\n")), 0);
  EXPECT_THAT(speeds, ElementsAre(10, DoubleEq(20), DoubleEq(40), DoubleEq(80), 160));
}

TEST_F(PlanTest, ValuesKeepTheFirstOnesUnitAndTheReaderGetsThemAsTheyStand) {
  const Plan p = plan(listed_sweep("particle.diameter", "[\"3 mm\", \"4500 um\"]"));
  EXPECT_THAT(numbers(p, 0), ElementsAre(3, DoubleEq(4.5)));
  EXPECT_EQ(scene_at(p, 1).particle.radius, 2.25e-3);
}

TEST_F(PlanTest, WordsAndSwitchesAreSweptToo) {
  const Plan p =
      plan(listed_sweep("target.bottom", "[\"free\", \"fixed\"]") +
               listed_sweep("solver.stiffen_supersonic", "[true, false]") + listed_sweep("replicates", "[1, 3]"),
           "");
  ASSERT_EQ(p.points.size(), 8U);
  EXPECT_FALSE(p.axes[0].is_number);
  EXPECT_EQ(scene_at(p, 0).target.bottom, Bottom::free);
  EXPECT_EQ(scene_at(p, 7).target.bottom, Bottom::fixed);
  EXPECT_TRUE(scene_at(p, 1).solver.stiffen_supersonic);
  EXPECT_EQ(scene_at(p, 1).replicates, 3);
}

TEST_F(PlanTest, SobolPointsFillTheBoxOfAllRanges) {
  const Plan p = plan(
      ranged("particle.speed", "\"100 m/s\"", "\"200 m/s\"") + ranged("target.alpha", "2", "8", "spacing = \"log\"\n"),
      "design = \"sobol\"\ncount = 63\n");
  ASSERT_EQ(p.points.size(), 63U);
  EXPECT_EQ(p.points[0].values[0].number, 150);
  EXPECT_NEAR(p.points[0].values[1].number, 4, 1e-11) << "the middle of the ratios";
  int low_half = 0, low_quarter = 0;
  for (const PlanPoint& point : p.points) {
    low_half += point.values[0].number < 150;
    low_quarter += point.values[1].number < 2 * std::sqrt(2);
  }
  EXPECT_EQ(low_half, 31);
  EXPECT_EQ(low_quarter, 15);
}

TEST_F(PlanTest, ASobolDesignGoesWithEveryValueOfTheOthers) {
  const Plan p = plan(listed_sweep("target.bottom", "[\"free\", \"fixed\"]") + ranged("target.alpha", "2", "8"),
                      "design = \"sobol\"\ncount = 3\n");
  EXPECT_EQ(p.points.size(), 6U);
  EXPECT_EQ(p.points[0].values[1].number, p.points[3].values[1].number);
}

TEST_F(PlanTest, AListHasItsRowsWithTheUnitsOfItsHeader) {
  write("points.csv", "particle.diameter [mm];pi5;target.bottom\n4,5;0,2;free\n3;1;fixed\n");
  const Plan p = plan("", "list = \"points.csv\"\n");
  EXPECT_THAT(numbers(p, 0), ElementsAre(4.5, 3));
  EXPECT_THAT(numbers(p, 1), ElementsAre(0.2, 1));
  EXPECT_EQ(scene_at(p, 1).particle.radius, 1.5e-3);
  EXPECT_EQ(scene_at(p, 1).target.bottom, Bottom::fixed);
  EXPECT_EQ(plan(ranged("target.alpha", "2", "8", "count = 4\n"), "list = \"points.csv\"\n").points.size(), 8U);
}

TEST_F(PlanTest, TheSceneMayStandInThePlan) {
  write("plan.toml",
        "[scene.particle]\nradius = \"2 mm\"\ndensity = \"7800 kg/m3\"\nspeed = \"180 m/s\"\n[scene.target]\ndensity = "
        "\"1000 kg/m3\"\n"
        "mu = \"300 kPa\"\nalpha = 3\ndepth = \"40 mm\"\n[[scene.below]]\ndensity = \"1000 kg/m3\"\nmu = \"1 "
        "MPa\"\nalpha = 3\ndepth = \"9 mm\"\n" +
            listed_sweep("below[1].mu", "[\"2 MPa\", \"3 MPa\"]"));
  const Plan p = read_plan(path("plan.toml"));
  EXPECT_EQ(scene_at(p, 1).below.at(0).mu_as_given, 3e6);
  EXPECT_EQ(scene_at(p, 1).particle.speed, 180);
}

TEST_F(PlanTest, ATableThatTheSceneLacksIsMade) {
  EXPECT_EQ(scene_at(plan(listed_sweep("target.fibres.k1", "[\"1 MPa\"]") + listed_sweep("target.fibres.k2", "[2]")), 0)
                .target.fibres.index(),
            1U);
}

// A plan with its fault, and what the message has.
struct Fault {
  const char* name;
  std::string sweeps, head;
  std::vector<std::string> said;
};

class BadPlan : public PlanTest, public testing::WithParamInterface<Fault> {};

TEST_P(BadPlan, IsOneMessageWithFileLineAndKey) {
  write("points.csv", "particle.sped [m/s]\n100\n");
  write("holes.csv", "particle.speed [m/s]\n100\nfast\n");
  const Fault& fault = GetParam();
  const std::string message = refusal(fault.sweeps, fault.head);
  for (const std::string& words : fault.said) EXPECT_THAT(message, HasSubstr(words));
  EXPECT_THAT(message, testing::ContainsRegex("(plan.toml|points.csv|holes.csv)(:[0-9]+)?: ")) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Plans, BadPlan,
    testing::Values(
        Fault{"KeyOfNoScene",
              listed_sweep("particle.velocity", "[\"1 m/s\"]"),
              "",
              {"plan.toml:3: particle.velocity: point 1 of 1", "did you mean speed?"}},
        Fault{"WordOfNoGroup",
              listed_sweep("p4", "[1]"),
              "",
              {"plan.toml:3: sweep[1].key: found \"p4\" (did you mean pi4?)", "pi5 (density ratio, rho_t / rho_p)"}},
        Fault{"Response", listed_sweep("pi8", "[1]"), "", {"found \"pi8\"", "pi4 ("}},
        Fault{"OtherChange",
              listed_sweep("pi4", "[1]", "by = \"alpha\"\n"),
              "",
              {"plan.toml:5: sweep[1].by: found \"alpha\"", "target_density, speed, mu"}},
        Fault{"ByOfAKey", listed_sweep("target.alpha", "[1]", "by = \"mu\"\n"), "", {"sweep[1].by", "a group as key"}},
        Fault{"BadValue",
              listed_sweep("particle.speed", "[\"100 m/s\", \"-3 m/s\"]"),
              "",
              {"plan.toml:3: particle.speed: point 2 of 2 (particle.speed = -3 m/s)",
               "scene.toml:4: particle.speed: found \"-3 m/s\"; accepted: a positive speed"}},
        Fault{"NoUnit",
              listed_sweep("particle.speed", "[100]"),
              "",
              {"point 1 of 1 (particle.speed = 100)", "100 without a unit"}},
        Fault{"BesideItsOther", listed_sweep("particle.radius", "[\"1 mm\"]"), "", {"particle.radius", "diameter"}},
        Fault{"TooLarge",
              listed_sweep("target.depth", "[\"40 mm\", \"40 km\"]"),
              "",
              {"target.depth: point 2 of 2", "memory"}},
        Fault{"NoSuchLayer", listed_sweep("below[2].mu", "[\"1 MPa\"]"), "", {"below[2].mu", "0 tables [[below]]"}},
        Fault{"ArrayAsValue", listed_sweep("target.erosion", "[1]"), "", {"target.erosion", "a key with one value"}},
        Fault{"BothWays",
              listed_sweep("target.alpha", "[1]", "from = 1\n"),
              "",
              {"plan.toml:5: sweep[1].from: found this beside values"}},
        Fault{"NeitherWay", "[[sweep]]\nkey = \"target.alpha\"\n", "", {"sweep[1].values: found no such key"}},
        Fault{"NoCount", ranged("target.alpha", "1", "2"), "", {"sweep[1].count: found no such key"}},
        Fault{"SameEnds", ranged("target.alpha", "2", "2", "count = 3\n"), "", {"sweep[1].to: found 2"}},
        Fault{"OtherDimension",
              ranged("particle.speed", "\"1 m/s\"", "\"2 m\"", "count = 3\n"),
              "",
              {"plan.toml:5: sweep[1].to: found \"2 m\""}},
        Fault{"LogarithmOfNothing",
              ranged("target.alpha", "0", "2", "count = 3\nspacing = \"log\"\n"),
              "",
              {"sweep[1].spacing: found \"log\" from 0 to 2"}},
        Fault{"GroupWithAUnit",
              listed_sweep("pi4", "[\"3 m\"]"),
              "",
              {"sweep[1].values: found numbers with a unit", "pi4 has no dimension"}},
        Fault{"TwiceTheSame",
              listed_sweep("pi4", "[3]") + listed_sweep("target.mu", "[\"1 MPa\"]"),
              "",
              {"plan.toml:6: sweep[2].key", "changes target.mu as pi4 does"}},
        Fault{"ReplicatesTwice",
              listed_sweep("replicates", "[3]"),
              "replicates = 2\n",
              {"sweep[1].key: found replicates"}},
        Fault{"CountInAGrid",
              listed_sweep("target.alpha", "[3]"),
              "count = 4\n",
              {"plan.toml:2: count: found this in a grid"}},
        Fault{"SobolWithoutCount",
              ranged("target.alpha", "1", "2"),
              "design = \"sobol\"\n",
              {"count: found no such key"}},
        Fault{"SobolWithoutRange",
              listed_sweep("target.alpha", "[3]"),
              "design = \"sobol\"\ncount = 4\n",
              {"plan.toml:2: design: found \"sobol\" without a range"}},
        Fault{"SobolCountTwice",
              ranged("target.alpha", "1", "2", "count = 3\n"),
              "design = \"sobol\"\ncount = 4\n",
              {"sweep[1].count: found this in a Sobol design"}},
        Fault{"TooMany",
              ranged("target.alpha", "1", "2", "count = 1000\n") + ranged("target.nu", "0.1", "0.4", "count = 1000\n"),
              "",
              {"found 1e+06 points; accepted: up to 100000 points"}},
        Fault{"Nothing", "", "", {"sweep: found no such table"}},
        Fault{"ColumnOfNoScene",
              "",
              "list = \"points.csv\"\n",
              {"points.csv:2: particle.sped: point 1 of 1", "did you mean speed?"}},
        Fault{"HoleInAList",
              "",
              "list = \"holes.csv\"\n",
              {"holes.csv:3: particle.speed [m/s]: found \"fast\"; accepted: a number in m/s"}},
        Fault{"UnknownKey",
              listed_sweep("target.alpha", "[3]", "step = 3\n"),
              "",
              {"plan.toml:5: sweep[1].step: found an unknown key"}}),
    [](const auto& info) { return info.param.name; });

TEST_F(PlanTest, AGroupThatTheSceneDecidesOtherwiseIsRefused) {
  write("scene.toml", test::small_scene + "[target.fibres]\nk1 = \"1 MPa\"\nk2 = 1\n");
  EXPECT_THAT(refusal(listed_sweep("pi7", "[0.8]")), IsEmpty());
  std::string text = test::small_scene;
  text.replace(text.find("strain = 1.0"), 12, "strain = 1.0\nstrain_below = 0.5\ncell = \"20 mm\"");
  write("scene.toml", text);
  EXPECT_THAT(refusal(listed_sweep("pi7", "[0.8]")),
              AllOf(HasSubstr("pi7: found 0.5 for 0.8"), HasSubstr("point 1 of 1")));
}

}  // namespace
}  // namespace percal
