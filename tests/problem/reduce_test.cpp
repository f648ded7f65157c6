#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "percal/problem/domain.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* skin = R"([particle]
radius = "1 um"
density = "16800 kg/m3"
speed = "651 m/s"
youngs_modulus = "79 GPa"
[target]
density = "1000 kg/m3"
mu = "15 MPa"
convention = "mu/alpha"
alpha = 8.5
depth = "75 um"
width = "5 um"
[target.erosion]
strain = 0.7
)";

Scene skin_scene() { return parse_scene(skin, "skin.toml"); }

std::string key_of(const Scene& scene) { return evaluation_key(reduce(scene).problem, "level"); }

// The reason given for leaving `what` out; empty where it is not on the list.
std::string why_left_out(const Reduction& reduction, const std::string& what) {
  for (const auto& omission : reduction.left_out)
    if (omission.what == what) return omission.why;
  return "";
}

TEST(Reduce, GivesTheGroupsOfTheScene) {
  const Reduction reduction = reduce(skin_scene());
  EXPECT_NEAR(reduction.mu_true, 15e6 * 8.5 / 2, 1e-6);
  EXPECT_NEAR(reduction.problem.pi4, 1000 * 651.0 * 651 / 63.75e6, 1e-11);
  EXPECT_NEAR(reduction.problem.density_ratio, 16.8, 1e-11);
  EXPECT_EQ(reduction.problem.depth, 75);
  EXPECT_EQ(reduction.problem.width, 5);
  EXPECT_EQ(reduction.scales.radius, 1e-6);
  EXPECT_EQ(reduction.scales.speed, 651);
  EXPECT_EQ(reduction.scales.target_density, 1000);
  EXPECT_DOUBLE_EQ(reduction.problem.mu(), 1 / reduction.problem.pi4);
}

TEST(Reduce, TheSameSceneInOtherUnitsIsTheSameProblem) {
  const Scene other = parse_scene(R"([particle]
radius = "0.001 mm"
density = "16.8 g/cm3"
speed = "0.651 km/s"
youngs_modulus = "79000 MPa"
[target]
density = "1 g/cm3"
mu = "15000 kPa"
convention = "mu/alpha"
alpha = 8.5
depth = "0.075 mm"
width = "5000 nm"
[target.erosion]
strain = 0.7
)",
                                  "other.toml");
  EXPECT_EQ(key_of(other), key_of(skin_scene()));
}

TEST(Reduce, TheTrueModulusIsTheSameProblemAsLsDynasMu1) {
  Scene other = skin_scene();
  other.target.convention = ModulusConvention::true_shear;
  other.target.mu_as_given = 63.75e6;
  EXPECT_EQ(key_of(other), key_of(skin_scene()));
}

TEST(Reduce, GoldIntoSkinAndSteelIntoGelatinAreOneProblem) {
  const std::string folder = std::string(PERCAL_DATA) + "/guha2009/";
  EXPECT_EQ(key_of(read_scene(folder + "gold.toml")), key_of(read_scene(folder + "steel.toml")));
}

TEST(Reduce, RoundsToTwelveDigits) {
  EXPECT_EQ(round_to_12_digits(0.1 + 0.2), 0.3);
  EXPECT_EQ(round_to_12_digits(1.234567890124e-7), 1.23456789012e-7);
  EXPECT_EQ(round_to_12_digits(-98765432109876.0), -98765432109900.0);
  EXPECT_EQ(round_to_12_digits(0), 0);
  EXPECT_EQ(round_to_12_digits(round_to_12_digits(1.0 / 7)), round_to_12_digits(1.0 / 7));
  EXPECT_NE(round_to_12_digits(1.00000000001), 1) << "the twelfth digit counts";
}

TEST(Reduce, EveryNumberOfTheProblemHasTwelveDigits) {
  Scene scene = skin_scene();
  scene.particle.radius = 0.7e-6;
  scene.particle.density = 16811;
  scene.particle.speed = 613.7;
  scene.target.density = 1063;
  scene.solver.end_time = 1e-7 / 3;
  scene.target.volumetric = PoissonRatio{0.4837};
  scene.target.alpha = 25.0 / 3;
  scene.mesh.fine_width = 4.0 / 3;
  const Problem p = reduce(scene).problem;
  for (const double number :
       {p.pi4, p.density_ratio, p.alpha, p.bulk_ratio, p.depth, p.width, p.fine_width, p.end_time})
    EXPECT_EQ(number, round_to_12_digits(number));
}

