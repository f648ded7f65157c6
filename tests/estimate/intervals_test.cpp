#include "percal/estimate/intervals.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "estimate/problems.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

double deviation(const Minimum& minimum, int k) { return std::sqrt(minimum.covariance(k, k)); }

TEST(ProfileIntervals, OfALineAreStudentsT) {
  const auto problem = line_problem(9, 1.5, -0.7, 0.2, 3);
  const Minimum minimum = refine(problem, VectorXd::Zero(2), {}, quick);
  for (const double level : {0.68, 0.95}) {
    const auto intervals = profile_intervals(problem, minimum, level, quick);
    ASSERT_EQ(intervals.size(), 2u);
    for (int k = 0; k < 2; ++k) {
      const double half = student_quantile((1 + level) / 2, 7) * deviation(minimum, k);
      EXPECT_NEAR(intervals[k].degrees_of_freedom, 7, 1e-8);
      EXPECT_NEAR(intervals[k].interval.low, minimum.searched[k] - half, 1e-5 * half);
      EXPECT_NEAR(intervals[k].interval.high, minimum.searched[k] + half, 1e-5 * half);
      EXPECT_FALSE(intervals[k].interval.low_open || intervals[k].interval.high_open);
      EXPECT_TRUE(intervals[k].identifiable);
    }
  }
}

TEST(ProfileIntervals, WithKnownErrorsAreTheNormalDistributions) {
  auto problem = line_problem(9, 1.5, -0.7, 0.2, 3);
  problem.groups[0] = {.name = "line", .estimated = false, .fixed = 0.2};
  const Minimum minimum = refine(problem, VectorXd::Zero(2), {}, quick);
  const auto intervals = profile_intervals(problem, minimum, 0.95, quick);
  EXPECT_NEAR(intervals[1].interval.high, minimum.searched[1] + 1.959964 * deviation(minimum, 1), 1e-6);
}

// y = 4 x^2 does not tell x from -x.
CalibrationProblem two_basins() {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("x", -3, 3)};
  problem.groups = {{.name = "line"}};
  const double noise[] = {0.11, -0.08, 0.02, -0.13, 0.07, 0.04, -0.06, 0.05};
  for (int i = 0; i < 8; ++i) problem.data.push_back({.label = fmt::format("y{}", i), .value = 4 + noise[i]});
  problem.model = model_of(8, [](const Eigen::VectorXd& at, int) {
    return ValueAndGradient{4 * at[0] * at[0], VectorXd::Constant(1, 8 * at[0])};
  });
  return problem;
}

TEST(RegionIntervals, HoldAPieceAboutEveryMinimumThatFitsAboutAsWell) {
  const auto problem = two_basins();
  const auto minima = find_minima(problem, quick);
  ASSERT_EQ(minima.size(), 2u);
  const auto around = profile_intervals(problem, minima[0], 0.95, quick)[0];
  const auto found = region_intervals(problem, minima, 0.95, quick)[0];
  ASSERT_EQ(found.region.size(), 2u);
  EXPECT_NEAR(found.region[0].low, -found.region[1].high, 1e-5);
  EXPECT_NEAR(found.region[0].high, -found.region[1].low, 1e-5);
  const auto& piece = found.region[minima[0].searched[0] < 0 ? 0 : 1];
  EXPECT_NEAR(piece.low, around.interval.low, 1e-9);
  EXPECT_NEAR(piece.high, around.interval.high, 1e-9);
  EXPECT_EQ(found.interval.low, found.region[0].low);
  EXPECT_EQ(found.interval.high, found.region[1].high);
  EXPECT_THAT(findings(problem, minima, {found}),
              Contains(HasSubstr("The data do not choose between 2 minima: x is -1.0")));
}

TEST(RegionIntervals, LeaveOutAMinimumThatTheDataRuleOut) {
  auto problem = two_basins();
  const auto minima = find_minima(problem, quick);
  ASSERT_EQ(minima.size(), 2u);
  auto worse = minima;
  const double t = student_quantile(0.975, 7);
  worse[1].deviance = minima[0].deviance + 0.5 * t * t;
  const auto half = region_intervals(problem, worse, 0.95, quick)[0].region;
  ASSERT_EQ(half.size(), 2u);  // what is left of the threshold is half of it, so the piece is narrower by its root
  const bool first_is_low = minima[0].searched[0] < 0;
  const auto width = [](const Interval& piece) { return piece.high - piece.low; };
  EXPECT_NEAR(width(half[first_is_low ? 1 : 0]) / width(half[first_is_low ? 0 : 1]), std::sqrt(0.5), 0.01);
  worse[1].deviance = minima[0].deviance + 1.01 * t * t;
  EXPECT_EQ(region_intervals(problem, worse, 0.95, quick)[0].region.size(), 1u);
}

