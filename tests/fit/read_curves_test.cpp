#include "percal/fit/read/read_curves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

CurveData curves(const std::string& text, const CurveColumns& columns = {}) {
  return curves_of(parse_csv(text, "c.csv"), columns);
}

std::string refusal(const std::string& text, const CurveColumns& columns = {}) {
  try {
    curves(text, columns);
  } catch (const BadInput& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused in " << text;
  return "";
}

TEST(ReadCurves, ColumnsAreFoundByTheirNames) {
  const auto data = curves("mode,set,stretch,nominal_stress_kPa,sem_kPa\nUT,1,1.5,3,1\nPS,1,2,5,1\n");
  ASSERT_EQ(data.points.size(), 2u);
  EXPECT_EQ(data.points[1].strained.deformation, Deformation::planar);
  EXPECT_EQ(data.points[1].strained.amount, 2);
  EXPECT_EQ(data.points[1].nominal_stress, 5000);
  EXPECT_EQ(data.sources[0].x, "stretch");
  EXPECT_EQ(data.sources[0].y, "nominal_stress_kPa");
}

TEST(ReadCurves, StrainsBecomeStretches) {
  const CurveColumns uniaxial{.mode = "uniaxial"};
  EXPECT_DOUBLE_EQ(curves("strain,stress_kPa\n0.5,3\n", uniaxial).points[0].strained.amount, 1.5);
  EXPECT_DOUBLE_EQ(curves("strain [%],stress_kPa\n-20,3\n", uniaxial).points[0].strained.amount, 0.8);
  EXPECT_DOUBLE_EQ(curves("true_strain,stress_kPa\n0.5,3\n", uniaxial).points[0].strained.amount, std::exp(0.5));
  EXPECT_DOUBLE_EQ(curves("green_strain,stress_kPa\n1.5,3\n", uniaxial).points[0].strained.amount, 2);
  EXPECT_DOUBLE_EQ(curves("strain,shear_stress_kPa\n0.5,3\n", {.mode = "shear"}).points[0].strained.amount, 0.5);
}

TEST(ReadCurves, StretchOrGammaMeansWhatTheModeNeeds) {
  const auto data = curves("mode,x_stretch_or_gamma,stress_kPa\ncompression,0.9,-3\nsimple_shear,-0.2,-5\n");
  EXPECT_EQ(data.points[0].strained.amount, 0.9);
  EXPECT_EQ(data.points[1].strained.amount, -0.2);
}

TEST(ReadCurves, ACauchyStressIsRecognisedAndConverted) {
  const auto data = curves("stretch,cauchy_stress_kPa\n1.5,3\n", {.mode = "ET"});
  EXPECT_EQ(data.sources[0].stress, StressMeasure::cauchy);
  EXPECT_DOUBLE_EQ(data.points[0].nominal_stress, 2000);
  EXPECT_DOUBLE_EQ(curves("stretch,true_stress_kPa\n1.5,3\n", {.mode = "UT"}).points[0].nominal_stress, 2000);
  EXPECT_DOUBLE_EQ(curves("gamma,cauchy_stress_kPa\n1.5,3\n", {.mode = "SS"}).points[0].nominal_stress, 3000);
}

TEST(ReadCurves, StandardErrorsAreFoundByTheirNamesAndInTheirUnit) {
  const auto error = [](const std::string& header, const CurveColumns& columns = {.mode = "UT"}) {
    return curves("stretch,stress_kPa," + header + "\n1.5,3,20\n", columns).points[0].standard_error;
  };
  for (const std::string header : {"sem_Pa", "se_Pa", "stress_sd_Pa", "std_error [Pa]", "stress_uncertainty_Pa"})
    EXPECT_EQ(error(header), 20) << header;
  EXPECT_EQ(error("sem_kPa"), 20000);
  EXPECT_EQ(error("strain_sd [%]"), std::nullopt);
  EXPECT_EQ(error("scatter_Pa"), std::nullopt);
  EXPECT_EQ(error("scatter_Pa", {.mode = "UT", .error = "scatter"}), 20);
  const auto cauchy = curves("stretch,cauchy_stress_kPa,sem_kPa\n2,3,1\n", {.mode = "UT"});
  EXPECT_EQ(cauchy.points[0].standard_error, 500);
  EXPECT_EQ(cauchy.sources[0].error, "sem_kPa");
  const auto two = curves("stretch,stress_kPa,stress_sd_kPa,sem_kPa\n2,3,1,7\n", {.mode = "UT"});
  EXPECT_EQ(two.points[0].standard_error, 1000);
  const auto some = curves("stretch,stress_kPa,sem_kPa\n2,3,\n2.5,4,0.5\n", {.mode = "UT"});
  EXPECT_EQ(some.points[0].standard_error, std::nullopt);
  EXPECT_EQ(some.points[1].standard_error, 500);
  EXPECT_THAT(refusal("stretch,stress_kPa,sem_kPa\n2,3,-1\n", {.mode = "UT"}), HasSubstr("c.csv:2: sem_kPa"));
}

TEST(ReadCurves, GeneralBiaxialTakesBothStretches) {
  const CurveColumns along_y{.mode = "general_biaxial", .x = "stretch_y", .y = "cauchy_yy_MPa"};
  const auto data = curves("stretch_x,stretch_y,cauchy_xx_MPa,cauchy_yy_MPa\n1.1,1.25,1,2\n", along_y);
  EXPECT_EQ(data.points[0].strained.amount, 1.25);
  EXPECT_EQ(data.points[0].strained.across, 1.1);
  EXPECT_DOUBLE_EQ(data.points[0].nominal_stress, 1.6e6);
}

TEST(ReadCurves, SeveralPossibleColumnsAreNotGuessed) {
  const std::string text = "stretch_x,stretch_y,cauchy_xx_MPa,cauchy_yy_MPa\n1.1,1.2,1,2\n";
  EXPECT_THAT(refusal(text, {.mode = "ET"}), AllOf(HasSubstr("cauchy_xx_MPa, cauchy_yy_MPa"), HasSubstr("--y")));
  EXPECT_THAT(refusal(text, {.mode = "ET", .y = "cauchy_xx"}),
              AllOf(HasSubstr("stretch_x, stretch_y"), HasSubstr("--x")));
}

TEST(ReadCurves, EveryBadLineOfEveryColumnIsNamedTogether) {
  const auto message = refusal("mode,stretch,stress_kPa\nUT,1.5,3\nUX,1.6,4\nUT,one,4\nUT,1.7,\n");
  for (const std::string part : {"c.csv:3: mode", "c.csv:4: stretch", "c.csv:5: stress_kPa"})
    EXPECT_THAT(message, HasSubstr(part));
  const auto stretches = refusal("mode,stretch,stress_kPa\nUT,0,3\nUT,-1,4\nUT,1.5,4\nSS,1.2,3\n");
  for (const std::string part : {"c.csv:2: stretch", "c.csv:3: stretch", "c.csv:5: stretch"})
    EXPECT_THAT(stretches, HasSubstr(part));
}

TEST(ReadCurves, WhatIsMissingIsSaid) {
  EXPECT_THAT(refusal("stretch,stress_kPa\n1.5,3\n"), HasSubstr("--mode"));
  EXPECT_THAT(refusal("stretch,stress\n1.5,3\n", {.mode = "UT"}), HasSubstr("kPa"));
  EXPECT_THAT(refusal("stretch,stress_kPa\n1.5,3\n", {.mode = "sideways"}), HasSubstr("equibiaxial"));
  EXPECT_THAT(refusal("stretch,force_N\n1.5,3\n", {.mode = "UT"}), HasSubstr("force_N"));
  EXPECT_THAT(refusal("v_m_s,depth_mm\n1.5,3\n"), HasSubstr("depths of shots"));
  EXPECT_THAT(refusal("position,stress_kPa\n1.5,3\n", {.mode = "UT", .x = "position"}),
              HasSubstr("does not say what it counts"));
  EXPECT_THAT(refusal("gamma,stress_kPa\n1.5,3\n", {.mode = "UT"}), HasSubstr("gamma for uniaxial"));
  EXPECT_THAT(refusal("strain,stress_kPa\n-1,3\n", {.mode = "UT"}), HasSubstr("above -1"));
  EXPECT_THAT(refusal("strain,stress_kPa\n1,1e28\n", {.mode = "UT"}), HasSubstr("1e+30"));
}

TEST(ReadCurves, AModeThatTheFileContradictsIsNotIgnored) {
  const std::string file = PERCAL_DATA "/public/treloar1944_rubber_primary.csv";
  EXPECT_THROW(read_curves({file}, {.mode = "ET"}), BadInput);
  EXPECT_EQ(read_curves({file}, {.mode = "ET", .where = {"mode=ET"}}).points.size(), 16u);
}

TEST(ReadCurves, SeveralFilesAreOneSetOfPoints) {
  const std::string folder = PERCAL_DATA "/public/";
  const auto data =
      read_curves({folder + "treloar1944_rubber_primary.csv", folder + "meunier2008_silicone_modes.csv"}, {});
  EXPECT_EQ(data.points.size(), 53u + 66u);
  EXPECT_EQ(data.sources[1].points, 66);
  EXPECT_EQ(data.points[52].source, 0);
  EXPECT_EQ(data.points[53].source, 1);
}

TEST(ReadCurves, EveryPublicFileOfCurvesIsReadAsItIs) {
  const std::string folder = PERCAL_DATA "/public/";
  const auto count = [&](const std::string& file, const CurveColumns& columns) {
    return read_curves({folder + file}, columns).points.size();
  };
  EXPECT_EQ(count("treloar1944_rubber_primary.csv", {}), 53u);
  EXPECT_EQ(count("meunier2008_silicone_modes.csv", {}), 66u);
  EXPECT_EQ(count("stpierre2023_meat_tension_compression_shear.csv", {.where = {"material_label=ac"}}), 78u);
  EXPECT_EQ(count("budday2017_brain_cann_table.csv", {.where = {"region=cortex"}}), 66u);
  const CurveColumns skin{
      .mode = "equibiaxial", .x = "stretch_x", .y = "cauchy_xx_MPa", .where = {"protocol=equibiaxial"}};
  EXPECT_EQ(count("tac2022_porcine_skin_biaxial.csv", skin), 81u);
  EXPECT_THROW(count("gelatin_bb_calibration_points.csv", {}), BadInput);
}

}  // namespace
}  // namespace percal
