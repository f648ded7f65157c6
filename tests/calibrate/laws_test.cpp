// Laws of a material: its modulus against the rate, its erosion strain against the sphere's size.
#include <gmock/gmock.h>

#include "calibrate/gel_job.hpp"
#include "calibrate/law_checks.hpp"
#include "calibrate/shots_of_the_solver.hpp"
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/kept_model.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/math/statistics.hpp"
#include "percal/predict/predictor.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

constexpr double mesh_of_laws = 0.1;
enum { mu, alpha, strain, rate_power, size_power };

// Balls of two sizes at many speeds, two slow curves; alpha is held.
CalibrationJob job_with_laws(int shots = 14) {
  CalibrationJob job = test::gel_job(shots);
  job.training.verify = 1 / mesh_of_laws;
  job.parameters.push_back({ParameterKind::rate_exponent,
                            {.name = "rate_power", .unit = "", .low = -0.2, .high = 0.5, .logarithmic = false}});
  job.parameters.push_back({ParameterKind::size_exponent,
                            {.name = "size_power", .unit = "", .low = -0.8, .high = 0.8, .logarithmic = false}});
  CalibrationMaterial& gel = job.materials[0];
  gel.rate_exponent = SharedParameter{rate_power};
  gel.size_exponent = SharedParameter{size_power};
  gel.reference_rate = 4e4;
  gel.reference_radius = 1e-3;
  job.hypotheses[0].held = {{alpha, 8.0}};
  for (int k = 0; k < shots; k += 2) {
    job.shots[k].radius = 0.7e-3;
    job.shots[k].layer_width = 5 * job.shots[k].radius;
  }
  return job;
}

// Nominal stresses in tension at two rates, with 2 % scatter.
void add_curves(CalibrationJob& job, const std::vector<double>& natural, unsigned seed) {
  Draws draws(seed);
  job.groups.push_back({"curves", true, 0});
  for (const double rate : {0.01, 10.0}) {
    MeasuredCurve curve{.name = "tension", .material = 0, .data = {}, .rate = rate, .group = 1};
    const double modulus = natural[mu] * std::pow(rate / job.materials[0].reference_rate, natural[rate_power]);
    for (const double stretch : {1.1, 1.2, 1.3, 1.4, 1.5}) {
      const double law =
          2 / natural[alpha] * (std::pow(stretch, natural[alpha] - 1) - std::pow(stretch, -natural[alpha] / 2 - 1));
      curve.data.points.push_back({.strained = {Deformation::uniaxial, stretch},
                                   .nominal_stress = modulus * law * (1 + 0.02 * draws.normal())});
    }
    job.curves.push_back(curve);
  }
}

const std::vector<double> true_laws{250e3, 8, 0.8, 0.12, -0.25};

TEST(Laws, TheModelsDerivativesAreThoseOfItsValues) {
  CalibrationJob job = job_with_laws();
  job.hypotheses[0].held.clear();
  add_curves(job, true_laws, 1);
  const JobModel model = finite_element_model(job, job.hypotheses[0], test::emulator_of_the_smooth_law(), mesh_of_laws);
  Eigen::VectorXd at(5);
  for (int k = 0; k < 5; ++k) at[k] = job.parameters[k].free.searched(true_laws[k]);
  test::expect_derivatives([&](const Eigen::VectorXd& x) { return model.log_depths(x, job.shots, Want::values); }, at);
  test::expect_derivatives([&](const Eigen::VectorXd& x) { return model.stresses(x, Want::values); }, at);
  // Spheres of 1.4 mm diameter below a cell of 2 mm, the others above.
  job.parameters.push_back({ParameterKind::erosion_strain, {.name = "below", .unit = "", .low = 0.3, .high = 1.5}});
  job.materials[0].erosion_strain_below = SharedParameter{5};
  job.materials[0].cell = 2e-3;
  const JobModel with_cell =
      finite_element_model(job, job.hypotheses[0], test::emulator_of_the_smooth_law(), mesh_of_laws);
  at.conservativeResize(6);
  at[5] = std::log(0.5);
  test::expect_derivatives([&](const Eigen::VectorXd& x) { return with_cell.log_depths(x, job.shots, Want::values); },
                           at);
  at.conservativeResize(5);
  // A faster shot meets a stiffer gel.
  const Eigen::VectorXd exponents = model.speed_exponents(at, job.shots);
  std::vector<MeasuredShot> faster = job.shots;
  for (MeasuredShot& shot : faster) shot.speed *= 1.001;
  const Eigen::VectorXd moved =
      (model.log_depths(at, faster, Want::values).value - model.log_depths(at, job.shots, Want::values).value) /
      std::log(1.001);
  EXPECT_LT((moved - exponents).cwiseAbs().maxCoeff(), 0.01);
}

