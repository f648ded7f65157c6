#include "percal/scene/width.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percal {
namespace {

// Steel into gelatin; pi4 = density speed^2/mu.
Scene ball(double speed, double particle_density) {
  Scene scene;
  scene.particle.radius = 2e-3;
  scene.particle.density = particle_density;
  scene.particle.speed = speed;
  scene.target.density = 1000;
  scene.target.mu_as_given = 1e5;
  scene.target.alpha = 8.5;
  scene.target.depth = 0.1;
  return scene;
}

TEST(Width, IsWiderForFastAndForHeavyShots) {
  EXPECT_EQ(usual_width(29.9, 16.8), 5);
  EXPECT_EQ(usual_width(30, 7.6), 12);
  EXPECT_EQ(usual_width(30, 10.1), 20);
  EXPECT_DOUBLE_EQ(width_of(ball(50, 7800)), 5 * 2e-3);
  EXPECT_DOUBLE_EQ(width_of(ball(60, 7800)), 12 * 2e-3);
  EXPECT_DOUBLE_EQ(width_of(ball(60, 16800)), 20 * 2e-3);
}

TEST(Width, ThatIsGivenStays) {
  Scene scene = ball(60, 7800);
  scene.target.width = 0.013;
  EXPECT_EQ(width_of(scene), 0.013);
}

TEST(Width, FollowsTheSoftestLayer) {
  Scene scene = ball(50, 7800);
  scene.below = {{.density = 1000, .mu_as_given = 1e4, .alpha = 8.5, .depth = 0.1}};
  EXPECT_DOUBLE_EQ(width_of(scene), 12 * 2e-3);
}

// A rod that may turn reaches as far as its ends.
TEST(Width, CountsInReachesOfAProfile) {
  Scene scene = ball(50, 7800);
  scene.geometry = Geometry::plane_strain;
  scene.particle.shape =
      ProfileShape{.vertices = {{-2e-3, 0}, {2e-3, 0}, {2e-3, 4e-2}, {-2e-3, 4e-2}}, .free_rotation = true};
  EXPECT_NEAR(width_of(scene), 5 * std::hypot(2e-3, 2e-2), 1e-12);
}

}  // namespace
}  // namespace percal