TEST(Reduce, ChoosesABulkModulusOfAtLeastFiftyMu) {
  Scene slow = skin_scene();
  slow.particle.speed = 100;
  const Reduction reduction = reduce(slow);
  EXPECT_EQ(reduction.problem.bulk_ratio, 50);
  EXPECT_TRUE(reduction.bulk_was_chosen);
  EXPECT_DOUBLE_EQ(reduction.bulk_modulus, 50 * 63.75e6);
  EXPECT_LT(reduction.mach, 0.3);
}

TEST(Reduce, ChoosesABulkModulusForAMachNumberBelowThreeTenths) {
  for (const double speed : {300.0, 651.0, 2000.0, 30000.0}) {
    Scene fast = skin_scene();
    fast.particle.speed = speed;
    const Reduction reduction = reduce(fast);
    EXPECT_LT(reduction.mach, 0.3) << speed;
    EXPECT_GE(reduction.problem.bulk_ratio, 50) << speed;
    if (reduction.problem.bulk_ratio > 50) {
      EXPECT_GT(reduction.mach, 0.295) << "no stiffer, and so no dearer, than it must be";
    }
  }
}

TEST(Reduce, KeepsTheBulkModulusThatTheSceneGives) {
  Scene scene = skin_scene();
  scene.target.volumetric = PoissonRatio{0.49};
  EXPECT_NEAR(reduce(scene).problem.bulk_ratio, 2 * 1.49 / (3 * 0.02), 1e-9);
  EXPECT_FALSE(reduce(scene).bulk_was_chosen);
  scene.target.volumetric = BulkToShear{2};
  EXPECT_EQ(reduce(scene).problem.bulk_ratio, 2);
  EXPECT_GT(reduce(scene).mach, 1) << "also where it makes the impact supersonic";
}

TEST(Reduce, TheMachNumberIsSpeedOverTheDilatationalWaveSpeed) {
  Scene scene = skin_scene();
  scene.target.volumetric = BulkToShear{50};
  const Reduction reduction = reduce(scene);
  const double wave_speed = std::sqrt((reduction.bulk_modulus + 4.0 / 3 * reduction.mu_true) / 1000);
  EXPECT_NEAR(reduction.mach, 651 / wave_speed, 1e-11);
}

TEST(Reduce, GradedColumnsGrowByAFifthWhereTheSceneDoesNotSay) {
  Scene scene = skin_scene();
  for (const double n : {14.0, 9.66, 7.0}) {
    scene.mesh.elements_per_radius = n;
    const Reduction reduction = reduce(scene);
    EXPECT_EQ(reduction.problem.elements_per_radius, n);
    EXPECT_EQ(reduction.problem.graded_columns, usual_graded_columns(reduction.problem)) << n;
    EXPECT_TRUE(reduction.mesh.columns_were_chosen);
    EXPECT_LE(reduction.mesh.growth, usual_growth);
    EXPECT_EQ(reduction.mesh.columns, std::ceil(n) + reduction.problem.graded_columns);
    EXPECT_THAT(reduction.warnings, IsEmpty());
  }
  scene.mesh.graded_columns = 23;
  EXPECT_EQ(reduce(scene).problem.graded_columns, 23);
  EXPECT_FALSE(reduce(scene).mesh.columns_were_chosen);
}

TEST(Reduce, FewGradedColumnsStayAndAreWarnedOf) {
  Scene scene = skin_scene();
  scene.mesh.graded_columns = 5;
  EXPECT_THAT(reduce(scene).warnings, ElementsAre(HasSubstr("expect 3 to 4 % in depth")));
  scene.mesh.graded_columns = 9;  // growth 1.29
  EXPECT_THAT(reduce(scene).warnings, IsEmpty());
}

TEST(Reduce, TheWidthFollowsTheShotWhereTheSceneDoesNotSay) {
  Scene scene = skin_scene();
  EXPECT_FALSE(reduce(scene).mesh.width_was_chosen);
  scene.target.width.reset();
  EXPECT_EQ(reduce(scene).problem.width, 5);
  EXPECT_TRUE(reduce(scene).mesh.width_was_chosen);
  scene.target.mu_as_given /= 10;  // pi4 = 66, and gold is heavy
  EXPECT_EQ(reduce(scene).problem.width, 20);
  EXPECT_THAT(reduce(scene).warnings, IsEmpty());
  scene.target.width = 5e-6;
  EXPECT_EQ(reduce(scene).problem.width, 5);
  EXPECT_THAT(reduce(scene).warnings, ElementsAre(HasSubstr("nearer than the 20")));
}

