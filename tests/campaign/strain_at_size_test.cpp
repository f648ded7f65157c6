#include "percal/campaign/strain_at_size.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "percal/base/error.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

// Stops within some radii.
Scene light_into_gel(double elements_per_radius, double strain) {
  Scene scene = parse_scene(R"(
[particle]
radius = "1 mm"
density = "1500 kg/m3"
speed = "100 m/s"
[target]
density = "1000 kg/m3"
mu = "1 MPa"
alpha = 5
depth = "20 mm"
[target.erosion]
strain = 0.9
)",
                            "gel.toml");
  scene.mesh.elements_per_radius = elements_per_radius;
  scene.target.erosion = StrainErosion{strain};
  return scene;
}

std::string refusal(const Scene& scene, double element) {
  try {
    need_element_size(scene, element, Place{.file = "result.json", .line = 0, .key = "--element-size"});
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(StrainAtSize, SendsTheShotAsDeepOnOtherElements) {
  const Scene scene = light_into_gel(7, 0.9);
  Campaign campaign(nullptr, 1);
  const StrainAtSize found = strain_at_size(scene, 1e-3 / 5, campaign, nullptr);
  ASSERT_EQ(found.why_not, "");
  EXPECT_EQ(campaign.cost().runs, strain_runs(scene));
  EXPECT_EQ(found.own_strain, 0.9);
  EXPECT_LT(found.half_width, 0.3 * found.strain);
  const Reduction check = reduce(light_into_gel(5, found.strain));
  const Penetration there =
      summarise(campaign.replicate({check.problem}, 10, nullptr).front(), check.problem, check.scales);
  // Means of 5 and 10 whose runs scatter by some per cent.
  EXPECT_NEAR(*there.depth / *found.own.depth, 1, 0.05);
}

TEST(StrainAtSize, OnItsOwnElementsItIsItself) {
  Campaign campaign(nullptr, 1);
  const StrainAtSize found = strain_at_size(light_into_gel(6, 0.9), 1e-3 / 6, campaign, nullptr);
  ASSERT_EQ(found.why_not, "");
  EXPECT_NEAR(found.strain, 0.9, found.half_width);
}

TEST(StrainAtSize, RefusesElementsThatNoStrainWasMeantFor) {
  const Scene scene = light_into_gel(10, 0.9);
  EXPECT_EQ(refusal(scene, 0.1e-3), "");
  EXPECT_EQ(refusal(scene, 0.25e-3), "");
  EXPECT_THAT(refusal(scene, 0.3e-3), HasSubstr("1/40 to 1/4 of the particle's radius: 25 um to 250 um"));
  EXPECT_THAT(refusal(scene, 0.02e-3), HasSubstr("found 20 um"));
  Scene whole = scene;
  whole.target.erosion = NoErosion{};
  EXPECT_THAT(refusal(whole, 0.1e-3), HasSubstr("does not erode by strain"));
  Scene averaged = scene;
  averaged.target.erosion_average = AverageWithin{0.5e-3};
  EXPECT_NE(refusal(averaged, 0.25e-3), "") << "two elements in the length";
}

TEST(StrainAtSize, SaysWhyThereIsNone) {
  Scene scene = light_into_gel(5, 0.9);
  scene.target.depth = 2e-3;
  Campaign campaign(nullptr, 1);
  EXPECT_THAT(strain_at_size(scene, 0.2e-3, campaign, nullptr).why_not, HasSubstr("passed through"));
}

}  // namespace
}  // namespace percal
