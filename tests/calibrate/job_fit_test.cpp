#include "percal/calibrate/job_fit.hpp"

#include <gtest/gtest.h>

#include "calibrate/gel_job.hpp"
#include "percal/calibrate/error_budget.hpp"
#include "percal/calibrate/hypothesis_fit.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;

class JobFits : public testing::Test {
 protected:
  static void SetUpTestSuite() { emulator_ = new Emulator(test::emulator_of_the_smooth_law()); }
  static void TearDownTestSuite() { delete emulator_; }

  // alpha is held: depths alone do not know it.
  JobFits() {
    job_.hypotheses[0].held[1] = truth_[1];
    job_.hypotheses[0].held[2] = truth_[2];
    test::measure(job_, truth_, 0.05, 3);
  }
  JobModel model() const { return finite_element_model(job_, job_.hypotheses[0], *emulator_, 0.1); }
  JobFit fit() const { return fit_job(job_, model(), used_shots(job_), quick_search()); }

  static inline const Emulator* emulator_;
  const std::vector<double> truth_{200e3, 7, 0.8};
  CalibrationJob job_ = test::gel_job(16);
};

TEST_F(JobFits, RecoverTheModulusThatMadeTheDepths) {
  const JobFit found = fit();
  ASSERT_EQ(found.problem.parameters.size(), 1u);
  const double error = std::sqrt(found.best().covariance(0, 0));
  EXPECT_NEAR(found.best().searched[0], std::log(truth_[0]), 3 * error);
  EXPECT_LT(error, 0.2);
  EXPECT_NEAR(found.best().scatter[0], 0.05, 0.03);
}

TEST_F(JobFits, AShotMoreThanMeasuredDeepIsNoMisfitWhereItWasOnlySeenToGoThatFar) {
  job_.shots[0].datum = ShotDatum::at_least;
  job_.shots[0].depth *= 0.5;
  const JobFit met = fit();
  EXPECT_EQ(met.best().residual[0], 0) << "the model goes deeper, as it may";
  job_.shots[0].datum = ShotDatum::depth;
  EXPECT_LT(fit().best().searched[0], 1e9);
  EXPECT_GT(fit().best().scatter[0], 2 * met.best().scatter[0]) << "as a depth it would be one";
}

TEST_F(JobFits, TheSpeedsErrorCountsThroughTheSlopeOfTheDepth) {
  for (auto& shot : job_.shots) shot.speed_error = 0.02 * shot.speed;
  const JobFit found = fit();
  const VectorXd exponents = model().speed_exponents(found.at, shots_of(job_, found.shots));
  for (std::size_t i = 0; i < found.shots.size(); ++i)
    EXPECT_NEAR(found.problem.data[i].error, 0.02 * exponents[static_cast<Eigen::Index>(i)], 1e-4);
}

TEST_F(JobFits, PredictionIntervalsHoldMostOfTheirShots) {
  const JobFit found = fit();
  const Deviation said = deviation("all", job_, shot_depths(job_, model(), found, found.shots));
  EXPECT_EQ(said.shots, 16);
  EXPECT_GE(said.within, 14);
  EXPECT_NEAR(said.mean_absolute, 0.04, 0.02);
}

TEST_F(JobFits, AParameterThatNoDatumDependsOnIsLeftOut) {
  CalibrationJob more = job_;
  more.parameters.push_back(more.parameters[0]);
  more.materials.push_back(more.materials[0]);
  more.materials.back().mu = SharedParameter{3};
  const auto model = finite_element_model(more, more.hypotheses[0], *emulator_, 0.1);
  const JobFit found = fit_job(more, model, used_shots(more), quick_search());
  EXPECT_EQ(found.of_model, std::vector<int>{0});
  EXPECT_EQ(found.at.size(), 2);
}

TEST_F(JobFits, CrossValidationFitsOneKindAndPredictsTheOther) {
  const CrossValidation wanted{.name = "steel -> titanium",
                               .fit = {"material=steel"},
                               .predict = {"material=titanium"},
                               .hypotheses = {},
                               .goal = {}};
  const auto result = cross_validate(job_, model(), wanted, quick_search());
  EXPECT_EQ(result.fitted, 8);
  ASSERT_EQ(result.shots.size(), 8u);
  for (const auto& shot : result.shots) EXPECT_FALSE(shot.fitted);
  EXPECT_LT(result.prediction.mean_absolute, 0.12);
}

