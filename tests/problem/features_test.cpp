// Profiles, layers, erosion by stress and energy, relaxation, Mach numbers: from the scene to the problem.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "percal/base/error.hpp"
#include "percal/math/polygon.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double pi = std::numbers::pi;

const std::string gelatin = R"([target]
density = "464 kg/m3"
mu = "113 kPa"
convention = "mu/alpha"
alpha = 8.5
depth = "119.25 mm"
width = "7.95 mm"
[target.erosion]
strain = 0.51
)";

Scene scene_of(const std::string& particle, const std::string& geometry = "plane strain",
               const std::string& rest = "") {
  return parse_scene("geometry = \"" + geometry + "\"\n[particle]\nspeed = \"50 m/s\"\n" + particle + gelatin + rest,
                     "x");
}

const std::string thesis_rhombus =
    "shape = \"rhombus\"\nside = \"6.0 mm\"\ntip_angle = \"60 deg\"\nmass = \"0.7027 g\"\nthickness = \"3.10 mm\"\n";
const std::string thesis_square =
    "shape = \"rhombus\"\nside = \"5.83 mm\"\ntip_angle = \"90 deg\"\nmass = \"0.7509 g\"\nthickness = \"2.90 mm\"\n";

RigidPolygon profile_of(const Problem& problem) { return std::get<RigidPolygon>(problem.particle); }
std::string key(const Scene& scene) { return evaluation_key(reduce(scene).problem, "level"); }

TEST(Profile, TheThesisRhombusHasItsClosedForms) {
  const Scene scene = scene_of(thesis_rhombus);
  EXPECT_NEAR(scene.particle.radius, 3e-3, 1e-17) << "half of 6 mm, since both triangles are equilateral";
  const Problem p = reduce(scene).problem;
  const RigidPolygon rhombus = profile_of(p);
  const double q = std::sqrt(3);  // half height over half width
  ASSERT_EQ(rhombus.vertices.size(), 4u);
  EXPECT_EQ(rhombus.vertices[0][0], 0);
  EXPECT_NEAR(rhombus.vertices[0][1], -q, 1e-11);
  EXPECT_EQ(rhombus.vertices[1], (std::array{1.0, 0.0}));
  EXPECT_EQ(rhombus.vertices[3], (std::array{-1.0, 0.0}));
  const double mass = 0.7027e-3 / 3.10e-3 / (464 * 9e-6);
  EXPECT_NEAR(rhombus.mass, mass, 1e-9);
  EXPECT_NEAR(rhombus.inertia, mass * (1 + q * q) / 6, 1e-9);
  EXPECT_NEAR(p.density_ratio, mass / (2 * q), 1e-10);
  EXPECT_FALSE(p.whole);
  EXPECT_EQ(p.geometry, Geometry::plane_strain);
}

TEST(Profile, TheThesisSquareHasItsClosedForms) {
  const Scene scene = scene_of(thesis_square);
  const double half = 5.83e-3 / std::sqrt(2);
  EXPECT_NEAR(scene.particle.radius, half, 1e-17);
  const RigidPolygon square = profile_of(reduce(scene).problem);
  const double mass = 0.7509e-3 / 2.90e-3 / (464 * half * half);
  EXPECT_NEAR(square.mass, mass, 1e-9);
  EXPECT_NEAR(square.inertia, mass * 2 / 6, 1e-9) << "m s^2/6 with s^2 = 2";
  EXPECT_THAT(square.vertices,
              ElementsAre(std::array{0.0, -1.0}, std::array{1.0, 0.0}, std::array{0.0, 1.0}, std::array{-1.0, 0.0}));
}

TEST(Profile, ASquareTurnedOnItsCornerIsTheRhombusWithARightAngleWhereverItsOutlineBegins) {
  const std::string rest = "orientation = \"45 deg\"\nmass = \"0.7509 g\"\nthickness = \"2.90 mm\"\n";
  const std::string expected = key(scene_of(thesis_square));
  for (const char* vertices :
       {R"([["0 mm", "0 mm"], ["5.83 mm", "0 mm"], ["5.83 mm", "5.83 mm"], ["0 mm", "5.83 mm"]])",
        R"([["1 mm", "12.83 mm"], ["1 mm", "7 mm"], ["6.83 mm", "7 mm"], ["6.83 mm", "12.83 mm"]])",
        R"([["0 m", "0.00583 m"], ["5830 um", "0.583 cm"], ["5830 um", "0 m"], ["0 m", "0 m"]])"})
    EXPECT_EQ(key(scene_of("shape = \"profile\"\nvertices = " + std::string(vertices) + "\n" + rest)), expected);
}

