#include "percal/study/extrapolation.hpp"

#include <gmock/gmock.h>

#include <cmath>

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

TEST(Extrapolation, IsAParabolaInTheElementSizeThatALineMayOverrule) {
  // d = 20 + 400 h^2: 24 with 10, 21 with 20. A line would go to 18.
  const Extrapolation found = extrapolate(mean_of_five(24, 0.3), mean_of_five(21, 0.2), 10);
  EXPECT_NEAR(found.depth, 20, 1e-12);
  EXPECT_NEAR(found.standard_error, std::sqrt(16 * 0.04 + 0.09) / 3, 1e-12);
  EXPECT_NEAR(found.model_error, 2, 1e-12) << "from 20 to 18";
  EXPECT_EQ(found.finer_elements_per_radius, 20);
  EXPECT_EQ(found.replicates, 5);
  EXPECT_NEAR(extrapolate(mean_of_five(20, 0.3), mean_of_five(20, 0.2), 10).model_error, 0.2, 1e-12) << "1 %";
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
