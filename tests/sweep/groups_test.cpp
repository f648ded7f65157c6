// Sweeps of dimensionless groups: the scenes have the numbers that were asked for, as percal scale computes them.
#include "percal/scaling/groups.hpp"

#include <gtest/gtest.h>

#include "percal/scaling/similar_scene.hpp"
#include "sweep/small_plan.hpp"

namespace percal {
namespace {

using test::listed_sweep;

class SweptGroups : public test::PlanFolder {
 protected:
  static double value_of(int number, const Scene& scene) { return *value(group(number), system_of(scene).system); }
};

TEST_F(SweptGroups, EveryGroupHasTheValueAskedForAndTheOthersStay) {
  const Scene before = scene_at(plan(listed_sweep("target.alpha", "[8.65]")), 0);
  const std::vector<std::pair<int, double>> asked{{1, 30}, {2, 8}, {3, 0.01}, {4, 44}, {5, 0.3}, {6, 5}, {7, 0.6}};
  for (const auto& [number, wanted] : asked) {
    const Scene scene = scene_at(plan(listed_sweep(group(number).symbol, "[" + std::to_string(wanted) + "]")), 0);
    EXPECT_NEAR(value_of(number, scene) / wanted, 1, 1e-12) << number;
    for (const int other : {1, 4, 5, 6, 7})
      if (other != number) {
        EXPECT_NEAR(value_of(other, scene) / value_of(other, before), 1, 1e-12) << other << " beside " << number;
      }
  }
}

TEST_F(SweptGroups, AreChangedByTheNumberThatThePlanNames) {
  const Scene by_mu = scene_at(plan(listed_sweep("pi4", "[44]")), 0),
              by_speed = scene_at(plan(listed_sweep("pi4", "[44]", "by = \"speed\"\n")), 0);
  EXPECT_EQ(by_mu.particle.speed, 180);
  EXPECT_EQ(by_speed.target.mu_as_given, 346e3);
  EXPECT_NEAR(value_of(4, by_speed) / 44, 1, 1e-12);
  EXPECT_NEAR(by_mu.target.mu_as_given, 1010 * 180.0 * 180 / 44, 1);
}

TEST_F(SweptGroups, HoldTogetherWhateverTheyAreChangedBy) {
  const Plan p =
      plan(listed_sweep("pi3", "[0.02]") + listed_sweep("pi4", "[20, 60]", "by = \"speed\"\n") +
           listed_sweep("density_ratio", "[0.2, 1]", "by = \"target_density\"\n") + listed_sweep("pi6", "[3]"));
  for (std::size_t k = 0; k < p.points.size(); ++k) {
    const Scene scene = scene_at(p, k);
    EXPECT_NEAR(value_of(3, scene) / 0.02, 1, 1e-12);
    EXPECT_NEAR(value_of(4, scene) / p.points[k].values[1].number, 1, 1e-12);
    EXPECT_NEAR(value_of(5, scene) / p.points[k].values[2].number, 1, 1e-12);
    EXPECT_EQ(scene.target.alpha, 3);
  }
}

// mu as LS-DYNA has it: the true modulus is alpha/2 of what the scene says.
TEST_F(SweptGroups, KeepTheScenesConventions) {
  std::string text = test::small_scene;
  text.replace(text.find("alpha ="), 7, "convention = \"mu/alpha\"\nalpha =");
  text.replace(text.find("strain = 1.0"), 12, "strain = 0.5\nmeasure = \"true\"");
  write("scene.toml", text);
  const Scene scene =
      scene_at(plan(listed_sweep("pi4", "[44]") + listed_sweep("pi6", "[4]") + listed_sweep("pi7", "[0.7]")), 0);
  EXPECT_NEAR(value_of(4, scene) / 44, 1, 1e-12);
  EXPECT_NEAR(value_of(7, scene), 0.7, 1e-12);
  EXPECT_NEAR(scene.target.mu_as_given * 4 / 2, 1010 * 180.0 * 180 / 44, 1);
  EXPECT_NEAR(std::get<StrainErosion>(scene.target.erosion).limit, std::log(1.7), 1e-12);
}

TEST_F(SweptGroups, AreTheProblemThatIsRun) {
  const auto points = points_to_run(plan(listed_sweep("pi4", "[44]") + listed_sweep("pi5", "[0.25]")));
  EXPECT_NEAR(points[0].reduction.problem.pi4, 44, 1e-9);
  EXPECT_NEAR(points[0].reduction.problem.density_ratio, 4, 1e-9);
}

}  // namespace
}  // namespace percal
