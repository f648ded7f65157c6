#include "percal/scene/scene_toml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "percal/scene/profile.hpp"
#include "percal/text/file.hpp"
#include "scene/refusal.hpp"
#include "support/replaced.hpp"

namespace percal {
namespace {

using test::refusal;
using test::replaced;
using testing::AllOf;
using testing::HasSubstr;

const std::string particle = "[particle]\nradius = \"1 um\"\ndensity = \"16800 kg/m3\"\nspeed = \"600 m/s\"\n";
const std::string target =
    "[target]\ndensity = \"1060 kg/m3\"\nmu = \"15 MPa\"\nalpha = 9\ndepth = \"75 um\"\nwidth = \"5 um\"\n";

// The scene with `line` put in at the end of one table.
std::string with_particle(const std::string& line) { return particle + line + "\n" + target; }
std::string with_target(const std::string& line) { return particle + target + line + "\n"; }

TEST(SceneToml, TheShortestSceneHasTheDefaults) {
  const Scene scene = parse_scene(particle + target, "scene.toml");
  EXPECT_EQ(scene.source, "scene.toml");
  EXPECT_EQ(scene.particle.radius, 1e-6);
  EXPECT_EQ(scene.particle.density, 16800);
  EXPECT_EQ(scene.particle.speed, 600);
  EXPECT_EQ(scene.target.mu_as_given, 15e6);
  EXPECT_EQ(scene.target.alpha, 9);
  EXPECT_EQ(scene.target.depth, 75e-6);
  EXPECT_EQ(scene.target.width, 5e-6);
  EXPECT_EQ(scene.target.erosion, Erosion(NoErosion{}));
  EXPECT_EQ(scene.target.volumetric, VolumetricChoice(ChooseBulk{}));
  EXPECT_EQ(scene.mesh, MeshScene{});
  EXPECT_EQ(scene.solver, SolverScene{});
  EXPECT_EQ(scene.output, OutputScene{});
  EXPECT_EQ(scene.replicates, usual_replicates);
}

TEST(SceneToml, HourglassDefaultsToWhatItsFormNeeds) {
  const auto hourglass = [](const std::string& lines) {
    return parse_scene(particle + target + "[solver]\n" + lines, "scene.toml").solver.hourglass;
  };
  EXPECT_EQ(hourglass(""), 0.5);
  EXPECT_EQ(hourglass("hourglass_form = \"viscosity\""), 0.02);
  EXPECT_EQ(hourglass("hourglass = 0.1\nhourglass_form = \"viscosity\""), 0.1);
}

// Scenes of a time when contact had springs are still read, and say that they are.
TEST(SceneToml, AContactStiffnessIsReadAndNotWrittenAgain) {
  const Scene scene = parse_scene(particle + target + "[solver]\ncontact_stiffness = 0.6\n", "scene.toml");
  EXPECT_TRUE(scene.solver.contact_stiffness_was_given);
  EXPECT_EQ(scene_to_toml(scene, "").find("contact_stiffness"), std::string::npos);
  EXPECT_FALSE(parse_scene(particle + target, "scene.toml").solver.contact_stiffness_was_given);
}

TEST(SceneToml, EveryKeyIsRead) {
  const Scene scene = parse_scene(
      "replicates = 7\n[particle]\nshape = \"sphere\"\nname = \"gold\"\nradius = \"1 um\"\ndensity = \"16.8 "
      "g/cm3\"\nspeed = \"0.6 km/s\"\n"
      "youngs_modulus = \"78 GPa\"\n[target]\nname = \"skin\"\ndensity = \"1060 kg/m3\"\nmu = \"-15 MPa\"\nconvention "
      "= \"mu/alpha\"\n"
      "alpha = -9\nnu = 0.49\ndepth = \"75 um\"\nwidth = \"5 um\"\nbottom = \"fixed\"\n[target.erosion]\nstrain = "
      "0.7\nmeasure = \"green-lagrange\"\n"
      "[mesh]\nelements_per_radius = 14.25\nfine_width = 2\ngraded_columns = 7\n[solver]\nhourglass = 0.1\n"
      "linear_viscosity = 0\nquadratic_viscosity = 0.5\ntime_step_factor = 1\narithmetic = \"double\"\nend_time = \"3 "
      "us\"\n[output]\nhistory = true\nafter = \"rest\"\nchannel = true\n",
      "scene.toml");
  Scene expected;
  expected.source = "scene.toml";
  expected.replicates = 7;
  expected.particle = {.name = "gold", .radius = 1e-6, .density = 16800, .speed = 600, .youngs_modulus = 78e9};
  expected.target = {.name = "skin",
                     .density = 1060,
                     .mu_as_given = -15e6,
                     .convention = ModulusConvention::mu_over_alpha,
                     .alpha = -9,
                     .volumetric = PoissonRatio{0.49},
                     .depth = 75e-6,
                     .width = 5e-6,
                     .bottom = Bottom::fixed,
                     .erosion = StrainErosion{0.7, StrainMeasure::green_lagrange}};
  expected.mesh = {.elements_per_radius = 14.25, .fine_width = 2, .graded_columns = 7};
  expected.solver = {.hourglass = 0.1,
                     .linear_viscosity = 0,
                     .quadratic_viscosity = 0.5,
                     .time_step_factor = 1,
                     .arithmetic = Arithmetic::double_precision,
                     .end_time = 3e-6};
  expected.output = {.history = true, .after = RunUntil::rest, .channel = true};
  EXPECT_EQ(scene, expected);
  EXPECT_EQ(parse_scene(with_target("bulk_to_shear = 80"), "x").target.volumetric, VolumetricChoice(BulkToShear{80}));
}

TEST(SceneToml, AnUnknownShapeIsRefused) {
  EXPECT_THAT(refusal(with_particle("shape = \"cube\"")),
              HasSubstr("scene.toml:5: particle.shape: found \"cube\"; accepted: \"sphere\", \"cylinder\", "
                        "\"profile\", \"rhombus\", \"cone\""));
}

TEST(SceneToml, ValuesOutOfRangeAreRefused) {
  const std::string all = particle + target;
  EXPECT_THAT(refusal(replaced(all, "1 um", "-1 um")),
              HasSubstr("particle.radius: found \"-1 um\"; accepted: a positive length"));
  EXPECT_THAT(refusal(replaced(all, "1 um", "0 um")), HasSubstr("particle.radius"));
  EXPECT_THAT(refusal(replaced(all, "\"1 um\"", "1e-6")), HasSubstr("without a unit"));
  EXPECT_THAT(refusal(replaced(all, "600 m/s", "0 m/s")), HasSubstr("particle.speed"));
  EXPECT_THAT(refusal(replaced(all, "15 MPa", "0 MPa")),
              HasSubstr("scene.toml:7: target.mu: found 0 Pa; accepted: a positive pressure"));
  EXPECT_THAT(refusal(replaced(all, "15 MPa", "-15 MPa")), HasSubstr("target.mu"));
  EXPECT_THAT(refusal(replaced(all, "75 um", "1 um")),
              HasSubstr("target.depth: found \"1 um\"; accepted: a length above the particle's radius of 1 um"));
  EXPECT_THAT(refusal(replaced(all, "width = \"5 um\"", "width = \"1 um\"")), HasSubstr("target.width"));
  EXPECT_THAT(refusal(replaced(all, "alpha = 9", "alpha = 0")),
              AllOf(HasSubstr("target.alpha: found 0"), HasSubstr("not solved so far")));
  EXPECT_THAT(refusal(replaced(all, "alpha = 9", "alpha = -0.0009")), HasSubstr("target.alpha"));
  EXPECT_EQ(refusal(replaced(all, "alpha = 9", "alpha = -0.001")), "accepted");
  for (const char* line : {"nu = 0.5",
                           "nu = 0.7",
                           "nu = -1",
                           "nu = nan",
                           "bulk_to_shear = 0",
                           "bulk_to_shear = -3",
                           "bottom = \"loose\"",
                           "[target.erosion]\nstrain = 0",
                           "[target.erosion]\nstrain = -0.1",
                           "[target.erosion]",
                           "[target.erosion]\nstrain = 0.7\nmeasure = \"log\"",
                           "[mesh]\nelements_per_radius = 0.9",
                           "[mesh]\nelements_per_radius = 1001",
                           "[mesh]\nfine_width = 0",
                           "[mesh]\nfine_width = 6",
                           "[mesh]\ngraded_columns = 0",
                           "[solver]\ntime_step_factor = 0",
                           "[solver]\ntime_step_factor = 1.21",
                           "[solver]\ncontact_stiffness = 0",
                           "[solver]\nhourglass = -1",
                           "[solver]\nlinear_viscosity = -1",
                           "[solver]\nquadratic_viscosity = -1",
                           "[solver]\narithmetic = \"half\"",
                           "[solver]\nend_time = \"0 s\"",
                           "[solver]\nend_time = 3",
                           "[output]\nhistory = 1",
                           "[output]\nafter = \"a while\"",
                           "[output]\nafter = true",
                           "[output]\nchannel = \"yes\"",
                           "[output]\nchanel = true"}) {
    EXPECT_NE(refusal(with_target(line)), "accepted") << line;
  }
  EXPECT_THAT(refusal("replicates = 0\n" + all),
              HasSubstr("scene.toml:1: replicates: found 0; accepted: a whole number from 1 to 1000"));
  EXPECT_EQ(refusal(with_target("[solver]\ntime_step_factor = 1.2")), "accepted");
  for (const char* width : {"4.9 um", "5 um", "19.6 um"}) {  // 4.9e-6/1e-6 is just below 4.9
    EXPECT_EQ(refusal(replaced(with_target("[mesh]\nfine_width = " + std::string(width, std::string(width).find(' '))),
                               "width = \"5 um\"", "width = \"" + std::string(width) + "\"")),
              "accepted")
        << width;
  }
}

TEST(SceneToml, NuBesideBulkToShearIsRefused) {
  EXPECT_THAT(refusal(with_target("nu = 0.49\nbulk_to_shear = 50")),
              HasSubstr("scene.toml:12: target.bulk_to_shear: found this beside nu"));
}

TEST(SceneToml, AModulusInMuOverAlphaTakesTheSignOfAlpha) {
  const std::string given = with_target("convention = \"mu/alpha\"");
  EXPECT_EQ(refusal(given), "accepted");
  EXPECT_THAT(refusal(replaced(given, "alpha = 9", "alpha = -9")),
              AllOf(HasSubstr("mu alpha/2"), HasSubstr("a negative pressure")));
  EXPECT_EQ(refusal(replaced(replaced(given, "alpha = 9", "alpha = -9"), "15 MPa", "-15 MPa")), "accepted");
}

TEST(SceneToml, UnknownAndMissingKeysAreRefused) {
  EXPECT_THAT(refusal(with_target("poisson = 0.4")),
              HasSubstr("scene.toml:11: target.poisson: found an unknown key (did you mean nu?); accepted: name, density"));
  EXPECT_THAT(refusal(with_target("[solver]\nhourglas = 1")), HasSubstr("did you mean hourglass?"));
  EXPECT_THAT(refusal(particle + target + "[extra]\n"), HasSubstr("extra: found an unknown key"));
  EXPECT_THAT(refusal(target), HasSubstr("particle: found no such key"));
  EXPECT_THAT(refusal(particle), HasSubstr("target: found no such key"));
  EXPECT_THAT(refusal(""), HasSubstr("scene.toml: particle: found no such key"));
}

TEST(SceneToml, AJobCanEmbedAScene) {
  const std::string text = "[scene.particle]\nradius = \"1 um\"\ndensity = \"16800 kg/m3\"\nspeed = \"600 m/s\"\n" +
                           replaced(target, "[target]", "[scene.target]");
  const auto job = parse_toml(text, "job.toml");
  Scene scene = scene_from(job.table("scene"));
  EXPECT_NO_THROW(job.finish());
  EXPECT_EQ(scene.source, "job.toml");
  scene.source = "x";
  EXPECT_EQ(scene, parse_scene(particle + target, "x"));
}

// A positive number with random bits in its fraction, across many orders of magnitude.
double random_number(std::mt19937_64& random, double low_exponent, double high_exponent) {
  return std::exp2(std::uniform_real_distribution(low_exponent, high_exponent)(random));
}

Scene random_scene(std::mt19937_64& random) {
  const auto number = [&](double low, double high) { return random_number(random, low, high); };
  const auto coin = [&] { return random() % 2 == 0; };
  Scene scene;
  scene.source = "x";
  scene.replicates = 1 + static_cast<int>(random() % 1000);
  scene.particle = {.name = coin() ? "gold \"fine\"\\\n\x01 \u00b5" : "",
                    .radius = number(-40, 40),
                    .density = number(-60, 60),
                    .speed = number(-30, 30),
                    .youngs_modulus = {}};
  if (coin()) scene.particle.youngs_modulus = number(-60, 60);
  auto& layer = scene.target;
  layer.name = "skin";
  layer.density = number(-60, 60);
  layer.convention = coin() ? ModulusConvention::true_shear : ModulusConvention::mu_over_alpha;
  layer.alpha = number(-9, 6) * (coin() ? 1 : -1);
  layer.mu_as_given = number(-60, 60);
  if (layer.convention == ModulusConvention::mu_over_alpha)
    layer.mu_as_given = std::copysign(layer.mu_as_given, layer.alpha);
  if (coin())
    layer.volumetric = PoissonRatio{0.5 - number(-30, -1)};
  else if (coin())
    layer.volumetric = BulkToShear{number(-60, 60)};
  layer.depth = scene.particle.radius * (1 + number(-3, 10));
  if (coin()) layer.width = scene.particle.radius * (1 + number(-3, 10));
  layer.bottom = coin() ? Bottom::free : Bottom::fixed;
  if (coin()) layer.erosion = StrainErosion{number(-10, 10), static_cast<StrainMeasure>(random() % 3)};
  scene.mesh.elements_per_radius = 1 + 999 * number(-10, 0);
  scene.mesh.fine_width = number(-10, 0);
  if (coin()) scene.mesh.graded_columns = 1 + static_cast<int>(random() % 100);
  scene.solver = {.hourglass = number(-60, 60),
                  .linear_viscosity = coin() ? 0 : number(-60, 60),
                  .quadratic_viscosity = number(-60, 60),
                  .time_step_factor = number(-10, 0.2),
                  .arithmetic = coin() ? Arithmetic::single_precision : Arithmetic::double_precision,
                  .end_time = {}};
  if (coin()) scene.solver.end_time = number(-60, 60);
  scene.output = {.history = coin(), .after = coin() ? RunUntil::rest : RunUntil::deepest, .channel = coin()};
  return scene;
}

// A convex polygon in plane strain, turned, by density or mass; what the reader derives is derived here as it does.
ParticleScene random_profile(std::mt19937_64& random) {
  const auto coin = [&] { return random() % 2 == 0; };
  const double size = random_number(random, -20, 20);
  ProfileShape profile;
  const int corners = 3 + static_cast<int>(random() % 5);
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + random_number(random, -9, -1)) * 2 * std::numbers::pi / corners;
    profile.vertices.push_back({size * std::cos(angle), size * std::sin(angle)});
  }
  profile.orientation = random_number(random, -9, 2) * (coin() ? 1 : -1);
  profile.free_rotation = coin();
  ParticleScene particle{
      .name = "prism", .shape = profile, .radius = half_width(standing(profile)), .density = 7, .youngs_modulus = {}};
  if (coin()) {
    const double mass = random_number(random, -20, 20);
    std::get<ProfileShape>(particle.shape).mass = mass;
    particle.density = mass / solid_body(profile, Geometry::plane_strain).measure;
  }
  particle.speed = random_number(random, -9, 9);
  return particle;
}

