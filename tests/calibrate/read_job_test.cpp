// Calibration jobs as they are read.
#include <gmock/gmock.h>

#include "calibrate/small_job.hpp"
#include "percal/calibrate/hypothesis_findings.hpp"

namespace percal {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

class ReadCalibrationJob : public calibrate_test::SmallJob {};

TEST_F(ReadCalibrationJob, ParametersHaveKindBoundsAndPrior) {
  const auto job = read_job();
  ASSERT_EQ(job.parameters.size(), 4u);
  const FreeParameter& mu = job.parameters[0].free;
  EXPECT_EQ(mu.name, "mu");
  EXPECT_EQ(job.parameters[0].kind, ParameterKind::modulus);
  EXPECT_TRUE(mu.logarithmic);
  EXPECT_EQ(mu.unit, "Pa");
  EXPECT_DOUBLE_EQ(mu.low, 1e4);
  EXPECT_DOUBLE_EQ(mu.high, 1e6);
  EXPECT_DOUBLE_EQ(mu.prior.value(), 1e5);
  EXPECT_DOUBLE_EQ(mu.prior_error, 0.5);
  EXPECT_EQ(job.parameters[2].kind, ParameterKind::exponent);
  EXPECT_FALSE(job.parameters[2].free.logarithmic);
  EXPECT_EQ(job.parameters[3].kind, ParameterKind::erosion_strain);
  EXPECT_TRUE(job.parameters[3].free.logarithmic);
}

TEST_F(ReadCalibrationJob, MaterialsShareParametersOrHaveNumbersOfTheirOwn) {
  const auto job = read_job();
  ASSERT_EQ(job.materials.size(), 2u);
  EXPECT_EQ(std::get<SharedParameter>(job.materials[0].alpha).index, 2);
  EXPECT_EQ(std::get<SharedParameter>(job.materials[1].alpha).index, 2);
  EXPECT_EQ(std::get<SharedParameter>(job.materials[1].mu).index, 1);
  EXPECT_DOUBLE_EQ(std::get<double>(job.materials[1].erosion_strain), 0.8);
  EXPECT_DOUBLE_EQ(job.materials[0].rate_factor.value(), 10);
  EXPECT_DOUBLE_EQ(job.materials[0].rate_factor_error, 0.05);
  EXPECT_DOUBLE_EQ(job.materials[0].curve_modulus.value(), 9e4);
  EXPECT_FALSE(job.materials[1].rate_factor.has_value());
}

TEST_F(ReadCalibrationJob, ModuliWithUnitsAreNumbers) {
  const auto job = read_job({{"[parameters.mu_hard]\nkind = \"modulus\"\nlow = \"20 kPa\"\nhigh = \"2 MPa\"\n", ""},
                             {"mu = \"mu_hard\"", "mu = \"113 kPa\""}});
  EXPECT_DOUBLE_EQ(std::get<double>(job.materials[1].mu), 113e3);
}

TEST_F(ReadCalibrationJob, RowsOfATableAreShots) {
  const auto job = read_job();
  ASSERT_EQ(job.shots.size(), 6u);
  const MeasuredShot& second = job.shots[1];
  EXPECT_EQ(second.label, "steel 3 mm at 60 m/s into soft");
  EXPECT_DOUBLE_EQ(second.radius, 1.5e-3);
  EXPECT_DOUBLE_EQ(second.density, 7800);
  EXPECT_DOUBLE_EQ(second.speed, 60);
  EXPECT_DOUBLE_EQ(second.speed_error, 2);
  EXPECT_DOUBLE_EQ(second.depth, 0.024);
  EXPECT_DOUBLE_EQ(second.layer_depth, 0.06);
  EXPECT_DOUBLE_EQ(second.layer_width, 7.5e-3);
  EXPECT_EQ(second.row.at("ball"), "steel");
  EXPECT_EQ(second.row.at("diameter_mm"), "3");
}

TEST_F(ReadCalibrationJob, ADensityMayBeAMass) {
  const double mass = 7800 * 4 * 3.14159265358979 / 3 * 1e-9;  // kg, of a ball of 2 mm
  const auto job = read_job(
      {{"diameter = \"2 mm\"\nparticle_density = \"7800 kg/m3\"", "diameter = \"2 mm\"\nparticle_mass = \"32.67 mg\""},
       {"particle_density_column = \"density_kg_m3\"\ndiameter_column",
        "particle_mass = \"32.67 mg\"\ndiameter_column"}});
  EXPECT_NEAR(job.shots[4].density, 7800 * 32.67e-6 / mass, 0.1);
  EXPECT_NEAR(job.shots[1].density, 7800 * 32.67e-6 / mass / std::pow(1.5, 3), 0.1) << "of a ball of 3 mm";
  EXPECT_EQ(read_job().shots[4].density, 7800);
  // Or the mass over the area that faces the target.
  const auto over_area = read_job({{"diameter = \"2 mm\"\nparticle_density = \"7800 kg/m3\"",
                                    "diameter = \"2 mm\"\nparticle_sectional_density = \"10.4 kg/m2\""},
                                   {"particle_density_column = \"density_kg_m3\"\ndiameter_column",
                                    "particle_sectional_density = \"1.04 g/cm2\"\ndiameter_column"}});
  EXPECT_NEAR(over_area.shots[4].density, 7800, 1e-9);
  EXPECT_NEAR(over_area.shots[1].density, 5200, 1e-9) << "of a ball of 3 mm";
}

TEST_F(ReadCalibrationJob, ConditionsChooseWhichRowsAreCensoredFittedAndHaveAnError) {
  const auto job = read_job();
  const auto of = [&](auto member) {
    std::vector<std::decay_t<decltype(job.shots[0].*member)>> all;
    for (int i = 0; i < 4; ++i) all.push_back(job.shots[i].*member);
    return all;
  };
  EXPECT_THAT(of(&MeasuredShot::datum),
              ElementsAre(ShotDatum::depth, ShotDatum::depth, ShotDatum::at_least, ShotDatum::depth));
  EXPECT_THAT(of(&MeasuredShot::used), ElementsAre(true, true, true, false));
  EXPECT_THAT(of(&MeasuredShot::depth_error),
              ElementsAre(DoubleEq(0.05 * 0.015), DoubleEq(0.05 * 0.024), DoubleEq(0.05 * 0.06), 0));
}

TEST_F(ReadCalibrationJob, PointsInTheJobAreShots) {
  const auto job = read_job();
  const MeasuredShot &slow = job.shots[4], &fast = job.shots[5];
  EXPECT_EQ(slow.label, "sphere 2 mm at 50 m/s");
  EXPECT_DOUBLE_EQ(slow.radius, 1e-3);
  EXPECT_DOUBLE_EQ(slow.depth_error, 0.4e-3);
  EXPECT_DOUBLE_EQ(slow.layer_depth, 40e-3);
  EXPECT_DOUBLE_EQ(slow.layer_width, 5e-3);
  EXPECT_TRUE(slow.used);
  EXPECT_EQ(fast.label, "the fast one");
  EXPECT_EQ(fast.datum, ShotDatum::at_least);
  EXPECT_FALSE(fast.used);
  EXPECT_DOUBLE_EQ(fast.speed_error, 1);
  EXPECT_EQ(fast.target, 1);
}

TEST_F(ReadCalibrationJob, SetsAndScatterGroupsAreNamed) {
  const auto job = read_job();
  ASSERT_EQ(job.sets.size(), 2u);
  EXPECT_TRUE(job.sets[0].leave_one_out);
  EXPECT_FALSE(job.sets[1].leave_one_out);
  const auto group = [&](const auto& data) { return job.groups[data.group]; };
  EXPECT_EQ(group(job.shots[0]).name, "shots");
  EXPECT_TRUE(group(job.shots[0]).estimated);
  EXPECT_EQ(group(job.shots[4]).name, "few");
  EXPECT_FALSE(group(job.shots[4]).estimated);
  EXPECT_DOUBLE_EQ(group(job.shots[4]).fixed, 0.03);
  EXPECT_EQ(group(job.curves[0]).name, "curves");
}

TEST_F(ReadCalibrationJob, BlocksOfOneNameAreOneSet) {
  const auto job = read_job({{"name = \"by hand\"", "name = \"balls\"\nleave_one_out = true"}});
  ASSERT_EQ(job.sets.size(), 1u);
  EXPECT_EQ(job.shots[5].set, 0);
}

TEST_F(ReadCalibrationJob, CurvesHaveTheirFactorAndError) {
  const auto job = read_job();
  ASSERT_EQ(job.curves.size(), 1u);
  const MeasuredCurve& curve = job.curves[0];
  ASSERT_EQ(curve.data.points.size(), 2u);
  EXPECT_DOUBLE_EQ(curve.data.points[1].nominal_stress, 11e3);
  EXPECT_DOUBLE_EQ(curve.relative_error, 0.02);
  EXPECT_DOUBLE_EQ(curve.rate_factor, 10);
  EXPECT_DOUBLE_EQ(curve.rate_factor_error, 0.1);
  EXPECT_TRUE(curve.synthetic);
}

TEST_F(ReadCalibrationJob, WhatACurveContradictsIsTheFirstFinding) {
  write("curve.csv", "test,stretch,strain,stress_kPa\na,1.1,0.1,5.5\na,1.2,0.2,11\n");
  const auto job = read_job({{"x = \"stretch\"", "x = \"strain\""}, {"mode = \"uniaxial\"", "mode = \"compression\""}});
  EXPECT_LT(job.curves[0].data.points[1].nominal_stress, 0);
  EXPECT_LT(job.curves[0].data.points[1].strained.amount, 1);
  EXPECT_THAT(overall_findings(job, {}).at(0), HasSubstr("compression written with positive numbers"));
  EXPECT_THAT(overall_findings(read_job(), {}), testing::Not(testing::Contains(HasSubstr("curve.csv"))));
}

TEST_F(ReadCalibrationJob, ACurveMayBeForceAndDisplacementUpToItsPeak) {
  write("curve.csv", "Extension (mm),Load (N)\n0,0\n1,1\n2,2\n3,3\n4,4\n5,5\n6,6\n7,4\n8,2\n");
  const std::string sizes = "gauge_length = \"10 mm\"\narea = \"50 mm2\"\nuntil = \"peak\"";
  const auto with = [](const std::string& keys) {
    return std::vector<std::pair<std::string, std::string>>{
        {"where = [\"test=a\"]\nx = \"stretch\"\ny = \"stress\"", keys}};
  };
  const auto refusal = [&](const std::string& keys) {
    try {
      read_job(with(keys));
    } catch (const BadInput& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  const auto job = read_job(with(sizes));
  ASSERT_EQ(job.curves[0].data.points.size(), 7u);
  EXPECT_DOUBLE_EQ(job.curves[0].data.points[6].strained.amount, 1.6);
  EXPECT_DOUBLE_EQ(job.curves[0].data.points[6].nominal_stress, 6 / 50e-6);
  EXPECT_THAT(overall_findings(job, {}), testing::Contains(HasSubstr("stretch = 1 + Extension/10 mm")));
  EXPECT_THAT(refusal(sizes + "\nwidth = \"1 mm\""), HasSubstr("curves[1].width: found a width beside an area"));
  EXPECT_THAT(refusal("branch = \"up\""), HasSubstr("curves[1].branch: found \"up\""));
  EXPECT_THAT(refusal("without = \"peaks\""), HasSubstr("accepted: \"holds\""));
}

TEST_F(ReadCalibrationJob, HypothesesHoldNumbersAndMakeChoices) {
  const auto job = read_job();
  ASSERT_EQ(job.hypotheses.size(), 2u);
  EXPECT_TRUE(job.hypotheses[0].held.empty());
  EXPECT_EQ(job.hypotheses[0].convention, ModulusConvention::true_shear);
  EXPECT_THAT(job.hypotheses[1].held, ElementsAre(testing::Pair(0, DoubleEq(9e4)), testing::Pair(2, DoubleEq(5))));
  EXPECT_EQ(job.hypotheses[1].convention, ModulusConvention::mu_over_alpha);
  EXPECT_EQ(job.hypotheses[1].measure, StrainMeasure::true_strain);
}

TEST_F(ReadCalibrationJob, HypothesesMayBeCalledReadingsAsTheyOnceWere) {
  const auto job = read_job({{"[[hypotheses]]\nname = \"free\"", "[[readings]]\nname = \"free\""},
                             {"[[hypotheses]]\nname = \"held\"", "[[readings]]\nname = \"held\""},
                             {"hypotheses = [\"free\"]", "readings = [\"free\"]"}});
  ASSERT_EQ(job.hypotheses.size(), 2u);
  EXPECT_EQ(job.hypotheses[1].name, "held");
  EXPECT_THAT(job.cross_validations.at(0).hypotheses, ElementsAre(0));
}

TEST_F(ReadCalibrationJob, WithoutHypothesesTheDataAreReadAsGiven) {
  std::string text = calibrate_test::small_job;
  const auto from = text.find("[[hypotheses]]"), to = text.find("[[cross_validation]]");
  text.erase(from, to - from);
  text.erase(text.find("hypotheses = [\"free\"]\n"), std::string("hypotheses = [\"free\"]\n").size());
  const auto job = read_calibration_job(write("job.toml", text));
  ASSERT_EQ(job.hypotheses.size(), 1u);
  EXPECT_EQ(job.hypotheses[0].name, "as given");
}

TEST_F(ReadCalibrationJob, CrossValidationsPairsTrainingAndSolverAreRead) {
  const auto job = read_job();
  ASSERT_EQ(job.cross_validations.size(), 1u);
  EXPECT_THAT(job.cross_validations[0].fit, ElementsAre("set=balls", "ball=steel"));
  EXPECT_THAT(job.cross_validations[0].hypotheses, ElementsAre(0));
  EXPECT_DOUBLE_EQ(job.cross_validations[0].goal.value(), 0.07);
  ASSERT_EQ(job.published.size(), 1u);
  EXPECT_EQ(job.published[0].modulus, 0);
  EXPECT_DOUBLE_EQ(job.published[0].pairs.at(1).mu, 120e3);
  EXPECT_DOUBLE_EQ(job.published[0].pairs.at(1).erosion_strain, 0.7);
  EXPECT_EQ(job.training.coarse, 4);
  EXPECT_EQ(job.training.fine, 6);
  EXPECT_EQ(job.training.verify, 7);
  EXPECT_EQ(job.training.initial, 20);
  EXPECT_EQ(job.training.batch, 5);
  EXPECT_EQ(job.training.most, 30);
  EXPECT_DOUBLE_EQ(job.training.fine_share, 0.25);
  EXPECT_DOUBLE_EQ(job.training.accuracy, 0.5);
  EXPECT_DOUBLE_EQ(job.training.failures_tolerated, 0.3);
  EXPECT_EQ(job.training.verify_replicates, 2);
  EXPECT_EQ(job.training.seed, 7u);
  EXPECT_EQ(job.solver.arithmetic, Arithmetic::double_precision);
  EXPECT_DOUBLE_EQ(job.level, 0.9);
  EXPECT_EQ(job.bootstrap, 20);
  EXPECT_EQ(job.text, calibrate_test::small_job);
}

TEST(CalibrationExamples, SkinConsistentHasTheShotsOfThreeTables) {
  const auto job = read_calibration_job(test::guha2009 + "skin_consistent.toml");
  ASSERT_EQ(job.shots.size(), 24u + 3 + 9);
  EXPECT_EQ(job.sets.size(), 3u);
  int used = 0, censored = 0;
  for (const MeasuredShot& shot : job.shots) {
    used += shot.used;
    censored += shot.datum == ShotDatum::at_least;
  }
  EXPECT_EQ(used, 24 + 3 + 1);
  EXPECT_EQ(censored, 1);
  EXPECT_DOUBLE_EQ(job.shots[0].radius, 1.59e-3);  // the corrected diameter of the first rows
  EXPECT_DOUBLE_EQ(job.shots[32].depth_error, 0.90e-6);
  EXPECT_DOUBLE_EQ(job.shots[32].speed, 651);
  EXPECT_EQ(job.hypotheses.front().name, "mu free");
  EXPECT_DOUBLE_EQ(job.hypotheses.at(1).held.at(0), 113e3);
  EXPECT_EQ(job.published.at(0).pairs.size(), 6u);
}

}  // namespace
}  // namespace percal
