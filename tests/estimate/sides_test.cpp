// Data that only tell on which side of a number they lie: passed or stopped at a speed.
#include <gmock/gmock.h>

#include <cmath>

#include "estimate/problems.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;
using testing::Contains;
using testing::HasSubstr;

// Shots at even steps of ln speed about a speed that half of them pass at: ln v - ln v50, plus a normal scatter, is above or below 0.
CalibrationProblem v50_problem(int shots, double log_v50, double scatter, double half_range, unsigned seed) {
  CalibrationProblem problem;
  problem.parameters = {positive_parameter("v50", 10, 1000)};
  problem.groups = {{.name = "shots"}};
  Draws draws(seed);
  std::vector<double> speeds;
  for (int i = 0; i < shots; ++i) {
    speeds.push_back(std::log(100.0) + half_range * (2.0 * i / (shots - 1) - 1));
    const bool passes = speeds.back() - log_v50 + scatter * draws.normal() > 0;
    problem.data.push_back({.label = "shot", .value = 0, .seen = passes ? Seen::above : Seen::below});
  }
  problem.model = model_of(shots, [speeds](const VectorXd& at, int i) {
    return ValueAndGradient{speeds[i] - at[0], VectorXd::Constant(1, -1)};
  });
  return problem;
}

TEST(Sides, AreFittedByTheirProbability) {
  CalibrationProblem problem = v50_problem(9, std::log(100.0), 0.1, 0.3, 4);
  problem.groups[0] = {.name = "shots", .estimated = false, .fixed = 0.1};
  const Minimum found = refine(problem, VectorXd::Constant(1, std::log(80.0)), {}, quick);
  ASSERT_TRUE(found.converged);
  const auto minus_two_log_likelihood = [&](double log_v50) {
    const VectorXd above = problem.model(VectorXd::Constant(1, log_v50), Want::values).value;
    double sum = 0;
    for (std::size_t i = 0; i < problem.data.size(); ++i)
      sum -= 2 * log_normal_cdf(side(problem.data[i].seen) * above[static_cast<int>(i)] / 0.1);
    return sum;
  };
  const double at = found.searched[0];
  EXPECT_NEAR(found.objective, minus_two_log_likelihood(at), 1e-9);
  EXPECT_GT(minus_two_log_likelihood(at + 1e-3), minus_two_log_likelihood(at));
  EXPECT_GT(minus_two_log_likelihood(at - 1e-3), minus_two_log_likelihood(at));
}

TEST(Sides, TellTheirScatter) {
  for (const double scatter : {0.05, 0.15, 0.3}) {
    const auto problem = v50_problem(3000, std::log(105.0), scatter, 3 * scatter, 11);
    const Minimum found = refine(problem, VectorXd::Constant(1, std::log(100.0)), {}, {});
    EXPECT_TRUE(found.converged);
    EXPECT_NEAR(found.scatter[0] / scatter, 1, 0.1);
    EXPECT_NEAR(found.searched[0], std::log(105.0), 0.1 * scatter);
  }
}

TEST(Sides, ThatDoNotOverlapSaySoAndHoldTheGap) {
  CalibrationProblem problem = v50_problem(8, 0, 0.1, 0.3, 1);
  for (int i = 0; i < 8; ++i) problem.data[i].seen = i < 4 ? Seen::below : Seen::above;
  const auto minima = find_minima(problem, quick);
  const auto intervals = region_intervals(problem, minima, 0.95, quick);
  const double highest_stop = 100 * std::exp(-0.3 / 7), lowest_pass = 100 * std::exp(0.3 / 7);
  EXPECT_LT(intervals[0].interval.low, highest_stop);
  EXPECT_GT(intervals[0].interval.low, 0.85 * highest_stop);
  EXPECT_GT(intervals[0].interval.high, lowest_pass);
  EXPECT_LT(intervals[0].interval.high, 1.15 * lowest_pass);
  EXPECT_THAT(findings(problem, minima, intervals), Contains(HasSubstr("the gap between them alone")));
}

// The speed that half of them pass at, from as few shots as a range fires.
TEST(Sides, TheIntervalHoldsTheSpeedThatHalfPass) {
  constexpr int replicates = 300;
  for (const int shots : {8, 24}) {
    int held = 0;
    for (unsigned seed = 1; seed <= replicates; ++seed) {
      const auto problem = v50_problem(shots, std::log(103.0), 0.1, 0.25, seed);
      const auto minima = find_minima(problem, {.global_evaluations = 100, .starts = 2});
      const auto intervals = region_intervals(problem, minima, 0.95, quick);
      if (!intervals.empty()) held += intervals[0].interval.low <= 103 && 103 <= intervals[0].interval.high;
    }
    EXPECT_GE(held, 0.89 * replicates) << shots;
    EXPECT_LE(held, 0.99 * replicates) << shots;
    RecordProperty("held of 300, shots " + std::to_string(shots), held);
  }
}

TEST(Sides, DrawnAnewTheyMayComeOutOtherwise) {
  const auto problem = v50_problem(24, std::log(103.0), 0.15, 0.25, 5);
  const Minimum minimum = refine(problem, VectorXd::Constant(1, std::log(100.0)), {}, quick);
  const Bootstrap drawn = bootstrap(problem, minimum, BootstrapKind::parametric, 200, 0.95, 3, quick);
  EXPECT_LE(drawn.failed, 4);
  const VectorXd spread = drawn.searched.col(0).array() - drawn.searched.col(0).mean();
  const double deviation = std::sqrt(spread.squaredNorm() / static_cast<double>(spread.size() - 1));
  EXPECT_GT(deviation, 0.5 * std::sqrt(minimum.covariance(0, 0)));
  EXPECT_LT(deviation, 2 * std::sqrt(minimum.covariance(0, 0)));
}

}  // namespace
}  // namespace percal