TEST(Profile, ItDoesNotMatterWithWhichCornerAnAsymmetricOutlineBegins) {
  const std::array corners{R"(["0 mm", "0 mm"])", R"(["5 mm", "1 mm"])", R"(["4 mm", "6 mm"])",
                           R"(["0.7 mm", "3 mm"])"};
  std::string expected;
  for (int first = 0; first < 4; ++first) {
    std::string list;
    for (int i = 0; i < 4; ++i) list += std::string(i == 0 ? "" : ", ") + corners[(first + i) % 4];
    const std::string found = key(scene_of("shape = \"profile\"\ndensity = \"7 t/m3\"\nvertices = [" + list + "]\n"));
    if (first == 0) expected = found;
    EXPECT_EQ(found, expected);
  }
}

TEST(Profile, WhatIsNotItsOwnMirrorImageOrMayTurnIsComputedWhole) {
  EXPECT_TRUE(reduce(scene_of(thesis_square + "orientation = \"10 deg\"\n")).problem.whole);
  EXPECT_TRUE(reduce(scene_of(thesis_square + "rotation = \"free\"\n")).problem.whole);
  EXPECT_TRUE(reduce(scene_of(thesis_square, "plane strain", "[mesh]\nwhole = true\n")).problem.whole);
  EXPECT_FALSE(reduce(scene_of(thesis_square)).problem.whole);
  Scene made_by_hand = scene_of(thesis_square + "rotation = \"free\"\n");
  made_by_hand.mesh.whole = false;
  EXPECT_TRUE(reduce(made_by_hand).problem.whole);
}

TEST(Profile, OneThatMirrorsAnotherHasMirroredBits) {
  const RigidPolygon left = profile_of(reduce(scene_of(thesis_rhombus + "orientation = \"20 deg\"\n")).problem),
                     right = profile_of(reduce(scene_of(thesis_rhombus + "orientation = \"-20 deg\"\n")).problem);
  ASSERT_EQ(left.vertices.size(), right.vertices.size());
  for (std::size_t i = 0; i < left.vertices.size(); ++i) {
    const auto& [x, y] = left.vertices[(left.vertices.size() - i) % left.vertices.size()];
    EXPECT_EQ(right.vertices[i], (std::array{-x, y}));
  }
  EXPECT_EQ(left.mass, right.mass);
}

TEST(Profile, OneThatIsSymmetricToATenthOfItsToleranceIsSoToTheLastBit) {
  const RigidPolygon profile = profile_of(
      reduce(scene_of("shape = \"profile\"\ndensity = \"7 t/m3\"\nvertices = [[\"-1 mm\", \"0 mm\"], [\"1.0000000002 "
                      "mm\", \"0 mm\"], "
                      "[\"3 mm\", \"5 mm\"], [\"0.0000000003 mm\", \"7 mm\"], [\"-3 mm\", \"5.0000000004 mm\"]]\n"))
          .problem);
  ASSERT_EQ(profile.vertices.size(), 5u);
  for (const auto& [x, y] : profile.vertices) EXPECT_THAT(profile.vertices, testing::Contains(std::array{0.0 - x, y}));
}