TEST(RegionIntervals, JoinPiecesThatOverlap) {
  const Region joined = united({{3, 5}, {1, 2}, {4, 6, false, true}, {1.5, 1.8}});
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(joined[0].high, 2);
  EXPECT_EQ(joined[1].low, 3);
  EXPECT_EQ(joined[1].high, 6);
  EXPECT_TRUE(joined[1].high_open);
  EXPECT_EQ(words_of(joined, [](double value) { return fmt::format("{}", value); }), "1 to 2 or 3 to 6");
}

// The profile over k of the curve, from the closed form of m: rise = (S(k) - S)/s^2 with S the sum of squares.
TEST(ProfileIntervals, TheEndsOfACurvesAreWhereTheSumOfSquaresSaysSo) {
  const auto problem = curve_problem(15, 1.3, 2.1, 0.4, 11);
  const Minimum minimum = refine(problem, Eigen::Vector2d(0, 1), {}, quick);
  const auto found = profile_intervals(problem, minimum, 0.95, quick)[1];
  const auto sum_of_squares = [&](double k) {
    double yf = 0, ff = 0, yy = 0;
    for (int i = 0; i < 15; ++i) {
      const double f = std::expm1(k * curve_x(i, 15)), y = problem.data[i].value;
      yf += y * f;
      ff += f * f;
      yy += y * y;
    }
    return yy - yf * yf / ff;
  };
  const double least = sum_of_squares(minimum.searched[1]), s2 = least / 13, t = student_quantile(0.975, 13);
  for (const double end : {found.interval.low, found.interval.high})
    EXPECT_NEAR((sum_of_squares(end) - least) / s2, t * t, 1e-4);
  for (const ProfilePoint& point : found.profile)
    EXPECT_NEAR(point.rise, (sum_of_squares(point.searched) - least) / s2, 1e-5);
  EXPECT_TRUE(std::ranges::is_sorted(found.profile, {}, &ProfilePoint::searched));
  EXPECT_NE(found.interval.high - minimum.searched[1], minimum.searched[1] - found.interval.low);  // not symmetric
}

TEST(ProfileIntervals, AnEndThatABoundCutsOffIsOpen) {
  auto problem = line_problem(9, 1.5, -0.7, 0.2, 3);
  const Minimum wide = refine(problem, VectorXd::Zero(2), {}, quick);
  problem.parameters[1] = linear_parameter("b", wide.searched[1] - 0.5 * deviation(wide, 1), 5);
  const Minimum minimum = refine(problem, VectorXd::Zero(2), {}, quick);
  const auto found = profile_intervals(problem, minimum, 0.95, quick)[1];
  EXPECT_TRUE(found.interval.low_open);
  EXPECT_EQ(found.interval.low, problem.parameters[1].low);
  EXPECT_FALSE(found.interval.high_open);
  EXPECT_TRUE(found.identifiable);
  EXPECT_THAT(findings(problem, {minimum}, {found}), Contains(HasSubstr("no lower limit to b")));
}

// y = m n (exp(2 x) - 1).
CalibrationProblem product_problem(double noise) {
  auto problem = curve_problem(20, 1.3, 2, noise, 13);
  problem.parameters = {positive_parameter("m", 1e-2, 1e2), positive_parameter("n", 1e-2, 1e2)};
  problem.model = model_of(20, [](const VectorXd& at, int i) {
    const double y = std::exp(at[0] + at[1]) * std::expm1(2 * curve_x(i, 20));
    return ValueAndGradient{y, Eigen::Vector2d(y, y)};
  });
  return problem;
}

