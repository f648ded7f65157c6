#include "percal/estimate/least_squares.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <numbers>

#include "estimate/problems.hpp"
#include "percal/base/error.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ::testing::HasSubstr;

MatrixXd line_matrix(int data) {
  MatrixXd X(data, 2);
  for (int i = 0; i < data; ++i) X.row(i) << 1, line_x(i);
  return X;
}

VectorXd values(const CalibrationProblem& problem) {
  VectorXd y(problem.data.size());
  for (int i = 0; i < y.size(); ++i) y[i] = problem.data[i].value;
  return y;
}

TEST(LeastSquares, OfALineAreTheTextbooks) {
  const auto problem = line_problem(9, 1.5, -0.7, 0.2, 3);
  const MatrixXd X = line_matrix(9);
  const VectorXd y = values(problem);
  const VectorXd expected = (X.transpose() * X).ldlt().solve(X.transpose() * y);
  const double s2 = (y - X * expected).squaredNorm() / 7;
  const MatrixXd covariance = s2 * (X.transpose() * X).inverse();

  const auto minima = find_minima(problem, quick);
  ASSERT_EQ(minima.size(), 1u);
  const Minimum& found = minima[0];
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.degrees_of_freedom, 7);
  EXPECT_NEAR(found.scatter[0], std::sqrt(s2), 1e-12);
  EXPECT_NEAR(found.objective, 7, 1e-9);
  EXPECT_LT((found.searched - expected).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT((found.covariance - covariance).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((found.residual - (X * expected - y)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(found.at_bound, std::vector<bool>({false, false}));
}

TEST(LeastSquares, KnownErrorsWeighThePoints) {
  auto problem = line_problem(8, 1, 1, 0.3, 5);
  problem.groups[0] = {.name = "line", .estimated = false, .fixed = 0.4};
  VectorXd weight(8);
  for (int i = 0; i < 8; ++i) {
    problem.data[i].error = 0.1 * (i + 1);
    weight[i] = 1 / (0.01 * (i + 1) * (i + 1) + 0.16);
  }
  const MatrixXd X = line_matrix(8), information = X.transpose() * weight.asDiagonal() * X;
  const VectorXd expected = information.ldlt().solve(X.transpose() * weight.cwiseProduct(values(problem)));
  const Minimum found = refine(problem, VectorXd::Zero(2), {}, quick);
  EXPECT_LT((found.searched - expected).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT((found.covariance - information.inverse()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(found.scatter[0], 0.4);
}

TEST(LeastSquares, APriorIsOneMoreMeasurement) {
  auto problem = line_problem(6, 0, 1, 0.1, 7);
  problem.groups[0] = {.name = "line", .estimated = false, .fixed = 0.1};
  problem.parameters[1].prior = 1.5;
  problem.parameters[1].prior_error = 0.05;
  const MatrixXd X = line_matrix(6);
  MatrixXd information = X.transpose() * X / 0.01;
  VectorXd right = X.transpose() * values(problem) / 0.01;
  information(1, 1) += 400;
  right[1] += 400 * 1.5;
  const Minimum found = refine(problem, VectorXd::Zero(2), {}, quick);
  EXPECT_LT((found.searched - information.ldlt().solve(right)).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT((found.covariance - information.inverse()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(found.degrees_of_freedom, 5);
}

TEST(LeastSquares, AHeldParameterStays) {
  const auto problem = line_problem(9, 1.5, -0.7, 0.2, 3);
  const Minimum found = refine(problem, VectorXd::Zero(2), {{.parameter = 1, .searched = -0.5}}, quick);
  EXPECT_EQ(found.searched[1], -0.5);
  EXPECT_NEAR(found.searched[0], (values(problem) - -0.5 * line_matrix(9).col(1)).mean(), 1e-10);
  EXPECT_EQ(found.covariance(1, 1), 0);
  EXPECT_EQ(found.degrees_of_freedom, 8);
}

// Of the profiled objective over k, with m by linear least squares: a ladder of finer scans that knows no derivatives.
TEST(LeastSquares, TheOptimumOfACurveIsAnIndependentScans) {
  const auto problem = curve_problem(40, 1.3, 2.1, 0.2, 11);
  const auto best_m = [&](double k) {
    double up = 0, down = 0;
    for (int i = 0; i < 40; ++i) {
      const double f = std::expm1(k * curve_x(i, 40));
      up += f * problem.data[i].value;
      down += f * f;
    }
    return up / down;
  };
  const auto sum_of_squares = [&](double k) {
    double sum = 0;
    for (int i = 0; i < 40; ++i) sum += std::pow(problem.data[i].value - best_m(k) * std::expm1(k * curve_x(i, 40)), 2);
    return sum;
  };
  double low = 0.1, high = 10;
  while (high - low > 1e-6) {
    double best = low;
    const double step = (high - low) / 100;
    for (int i = 0; i <= 100; ++i)
      if (sum_of_squares(low + i * step) < sum_of_squares(best)) best = low + i * step;
    low = best - 2 * step;
    high = best + 2 * step;
  }
  const double k = (low + high) / 2;
  const Minimum found = find_minima(problem, quick)[0];
  EXPECT_NEAR(found.searched[1], k, 1e-6 * k);
  EXPECT_NEAR(problem.parameters[0].natural(found.searched[0]), best_m(k), 1e-6 * best_m(k));
  EXPECT_NEAR(found.scatter[0], std::sqrt(sum_of_squares(k) / 38), 1e-7);
}

// (a^2 - 4)^2 is 0 at a = -2 and 2; the second datum prefers the positive one.
TEST(LeastSquares, BothMinimaAreFoundAndTheBetterOneIsFirst) {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("a", -5, 5)};
  problem.groups = {{.name = "g", .estimated = false, .fixed = 0.5}};
  problem.data = {{.label = "square", .value = 4}, {.label = "line", .value = 0.3}};
  problem.model = model_of(2, [](const VectorXd& at, int i) {
    return i == 0 ? ValueAndGradient{at[0] * at[0], VectorXd::Constant(1, 2 * at[0])}
                  : ValueAndGradient{0.1 * at[0], VectorXd::Constant(1, 0.1)};
  });
  const auto minima = find_minima(problem, quick);
  ASSERT_EQ(minima.size(), 2u);
  EXPECT_NEAR(minima[0].searched[0], 2, 0.01);
  EXPECT_NEAR(minima[1].searched[0], -2, 0.01);
  EXPECT_LT(minima[0].deviance, minima[1].deviance);
}

TEST(LeastSquares, EquallyGoodMinimaWithAHillBetweenAreTwo) {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("a", -5, 6)};
  problem.groups = {{.name = "g", .estimated = false, .fixed = 0.5}};
  problem.data = {{.label = "square", .value = 4}};
  problem.model = model_of(1, [](const VectorXd& at, int) {
    return ValueAndGradient{at[0] * at[0], VectorXd::Constant(1, 2 * at[0])};
  });
  EXPECT_EQ(find_minima(problem, quick).size(), 2u);
}

TEST(LeastSquares, AMinimumOutsideTheBoxEndsAtItsBound) {
  auto problem = line_problem(9, 1.5, -0.7, 0.2, 3);
  problem.parameters[1] = linear_parameter("b", -0.4, 3);
  const Minimum found = find_minima(problem, quick)[0];
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.searched[1], -0.4);
  EXPECT_NEAR(found.searched[0], (values(problem) + 0.4 * line_matrix(9).col(1)).mean(), 1e-9);
  EXPECT_EQ(found.at_bound, std::vector<bool>({false, true}));
}

// The model knows m n only. Every start ends elsewhere on the ridge: one minimum all the same.
CalibrationProblem product_problem() {
  auto problem = curve_problem(20, 1.3, 2, 0.05, 13);
  problem.parameters = {positive_parameter("m", 1e-2, 1e2), positive_parameter("n", 1e-2, 1e2)};
  problem.model = model_of(20, [](const VectorXd& at, int i) {
    const double y = std::exp(at[0] + at[1]) * std::expm1(2 * curve_x(i, 20));
    return ValueAndGradient{y, Eigen::Vector2d(y, y)};
  });
  return problem;
}

TEST(LeastSquares, ARidgeIsOneMinimum) {
  const auto minima = find_minima(product_problem(), quick);
  ASSERT_EQ(minima.size(), 1u);
  EXPECT_TRUE(minima[0].converged);
  EXPECT_TRUE(minima[0].covariance.allFinite());
  EXPECT_GT(minima[0].covariance(0, 0), 1);  // ln 100 to either side is the box
  const VectorXd product = VectorXd::Ones(2);
  EXPECT_LT(std::sqrt(product.dot(minima[0].covariance * product)), 0.02);
}

// The model knows n + m^2 only: the ridge is a parabola across the box.
TEST(LeastSquares, ACurvedRidgeIsOneMinimum) {
  CalibrationProblem problem = line_problem(10, 1.5, 0, 0.1, 3);
  problem.parameters = {linear_parameter("m", -3, 3), linear_parameter("n", -20, 20)};
  problem.model = model_of(10, [](const VectorXd& at, int) {
    return ValueAndGradient{at[1] + at[0] * at[0], Eigen::Vector2d(2 * at[0], 1)};
  });
  const auto minima = find_minima(problem, quick);
  ASSERT_EQ(minima.size(), 1u);
  EXPECT_TRUE(minima[0].converged);
}

// One point measured as 1, one that is known to be 2 or more: -2 ln Phi((a - 2)/s) + ((a - 1)/s)^2 is least where its slope is 0.
TEST(LeastSquares, AnAtLeastPullsUpwardsOnly) {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("a", -50, 50)};
  problem.groups = {{.name = "g", .estimated = false, .fixed = 0.5}};
  problem.data = {{.label = "seen", .value = 1}, {.label = "bottom", .value = 2, .seen = Seen::at_least}};
  problem.model = model_of(2, [](const VectorXd& at, int) { return ValueAndGradient{at[0], VectorXd::Ones(1)}; });
  const double a = refine(problem, VectorXd::Zero(1), {}, quick).searched[0];
  EXPECT_GT(a, 1.2);
  EXPECT_LT(a, 2);
  const auto objective = [](double x) {
    return std::pow((x - 1) / 0.5, 2) - 2 * std::log(std::erfc(-(x - 2) / 0.5 / std::numbers::sqrt2) / 2);
  };
  EXPECT_NEAR(objective(a + 1e-4), objective(a - 1e-4), 1e-8);  // as far as a is the bottom to 1e-5

  problem.data[0].value = 9;
  const Minimum met = refine(problem, VectorXd::Zero(1), {}, quick);
  EXPECT_NEAR(met.searched[0], 9, 1e-9);
  EXPECT_EQ(met.residual[1], 0);
  EXPECT_EQ(met.degrees_of_freedom, 0);
}

TEST(LeastSquares, FarBelowAnAtLeastThereIsStillASlope) {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("a", -1000, 1000)};
  problem.groups = {{.name = "g", .estimated = false, .fixed = 0.5}};
  problem.data = {{.label = "seen", .value = 400}, {.label = "bottom", .value = 500, .seen = Seen::at_least}};
  problem.model = model_of(2, [](const VectorXd& at, int) { return ValueAndGradient{at[0], VectorXd::Ones(1)}; });
  const Minimum found = refine(problem, VectorXd::Constant(1, -1000), {}, quick);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.searched[0], 450, 0.5);  // the bottom is 100 deviations away: as heavy as a measured point
}

TEST(LeastSquares, AModelWithoutAnAnswerInPartOfTheBoxIsSearchedAllTheSame) {
  auto problem = curve_problem(20, 1.3, 2, 0.05, 17);
  problem.model = [inner = problem.model](const VectorXd& at, Want want) {
    ModelAnswer answer = inner(at, want);
    if (at[1] > 4) answer.value.setConstant(std::nan(""));
    return answer;
  };
  EXPECT_NEAR(find_minima(problem, quick)[0].searched[1], 2, 0.1);
  problem.model = [](const VectorXd& at, Want) {
    return ModelAnswer{VectorXd::Constant(20, std::nan("")), MatrixXd::Zero(20, at.size()), {}};
  };
  const auto nothing = find_minima(problem, quick);
  ASSERT_EQ(nothing.size(), 1u);
  EXPECT_FALSE(nothing[0].converged);
}

TEST(LeastSquares, TheSameProblemGivesTheSameBits) {
  const auto problem = curve_problem(30, 1.3, 2, 0.1, 19);
  const Minimum first = find_minima(problem, quick)[0], second = find_minima(problem, quick)[0];
  EXPECT_EQ(first.searched, second.searched);
  EXPECT_EQ(first.scatter, second.scatter);
  EXPECT_EQ(first.covariance, second.covariance);
}

std::string refusal(const CalibrationProblem& problem) {
  try {
    find_minima(problem, quick);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "accepted";
}

TEST(LeastSquares, WhatCannotBeFittedIsRefused) {
  const auto good = line_problem(4, 1, 1, 0.1, 1);
  auto bad = good;
  bad.data.clear();
  EXPECT_THAT(refusal(bad), HasSubstr("data: found none"));
  bad = good;
  bad.parameters[1].low = 30;
  EXPECT_THAT(refusal(bad), HasSubstr("b: found bounds 30"));
  bad = good;
  bad.parameters[0].logarithmic = true;
  EXPECT_THAT(refusal(bad), HasSubstr("a positive one"));
  bad = good;
  bad.parameters[0].prior = 1;
  EXPECT_THAT(refusal(bad), HasSubstr("prior error"));
  bad = good;
  bad.data[2].group = 1;
  EXPECT_THAT(refusal(bad), HasSubstr("y2: found scatter group 1"));
  bad = good;
  bad.data[2].value = std::nan("");
  EXPECT_THAT(refusal(bad), HasSubstr("y2: found value nan"));
  bad = good;
  bad.groups[0].estimated = false;
  EXPECT_THAT(refusal(bad), HasSubstr("y0: found no error"));
}

}  // namespace
}  // namespace percal
