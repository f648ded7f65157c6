// Shapes of the particle, whole and half models, elasticity: what is read and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "percal/math/polygon.hpp"
#include "percal/scene/scene_toml.hpp"
#include "scene/refusal.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string wide_target =
    "[target]\ndensity = \"1 t/m3\"\nmu = \"1 MPa\"\nalpha = 9\ndepth = \"75 mm\"\nwidth = \"12 mm\"\n";
const std::string plane = "plane strain", axisymmetric = "axisymmetric";

// A scene with these lines in [particle], its line 4 on.
std::string text_of(const std::string& geometry, const std::string& lines, const std::string& rest = "") {
  return "geometry = \"" + geometry + "\"\n[particle]\nspeed = \"50 m/s\"\n" + lines + wide_target + rest;
}

Scene read(const std::string& geometry, const std::string& lines) { return parse_scene(text_of(geometry, lines), "x"); }

std::string refusal(const std::string& geometry, const std::string& lines, const std::string& rest = "") {
  return test::refusal(text_of(geometry, lines, rest));
}

const ProfileShape& profile_of(const Scene& scene) { return std::get<ProfileShape>(scene.particle.shape); }

const std::string density = "density = \"7 t/m3\"\n";
const std::string mass = "mass = \"6 g\"\nthickness = \"3 mm\"\n";
const std::string rhombus = "shape = \"rhombus\"\nside = \"6 mm\"\ntip_angle = \"60 deg\"\n";
const std::string cone = "shape = \"cone\"\nradius = \"3 mm\"\ntip_angle = \"90 deg\"\n";
const std::string sphere = "radius = \"3 mm\"\n" + density;

std::string profile(const std::string& vertices) { return "shape = \"profile\"\nvertices = " + vertices + "\n"; }
const std::string square = profile(R"([["0 mm", "0 mm"], ["4 mm", "0 mm"], ["4 mm", "4 mm"], ["0 mm", "4 mm"]])");

TEST(ParticleToml, ARhombusStandsOnItsTip) {
  const Scene scene = read(plane, rhombus + mass);
  const ProfileShape& shape = profile_of(scene);
  ASSERT_EQ(shape.vertices.size(), 4u);
  EXPECT_EQ(shape.vertices[0], (std::array{0.0, 0.0}));
  EXPECT_NEAR(shape.vertices[1][0], 3e-3, 1e-17);
  EXPECT_NEAR(shape.vertices[2][1], 6e-3 * std::sqrt(3), 1e-17);
  EXPECT_NEAR(scene.particle.radius, 3e-3, 1e-17);
  EXPECT_EQ(shape.mass, 0.006 / 0.003) << "per metre";
  EXPECT_NEAR(scene.particle.density, 2 / (2 * 3e-3 * 3e-3 * std::sqrt(3)), 1e-6) << "the one that makes this mass";
  EXPECT_EQ(scene.particle.name, "rhombus");
  EXPECT_FALSE(shape.free_rotation);
  EXPECT_FALSE(scene.mesh.whole);
}

TEST(ParticleToml, AConeHasItsTipDownAndItsMassIsThatOfTheWholeBody) {
  const Scene scene = read(axisymmetric, cone + "mass = \"1 g\"\n");
  EXPECT_EQ(scene.particle.radius, 3e-3);
  EXPECT_NEAR(profile_of(scene).vertices[1][1], 3e-3, 1e-17);
  EXPECT_EQ(profile_of(scene).mass, 1e-3);
  EXPECT_NEAR(scene.particle.density, 1e-3 / (std::numbers::pi / 3 * 27e-9), 1e-6);
}

TEST(ParticleToml, AProfileIsTurnedAndItsRadiusIsHalfTheWidthThatItThenHas) {
  const Scene scene = read(plane, square + density + "orientation = \"45 deg\"\n");
  EXPECT_DOUBLE_EQ(scene.particle.radius, 2e-3 * std::sqrt(2));
  EXPECT_DOUBLE_EQ(profile_of(scene).orientation, std::numbers::pi / 4);
  EXPECT_FALSE(scene.mesh.whole) << "on its corner a square is symmetric";
  EXPECT_DOUBLE_EQ(profile_of(read(plane, square + density + "orientation = \"-0.25 rad\"\n")).orientation, -0.25);
  EXPECT_EQ(read(plane, square + density).particle.radius, 2e-3);
}