TEST(Identifiability, OfAProductItsFactorsAreNotKnownAndTheProductIs) {
  const auto problem = product_problem(0.05);
  const auto minima = find_minima(problem, quick);
  const auto intervals = profile_intervals(problem, minima[0], 0.95, quick);
  for (const auto& one : intervals) {
    EXPECT_FALSE(one.identifiable);
    EXPECT_TRUE(one.interval.low_open && one.interval.high_open);
    EXPECT_NEAR(one.interval.low, 0.013, 3e-4);  // where the other one is at its bound, 100
    EXPECT_EQ(one.interval.high, 1e2);
  }
  const auto found = combinations(problem, minima[0]);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].determined);
  EXPECT_NEAR(found[0].weight[0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(found[0].weight[1], std::sqrt(0.5), 1e-6);
  double squares = 0;  // of d y / d ln (m n), which is y; the combination is ln (m n)/sqrt 2
  for (int i = 0; i < 20; ++i) squares += std::pow(problem.data[i].value + minima[0].residual[i], 2);
  EXPECT_NEAR(found[0].standard_deviation, minima[0].scatter[0] / std::sqrt(2 * squares), 1e-9);
  EXPECT_FALSE(found[1].determined);

  const auto sentences = findings(problem, minima, intervals);
  EXPECT_THAT(
      sentences,
      Contains(
          "m cannot be known from these data: its 95 % interval, 0.0129 to 100, ends only where bounds cut it off."));
  EXPECT_THAT(
      sentences,
      Contains(MatchesRegex(
          "Near the best fit, the objective stays as low along a ridge: . rises by 10 % where . falls by 9.1 %.")));
  EXPECT_THAT(sentences, Contains(MatchesRegex("What the data do determine: . \\* ., to within .* %.")));
}

TEST(Identifiability, ASharpFitHasNothingToSay) {
  const auto problem = curve_problem(40, 1.3, 2, 0.05, 3);
  const auto minima = find_minima(problem, quick);
  EXPECT_THAT(findings(problem, minima, profile_intervals(problem, minima[0], 0.95, quick)), testing::IsEmpty());
  EXPECT_LT(correlation(minima[0])(0, 1), -0.9);
  EXPECT_EQ(correlation(minima[0])(1, 1), 1);
}

TEST(Identifiability, APriorIsNotCountedAsData) {
  auto problem = product_problem(0.05);
  const Minimum without = refine(problem, VectorXd::Zero(2), {}, quick);
  problem.parameters[0].prior = 1;
  problem.parameters[0].prior_error = 0.01;
  const Minimum with = refine(problem, VectorXd::Zero(2), {}, quick);
  EXPECT_LT(deviation(with, 1), 0.02);
  EXPECT_GT(deviation(without, 1), 1);
  EXPECT_FALSE(combinations(problem, with)[1].determined);
}

TEST(Findings, ARivalMinimumAndABoundAreNamed) {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("a", -5, 5)};
  problem.groups = {{.name = "g", .estimated = false, .fixed = 0.5}};
  problem.data = {{.label = "square", .value = 4}, {.label = "line", .value = 0.3}};
  problem.model = model_of(2, [](const VectorXd& at, int i) {
    return i == 0 ? ValueAndGradient{at[0] * at[0], VectorXd::Constant(1, 2 * at[0])}
                  : ValueAndGradient{0.1 * at[0], VectorXd::Constant(1, 0.1)};
  });
  auto minima = find_minima(problem, quick);
  EXPECT_THAT(findings(problem, minima, {}), Contains(HasSubstr("A second minimum fits about as well")));
  problem.parameters[0].high = 1.5;
  minima = find_minima(problem, quick);
  problem.parameters[0].low = -1.5;
  minima = find_minima(problem, quick);
  EXPECT_THAT(findings(problem, minima, {}),
              Contains("The best fit has a at its upper bound, 1.5: a better one may lie beyond."));
}