// Cone of full tip angle 60: H = R sqrt 3; volume R^2 H/6 per radian, inertia (3/80) m (4 R^2 + H^2).
TEST(Profile, AConeHasItsClosedFormsPerRadian) {
  const Problem p =
      reduce(scene_of("shape = \"cone\"\nradius = \"2 mm\"\ntip_angle = \"60 deg\"\ndensity = \"928 kg/m3\"\n",
                      "axisymmetric"))
          .problem;
  const double height = std::sqrt(3), mass = 2 * height / 6;
  const RigidPolygon cone = profile_of(p);
  EXPECT_NEAR(cone.mass, mass, 1e-11);
  EXPECT_NEAR(cone.inertia, 3.0 / 80 * mass * (4 + height * height), 1e-11);
  ASSERT_EQ(cone.vertices.size(), 3u);
  EXPECT_EQ(cone.vertices[0][0], 0);
  EXPECT_NEAR(cone.vertices[0][1], -0.75 * height, 1e-11) << "centre of mass a quarter of the height from the base";
  EXPECT_FALSE(p.whole);
  EXPECT_EQ(p.density_ratio, 2);
}

TEST(Profile, AConeByItsMassByItsDensityAndByItsHalfMeridianIsOneProblem) {
  const std::string whole =
      "shape = \"profile\"\nvertices = [[\"0 mm\", \"0 mm\"], [\"2 mm\", \"3 mm\"], [\"-2 mm\", \"3 mm\"]]\n";
  const std::string half =
      "shape = \"profile\"\nvertices = [[\"0 mm\", \"3 mm\"], [\"0 mm\", \"0 mm\"], [\"2 mm\", \"3 mm\"]]\n";
  const std::string expected = key(scene_of(whole + "density = \"928 kg/m3\"\n", "axisymmetric"));
  EXPECT_EQ(key(scene_of(half + "density = \"928 kg/m3\"\n", "axisymmetric")), expected);
  const double volume = pi / 3 * 4e-6 * 3e-3;
  EXPECT_EQ(key(scene_of(half + fmt::format("mass = \"{} kg\"\n", 928 * volume), "axisymmetric")), expected);
}

TEST(Profile, EveryNumberOfItHasTwelveDigitsAndNoNegativeZero) {
  const RigidPolygon profile = profile_of(reduce(scene_of(thesis_rhombus + "orientation = \"17 deg\"\n")).problem);
  for (const auto& [x, y] : profile.vertices)
    for (const double number : {x, y}) EXPECT_EQ(number, round_to_12_digits(number));
  EXPECT_EQ(profile.mass, round_to_12_digits(profile.mass));
  EXPECT_EQ(profile.inertia, round_to_12_digits(profile.inertia));
  const RigidPolygon square = profile_of(reduce(scene_of(thesis_square)).problem);
  for (const auto& [x, y] : square.vertices) EXPECT_FALSE((x == 0 && std::signbit(x)) || (y == 0 && std::signbit(y)));
}

// A scene with everything, and the similar one with radius x a, speed x v, density x rho, all else after the groups.
Scene everything(double a, double v, double rho) {
  Scene scene;
  scene.geometry = Geometry::plane_strain;
  const auto at = [a](double x, double y) { return std::array{a * x, a * y}; };
  scene.particle = {.name = "p",
                    .shape = ProfileShape{.vertices_file = "",
                                          .vertices = {at(-1, 0), at(0, -2), at(1, 0), at(0, 1)},
                                          .orientation = 0.3,
                                          .mass = 3.3 * rho * a * a,
                                          .free_rotation = true},
                    .radius = 0,
                    .density = 0,
                    .speed = v,
                    .youngs_modulus = {}};
  const auto& profile = std::get<ProfileShape>(scene.particle.shape);
  scene.particle.radius = half_width(turned(profile.vertices, profile.orientation));
  const double stress = rho * v * v;
  scene.target = {
      .name = "top", .density = rho, .mu_as_given = 0.1 * stress, .alpha = 9, .depth = 3 * a, .width = 7 * a};
  scene.target.erosion = StressErosion{0.7 * stress};
  scene.target.further_erosion.energy = 0.9 * stress;
  scene.target.fibres = PlanarFibres{0.2 * stress, 3, 0.4};
  scene.target.relaxation = PronySeries{{{0.3, 0.7 * a / v}, {0.1, 7 * a / v}}};
  scene.below = {{.name = "below",
                  .density = 1.1 * rho,
                  .mu_as_given = 0.3 * stress,
                  .alpha = 3,
                  .volumetric = PoissonRatio{0.49},
                  .depth = 40 * a,
                  .erosion_limit = 1.3 * stress,
                  .further_erosion = {.energy = 1.7 * stress}}};
  return scene;
}

