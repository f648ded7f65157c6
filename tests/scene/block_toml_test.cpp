// Scenes in three dimensions: what is read, what it becomes, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "percal/problem/problem.hpp"
#include "percal/scene/profile.hpp"
#include "percal/scene/scene_toml.hpp"
#include "scene/refusal.hpp"

namespace percal {
namespace {

using test::refusal;
using testing::HasSubstr;

const std::string ball_lines = "radius = \"1 mm\"\ndensity = \"7 t/m3\"\nspeed = \"50 m/s\"\n";
const std::string prism =
    "shape = \"rhombus\"\nside = \"2 mm\"\ntip_angle = \"60 deg\"\nthickness = \"1 mm\"\nspeed = \"50 m/s\"\n";
const std::string by_density = prism + "density = \"7 t/m3\"\n";

std::string block(const std::string& particle, const std::string& rest = "") {
  return "geometry = \"block\"\n[particle]\n" + particle + test::block_target + rest;
}
Scene scene_of(const std::string& text) { return parse_scene(text, "scene.toml"); }

TEST(BlockToml, ASphereHasSixCubesOnItsRadiusAndAQuarterIsComputed) {
  const Scene scene = scene_of(block(ball_lines));
  EXPECT_EQ(scene.mesh.elements_per_radius, 6);
  EXPECT_EQ(scene.solver.hourglass, 2);
  const Problem p = reduce(scene).problem;
  EXPECT_EQ(p.geometry, Geometry::block);
  EXPECT_FALSE(p.whole);
  EXPECT_EQ(p.block, (BlockModel{.fine_thickness = 1, .fine_depth = 75, .growth = 1.25, .angle = 0}));
  EXPECT_EQ(p.rates, 1);
}

// Half width 1 mm, half thickness 0.5 mm.
TEST(BlockToml, APrismHasSixCubesOnHalfItsThickness) {
  const Problem p = reduce(scene_of(block(by_density, "[mesh]\nfine_depth = 20\ngrowth = 1.1\n"))).problem;
  const auto& particle = std::get<RigidPolygon>(p.particle);
  EXPECT_DOUBLE_EQ(p.elements_per_radius, 12);
  EXPECT_DOUBLE_EQ(p.fine_width, 1.15);
  EXPECT_NEAR(p.block.fine_thickness, 0.65, 1e-12);
  EXPECT_EQ(p.block.fine_depth, 20);
  EXPECT_EQ(p.block.growth, 1.1);
  EXPECT_DOUBLE_EQ(particle.half_thickness, 0.5);
  EXPECT_NEAR(particle.mass, 7 * 2 * std::sqrt(3), 1e-9);  // area over a^2 of 2 sqrt(3), thickness 1
  EXPECT_FALSE(p.whole);
}

TEST(BlockToml, MassAndThicknessMakeTheDensity) {
  const Scene scene = scene_of(block(prism + "mass = \"0.0242487113059643 g\"\n"));  // 2 sqrt(3) mm3 of 7 t/m3
  EXPECT_NEAR(particle_density(scene), 7000, 1e-9);
  EXPECT_EQ(parse_scene(scene_to_toml(scene, ""), scene.source).particle.density, scene.particle.density);
}

TEST(BlockToml, WhatComesAslantOrMayTurnNeedsHalfOfTheBlock) {
  const Problem aslant = reduce(scene_of(block(ball_lines + "angle = \"30 deg\"\n"))).problem;
  EXPECT_TRUE(aslant.whole);
  EXPECT_NEAR(aslant.block.angle, std::numbers::pi / 6, 1e-11);
  EXPECT_TRUE(reduce(scene_of(block(by_density + "rotation = \"free\"\n"))).problem.whole);
  EXPECT_TRUE(reduce(scene_of(block(by_density + "orientation = \"5 deg\"\n"))).problem.whole);
}

TEST(BlockToml, ASceneIsWrittenAsItIsRead) {
  for (const std::string& text :
       {block(ball_lines + "angle = \"30 deg\"\n", "[mesh]\nfine_thickness = 1.5\nfine_depth = 20\ngrowth = 1.2\n"),
        block(by_density + "rotation = \"free\"\n"), block(prism + "mass = \"1 g\"\n")}) {
    Scene scene = scene_of(text);
    Scene again = parse_scene(scene_to_toml(scene, ""), scene.source);
    if (auto* shape = std::get_if<ProfileShape>(&scene.particle.shape)) {
      auto& other = std::get<ProfileShape>(again.particle.shape);
      if (shape->mass) {
        EXPECT_NEAR(*other.mass, *shape->mass, 1e-15);
      }
      other.mass = shape->mass;
      again.particle.density = scene.particle.density;
    }
    EXPECT_EQ(again, scene) << scene_to_toml(scene, "");
  }
}

TEST(BlockToml, ItsLayersMayBeStretchedInTwoDirectionsAndHaveFamiliesOfFibres) {
  const std::string woven = "k1 = \"1 MPa\"\nk2 = 2\nkappa = 0.1\nangle = \"45 deg\"\n";
  const std::string layer =
      "[[below]]\ndensity = \"1 t/m3\"\nmu = \"2 MPa\"\nalpha = 3\ndepth = \"10 mm\"\nstretch_across = "
      "1.05\n[below.fibres]\n" +
      woven;
  const Scene scene =
      scene_of(block(ball_lines, "stretch = 1.1\nstretch_across = 1.02\n[target.fibres]\n" + woven + layer));
  const Fibres families = FibreFamilies{1e6, 2, 0.1, std::numbers::pi / 4};
  EXPECT_EQ(scene.target.fibres, families);
  EXPECT_EQ(scene.target.stretch_across, 1.02);
  EXPECT_EQ(scene.below[0].fibres, families);
  EXPECT_EQ(scene.below[0].stretch_across, 1.05);
  EXPECT_EQ(parse_scene(scene_to_toml(scene, ""), scene.source), scene);
  const Problem p = reduce(scene).problem;
  EXPECT_NEAR(std::get<FibreFamilies>(p.fibres).k1, 1e6 / (1000 * 50 * 50), 1e-9);
  EXPECT_EQ(p.stretch_across, 1.02);
  EXPECT_EQ(p.block.fine_depth, 85);
  EXPECT_THAT(refusal("[particle]\n" + ball_lines + test::block_target + "[target.fibres]\n" + woven),
              HasSubstr("target.fibres.angle: found this in a scene of two dimensions"));
  EXPECT_THAT(refusal("[particle]\n" + ball_lines + test::block_target + "stretch_across = 1.1\n"),
              HasSubstr("target.stretch_across: found this in a scene of two dimensions"));
}

TEST(BlockToml, KeysOfABlockAreRefusedElsewhere) {
  const std::string flat = "[particle]\n" + ball_lines + test::block_target;
  EXPECT_THAT(refusal(flat + "[mesh]\nfine_depth = 3\n"),
              HasSubstr("mesh.fine_depth: found this in a scene of two dimensions"));
  EXPECT_THAT(refusal("[particle]\n" + ball_lines + "angle = \"3 deg\"\n" + test::block_target),
              HasSubstr("particle.angle: found this in a scene of two dimensions"));
  EXPECT_THAT(refusal(block(ball_lines, "[mesh]\ngraded_columns = 3\n")),
              HasSubstr("mesh.graded_columns: found this in geometry"));
}

TEST(BlockToml, WhatABlockLacksIsRefusedByName) {
  for (const auto& [rest, key] : std::vector<std::pair<std::string, std::string>>{
           {"[target.erosion]\nstrain = 0.7\nlength_in_radii = 0.6\n", "target.erosion"},
           {"[[target.relaxation]]\nshare = 0.3\ntime = \"1 us\"\n", "target.relaxation"},
           {"[solver]\nrates = 2\n", "solver.rates"},
           {"[solver]\nhourglass_form = \"viscosity\"\n", "solver.hourglass_form"},
           {"[solver]\nvolumetric_law = \"quadratic\"\n", "solver.volumetric_law"},
           {"[solver]\neroded_nodes = \"in contact\"\n", "solver.eroded_nodes"},
           {"[output]\nchannel = true\n", "output.channel"}})
    EXPECT_THAT(refusal(block(ball_lines, rest)), HasSubstr(key + ": found")) << rest;
  EXPECT_THAT(refusal(block("shape = \"cylinder\"\n" + ball_lines)), HasSubstr("\"cylinder\" in a block"));
  EXPECT_THAT(refusal(block("shape = \"cone\"\ntip_angle = \"60 deg\"\n" + ball_lines)),
              HasSubstr("\"cone\" in a block"));
  EXPECT_THAT(refusal(block(ball_lines + "thickness = \"1 mm\"\n")),
              HasSubstr("particle.thickness: found this beside shape"));
  EXPECT_THAT(refusal(block(by_density + "angle = \"30 deg\"\n")),
              HasSubstr("particle.angle: found this beside rotation"));
}

TEST(BlockToml, APrismNeedsItsThickness) {
  EXPECT_THAT(
      refusal(block(
          "shape = \"rhombus\"\nside = \"2 mm\"\ntip_angle = \"60 deg\"\nspeed = \"50 m/s\"\ndensity = \"7 t/m3\"\n")),
      HasSubstr("particle.thickness: found no such key"));
}

}  // namespace
}  // namespace percal