TEST(ParticleToml, VerticesComeFromACsvBesideTheScene) {
  const auto folder = std::filesystem::temp_directory_path() / "percal_particle_toml_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "square.csv") << "# a square\nx_mm,y_mm\n0,0\n4,0\n4,4\n0,4\n";
  std::ofstream(folder / "no_unit.csv") << "x,y\n0,0\n4,0\n4,4\n";
  std::ofstream(folder / "scene.toml") << text_of(plane, profile("\"square.csv\"") + density);
  const Scene scene = read_scene((folder / "scene.toml").string());
  EXPECT_EQ(profile_of(scene).vertices, profile_of(read(plane, square + density)).vertices);
  EXPECT_EQ(profile_of(scene).vertices_file, (folder / "square.csv").string());
  std::ofstream(folder / "scene.toml") << text_of(plane, profile("\"no_unit.csv\"") + density);
  EXPECT_THROW(read_scene((folder / "scene.toml").string()), BadInput);
  std::filesystem::remove_all(folder);
}

TEST(ParticleToml, EitherOrderOfTheCornersIsTheSamePolygon) {
  EXPECT_EQ(
      profile_of(
          read(plane, profile(R"([["0 mm", "0 mm"], ["0 mm", "4 mm"], ["4 mm", "4 mm"], ["4 mm", "0 mm"]])") + density))
          .vertices,
      profile_of(read(plane, square + density)).vertices);
}

TEST(ParticleToml, PolygonsThatAreNotConvexAreRefused) {
  EXPECT_THAT(
      refusal(plane, profile(R"([["0 mm", "0 mm"], ["4 mm", "0 mm"], ["4 mm", "4 mm"], ["3 mm", "1 mm"]])") + density),
      HasSubstr("scene.toml:5: particle.vertices: found a polygon that is not convex; accepted: the corners of a "
                "convex polygon in their order"));
  EXPECT_THAT(refusal(plane, profile(R"([["0 mm", "0 mm"], ["4 mm", "0 mm"]])") + density),
              HasSubstr("fewer than three different points"));
  EXPECT_THAT(refusal(plane, profile(R"([["0 mm", "0 mm"], ["4 mm"]])") + density), HasSubstr("particle.vertices[2]"));
  EXPECT_THAT(refusal(plane, profile(R"([[0, 0], [4, 0], [4, 4]])") + density), HasSubstr("without a unit"));
  EXPECT_THAT(refusal(plane, profile("3") + density), HasSubstr("particle.vertices"));
  EXPECT_THAT(refusal(plane, "shape = \"profile\"\n" + density), HasSubstr("particle.vertices: found no such key"));
}

TEST(ParticleToml, InAnAxisymmetricSceneAProfileIsItsOwnMirrorImageOrItsRightHalf) {
  const std::string half = profile(R"([["0 mm", "0 mm"], ["3 mm", "4 mm"], ["0 mm", "4 mm"]])");
  EXPECT_EQ(
      profile_of(read(axisymmetric, half + density)).vertices,
      profile_of(read(axisymmetric, profile(R"([["0 mm", "0 mm"], ["3 mm", "4 mm"], ["-3 mm", "4 mm"]])") + density))
          .vertices);
  EXPECT_EQ(refusal(axisymmetric, half + density + "orientation = \"180 deg\"\n"), "accepted") << "base first";
  EXPECT_THAT(refusal(axisymmetric, half + density + "orientation = \"90 deg\"\n"),
              HasSubstr("as it is turned is not its own mirror"));
  EXPECT_THAT(refusal(axisymmetric, profile(R"([["-1 mm", "0 mm"], ["3 mm", "4 mm"], ["0 mm", "4 mm"]])") + density),
              HasSubstr("not its own mirror image in x = 0"));
  EXPECT_THAT(refusal(axisymmetric, profile(R"([["1 mm", "0 mm"], ["3 mm", "4 mm"], ["1 mm", "4 mm"]])") + density),
              HasSubstr("no side on the axis"));
}

TEST(ParticleToml, AKeyOfAnotherShapeIsRefused) {
  for (const char* key : {"side = \"1 mm\"", "tip_angle = \"60 deg\"", "orientation = \"1 deg\"",
                          "rotation = \"fixed\"", "vertices = \"a.csv\""})
    EXPECT_THAT(refusal(plane, sphere + key + "\n"), HasSubstr("found this beside shape = \"sphere\"")) << key;
  EXPECT_THAT(refusal(plane, rhombus + density + "radius = \"3 mm\"\n"),
              AllOf(HasSubstr("scene.toml:8: particle.radius"), HasSubstr("half the width")));
  EXPECT_THAT(refusal(plane, square + density + "tip_angle = \"3 deg\"\n"), HasSubstr("only of a rhombus or a cone"));
  EXPECT_THAT(refusal(axisymmetric, cone + density + "side = \"3 mm\"\n"), HasSubstr("side only of a rhombus"));
  EXPECT_THAT(refusal(plane, rhombus + density + "vertices = \"a.csv\"\n"),
              HasSubstr("only beside shape = \"profile\""));
}