TEST_F(JobFits, LeavingAShotOutDoesNotUseIt) {
  const JobFit full = fit();
  const auto before = leave_one_out(job_, model(), 0, full, quick_search());
  job_.shots[3].depth *= 1.3;
  const auto after = leave_one_out(job_, model(), 0, full, quick_search());
  EXPECT_NEAR(after.shots[3].depth, before.shots[3].depth, 1e-6 * before.shots[3].depth);
  EXPECT_NE(after.shots[4].depth, before.shots[4].depth);
}

TEST_F(JobFits, PlausiblePointsBeginAtTheBestAndStayNearIt) {
  const JobFit found = fit();
  const auto points = plausible_points(found, 40, 1, 5);
  ASSERT_EQ(points.size(), 40u);
  EXPECT_EQ(points[0], found.at);
  double sum = 0;
  for (const auto& point : points) sum += std::pow(point[0] - found.at[0], 2);
  const double deviation = std::sqrt(found.best().covariance(0, 0));
  EXPECT_NEAR(std::sqrt(sum / 40), deviation, 0.5 * deviation);
  EXPECT_EQ(plausible_points(found, 40, 1, 5), points) << "the same seed, the same points";
}

TEST_F(JobFits, TheSharesOfAnErrorBudgetMakeItsWhole) {
  for (auto& shot : job_.shots) {
    shot.speed_error = 0.02 * shot.speed;
    shot.depth_error = 0.03 * shot.depth;
  }
  job_.materials[0].rate_factor = 10;
  job_.materials[0].rate_factor_error = 0.1;
  const JobFit found = fit();
  const auto quantity = stiffness_quantity(job_, job_.hypotheses[0], model(), found, 0);
  EXPECT_NEAR(quantity.value, 3 * std::exp(found.best().searched[0]) / 10, 1e-6 * quantity.value);
  const VectorXd mesh = VectorXd::Constant(16, 0.02);
  const ErrorBudget budget = error_budget(job_, model(), found, quantity, mesh);
  double shares = 0, variance = 0;
  for (const auto& source : budget.sources) {
    shares += source.share;
    variance += source.standard_deviation * source.standard_deviation;
    if (source.name == "rate factor") {
      EXPECT_NEAR(source.standard_deviation, 0.1, 1e-12);
    }
  }
  EXPECT_NEAR(shares, 1, 1e-9);
  EXPECT_NEAR(std::sqrt(variance), budget.standard_deviation, 1e-9);
  // Without the two that the fit does not know, it is the fit's own error.
  const auto without = [&](const std::string& name) {
    for (const auto& source : budget.sources)
      if (source.name == name) return source.standard_deviation * source.standard_deviation;
    return 0.0;
  };
  EXPECT_NEAR(std::sqrt(variance - without("rate factor") - without("mesh")), std::sqrt(found.best().covariance(0, 0)),
              0.02 * budget.standard_deviation);
}

TEST_F(JobFits, ABiasOfAllDepthsMovesTheModulusByItsSensitivity) {
  const JobFit found = fit();
  const auto quantity = stiffness_quantity(job_, job_.hypotheses[0], model(), found, 0);
  const ErrorBudget budget = error_budget(job_, model(), found, quantity, VectorXd::Constant(16, 0.01));
  double said = 0;
  for (const auto& source : budget.sources)
    if (source.name == "mesh") said = source.standard_deviation;
  for (auto& shot : job_.shots) shot.depth *= std::exp(0.01);
  const double moved = std::abs(fit().best().searched[0] - found.best().searched[0]);
  EXPECT_NEAR(said, moved, 0.1 * moved);
}

TEST(Filters, AllConditionsHaveToHold) {
  const CalibrationJob job = test::gel_job(4);
  EXPECT_EQ(chosen(job, {"material=steel"}), (std::vector<int>{0, 2}));
  EXPECT_EQ(chosen(job, {"set=balls", "material=titanium"}), (std::vector<int>{1, 3}));
  EXPECT_TRUE(chosen(job, {"set=other"}).empty());
  EXPECT_TRUE(chosen(job, {"colour=red"}).empty());
}

}  // namespace
}  // namespace percal
