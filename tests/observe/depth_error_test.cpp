#include "percal/observe/depth_error.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

const std::string light_into_gel = R"(
[particle]
radius = "1 mm"
density = "1200 kg/m3"
speed = "100 m/s"
[target]
density = "1000 kg/m3"
mu = "1 MPa"
alpha = 8
depth = "40 mm"
[target.erosion]
strain = 0.8
)";

class ADepth : public testing::Test {
 protected:
  ADepth() {
    read(light_into_gel);
    penetration.depth = 10e-3;
    penetration.standard_error = 0.1e-3;
    penetration.depths = {9.8e-3, 10e-3, 10e-3, 10.2e-3};
  }
  void read(const std::string& toml) {
    scene = parse_scene(toml, "gel.toml");
    reduction = reduce(scene);
  }
  DepthError error(const ErrorEvidence& evidence = {}) const {
    return depth_error(scene, reduction, penetration, evidence);
  }
  double share(DepthErrorSource source) const { return *error().of(source).half_width / *penetration.depth; }

  Scene scene;
  Reduction reduction;
  Penetration penetration;
};
using DepthErrorTest = ADepth;

TEST_F(DepthErrorTest, TheMeshPhasesIsStudentsTTimesTheStandardError) {
  EXPECT_NEAR(*error().of(DepthErrorSource::mesh_phase).half_width, 3.1824e-4, 1e-8);  // t of 3 degrees of freedom
  EXPECT_FALSE(phase_half_width(std::nullopt, 1));
}

TEST_F(DepthErrorTest, IsTheRootOfTheSumOfSquaresOfWhatIsKnown) {
  double squares = 0;
  int known = 0;
  for (const ErrorPart& part : error().parts)
    if (part.half_width) squares += std::pow(*part.half_width, 2), ++known;
  EXPECT_EQ(known, 4) << "all but the mesh size";
  EXPECT_NEAR(*error().half_width(), std::sqrt(squares), 1e-12);
}

TEST_F(DepthErrorTest, OneRunDoesNotShowThePhase) {
  penetration.depths = {10e-3};
  penetration.standard_error = std::nullopt;
  EXPECT_FALSE(error().of(DepthErrorSource::mesh_phase).half_width);
  EXPECT_THAT(error().of(DepthErrorSource::mesh_phase).how, HasSubstr("two replicates"));
}

TEST_F(DepthErrorTest, OfTheLocalRuleBelongsToTheElements) {
  EXPECT_EQ(error().belongs_to, "elements of 1/10 radius");
  EXPECT_FALSE(error().of(DepthErrorSource::mesh_size).half_width);
  EXPECT_FALSE(error().bias);
}

TEST_F(DepthErrorTest, WithALengthSaysWhatTheElementsLeave) {
  const double without = *error().half_width();
  read(light_into_gel + "length_in_radii = 0.5\n");
  EXPECT_FALSE(error().of(DepthErrorSource::mesh_size).half_width);
  EXPECT_EQ(*error().half_width(), without) << "the bias is in no total";
  ASSERT_TRUE(error().bias);
  EXPECT_NEAR(*error().bias->half_width, 0.15 * 10e-3, 1e-12) << "pi4 10";
  EXPECT_THAT(error().bias->how, HasSubstr("elements of 0.2 of the erosion length"));
  scene.particle.speed = 80;
  reduction = reduce(scene);
  EXPECT_NEAR(*error().bias->half_width, 0.05 * 10e-3, 1e-12) << "pi4 6.4";
  scene.mesh.elements_per_radius = 20;
  EXPECT_NEAR(*error().bias->half_width, 0.05 / 4 * 10e-3, 1e-12) << "second order";
  const Extrapolation line{.depth = 9e-3,
                           .standard_error = 0.2e-3,
                           .model_error = 0.25e-3,
                           .elements_per_radius = 10,
                           .finer_elements_per_radius = 20,
                           .mesh_depth = 10e-3,
                           .finer_depth = 9.5e-3,
                           .replicates = 5};
  const DepthError found = error({.extrapolation = line});
  EXPECT_FALSE(found.bias);
  EXPECT_FALSE(error({.discretisation = 0.01}).bias) << "a study's number is in the total";
  EXPECT_EQ(found.belongs_to, "");
  EXPECT_EQ(found.of(DepthErrorSource::mesh_size).half_width, 0.25e-3);
  EXPECT_NEAR(*found.of(DepthErrorSource::mesh_phase).half_width, 2.7764 * 0.2e-3, 1e-8);
}