TEST(Reduce, SimilarSystemsWithEveryFeatureAreOneProblem) {
  const std::string expected = key(everything(1e-6, 651, 1000));
  EXPECT_EQ(key(everything(1.59e-3, 83, 464)), expected);
  EXPECT_EQ(key(everything(0.7, 3, 1010)), expected);
  EXPECT_NE(key(everything(1.59e-3, 83, 464)), "");
}

TEST(Reduce, SimilarElasticSpheresErodingByEnergyAreOneProblem) {
  const auto sphere = [](double a, double v, double rho) {
    Scene scene = everything(a, v, rho);
    scene.geometry = Geometry::axisymmetric;
    scene.particle = {.name = "p", .radius = a, .density = 7 * rho, .speed = v, .youngs_modulus = 30 * rho * v * v};
    scene.target.erosion = EnergyErosion{0.2 * rho * v * v};
    scene.target.erosion_average = AverageWithin{0.3 * a};
    return scene;
  };
  EXPECT_TRUE(std::holds_alternative<ElasticSphere>(reduce(sphere(1, 1, 1)).problem.particle));
  EXPECT_EQ(key(sphere(1e-6, 651, 1000)), key(sphere(1.59e-3, 83, 464)));
}

TEST(Reduce, ErosionLimitsAreOverTheImpactPressureAndRelaxationTimesInRadii) {
  const Scene scene = everything(2e-3, 50, 1000);  // rho_t v^2 = 2.5 MPa
  const Problem p = reduce(scene).problem;
  const double a = scene.particle.radius;
  EXPECT_NEAR(std::get<StressErosion>(p.erosion).limit, 0.7, 1e-12);
  EXPECT_NEAR(p.below.at(0).erosion_limit, 1.3, 1e-12);
  EXPECT_NEAR(p.further_erosion.energy.value(), 0.9, 1e-12);
  EXPECT_NEAR(std::get<PlanarFibres>(p.fibres).k1, 0.2, 1e-12);
  EXPECT_NEAR(p.below.at(0).further_erosion.energy.value(), 1.7, 1e-12);
  const auto& terms = std::get<PronySeries>(p.relaxation).terms;
  EXPECT_EQ(terms.at(0).share, 0.3);
  EXPECT_NEAR(terms.at(1).time, 7 * 2e-3 / a, 1e-11);
  EXPECT_NEAR(p.below.at(0).mu, 0.3, 1e-12);
  EXPECT_NEAR(p.below.at(0).density, 1.1, 1e-12);
  EXPECT_NEAR(p.below.at(0).bulk_ratio, bulk_to_shear(0.49), 1e-9);
  EXPECT_NEAR(p.whole_depth(), 43 * 2e-3 / a, 1e-10);
}

TEST(Reduce, StrainLimitsStayAndALayerWithoutALimitDoesNotErode) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.target.erosion = StrainErosion{0.7};
  scene.below[0].erosion_limit = 0.9;
  EXPECT_EQ(reduce(scene).problem.below[0].erosion_limit, 0.9);
  scene.below[0].erosion_limit.reset();
  EXPECT_EQ(reduce(scene).problem.below[0].erosion_limit, std::numeric_limits<double>::infinity());
}

// By the diameter; a particle just as large as a cell is not smaller.
TEST(Reduce, AStrainForParticlesSmallerThanACellHoldsForThoseAlone) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.target.further_erosion = {};
  scene.target.erosion = StrainErosion{0.7};
  scene.below[0].erosion_limit = 0.9;
  const double diameter = 2 * scene.particle.radius;
  const auto limits_with = [&](double cell) {
    scene.target.erosion_by_size = SmallerThanCell{cell, 0.3};
    scene.below[0].erosion_by_size = SmallerThanCell{cell, 0.4};
    const Problem p = reduce(scene).problem;
    return std::pair(std::get<StrainErosion>(p.erosion).limit, p.below[0].erosion_limit);
  };
  EXPECT_EQ(limits_with(diameter), std::pair(0.7, 0.9));
  EXPECT_EQ(limits_with(0.99 * diameter), std::pair(0.7, 0.9));
  EXPECT_EQ(limits_with(1.01 * diameter), std::pair(0.3, 0.4));
}

