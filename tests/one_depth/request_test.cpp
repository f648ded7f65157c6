#include "percal/one_depth/request.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "one_depth/small_shot.hpp"
#include "percal/base/error.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(std::string InvertWords::*word, const std::string& said) {
  InvertWords words = test::small_shot();
  words.*word = said;
  try {
    understood(words);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "understood";
}

TEST(InvertRequest, IsWhatWasSaid) {
  InvertWords words = test::small_shot();
  words.depth_error = "5 %";
  words.speed_error = "0.02";
  words.sphere = {.radius = "2 mm", .mass = "0.1 g"};
  const InvertRequest request = understood(words);
  EXPECT_EQ(request.sought, LayerNumber::mu);
  EXPECT_EQ(request.material.erosion_strain, 1);
  EXPECT_NEAR(request.shot.density, 1e-4 / (4.0 / 3 * std::numbers::pi * 8e-9), 1e-6);
  EXPECT_EQ(request.depth_error, 0.05);
  EXPECT_EQ(request.speed_error, 0.02);
  EXPECT_EQ(request.level, 0.95);
  words.depth_error = "1 mm";
  EXPECT_EQ(understood(words).depth_error, 0.05);
}

TEST(InvertRequest, OneOfModulusAndStrainIsLookedFor) {
  InvertWords words = test::small_shot();
  words.erosion_strain = "";
  words.mu = "300 kPa";
  EXPECT_EQ(understood(words).sought, LayerNumber::erosion_strain);
  EXPECT_THAT(refusal(&InvertWords::mu, "300 kPa"), AllOf(HasSubstr("--mu"), HasSubstr("beside --erosion-strain")));
  EXPECT_THAT(refusal(&InvertWords::erosion_strain, ""),
              AllOf(HasSubstr("--mu"), HasSubstr("neither this nor --erosion-strain")));
}

TEST(InvertRequest, WhatIsMissingIsAskedForByName) {
  EXPECT_THAT(refusal(&InvertWords::depth, ""), HasSubstr("--depth: found nothing"));
  EXPECT_THAT(refusal(&InvertWords::speed, ""), HasSubstr("--speed: found nothing"));
  EXPECT_THAT(refusal(&InvertWords::density, ""), HasSubstr("--density: found nothing"));
  EXPECT_THAT(refusal(&InvertWords::alpha, ""), HasSubstr("--alpha: found nothing"));
  EXPECT_THAT(refusal(&InvertWords::layer_depth, ""), HasSubstr("--layer-depth: found nothing"));
  InvertWords words = test::small_shot();
  words.sphere.density = "";
  EXPECT_THROW(understood(words), BadInput);
  words.sphere = {.density = "2500 kg/m3"};
  EXPECT_THROW(understood(words), BadInput);
}

TEST(InvertRequest, WhatCannotBeIsRefusedByName) {
  EXPECT_THAT(refusal(&InvertWords::depth, "20"), AllOf(HasSubstr("--depth"), HasSubstr("unit")));
  EXPECT_THAT(refusal(&InvertWords::depth_error, "15 mm"), AllOf(HasSubstr("--depth-error"), HasSubstr("half")));
  EXPECT_THAT(refusal(&InvertWords::depth_error, "0.1"), HasSubstr("--depth-error"));
  EXPECT_THAT(refusal(&InvertWords::speed_error, "2 m/s"), HasSubstr("--speed-error"));
  EXPECT_THAT(refusal(&InvertWords::alpha, "0"), HasSubstr("--alpha"));
  EXPECT_THAT(refusal(&InvertWords::layer_depth, "19 mm"), HasSubstr("more than the depth"));
  EXPECT_THAT(refusal(&InvertWords::layer_width, "1 mm"), HasSubstr("--layer-width"));
  EXPECT_THAT(refusal(&InvertWords::elements_per_radius, "0.5"), HasSubstr("--elements-per-radius"));
  EXPECT_THAT(refusal(&InvertWords::erosion_length, "0.1 mm"), HasSubstr("--erosion-length"));
}

TEST(InvertRequest, MeshAndWidthHaveTheirRules) {
  InvertWords words = test::small_shot();
  words.elements_per_radius = words.layer_width = "";
  EXPECT_EQ(understood(words).elements_per_radius, 10);
  words.erosion_length = "0.45 mm";  // a fifth of the radius
  EXPECT_EQ(understood(words).elements_per_radius, 15);
  words.erosion_length = "";
  words.erosion_strain = "";
  words.mu = "1 MPa";  // pi4 = 10
  EXPECT_NEAR(understood(words).shot.layer_width, 5 * 2.25e-3, 1e-12);
  words.mu = "100 kPa";
  EXPECT_NEAR(understood(words).shot.layer_width, 12 * 2.25e-3, 1e-12);
}

// Of data/guha2009, in three dimensions.
TEST(InvertRequest, ASceneHasTheShotAndTheLayer) {
  InvertWords words{.scene = PERCAL_DATA "/guha2009/rhombus_block.toml", .depth = "3.44 cm", .mu = "900 kPa"};
  const InvertRequest request = understood(words);
  EXPECT_EQ(request.sought, LayerNumber::erosion_strain);
  EXPECT_NEAR(request.material.erosion_strain, 0.299, 1e-12) << "where the search begins";
  LayerMaterial material = request.material;
  material.erosion_strain = 0.4;
  const Scene scene = scene_of(request, material);
  EXPECT_EQ(scene.geometry, Geometry::block);
  EXPECT_EQ(scene.target.mu_as_given, 900e3);
  EXPECT_EQ(scene.target.convention, ModulusConvention::true_shear);
  EXPECT_EQ(std::get<StrainErosion>(scene.target.erosion).limit, 0.4);
  words.elements_per_radius = "7";
  EXPECT_EQ(scene_of(understood(words), material).mesh.elements_per_radius, 7);
}

TEST(InvertRequest, WhatStandsBesideASceneIsRefusedByName) {
  const auto said = [](InvertWords words) {
    words.depth = words.depth.empty() ? "3.44 cm" : words.depth;
    words.mu = "900 kPa";
    if (words.scene.empty()) words.scene = PERCAL_DATA "/guha2009/rhombus_block.toml";
    try {
      understood(words);
    } catch (const BadInput& error) {
      return std::string(error.what());
    }
    return std::string("understood");
  };
  EXPECT_THAT(said({.layer_depth = "20 mm"}), HasSubstr("--layer-depth: found this beside --scene"));
  EXPECT_THAT(said({.sphere = {.density = "7800 kg/m3"}}), HasSubstr("--particle-density: found this beside --scene"));
  EXPECT_THAT(said({.depth = "20 cm"}), HasSubstr("--depth: found 200 mm; accepted: less than the depth"));
  EXPECT_THAT(said({.scene = PERCAL_DATA "/guha2009/skin_layers.toml"}), HasSubstr("below: found further layers"));
}

}  // namespace
}  // namespace percal