// The features that a plain scene leaves out.
void add_features(Scene& scene, std::mt19937_64& random) {
  const auto number = [&](double low, double high) { return random_number(random, low, high); };
  const auto coin = [&] { return random() % 2 == 0; };
  scene.solver.hourglass_form = static_cast<HourglassForm>(random() % 2);
  scene.solver.volumetric_law = static_cast<VolumetricLaw>(random() % 3);
  scene.solver.eroded_nodes = static_cast<ErodedNodes>(random() % 2);
  scene.solver.rates = 1 + static_cast<int>(random() % 2);
  scene.solver.stiffen_supersonic = coin();
  scene.particle.poisson_ratio = 0.5 - number(-30, -1);
  if (coin()) scene.particle.elasticity = Elasticity::rigid;
  if (scene.particle.youngs_modulus && coin()) scene.particle.elasticity = Elasticity::elastic;
  if (coin()) {
    scene.geometry = Geometry::plane_strain;
    scene.particle.elasticity = Elasticity::automatic;
    if (coin()) scene.particle = random_profile(random);
    scene.target.depth = scene.particle.radius * (1 + number(-3, 10));
    scene.target.width = reach(scene.particle, scene.geometry) * (1 + number(-3, 10));
    scene.mesh.whole = coin() || needs_both_halves(scene.particle);
  }
  if (coin()) scene.target.stretch = 1 + number(-9, 0);
  if (coin()) scene.target.fibres = PlanarFibres{number(-20, 20), number(-9, 9), 0.5 - number(-9, -3)};
  if (coin()) scene.particle.friction = CoulombFriction{number(-10, 1)};
  if (coin()) scene.target.erosion = StressErosion{number(-60, 60)};
  if (coin()) scene.target.erosion = EnergyErosion{number(-60, 60)};
  const std::size_t criterion = scene.target.erosion.index();
  if ((criterion == 1 || criterion == 2) && coin()) scene.target.further_erosion.energy = number(-60, 60);
  if (criterion == 1 && coin()) scene.target.erosion_by_size = SmallerThanCell{number(-20, 20), number(-10, 10)};
  if (coin())
    scene.target.relaxation = PronySeries{{{number(-20, -2), number(-60, 60)}, {number(-20, -2), number(-60, 60)}}};
  while (coin()) {
    LowerLayerScene layer{
        .name = "l", .density = number(-60, 60), .alpha = number(-9, 6), .depth = number(-60, 60), .erosion_limit = {}};
    layer.mu_as_given = number(-60, 60);
    if (coin()) layer.volumetric = BulkToShear{number(-60, 60)};
    if (scene.target.erosion.index() > 0 && coin()) layer.erosion_limit = number(-60, 60);
    scene.below.push_back(layer);
  }
}

TEST(SceneToml, WhatIsWrittenReadsBackBitForBit) {
  std::mt19937_64 random(20240613);
  for (int i = 0; i < 1000; ++i) {
    Scene scene = random_scene(random);
    if (i % 2 == 1) add_features(scene, random);
    const std::string text = scene_to_toml(scene, "two\nlines\x01");
    EXPECT_THAT(text, testing::StartsWith("# two\n# lines \n"));
    EXPECT_EQ(parse_scene(text, "x"), scene) << text;  // == of doubles other than zero is equality of bits
  }
}

TEST(SceneToml, QuantitiesAreWrittenInPlainSi) {
  EXPECT_THAT(scene_to_toml(parse_scene(particle + target, "x"), ""),
              AllOf(HasSubstr("radius = \"1e-06 m\"\n"), HasSubstr("mu = \"15000000 Pa\"\n"),
                    HasSubstr("speed = \"600 m/s\"\n")));
}

}  // namespace
}  // namespace percal
