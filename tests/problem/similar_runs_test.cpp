// Similar systems through the solver: not only one key, but the same bits.
#include <gtest/gtest.h>

#include "percal/impact/march/march.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

TEST(SimilarRuns, GoldIntoSkinAndSteelIntoGelatinGiveTheSameBits) {
  const std::string folder = std::string(PERCAL_DATA) + "/guha2009/";
  Scene gold = read_scene(folder + "gold.toml"), steel = read_scene(folder + "steel.toml");
  for (Scene* scene : {&gold, &steel}) {
    scene->mesh.elements_per_radius = 5;
    scene->solver.end_time = 6 * scene->particle.radius / scene->particle.speed;
  }
  const ImpactResult skin_run = run_impact(reduce(gold).problem), gelatin_run = run_impact(reduce(steel).problem);
  EXPECT_GT(skin_run.depth, 5);
  EXPECT_EQ(skin_run.depth, gelatin_run.depth);
  EXPECT_EQ(skin_run.end_speed, gelatin_run.end_speed);
  EXPECT_EQ(skin_run.energy.elastic, gelatin_run.energy.elastic);
}

}  // namespace
}  // namespace percal
