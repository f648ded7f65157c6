// A material that relaxes in a calibration: its curves' histories and its shots' rates, joined by a Prony series.
#include <gmock/gmock.h>

#include "calibrate/gel_job.hpp"
#include "calibrate/law_checks.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/predict/shot_model.hpp"
#include "support/program.hpp"
#include "support/relaxing_tests.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

constexpr double mesh_of_relaxation = 0.1;
enum RelaxingParameter { relaxing_mu, relaxing_alpha, relaxing_strain, relaxed_share, relaxation_time };

// Balls at many speeds and curves at two slow rates with holds; one term of relaxation, both of its numbers free.
CalibrationJob relaxing_job() {
  CalibrationJob job = test::gel_job(10);
  job.training.verify = 1 / mesh_of_relaxation;
  job.parameters.push_back(
      {ParameterKind::relaxation_share, {.name = "share", .unit = "", .low = 0, .high = 0.95, .logarithmic = false}});
  job.parameters.push_back({ParameterKind::relaxation_time, {.name = "time", .unit = "s", .low = 1e-6, .high = 100}});
  job.materials[0].relaxation = {{SharedParameter{relaxed_share}, SharedParameter{relaxation_time}}};
  return job;
}

RelaxingSolid solid_of(const std::vector<double>& natural) {
  return {{{{natural[relaxing_mu], natural[relaxing_alpha]}}}, {{{natural[relaxed_share], natural[relaxation_time]}}}};
}

void add_relaxing_curves(CalibrationJob& job, const std::vector<double>& natural, unsigned seed) {
  test::NormalNumbers normal(seed);
  job.groups.push_back({"curves", true, 0});
  for (const double rate : {0.05, 1.0}) {
    MeasuredCurve curve{.name = "tension", .material = 0, .data = {}, .group = 1};
    test::add_test(curve.data, {.rate = rate, .stretch = 1.4, .hold = 20, .ramp_rows = 10, .hold_rows = 10});
    test::fill_stresses(curve.data, solid_of(natural), 0.02, normal);
    curve.data.points.erase(curve.data.points.begin());  // rest, which no relative error measures
    job.curves.push_back(curve);
  }
}

Eigen::VectorXd searched_of(const CalibrationJob& job, const std::vector<double>& natural) {
  Eigen::VectorXd at(static_cast<Eigen::Index>(natural.size()));
  for (std::size_t k = 0; k < natural.size(); ++k)
    at[static_cast<Eigen::Index>(k)] = job.parameters[k].free.searched(natural[k]);
  return at;
}

TEST(RelaxationLaw, TheModelsDerivativesAreThoseOfItsValues) {
  for (const double time : {2.0, 2e-5}) {
    const std::vector<double> natural{250e3, 8, 0.8, 0.6, time};
    CalibrationJob job = relaxing_job();
    add_relaxing_curves(job, natural, 1);
    const JobModel model =
        finite_element_model(job, job.hypotheses[0], test::emulator_of_the_smooth_law(), mesh_of_relaxation);
    const Eigen::VectorXd at = searched_of(job, natural);
    test::expect_derivatives([&](const Eigen::VectorXd& x) { return model.log_depths(x, job.shots, Want::values); },
                             at);
    test::expect_derivatives([&](const Eigen::VectorXd& x) { return model.stresses(x, Want::values); }, at);
    std::vector<MeasuredShot> faster = job.shots;
    for (MeasuredShot& shot : faster) shot.speed *= 1.001;
    const Eigen::VectorXd moved =
        (model.log_depths(at, faster, Want::values).value - model.log_depths(at, job.shots, Want::values).value) /
        std::log(1.001);
    EXPECT_LT((moved - model.speed_exponents(at, job.shots)).cwiseAbs().maxCoeff(), 0.01) << time;
  }
}

TEST(RelaxationLaw, AShotMeetsWhatIsLeftAfterItsRadiusOverItsSpeed) {
  LayerMaterial gel{.density = 1010, .mu_true = 100e3, .alpha = 8, .erosion_strain = 0.8};
  gel.laws.relaxation = {{{0.5, 2e-5}, {0.2, 100}}};
  const SphereShot shot{.radius = 1e-3, .density = 7800, .speed = 50, .layer_depth = 0.1, .layer_width = 5e-3};
  const double left = 1 - 0.5 * (1 - std::exp(-1));  // a/v = 20 us
  EXPECT_NEAR(scene_of_shot({}, shot, gel).target.mu_as_given, left * 100e3, 1);
  EXPECT_NEAR(shot_inputs(shot, gel).at.log_pi4, std::log(1010 * 2500 / (left * 100e3)), 1e-6);
  EXPECT_TRUE(std::holds_alternative<NoRelaxation>(scene_of_shot({}, shot, gel).target.relaxation));
}

TEST(RelaxationLaw, ATermThatTakesNothingIsNone) {
  const Emulator emulator = test::emulator_of_the_smooth_law();
  CalibrationJob with = relaxing_job(), without = test::gel_job(10);
  with.hypotheses[0].held = {{relaxed_share, 0.0}, {relaxation_time, 1.0}};
  const Eigen::Vector3d at(std::log(200e3), 8, std::log(0.7));
  const auto depths = [&](const CalibrationJob& job) {
    return finite_element_model(job, job.hypotheses[0], emulator, mesh_of_relaxation)
        .log_depths(at, job.shots, Want::values)
        .value;
  };
  EXPECT_EQ(depths(with), depths(without));
}

