#include <gtest/gtest.h>

#include "calibrate/gel_job.hpp"
#include "percal/campaign/sphere_runs.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;

void expect_jacobian_by_differences(const JobModel& model, const VectorXd& at, std::span<const MeasuredShot> shots) {
  const auto answer = model.log_depths(at, shots, Want::values);
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    VectorXd up = at, down = at;
    const double step = 1e-4;
    up[j] += step;
    down[j] -= step;
    const VectorXd slope =
        (model.log_depths(up, shots, Want::values).value - model.log_depths(down, shots, Want::values).value) /
        (2 * step);
    EXPECT_LT((slope - answer.jacobian.col(j)).cwiseAbs().maxCoeff(), 1e-5) << "parameter " << j;
  }
}

VectorXd somewhere(const JobModel& model) {
  VectorXd at(static_cast<Eigen::Index>(model.parameters.size()));
  for (std::size_t k = 0; k < model.parameters.size(); ++k) {
    const auto& p = model.parameters[k];
    at[static_cast<Eigen::Index>(k)] = 0.6 * p.searched(p.low) + 0.4 * p.searched(p.high);
  }
  return at;
}

TEST(FiniteElementModel, ItsJacobianIsThatOfItsDepths) {
  for (const auto convention : {ModulusConvention::true_shear, ModulusConvention::mu_over_alpha}) {
    CalibrationJob job = test::gel_job();
    job.hypotheses[0].convention = convention;
    const auto model = finite_element_model(job, job.hypotheses[0], test::emulator_of_the_smooth_law(), 0.1);
    expect_jacobian_by_differences(model, somewhere(model), job.shots);
  }
}

TEST(FiniteElementModel, ItsJacobianByAnErosionLengthIsThatOfItsDepths) {
  const CalibrationJob job = test::gel_job_with_length();
  const auto model =
      finite_element_model(job, job.hypotheses[0], test::emulator_of_the_smooth_law(150, 0.002, true), 0.25);
  const VectorXd at = somewhere(model);
  expect_jacobian_by_differences(model, at, job.shots);
  EXPECT_NEAR(model.log_depths(at, job.shots, Want::values).jacobian(0, 3), -0.3, 0.02) << "the law's";
}

TEST(FiniteElementModel, ItsSpeedExponentIsThatOfItsDepths) {
  CalibrationJob job = test::gel_job();
  const auto emulator = test::emulator_of_the_smooth_law();
  const auto model = finite_element_model(job, job.hypotheses[0], emulator, 0.1);
  const VectorXd at = somewhere(model), exponents = model.speed_exponents(at, job.shots);
  CalibrationJob faster = job;
  for (auto& shot : faster.shots) shot.speed *= 1.0001;
  const VectorXd slope =
      (model.log_depths(at, faster.shots, Want::values).value - model.log_depths(at, job.shots, Want::values).value) /
      std::log(1.0001);
  EXPECT_LT((slope - exponents).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(FiniteElementModel, AHeldParameterIsNotSearched) {
  CalibrationJob job = test::gel_job();
  job.hypotheses[0].held[1] = 7;
  const auto model = finite_element_model(job, job.hypotheses[0], test::emulator_of_the_smooth_law(), 0.1);
  EXPECT_EQ(model.of_job, (std::vector<int>{0, 2}));
  EXPECT_EQ(natural_values(job, job.hypotheses[0], model.of_job, somewhere(model))[1], 7);
}

TEST(FiniteElementModel, HeldAsMu1AModulusIsAlphaHalvesAsStiff) {
  CalibrationJob job = test::gel_job();
  job.hypotheses[0].convention = ModulusConvention::mu_over_alpha;
  const std::vector<double> natural{100e3, 9, 0.7};
  EXPECT_DOUBLE_EQ(material_at(job, job.hypotheses[0], 0, natural).mu_true, 450e3);
}

TEST(FiniteElementModel, StressesOfACurveAreThoseOfTheOgdenSolid) {
  CalibrationJob job = test::gel_job();
  MeasuredCurve curve;
  curve.rate_factor = 4;
  for (const double stretch : {0.7, 0.95, 1.02, 1.4})
    curve.data.points.push_back({{Deformation::uniaxial, stretch}, 1000.0});
  job.curves = {curve};
  const auto model = finite_element_model(job, job.hypotheses[0], test::emulator_of_the_smooth_law(), 0.1);
  const VectorXd at = somewhere(model);
  const auto natural = natural_values(job, job.hypotheses[0], model.of_job, at);
  const auto answer = model.stresses(at, Want::values);
  for (std::size_t i = 0; i < curve.data.points.size(); ++i)
    EXPECT_NEAR(answer.value[static_cast<Eigen::Index>(i)] * 1000,
                nominal_stress(Ogden{natural[0] / 4, natural[1]}, curve.data.points[i].strained), 1e-9 * natural[0]);
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    VectorXd up = at, down = at;
    up[j] += 1e-5;
    down[j] -= 1e-5;
    const VectorXd slope = (model.stresses(up, Want::values).value - model.stresses(down, Want::values).value) / 2e-5;
    EXPECT_LT((slope - answer.jacobian.col(j)).cwiseAbs().maxCoeff(), 1e-5 * (1 + slope.cwiseAbs().maxCoeff())) << j;
  }
}

TEST(DehnModel, ItsJacobianIsThatOfItsDepths) {
  const CalibrationJob job = test::gel_job();
  const auto model = dehn_model(job);
  ASSERT_EQ(model.parameters.size(), 2u) << "c and one s";
  expect_jacobian_by_differences(model, somewhere(model), job.shots);
}

TEST(DehnModel, MaterialsWithOneModulusShareTheirStrength) {
  CalibrationJob job = test::gel_job();
  job.materials.push_back(job.materials[0]);
  EXPECT_EQ(dehn_model(job).parameters.size(), 2u);
  job.materials.back().mu = 200e3;
  EXPECT_EQ(dehn_model(job).parameters.size(), 3u);
}

// Whatever a sphere's size, the element is the same share of the length, and the emulator is told so.
TEST(ShotProblem, AMeshHasAsManyElementsInTheLengthForEverySize) {
  const CalibrationJob job = test::gel_job_with_length();
  const MaterialAt material = material_at(job, job.hypotheses[0], 0, {150e3, 8, 0.9, 0.4e-3});
  for (const auto& shot : job.shots) {
    const Problem problem = shot_problem(job, shot, material, mesh_of(shot, material, 4));
    EXPECT_NEAR(problem.elements_per_radius, 4 * shot.radius / 0.4e-3, 1e-9);
    EXPECT_NEAR(element_size(problem), 0.25, 1e-11);
    EXPECT_NEAR(inputs_of(problem).log_erosion_length, std::log(0.4e-3 / shot.radius), 1e-11);
    const Eigen::VectorXd rounding = in_order(shot_inputs(shot, material).at) - in_order(inputs_of(problem));
    EXPECT_LT(rounding.cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(ShotProblem, TheEmulatorsInputsAreThoseOfTheProblemThatIsRun) {
  const CalibrationJob job = test::gel_job();
  const MaterialAt material = material_at(job, job.hypotheses[0], 0, {150e3, 8, 0.9});
  for (const auto& shot : job.shots) {
    const Problem problem = shot_problem(job, shot, material, 8);
    const Eigen::VectorXd rounding = in_order(shot_inputs(shot, material).at) - in_order(inputs_of(problem));
    EXPECT_LT(rounding.cwiseAbs().maxCoeff(), 1e-11);
  }
}

}  // namespace
}  // namespace percal