TEST(Reduce, FrictionOfAnElasticParticleIsRefusedByNameAndNoneIsNone) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.geometry = Geometry::axisymmetric;
  scene.particle = {.name = "p",
                    .radius = 1e-3,
                    .density = 7000,
                    .speed = 50,
                    .youngs_modulus = 75e6,
                    .friction = CoulombFriction{0.2}};
  try {
    reduce(scene);
    FAIL() << "accepted";
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("particle.friction: found 0.2 of a particle that is elastic"));
  }
  scene.particle.elasticity = Elasticity::rigid;
  EXPECT_EQ(friction_coefficient(reduce(scene).problem), 0.2);
  scene.particle.friction = NoFriction{};
  EXPECT_EQ(friction_coefficient(reduce(scene).problem), 0);
}

TEST(Reduce, AStretchThatReachesTheErosionStrainIsRefused) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.target.further_erosion = {};
  scene.target.erosion = StrainErosion{0.3, StrainMeasure::true_strain};  // a stretch of 1.35
  scene.target.stretch = scene.below[0].stretch = 1.34;
  scene.below[0].erosion_limit = 0.3;
  EXPECT_EQ(reduce(scene).problem.stretch, 1.34);
  scene.below[0].stretch = 1.36;
  try {
    reduce(scene);
    FAIL() << "accepted";
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("below[1].stretch: found 1.36, which reaches the erosion strain of 0.3"));
  }
  scene.below[0].erosion_limit.reset();
  EXPECT_EQ(reduce(scene).problem.below[0].stretch, 1.36) << "it does not erode";
}

TEST(Reduce, ALengthOfErosionIsInRadiiAndOneAboveARadiusWarns) {
  Scene scene = scene_of(thesis_rhombus, "plane strain", "length = \"1.2 mm\"\n");
  scene.target.width.reset();  // the thesis's wall is too near for no warning
  EXPECT_EQ(std::get<AverageWithin>(reduce(scene).problem.erosion_average).length, 0.4);
  EXPECT_THAT(reduce(scene).warnings, IsEmpty());
  scene.target.erosion_average = AverageWithin{4e-3};
  EXPECT_THAT(reduce(scene).warnings, ElementsAre(HasSubstr("erosion is judged over 1.33 radii")));
  scene.target.erosion = NoErosion{};
  EXPECT_TRUE(std::holds_alternative<NoAverage>(reduce(scene).problem.erosion_average));
}

// Whoever changes the mesh after the scene was read is told as well.
TEST(Reduce, AMeshTooCoarseForTheLengthOfErosionIsRefused) {
  Scene scene = scene_of(thesis_rhombus, "plane strain", "length = \"1.2 mm\"\n");
  scene.mesh.elements_per_radius = 8;  // 3.2 elements
  EXPECT_NO_THROW(reduce(scene));
  scene.mesh.elements_per_radius = 7;
  try {
    reduce(scene);
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("target.erosion.length: found 1.2 mm (0.4 radii), 2.8 elements of 1/7"));
    EXPECT_THAT(error.what(), HasSubstr("or elements_per_radius = 8"));
  }
}

TEST(Mach, IsThatOfTheLayerWithTheSlowestWaves) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.target.volumetric = BulkToShear{500};
  scene.below[0].volumetric = BulkToShear{20};
  // c^2 of the layer below: (20 + 4/3) 0.3/1.1 v^2
  EXPECT_NEAR(reduce(scene).mach, 1 / std::sqrt((20 + 4.0 / 3) * 0.3 / 1.1), 1e-9);
  scene.below[0].volumetric = BulkToShear{5000};
  EXPECT_NEAR(reduce(scene).mach, 1 / std::sqrt((500 + 4.0 / 3) * 0.1), 1e-9);
}

TEST(Mach, EveryLayersBulkModulusIsChosenForIt) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.target.width.reset();
  scene.target.mu_as_given /= 100;  // pi4 = 1000
  scene.below[0].mu_as_given /= 300;
  scene.below[0].volumetric = ChooseBulk{};
  EXPECT_LT(reduce(scene).mach, 0.3);
  EXPECT_GT(reduce(scene).problem.below[0].bulk_ratio, 50);
  EXPECT_THAT(reduce(scene).warnings, IsEmpty());
}

