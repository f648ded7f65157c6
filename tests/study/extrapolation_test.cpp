#include "percal/study/extrapolation.hpp"

#include <gmock/gmock.h>

#include "percal/base/error.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

Penetration mean_of_five(double depth, double standard_error) {
  Penetration mean;
  mean.depth = depth;
  mean.standard_error = standard_error;
  mean.depths.assign(5, depth);
  return mean;
}

TEST(Extrapolation, IsALineInTheElementSize) {
  // d = 20 + 5 h: 20.5 with 10, 20.25 with 20.
  const Extrapolation line = extrapolate(mean_of_five(20.5, 0.3), mean_of_five(20.25, 0.2), 10);
  EXPECT_NEAR(line.depth, 20, 1e-12);
  EXPECT_NEAR(line.standard_error, 0.5, 1e-12) << "sqrt(4 0.2^2 + 0.3^2)";
  EXPECT_NEAR(line.model_error, 0.125, 1e-12) << "half of the step from 20.25 to 20";
  EXPECT_EQ(line.finer_elements_per_radius, 20);
  EXPECT_EQ(line.replicates, 5);
}

TEST(Extrapolation, NeedsALengthAndAPhase) {
  Scene scene = read_scene(PERCAL_DATA "/guha2009/gold.toml");
  try {
    need_a_limit(scene);
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("the local rule has no limit"));
  }
  scene.target.erosion_average = AverageWithin{0.5 * scene.particle.radius};
  need_a_limit(scene);
  scene.replicates = 1;
  EXPECT_THROW(need_a_limit(scene), BadInput);
}

}  // namespace
}  // namespace percal