TEST_F(DepthErrorTest, AStudyKnowsThePhaseOfASingleRun) {
  penetration.depths.resize(1);
  penetration.standard_error.reset();
  EXPECT_FALSE(error().of(DepthErrorSource::mesh_phase).half_width);
  EXPECT_NEAR(*error({.noise = 0.01}).of(DepthErrorSource::mesh_phase).half_width, 1.96 * 0.01 * *penetration.depth,
              1e-6);
}

TEST_F(DepthErrorTest, WhatWasMeasuredStandsForTheRuleWithTheRestOfItsSeries) {
  ErrorEvidence evidence;
  for (const DepthErrorSource source : {DepthErrorSource::wall, DepthErrorSource::time_step, DepthErrorSource::bulk})
    evidence.effects.push_back({source, -0.3e-3, 0, 5});
  const DepthError found = error(evidence);
  EXPECT_NEAR(*found.of(DepthErrorSource::wall).half_width, 0.3e-3, 1e-12);
  EXPECT_NEAR(*found.of(DepthErrorSource::time_step).half_width, 0.4e-3, 1e-12) << "of second order: 4/3";
  EXPECT_NEAR(*found.of(DepthErrorSource::bulk).half_width, 0.6e-3, 1e-12) << "as 1/K: twice";
  EXPECT_THAT(found.of(DepthErrorSource::wall).how, HasSubstr("moves the depth by -3.00 %"));
  evidence.effects = {{DepthErrorSource::wall, 0, 0.1e-3, 5}};
  EXPECT_NEAR(*error(evidence).of(DepthErrorSource::wall).half_width, 2.7764e-4, 1e-8) << "no less than its scatter";
}

TEST_F(DepthErrorTest, AWallIsFeltLessWhereTheTargetIsFirmAtTheErosionLimit) {
  const double firm = share(DepthErrorSource::wall);  // 27 mu
  std::get<StrainErosion>(scene.target.erosion).limit = 0.7;
  reduction = reduce(scene);
  EXPECT_DOUBLE_EQ(share(DepthErrorSource::wall), 3 * firm) << "17 mu";
  scene.particle.speed = 200;
  std::get<StrainErosion>(scene.target.erosion).limit = 0.8;
  scene.target.width = 5e-3;
  reduction = reduce(scene);
  EXPECT_DOUBLE_EQ(share(DepthErrorSource::wall), 3 * firm) << "a fast shot";
}

TEST_F(DepthErrorTest, AFartherWallAndAFinerStepPromiseLess) {
  const double near = share(DepthErrorSource::wall), coarse = share(DepthErrorSource::time_step);
  scene.target.width = 12e-3;
  scene.solver.time_step_factor = 0.45;
  reduction = reduce(scene);
  EXPECT_DOUBLE_EQ(share(DepthErrorSource::wall), near / 2);
  EXPECT_NEAR(share(DepthErrorSource::time_step), coarse / 4, 1e-12) << "second order";
  penetration.worst_closure = 0.03;
  EXPECT_NEAR(share(DepthErrorSource::time_step), 0.03, 1e-12) << "no less than the energy's";
  penetration.worst_closure = 0;
  read("geometry = \"block\"\n" + light_into_gel);
  EXPECT_NEAR(share(DepthErrorSource::time_step), 0.04, 1e-12) << "in three dimensions";
}

TEST_F(DepthErrorTest, KIsLessSureWhereItIsSoftForTheStressAtTheErosionLimit) {
  const double stiff = share(DepthErrorSource::bulk);  // 0.25 (1.8^8) mu = 27 mu; K is 110 mu
  std::get<StrainErosion>(scene.target.erosion).limit = 1.2;
  reduction = reduce(scene);
  EXPECT_GT(share(DepthErrorSource::bulk), 2 * stiff);
  reduction.mach = 1.1;
  EXPECT_FALSE(error().of(DepthErrorSource::bulk).half_width);
}

}  // namespace
}  // namespace percal