TEST(ParticleToml, ShapesBelongToAGeometry) {
  EXPECT_EQ(refusal(plane, sphere), "accepted");
  EXPECT_EQ(refusal(plane, "shape = \"cylinder\"\n" + sphere), "accepted");
  EXPECT_THAT(refusal(axisymmetric, "shape = \"cylinder\"\n" + sphere), HasSubstr("lies on its side"));
  EXPECT_THAT(refusal(plane, cone + density), HasSubstr("\"cone\" in plane strain"));
  EXPECT_EQ(refusal(axisymmetric, rhombus + density), "accepted") << "a double cone";
  EXPECT_THAT(refusal(axisymmetric, rhombus + density + "orientation = \"3 deg\"\n"),
              HasSubstr("particle.orientation"));
  EXPECT_THAT(refusal("spherical", sphere), HasSubstr("scene.toml:1: geometry: found \"spherical\""));
}

TEST(ParticleToml, ABallIsGivenByItsDiameterAndItsMass) {
  const Scene bb = read(axisymmetric, "diameter = \"0.177 in\"\nmass = \"5.4 gr\"\n");
  EXPECT_DOUBLE_EQ(bb.particle.radius, 0.177 * 0.0254 / 2);
  EXPECT_NEAR(bb.particle.density, 7354.3, 0.1) << "0.34991 g over 47.580 mm3";
  EXPECT_EQ(read(axisymmetric, "diameter = \"6 mm\"\n" + density), read(axisymmetric, sphere));
  const Scene rod = read(plane, "diameter = \"6 mm\"\nmass = \"2 g\"\nthickness = \"4 mm\"\n");
  EXPECT_DOUBLE_EQ(rod.particle.density, 0.5 / (std::numbers::pi * 9e-6));
  EXPECT_DOUBLE_EQ(read(axisymmetric, "shape = \"cone\"\ndiameter = \"6 mm\"\ntip_angle = \"90 deg\"\n" + density)
                       .particle.radius,
                   3e-3);
}

TEST(ParticleToml, MassesAreGivenInOneWay) {
  EXPECT_THAT(refusal(axisymmetric, sphere + "diameter = \"6 mm\"\n"), HasSubstr("particle.radius: found this beside"));
  EXPECT_THAT(refusal(axisymmetric, sphere + "mass = \"1 g\"\n"), HasSubstr("particle.mass: found this beside density"));
  EXPECT_THAT(refusal(plane, "radius = \"3 mm\"\nmass = \"1 g\"\n"), HasSubstr("this without a thickness"));
  EXPECT_THAT(refusal(plane, rhombus + density + "diameter = \"3 mm\"\n"), HasSubstr("half the width"));

  EXPECT_THAT(refusal(plane, rhombus), HasSubstr("particle.density: found no such key"));
  EXPECT_THAT(refusal(plane, rhombus + density + mass), HasSubstr("particle.mass: found this beside density"));
  EXPECT_THAT(refusal(plane, rhombus + "mass = \"1 g\"\n"), HasSubstr("this without a thickness"));
  EXPECT_THAT(refusal(plane, rhombus + density + "thickness = \"1 mm\"\n"), HasSubstr("this without a mass"));
  EXPECT_THAT(refusal(axisymmetric, cone + mass), HasSubstr("no thickness"));
  EXPECT_THAT(refusal(plane, rhombus + "mass = \"0 g\"\nthickness = \"1 mm\"\n"), HasSubstr("a positive mass"));
}

TEST(ParticleToml, SizesBeyondAllReasonAreRefused) {
  EXPECT_THAT(refusal(plane, "shape = \"rhombus\"\nside = \"1 mm\"\ntip_angle = \"1e-10 deg\"\n" + density),
              HasSubstr("particle.tip_angle: found a polygon that is not convex"));
  EXPECT_THAT(refusal(plane, "shape = \"rhombus\"\nside = \"1e-160 m\"\ntip_angle = \"60 deg\"\n" + mass),
              HasSubstr("scene.toml:"));
  EXPECT_THAT(refusal(plane, "shape = \"rhombus\"\nside = \"1e160 m\"\ntip_angle = \"60 deg\"\n" + mass),
              HasSubstr("scene.toml:"));
}