TEST(Laws, ThatAreHeldAtNothingChangeNoBit) {
  const Emulator emulator = test::emulator_of_the_smooth_law();
  CalibrationJob with = job_with_laws(), without = with;
  with.hypotheses[0].held = {{alpha, 8.0}, {rate_power, 0.0}, {size_power, 0.0}};
  without.parameters.resize(3);
  without.materials[0].rate_exponent = without.materials[0].size_exponent = 0.0;
  const Eigen::Vector2d at(std::log(200e3), std::log(0.7));
  EXPECT_EQ(finite_element_model(with, with.hypotheses[0], emulator, mesh_of_laws)
                .log_depths(at, with.shots, Want::values)
                .value,
            finite_element_model(without, without.hypotheses[0], emulator, mesh_of_laws)
                .log_depths(at, without.shots, Want::values)
                .value);
}

TEST(Laws, AreInTheScenesThatARunIsMadeOf) {
  const LayerMaterial gel{
      .density = 1010,
      .mu_true = 100e3,
      .alpha = 8,
      .erosion_strain = 0.8,
      .laws = {.rate_exponent = 0.5, .reference_rate = 100, .size_exponent = -1, .reference_radius = 2e-3}};
  const SphereShot shot{.radius = 1e-3, .density = 7800, .speed = 40, .layer_depth = 0.1, .layer_width = 5e-3};
  const Scene scene = scene_of_shot({}, shot, gel);
  EXPECT_NEAR(scene.target.mu_as_given, 2e6, 1);  // 40,000 1/s: 20 times as stiff
  EXPECT_DOUBLE_EQ(std::get<StrainErosion>(scene.target.erosion).limit, 1.6);
  EXPECT_NEAR(shot_inputs(shot, gel).at.log_pi4, std::log(1010 * 1600 / 2e6), 1e-9);
}

TEST(Laws, ASphereBelowACellMeetsAStrainOfItsOwn) {
  LayerMaterial skin{.density = 1000, .mu_true = 1e7, .alpha = 8, .erosion_strain = 0.9};
  skin.laws.cell = 2e-3;
  skin.laws.erosion_strain_below = 0.4;
  const SphereShot small{.radius = 0.99e-3, .density = 7800, .speed = 40, .layer_depth = 0.1, .layer_width = 5e-3};
  SphereShot large = small;
  large.radius = 1.01e-3;
  EXPECT_EQ(shot_inputs(small, skin).at.erosion_strain, 0.4);
  EXPECT_EQ(shot_inputs(large, skin).at.erosion_strain, 0.9);
  EXPECT_EQ(shot_inputs(small, skin).by_material[0].col(2).norm(), 0) << "the other strain is nothing to it";
  EXPECT_EQ(shot_inputs(large, skin).by_material[0].col(6).norm(), 0);
}