TEST(Mach, AWarningNamesIt) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.target.width.reset();
  scene.below.clear();
  scene.target.volumetric = BulkToShear{50};  // M^2 = 10/51.3
  EXPECT_THAT(reduce(scene).warnings,
              ElementsAre(HasSubstr("Mach number 0.441 is above 0.3: the depth may depend on K")));
  scene.target.volumetric = BulkToShear{2};
  EXPECT_THAT(reduce(scene).warnings,
              ElementsAre(HasSubstr("Mach number 1.73: the impact is faster than the target's waves")));
}

TEST(Mach, OnlyASupersonicLayerIsStiffenedAndOnlyOnRequest) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.target.width.reset();
  scene.target.volumetric = BulkToShear{2};
  scene.below[0].volumetric = BulkToShear{5};  // M = 0.76: kept
  EXPECT_EQ(reduce(scene).problem.bulk_ratio, 2);
  scene.solver.stiffen_supersonic = true;
  const Reduction stiffened = reduce(scene);
  EXPECT_NEAR(stiffened.problem.bulk_ratio, subsonic_bulk_ratio(10), 1e-9);
  EXPECT_EQ(stiffened.problem.below[0].bulk_ratio, 5);
  EXPECT_THAT(stiffened.warnings,
              ElementsAre(HasSubstr("top: K/mu = 2 makes the impact supersonic (Mach number 1.73); raised to 110.9"),
                          HasSubstr("Mach number 0.761 is above 0.3")));
  EXPECT_NEAR(stiffened.bulk_modulus, stiffened.problem.bulk_ratio * stiffened.mu_true, 1e-3);
}

std::vector<std::string> left_out_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& omission : reduce(scene).left_out) names.push_back(omission.what);
  return names;
}

TEST(Reduce, AStiffLayerBelowCanMakeTheParticleElastic) {
  Scene scene = everything(1e-3, 50, 1000);
  scene.geometry = Geometry::axisymmetric;
  scene.particle = {.name = "p", .radius = 1e-3, .density = 7000, .speed = 50, .youngs_modulus = 1e9};
  scene.below[0].mu_as_given = 1e6;  // (1100 50^2 + 1e7)/1e9 = 0.0128
  EXPECT_TRUE(std::holds_alternative<RigidSphere>(reduce(scene).problem.particle));
  scene.below[0].mu_as_given = 2e6;
  EXPECT_TRUE(std::holds_alternative<ElasticSphere>(reduce(scene).problem.particle));
}

TEST(LeftOut, NamesOnlyWhatTheSceneDoesNotHave) {
  EXPECT_THAT(left_out_of(scene_of(thesis_square)),
              ElementsAre("elastic particle", "rotation", "friction", "second half", "history", "radius of the channel",
                          "what follows the deepest point", "rate dependence", "initial stretch", "fibres",
                          "further layers", "rows at rest", "contact away from the particle", "double precision"));
  Scene all = everything(1e-3, 50, 1000);
  all.output = {.history = true, .after = RunUntil::rest, .channel = true};
  all.particle.friction = CoulombFriction{0.1};
  all.solver.arithmetic = Arithmetic::double_precision;
  EXPECT_THAT(left_out_of(all),
              ElementsAre("elastic particle", "initial stretch", "rows at rest", "contact away from the particle"));
}

TEST(LeftOut, AProfileOfSoftMaterialStaysRigidWithAWarning) {
  const Reduction reduction = reduce(scene_of(thesis_square + "youngs_modulus = \"10 MPa\"\n"));
  EXPECT_TRUE(std::holds_alternative<RigidPolygon>(reduction.problem.particle));
  EXPECT_THAT(reduction.left_out.front().why, HasSubstr("only a sphere in an axisymmetric scene can be elastic"));
  EXPECT_THAT(reduction.warnings, ElementsAre(HasSubstr("may matter"), HasSubstr("nearer than the 5")));
}

}  // namespace
}  // namespace percal