TEST(ParticleToml, AnglesHaveAUnit) {
  for (const char* angle :
       {"\"60\"", "60", "\"deg\"", "\"0 deg\"", "\"180 deg\"", "\"-60 deg\"", "\"1 m deg\"", "\"60 degrees\""})
    EXPECT_THAT(
        refusal(plane, "shape = \"rhombus\"\nside = \"6 mm\"\ntip_angle = " + std::string(angle) + "\n" + density),
        HasSubstr("particle.tip_angle"))
        << angle;
  for (const char* angle : {"\"60deg\"", "\"60 \u00b0\"", "\"1 rad\""})
    EXPECT_EQ(
        refusal(plane, "shape = \"rhombus\"\nside = \"6 mm\"\ntip_angle = " + std::string(angle) + "\n" + density),
        "accepted")
        << angle;
  EXPECT_THAT(refusal(plane, square + density + "orientation = \"361 deg\"\n"), HasSubstr("from -360 to 360 deg"));
}

TEST(ParticleToml, FreeRotationNeedsPlaneStrainAndBothHalves) {
  const std::string freely = rhombus + density + "rotation = \"free\"\n";
  EXPECT_TRUE(read(plane, freely).mesh.whole);
  EXPECT_TRUE(profile_of(read(plane, freely)).free_rotation);
  EXPECT_THAT(refusal(axisymmetric, freely), HasSubstr("a body of revolution that turns is no longer axisymmetric"));
  EXPECT_THAT(refusal(plane, freely, "[mesh]\nwhole = false\n"),
              AllOf(HasSubstr("mesh.whole: found false for a particle that may turn"), HasSubstr("for a half model")));
}

TEST(ParticleToml, ASceneThatIsNotItsMirrorImageIsWhole) {
  const std::string tilted = square + density + "orientation = \"10 deg\"\n";
  EXPECT_TRUE(read(plane, tilted).mesh.whole);
  EXPECT_THAT(refusal(plane, tilted, "[mesh]\nwhole = false\n"), HasSubstr("not its own mirror image"));
  EXPECT_EQ(refusal(plane, square + density, "[mesh]\nwhole = true\n"), "accepted");
  EXPECT_THAT(refusal(axisymmetric, sphere, "[mesh]\nwhole = true\n"),
              HasSubstr("mesh.whole: found true in an axisymmetric scene"));
}

TEST(ParticleToml, OnlyASphereInAnAxisymmetricSceneCanBeElastic) {
  const std::string elastic = "elasticity = \"elastic\"\n", modulus = "youngs_modulus = \"79 GPa\"\n";
  const Scene scene = read(axisymmetric, sphere + elastic + modulus + "poisson_ratio = 0.4\n");
  EXPECT_EQ(scene.particle.elasticity, Elasticity::elastic);
  EXPECT_EQ(scene.particle.poisson_ratio, 0.4);
  EXPECT_THAT(refusal(axisymmetric, sphere + elastic), HasSubstr("\"elastic\" without a youngs_modulus"));
  EXPECT_THAT(refusal(plane, sphere + elastic + modulus),
              HasSubstr("only a sphere in an axisymmetric scene can be elastic"));
  EXPECT_THAT(refusal(axisymmetric, cone + density + elastic + modulus), HasSubstr("\"elastic\" for a cone"));
  EXPECT_THAT(refusal(axisymmetric, sphere + "elasticity = \"soft\"\n"),
              HasSubstr("\"automatic\", \"rigid\", \"elastic\""));
  EXPECT_THAT(refusal(axisymmetric, sphere + "poisson_ratio = 0.5\n"), HasSubstr("particle.poisson_ratio"));
}

TEST(ParticleToml, TheTargetIsWiderThanTheReachOfTheParticle) {
  const std::string plate =
      profile(R"([["0 mm", "0 mm"], ["4 mm", "0 mm"], ["4 mm", "30 mm"], ["0 mm", "30 mm"]])") + density;
  EXPECT_EQ(refusal(plane, plate), "accepted");
  EXPECT_THAT(refusal(plane, plate + "rotation = \"free\"\n"),
              AllOf(HasSubstr("target.width: found \"12 mm\""),
                    HasSubstr("largest distance from its middle line of 15.13 mm")));
}

}  // namespace
}  // namespace percal