TEST(RelaxationLaw, CurvesAndShotsTogetherTellTheSeries) {
  const std::vector<double> natural{250e3, 8, 0.8, 0.6, 2};
  CalibrationJob job = relaxing_job();
  test::measure(job, natural, 0.03, 7);
  add_relaxing_curves(job, natural, 8);
  const JobModel model =
      finite_element_model(job, job.hypotheses[0], test::emulator_of_the_smooth_law(), mesh_of_relaxation);
  const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
  int found = 0;
  for (const ProfileInterval& one : region_intervals(fit.problem, fit.minima, 0.95, quick_search())) {
    const int parameter = model.of_job[fit.of_model[one.parameter]];
    EXPECT_LT(one.interval.low, natural[parameter]) << job.parameters[parameter].free.name;
    EXPECT_GT(one.interval.high, natural[parameter]) << job.parameters[parameter].free.name;
    EXPECT_LT(one.interval.high, 1.5 * one.interval.low) << job.parameters[parameter].free.name;
    ++found;
  }
  EXPECT_EQ(found, 5);
}

class RelaxingJobFile : public test::Program {
 protected:
  std::string refusal(const std::string& material, const std::string& curve = "", bool times = true) const {
    write("curve.csv", times ? "time_s,stretch,stress_kPa\n0,1.1,10\n1,1.2,22\n2,1.2,20\n"
                             : "stretch,stress_kPa\n1.1,10\n1.2,22\n1.25,26\n");
    return test::said_of_job(write("job.toml", test::job_of_a_curve(R"([parameters.share]
kind = "relaxation share"
low = 0
high = 0.6
[parameters.tau]
kind = "relaxation time"
low = "10 us"
high = "10 s")",
                                                                    material, curve)));
  }
  const std::string series = "[[materials.gel.relaxation]]\nshare = \"share\"\ntime = \"tau\"\n";
};

TEST_F(RelaxingJobFile, SaysTheSeriesAndItsCurvesTimes) {
  EXPECT_EQ(refusal(series), "read");
  EXPECT_EQ(refusal(series, "time = \"time_s\""), "read");
  EXPECT_EQ(refusal(series, "rate = \"0.1 1/s\"", false), "read");
  EXPECT_EQ(refusal(series + "[[materials.gel.relaxation]]\nshare = 0.3\ntime = \"3 s\"\n"), "read");
}

TEST_F(RelaxingJobFile, WhatDoesNotFitTogetherIsRefused) {
  EXPECT_THAT(refusal(series, "", false), HasSubstr("no column of time"));
  EXPECT_THAT(refusal(series, "rate = \"0.1 1/s\""), HasSubstr("a rate beside the column of time"));
  EXPECT_THAT(refusal(series, "without = \"holds\""), HasSubstr("whole histories"));
  EXPECT_THAT(refusal("", "time = \"time_s\""), HasSubstr("does not relax"));
  EXPECT_THAT(refusal("rate_exponent = 0.1\nreference_rate = \"1 1/s\"\n" + series), HasSubstr("one law of the rate"));
  EXPECT_THAT(refusal(series + "[[materials.gel.relaxation]]\nshare = 0.4\ntime = \"3 s\"\n"),
              HasSubstr("add up to 1"));
  EXPECT_THAT(refusal("[[materials.gel.relaxation]]\nshare = \"tau\"\ntime = \"3 s\"\n"),
              HasSubstr("a parameter of kind \"relaxation time\""));
  std::string four;
  for (int k = 0; k < 4; ++k) four += "[[materials.gel.relaxation]]\nshare = 0.1\ntime = \"3 s\"\n";
  EXPECT_THAT(refusal(four), HasSubstr("4 terms"));
}

TEST_F(RelaxingJobFile, APlainCalibrationOfCurvesAloneGoesThroughTheProgram) {
  CurveData data;
  for (const double rate : {0.05, 1.0}) test::add_test(data, {.rate = rate, .stretch = 1.4, .hold = 20});
  test::NormalNumbers normal(3);
  test::fill_stresses(data, solid_of({50e3, 8, 0.8, 0.5, 2}), 0.02, normal);
  std::string text = "time_s,stretch,stress_Pa\n";
  for (const StressPoint& point : data.points)
    text += std::to_string(*point.time) + "," + std::to_string(point.strained.amount) + "," +
            std::to_string(point.nominal_stress) + "\n";
  write("both.csv", text);
  const test::Ended ended = run({"calibrate", write("muscle.toml", R"(
bootstrap = 0
[parameters.mu]
kind = "modulus"
low = "5 kPa"
high = "500 kPa"
[parameters.share]
kind = "relaxation share"
low = 0
high = 0.95
[parameters.tau]
kind = "relaxation time"
low = "10 ms"
high = "100 s"
[materials.gel]
density = "1010 kg/m3"
mu = "mu"
alpha = 8
erosion_strain = 0.8
[[materials.gel.relaxation]]
share = "share"
time = "tau"
[[curves]]
name = "tension"
material = "gel"
file = "both.csv"
mode = "uniaxial"
)"),
                                 "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("is the instantaneous modulus"));
}

}  // namespace
}  // namespace percal