// Balls of two sizes into a gel that the rate stiffens, shot by the solver on a coarse mesh as means over its phase, and two slow curves.
TEST(SlowLaws, ComeBackFromShotsOfTheSolver) {
  test::OwnCampaign own;
  CalibrationJob job = job_with_laws(8);
  const std::vector<double> truth{250e3, 8, 0.8, 0.12, 0};
  add_curves(job, truth, 3);
  job.hypotheses[0].held = {{alpha, truth[alpha]}, {strain, truth[strain]}, {size_power, truth[size_power]}};
  test::train_coarsely(job);
  for (MeasuredShot& shot : job.shots) {
    shot.speed += 25;
    shot.depth = mean(test::solved_numbers(job, shot, truth, own.campaign));
  }
  const CalibrationResult result = calibrate(job, own.store, own.campaign, {}, [](const std::string&) {});
  ASSERT_FALSE(result.hypotheses.empty()) << result.findings.at(0);
  const auto& intervals = result.hypotheses[0].intervals;
  ASSERT_EQ(intervals.size(), 2u);
  for (const std::size_t k : {0u, 1u}) {
    const double true_number = truth[k == 0 ? mu : rate_power];
    RecordProperty(k == 0 ? "mu" : "power",
                   std::to_string(intervals[k].interval.low) + " to " + std::to_string(intervals[k].interval.high));
    EXPECT_LE(intervals[k].interval.low, true_number);
    EXPECT_GE(intervals[k].interval.high, true_number);
  }
  EXPECT_LT(intervals[1].interval.high - intervals[1].interval.low, 0.1) << "and they say something";
}

// 100 truths: depths with 5 % scatter and, of the rate, curves beside them.
TEST(SlowLaws, AreRecoveredByTheirIntervals) {
  const Emulator emulator = test::emulator_of_the_smooth_law();
  const auto points = sobol_points(100, 4, 1);
  std::array<int, 5> held{};
  int shots_held = 0, shots_predicted = 0;
  for (int t = 0; t < 100; ++t) {
    CalibrationJob job = job_with_laws();
    const std::vector<double> natural{180e3 * std::exp(0.7 * points(t, 0)), 8, 0.6 + 0.4 * points(t, 1),
                                      0.02 + 0.2 * points(t, 2), -0.4 + 0.8 * points(t, 3)};
    test::measure(job, natural, 0.05, 500 + static_cast<unsigned>(t));
    add_curves(job, natural, 900 + static_cast<unsigned>(t));
    job.shots[5].used = job.shots[12].used = false;
    const JobModel model = finite_element_model(job, job.hypotheses[0], emulator, mesh_of_laws);
    const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
    for (const ProfileInterval& one : region_intervals(fit.problem, fit.minima, 0.95, quick_search())) {
      const int parameter = model.of_job[fit.of_model[one.parameter]];
      held[parameter] += one.interval.low <= natural[parameter] && natural[parameter] <= one.interval.high;
    }
    for (const ShotDepth& depth : shot_depths(job, model, fit, {5, 12})) {
      ++shots_predicted;
      shots_held += test::holds(depth, job.shots[depth.shot]);
    }
  }
  for (const int parameter : {mu, strain, rate_power, size_power}) {
    RecordProperty("parameter " + std::to_string(parameter), held[parameter]);
    EXPECT_GE(held[parameter], 89) << parameter;
    EXPECT_LE(held[parameter], 99) << parameter;
  }
  RecordProperty("shots", shots_held);
  EXPECT_GE(shots_held, 0.89 * shots_predicted);
}

class LawsJob : public test::Program {
 protected:
  std::string refusal(const std::string& material, const std::string& curve = "") const {
    write("curve.csv", "stretch,stress_kPa\n1.1,10\n1.2,22\n");
    return test::said_of_job(write("job.toml", test::job_of_a_curve(R"([parameters.m]
kind = "rate exponent"
low = -0.1
high = 0.4)",
                                                                    material, curve)));
  }
};

TEST_F(LawsJob, APowerNeedsWhatItIsAPowerOf) {
  EXPECT_EQ(refusal("rate_exponent = \"m\"\nreference_rate = \"100 1/s\"", "rate = \"0.01 1/s\""), "read");
  EXPECT_THAT(refusal("rate_exponent = \"m\""), HasSubstr("reference_rate"));
  EXPECT_THAT(refusal("reference_rate = \"100 1/s\""), HasSubstr("both or none"));
  EXPECT_THAT(refusal("rate_exponent = \"m\"\nreference_rate = \"100 1/s\""), HasSubstr("rate: found no such key"));
  EXPECT_THAT(refusal("rate_exponent = \"mu\"\nreference_rate = \"100 1/s\"", "rate = \"0.01 1/s\""),
              HasSubstr("a parameter of kind \"modulus\""));
}

}  // namespace
}  // namespace percal