// Standard deviations of 4,000 replicates are known to 1.1 %, percentiles at 2.5 % to 2.7 % of a deviation.
TEST(Bootstrap, OfALineAgreesWithItsCovariance) {
  const auto problem = line_problem(30, 1.5, -0.7, 0.2, 3);
  const Minimum minimum = refine(problem, VectorXd::Zero(2), {}, quick);
  for (const auto kind : {BootstrapKind::parametric, BootstrapKind::residual}) {
    const Bootstrap found = bootstrap(problem, minimum, kind, 4000, 0.95, 1, quick);
    EXPECT_EQ(found.failed, 0);
    ASSERT_EQ(found.searched.rows(), 4000);
    for (int k = 0; k < 2; ++k) {
      const double own = deviation(minimum, k);
      EXPECT_NEAR(found.searched.col(k).mean(), minimum.searched[k], 0.06 * own);
      EXPECT_NEAR(found.intervals[k].low, minimum.searched[k] - 1.96 * own, 0.12 * own);
      EXPECT_NEAR(found.intervals[k].high, minimum.searched[k] + 1.96 * own, 0.12 * own);
    }
  }
}

// With 6 points a third of the squares is lost to the fit: without the correction the deviations would be 0.82 of these. The mean
// square of the corrected residuals is not quite s^2, hence 8 %.
TEST(Bootstrap, OfFewResidualsMakesUpForTheFit) {
  const auto problem = line_problem(6, 1.5, -0.7, 0.2, 3);
  const Minimum minimum = refine(problem, VectorXd::Zero(2), {}, quick);
  const auto found = bootstrap(problem, minimum, BootstrapKind::residual, 4000, 0.95, 1, quick).searched;
  for (int k = 0; k < 2; ++k) {
    const VectorXd off = found.col(k).array() - found.col(k).mean();
    EXPECT_NEAR(std::sqrt(off.squaredNorm() / 3999), deviation(minimum, k), 0.08 * deviation(minimum, k));
  }
}

TEST(Bootstrap, TheSeedDecidesTheNumbers) {
  const auto problem = curve_problem(20, 1.3, 2, 0.1, 3);
  const Minimum minimum = refine(problem, VectorXd::Zero(2), {}, quick);
  const auto draw = [&](unsigned seed) {
    return bootstrap(problem, minimum, BootstrapKind::residual, 20, 0.95, seed, quick).searched;
  };
  EXPECT_EQ(draw(4), draw(4));
  EXPECT_NE(draw(4), draw(5));
}

TEST(Bootstrap, CorrelatedModelErrorsAndPriorsAreDrawnToo) {
  auto problem = line_problem(12, 1.5, -0.7, 0.1, 3);
  problem.groups[0] = {.name = "line", .estimated = false, .fixed = 0.1};
  problem.parameters[1].prior = -0.7;
  problem.parameters[1].prior_error = 0.02;
  problem.model = [inner = problem.model](const VectorXd& at, Want want) {
    ModelAnswer answer = inner(at, want);
    if (want == Want::values_and_covariance) answer.covariance = MatrixXd::Constant(12, 12, 0.09);
    return answer;
  };
  const Minimum minimum = refine(problem, VectorXd::Zero(2), {}, quick);
  EXPECT_GT(deviation(minimum, 0), 0.3);
  const Bootstrap found = bootstrap(problem, minimum, BootstrapKind::parametric, 4000, 0.95, 1, quick);
  for (int k = 0; k < 2; ++k) {
    const double half = (found.intervals[k].high - found.intervals[k].low) / 2;
    EXPECT_NEAR(half, 1.96 * deviation(minimum, k), 0.12 * deviation(minimum, k));
  }
}

TEST(RidgeMap, OfALineIsTheEllipseOfItsCovariance) {
  const auto problem = line_problem(9, 1.5, -0.7, 0.2, 3);
  const Minimum minimum = refine(problem, VectorXd::Zero(2), {}, quick);
  const RidgeMap map = ridge_map(problem, minimum, 0, 1, 41, quick);
  EXPECT_NEAR(map.threshold, 2 * f_quantile(0.95, 2, 7), 1e-6);
  const auto rise = [&](double a, double b) {
    const Eigen::Vector2d off = Eigen::Vector2d(a, b) - minimum.searched;
    return off.dot(minimum.covariance.inverse() * off);
  };
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 41; ++column)
      EXPECT_NEAR(map.rise(row, column), rise(map.x[column], map.y[row]), 1e-6);
  ASSERT_EQ(map.contours.size(), 1u);
  EXPECT_EQ(map.contours[0].front(), map.contours[0].back());
  EXPECT_GT(map.contours[0].size(), 40u);
  for (const auto& [a, b] : map.contours[0]) EXPECT_NEAR(rise(a, b), map.threshold, 0.03 * map.threshold);
}