TEST(Reduce, TheEndTimeIsInRadiiAtImpactSpeed) {
  Scene scene = skin_scene();
  EXPECT_EQ(reduce(scene).problem.end_time, 1000);
  scene.solver.end_time = 1e-6 / 651;
  EXPECT_NEAR(reduce(scene).problem.end_time, 1, 1e-11);
}

TEST(LeftOut, AParticleWithoutAYoungsModulusIsRigid) {
  Scene scene = skin_scene();
  scene.particle.youngs_modulus.reset();
  const Reduction reduction = reduce(scene);
  EXPECT_THAT(why_left_out(reduction, "elastic particle"), HasSubstr("no Young's modulus"));
  EXPECT_THAT(reduction.warnings, IsEmpty());
}

// (rho_t v^2 + 10 mu)/E = (1000 651^2 + 10 63.75e6)/E: 0.02 lies at E = 53.06 GPa.
TEST(LeftOut, AStiffParticleIsRigidByTheRuleAndASofterOneElastic) {
  Scene scene = skin_scene();
  scene.particle.youngs_modulus = 53.2e9;
  const Reduction stiff = reduce(scene);
  EXPECT_THAT(why_left_out(stiff, "elastic particle"), HasSubstr("is below 0.02: rigid"));
  EXPECT_THAT(stiff.warnings, IsEmpty());
  scene.particle.youngs_modulus = 52.9e9;
  const Reduction soft = reduce(scene);
  EXPECT_THAT(why_left_out(soft, "elastic particle"), IsEmpty());
  const auto* sphere = std::get_if<ElasticSphere>(&soft.problem.particle);
  ASSERT_TRUE(sphere);
  EXPECT_NEAR(sphere->youngs_modulus, 52.9e9 / (1000 * 651.0 * 651), 1e-9);
  EXPECT_EQ(sphere->poisson_ratio, 0.3);
  scene.particle.elasticity = Elasticity::rigid;
  const Reduction kept_rigid = reduce(scene);
  EXPECT_TRUE(std::holds_alternative<RigidSphere>(kept_rigid.problem.particle));
  EXPECT_THAT(why_left_out(kept_rigid, "elastic particle"), HasSubstr("the scene wants a rigid particle"));
  EXPECT_THAT(kept_rigid.warnings, ElementsAre(HasSubstr("the particle's elasticity, left out here, may matter")));
  scene.particle.youngs_modulus = 1e15;
  scene.particle.elasticity = Elasticity::elastic;
  EXPECT_TRUE(std::holds_alternative<ElasticSphere>(reduce(scene).problem.particle)) << "because the scene asks for it";
}

TEST(LeftOut, ErosionAndHistoryAreListedOnlyWhereTheyAreNotAskedFor) {
  Scene scene = skin_scene();
  EXPECT_THAT(why_left_out(reduce(scene), "erosion"), IsEmpty());
  EXPECT_THAT(why_left_out(reduce(scene), "history"), HasSubstr("nobody asked"));
  EXPECT_EQ(reduce(scene).problem.history_samples, 0);
  scene.target.erosion = NoErosion{};
  EXPECT_THAT(why_left_out(reduce(scene), "what follows the deepest point"), HasSubstr("wants the deepest point"));
  scene.output = {.history = true, .after = RunUntil::rest, .channel = true};
  EXPECT_THAT(why_left_out(reduce(scene), "erosion"), HasSubstr("gives no limit"));
  EXPECT_THAT(why_left_out(reduce(scene), "history"), IsEmpty());
  EXPECT_GT(reduce(scene).problem.history_samples, 0);
  EXPECT_EQ(reduce(scene).problem.until, RunUntil::rest);
  EXPECT_TRUE(reduce(scene).problem.channel);
}

TEST(Reduce, AContactStiffnessIsToldToHaveNoEffect) {
  Scene scene = skin_scene();
  const std::string key = key_of(scene);
  scene.solver.contact_stiffness_was_given = true;
  EXPECT_THAT(reduce(scene).warnings, ElementsAre("contact_stiffness has no effect: contact has no springs any more"));
  EXPECT_EQ(key_of(scene), key);
}

}  // namespace
}  // namespace percal
