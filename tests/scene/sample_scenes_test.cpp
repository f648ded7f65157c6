// The scenes of data/guha2009 with profiles and layers, against the tables that they are made from; a made-up chip.
#include <gtest/gtest.h>

#include <cmath>

#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

Scene sample(const std::string& name) { return read_scene(std::string(PERCAL_DATA) + "/guha2009/" + name); }

// Elements as large as those of a ball of 1.59 mm with 14 on its radius, to 2 %.
double elements_on_the_balls_radius(const Scene& scene) {
  return 1.59e-3 / (scene.particle.radius / scene.mesh.elements_per_radius);
}

TEST(SampleScenes, TheRhombusIsThatOfTable51) {
  const Scene scene = sample("rhombus.toml");
  const auto& shape = std::get<ProfileShape>(scene.particle.shape);
  EXPECT_EQ(scene.geometry, Geometry::plane_strain);
  EXPECT_NEAR(scene.particle.radius, 3e-3, 1e-15);
  EXPECT_DOUBLE_EQ(*shape.mass, 0.7027e-3 / 3.10e-3);
  EXPECT_NEAR(elements_on_the_balls_radius(scene), 14, 0.28);
  EXPECT_FALSE(scene.mesh.whole);
}

TEST(SampleScenes, TheSquareIsThatOfTable52) {
  const Scene scene = sample("square.toml");
  const auto& shape = std::get<ProfileShape>(scene.particle.shape);
  EXPECT_NEAR(scene.particle.radius, 5.83e-3 / std::sqrt(2), 1e-15);
  EXPECT_DOUBLE_EQ(*shape.mass, 0.7509e-3 / 2.90e-3);
  EXPECT_NEAR(scene.particle.density, 7610, 0.01 * 7610) << "steel, from the printed mass";
  EXPECT_NEAR(elements_on_the_balls_radius(scene), 14, 0.28);
  EXPECT_TRUE(scene.mesh.whole);
}

TEST(SampleScenes, TheChipIsATetrahedronWithoutAPlaneOfSymmetry) {
  const Scene scene = read_scene(std::string(PERCAL_DATA) + "/synthetic/chip.toml");
  EXPECT_EQ(std::get<PolyhedronShape>(scene.particle.shape).vertices.size(), 4u);
  EXPECT_TRUE(scene.mesh.whole && scene.mesh.whole_across);
}

TEST(SampleScenes, SkinHasThreeLayers) {
  const Scene scene = sample("skin_layers.toml");
  ASSERT_EQ(scene.below.size(), 2u);
  EXPECT_EQ(scene.below[1].name, "dermis");
  EXPECT_EQ(scene.below[0].erosion_limit, 0.7);
}

}  // namespace
}  // namespace percal