TEST(RidgeMap, TheOthersAreFittedAnew) {
  auto problem = line_problem(12, 1.5, -0.7, 0.2, 3);  // and a parabola's coefficient
  problem.parameters.push_back(linear_parameter("c", -20, 20));
  problem.model = model_of(12, [](const VectorXd& at, int i) {
    const double x = line_x(i);
    return ValueAndGradient{at[0] + at[1] * x + at[2] * x * x, Eigen::Vector3d(1, x, x * x)};
  });
  const Minimum minimum = refine(problem, VectorXd::Zero(3), {}, quick);
  const RidgeMap map = ridge_map(problem, minimum, 0, 2, 11, quick);
  const MatrixXd marginal = minimum.covariance(std::vector{0, 2}, std::vector{0, 2});
  const Eigen::Vector2d off(map.x[8] - minimum.searched[0], map.y[1] - minimum.searched[2]);
  EXPECT_NEAR(map.rise(1, 8), off.dot(marginal.inverse() * off), 1e-6);
}

TEST(RidgeMap, ARidgeNarrowerThanTheGridIsStillABand) {
  const auto problem = product_problem(0.05);
  const Minimum minimum = find_minima(problem, quick)[0];
  const RidgeMap map = ridge_map(problem, minimum, 0, 1, 21, quick);
  EXPECT_NEAR(map.x.back(), 1e2, 1e-8);
  ASSERT_EQ(map.contours.size(), 1u);
  const double product = std::exp(minimum.searched.sum());
  const double half = std::sqrt(map.threshold) * combinations(problem, minimum)[0].standard_deviation * std::sqrt(2);
  int low = 0, high = 0;
  for (const auto& [m, n] : map.contours[0]) {
    const double off = (m * n / product - 1) / half;  // the model is linear in m n
    EXPECT_LT(std::abs(off), 1.0001);
    low += std::abs(off + 1) < 1e-4;
    high += std::abs(off - 1) < 1e-4;
  }
  EXPECT_GE(low, 40);
  EXPECT_GE(high, 40);
}

TEST(Threads, AnyNumberOfThemGivesTheSameBits) {
  const auto problem = curve_problem(12, 40, 3, 2, 5);
  const Minimum minimum = find_minima(problem, quick).front();
  SearchOptions three = quick;
  three.threads = 3;
  const auto intervals = [&](const SearchOptions& options) {
    std::vector<double> ends;
    for (const ProfileInterval& one : profile_intervals(problem, minimum, 0.95, options))
      ends.insert(ends.end(), {one.interval.low, one.interval.high});
    return ends;
  };
  EXPECT_EQ(intervals(quick), intervals(three));
  const auto drawn = [&](const SearchOptions& options) {
    return bootstrap(problem, minimum, BootstrapKind::parametric, 60, 0.95, 7, options).searched;
  };
  EXPECT_EQ(drawn(quick), drawn(three));
  const auto map = [&](const SearchOptions& options) { return ridge_map(problem, minimum, 0, 1, 7, options); };
  EXPECT_EQ(map(quick).rise, map(three).rise);
  EXPECT_EQ(map(quick).contours, map(three).contours);
}

TEST(NextExperiments, TheWidthIsThatOfAFitWithTheMeasurement) {
  auto problem = line_problem(6, 1, 1, 0.2, 5);
  problem.groups[0] = {.name = "line", .estimated = false, .fixed = 0.2};
  const Minimum now = refine(problem, VectorXd::Zero(2), {}, quick);
  const Eigen::Vector2d slope(0, 1);
  const std::vector<Candidate> candidates{{"near", Eigen::Vector2d(1, 1), 0.2}, {"far", Eigen::Vector2d(1, 10), 0.2}};
  const auto advice = next_experiments(now, slope, candidates);
  ASSERT_EQ(advice.size(), 2u);
  EXPECT_EQ(advice[0].label, "far");
  EXPECT_GT(advice[1].width_ratio, 0.9);
  const MatrixXd information = now.information + candidates[1].gradient * candidates[1].gradient.transpose() / 0.04;
  const double after = information.inverse()(1, 1);
  EXPECT_NEAR(advice[0].width_ratio, std::sqrt(after / now.covariance(1, 1)), 1e-12);
}

}  // namespace
}  // namespace percal
