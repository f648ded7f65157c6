#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "estimate/problems.hpp"
#include "percal/estimate/intervals.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// A mean of n numbers with known unequal errors e_i: the restricted likelihood written out in its textbook form
// -2 ln = sum ln(e^2 + s^2) + ln sum 1/(e^2 + s^2) + sum r^2/(e^2 + s^2), r about the weighted mean.
double mean_deviance(const VectorXd& y, const VectorXd& e, double s) {
  const VectorXd w = (e.cwiseAbs2().array() + s * s).inverse();
  const double mean = w.dot(y) / w.sum();
  return -w.array().log().sum() + std::log(w.sum()) + w.dot((y.array() - mean).square().matrix());
}

CalibrationProblem mean_problem(const VectorXd& y, const VectorXd& e) {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("mean", -100, 100)};
  problem.groups = {{.name = "g"}};
  for (int i = 0; i < y.size(); ++i) problem.data.push_back({.label = "y", .value = y[i], .error = e[i]});
  problem.model = model_of(static_cast<int>(y.size()), [](const VectorXd& at, int) {
    return ValueAndGradient{at[0], VectorXd::Ones(1)};
  });
  return problem;
}

TEST(Scatter, BesideKnownErrorsIsTheRestrictedLikelihoods) {
  VectorXd y(7), e(7);
  y << 1.0, 3.1, 2.2, 5.0, 0.3, 2.9, 4.1;
  e << 0.3, 0.5, 1.0, 0.2, 0.8, 0.4, 0.6;
  const double s = refine(mean_problem(y, e), VectorXd::Zero(1), {}, {}).scatter[0];
  EXPECT_GT(s, 1);
  EXPECT_LT(mean_deviance(y, e, s), mean_deviance(y, e, s * 1.001));
  EXPECT_LT(mean_deviance(y, e, s), mean_deviance(y, e, s * 0.999));
}

TEST(Scatter, IsZeroWhereTheKnownErrorsExplainTheResiduals) {
  VectorXd y(5);
  y << 1.0, 1.1, 0.9, 1.05, 0.95;
  const auto problem = mean_problem(y, VectorXd::Constant(5, 0.3));
  const Minimum found = refine(problem, VectorXd::Zero(1), {}, {});
  EXPECT_EQ(found.scatter[0], 0);
  EXPECT_NEAR(found.covariance(0, 0), 0.3 * 0.3 / 5, 1e-12);
  EXPECT_TRUE(found.converged);
}

// Two lines of different scatter with nothing in common but one parameter that is known to both: each has its own s^2.
TEST(Scatter, EachGroupHasItsOwn) {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("a", -100, 100), linear_parameter("b", -100, 100)};
  problem.groups = {{.name = "fine"}, {.name = "coarse"}};
  Draws draws(3);
  VectorXd y(40);
  for (int i = 0; i < 40; ++i) {
    y[i] = (i < 10 ? 1 + 0.1 * draws.normal() : 2 + 3 * draws.normal());
    problem.data.push_back({.label = "y", .value = y[i], .group = i < 10 ? 0 : 1});
  }
  problem.model = model_of(40, [](const VectorXd& at, int i) {
    return i < 10 ? ValueAndGradient{at[0], Eigen::Vector2d(1, 0)} : ValueAndGradient{at[1], Eigen::Vector2d(0, 1)};
  });
  const Minimum found = refine(problem, VectorXd::Zero(2), {}, {});
  EXPECT_TRUE(found.converged);
  const auto s = [](const VectorXd& values) {
    return std::sqrt((values.array() - values.mean()).square().sum() / static_cast<double>(values.size() - 1));
  };
  EXPECT_NEAR(found.scatter[0], s(y.head(10)), 1e-9);
  EXPECT_NEAR(found.scatter[1], s(y.tail(30)), 1e-9);
  EXPECT_NEAR(effective_degrees_of_freedom(problem, found, VectorXd::Unit(2, 0)), 9, 1e-6);
  EXPECT_NEAR(effective_degrees_of_freedom(problem, found, VectorXd::Unit(2, 1)), 29, 1e-6);
}

// Dense errors of the model, with everything written out as n x n matrices.
TEST(Scatter, WithCorrelatedModelErrorsIsTheRestrictedLikelihoods) {
  auto problem = line_problem(14, 1.5, -0.7, 0.5, 3);
  MatrixXd covariance(14, 14);
  for (int i = 0; i < 14; ++i)
    for (int j = 0; j < 14; ++j) covariance(i, j) = i < 9 && j < 9 ? 0.1 * std::exp(-std::abs(i - j) / 3.0) : 0;
  problem.model = [inner = problem.model, covariance](const VectorXd& at, Want want) {
    ModelAnswer answer = inner(at, want);
    if (want == Want::values_and_covariance) answer.covariance = covariance;
    return answer;
  };
  const Minimum found = refine(problem, VectorXd::Zero(2), {}, {});
  ASSERT_TRUE(found.converged);

  MatrixXd X(14, 2);
  VectorXd y(14);
  for (int i = 0; i < 14; ++i) {
    X.row(i) << 1, line_x(i);
    y[i] = problem.data[i].value;
  }
  const auto weights = [&](double s) {
    MatrixXd V = covariance;
    V.diagonal().array() += s * s;
    return MatrixXd(V.inverse());
  };
  const auto estimate = [&](double s) {
    return VectorXd((X.transpose() * weights(s) * X).ldlt().solve(X.transpose() * weights(s) * y));
  };
  const auto deviance = [&](double s) {
    const VectorXd r = y - X * estimate(s);
    return -std::log(weights(s).determinant()) + std::log((X.transpose() * weights(s) * X).determinant()) +
           r.dot(weights(s) * r);
  };
  const double s = found.scatter[0];
  EXPECT_LT(deviance(s), deviance(s * 1.001));
  EXPECT_LT(deviance(s), deviance(s * 0.999));
  EXPECT_LT((found.searched - estimate(s)).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((found.covariance - (X.transpose() * weights(s) * X).inverse()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Scatter, APerfectFitHasNoneAndStillConverges) {
  const auto problem = curve_problem(20, 1.3, 2, 0, 1);
  const Minimum found = refine(problem, Eigen::Vector2d(0, 1), {}, {});
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.searched[1], 2, 1e-9);
  EXPECT_LT(found.scatter[0], 1e-7);
}

}  // namespace
}  // namespace percal
