#include "percal/math/gaussian_process.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "percal/math/draws.hpp"

namespace percal {
namespace {

constexpr double noise = 0.1;

struct Example {
  Eigen::MatrixXd points = sobol_points(12, 2, 5);
  Eigen::VectorXd values = (3 * points.col(0)).array().sin() + points.col(1).array().square();

  static Eigen::MatrixXd covariance(const Eigen::MatrixXd& points, double length) {
    const auto correlation = [&](Eigen::Index i, Eigen::Index j) {
      const Eigen::Vector2d apart = (points.row(i) - points.row(j)).transpose();
      return std::exp(-0.5 * apart.cwiseQuotient(Eigen::Vector2d(length, 2 * length)).squaredNorm());
    };
    const Eigen::MatrixXd smooth = Eigen::MatrixXd::NullaryExpr(points.rows(), points.rows(), correlation);
    return smooth + noise * noise * Eigen::MatrixXd::Identity(points.rows(), points.rows());
  }
  GaussianProcess process(double length = 0.7) const {
    return *GaussianProcess::conditioned(covariance(points, length), values);
  }
};

Eigen::MatrixXd without_row(const Eigen::MatrixXd& m, Eigen::Index row) {
  Eigen::MatrixXd rest(m.rows() - 1, m.cols());
  rest << m.topRows(row), m.bottomRows(m.rows() - 1 - row);
  return rest;
}

TEST(GaussianProcess, TheLikelihoodIsTheNormalDensity) {
  const Example example;
  const Eigen::MatrixXd k = Example::covariance(example.points, 0.7);
  const double expected = -0.5 * example.values.dot(k.inverse() * example.values) -
                          0.5 * std::log((2 * std::numbers::pi * k).determinant());
  EXPECT_NEAR(example.process().log_likelihood(), expected, 1e-10);
}

TEST(GaussianProcess, TheLikelihoodsGradientIsItsDerivative) {
  const Example example;
  constexpr double length = 0.7, step = 1e-5;
  const Eigen::MatrixXd change =
      (Example::covariance(example.points, length + step) - Example::covariance(example.points, length - step)) /
      (2 * step);
  const double difference =
      (example.process(length + step).log_likelihood() - example.process(length - step).log_likelihood()) / (2 * step);
  const double gradient = example.process(length).likelihood_gradient().cwiseProduct(change).sum();
  EXPECT_NEAR(gradient, difference, 1e-6 * std::abs(difference));
}

TEST(GaussianProcess, LeaveOneOutIsWhatFittingWithoutThePointSays) {
  const Example example;
  const LeftOutValues left_out = example.process().leave_one_out();
  const Eigen::MatrixXd k = Example::covariance(example.points, 0.7);
  for (Eigen::Index i = 0; i < k.rows(); ++i) {
    const Eigen::MatrixXd rest = without_row(without_row(k, i).transpose(), i);
    const auto others = GaussianProcess::conditioned(rest, without_row(example.values, i));
    const Eigen::VectorXd cross = without_row(k.col(i), i);
    EXPECT_NEAR(left_out.error[i], cross.dot(others->weights()) - example.values[i], 1e-10);
    EXPECT_NEAR(left_out.deviation[i], std::sqrt(k(i, i) - others->whitened(cross).squaredNorm()), 1e-10);
  }
}

TEST(GaussianProcess, WhatIsKnownExactlyHasNoVarianceLeft) {
  const Example example;
  const Eigen::MatrixXd smooth =
      Example::covariance(example.points, 0.3) -
      noise * noise * Eigen::MatrixXd::Identity(example.points.rows(), example.points.rows());
  const auto process = GaussianProcess::conditioned(smooth, example.values);
  EXPECT_LT((smooth * process->weights() - example.values).cwiseAbs().maxCoeff(), 1e-9);
  const Eigen::MatrixXd known = process->whitened(smooth);
  EXPECT_LT((smooth - known.transpose() * known).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(GaussianProcess, ACovarianceThatIsNoneIsRefused) {
  EXPECT_FALSE(GaussianProcess::conditioned(Eigen::Matrix2d{{1, 2}, {2, 1}}, Eigen::Vector2d(1, 1)));
}

}  // namespace
}  // namespace percal
