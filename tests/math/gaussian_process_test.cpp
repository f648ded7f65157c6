#include "percal/math/gaussian_process.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "percal/math/correlation.hpp"
#include "percal/math/draws.hpp"

namespace percal {
namespace {

constexpr double noise = 0.1;

struct Example {
  Eigen::MatrixXd points = sobol_points(12, 2, 5);
  Eigen::VectorXd values = (3 * points.col(0)).array().sin() + points.col(1).array().square();

  static Eigen::MatrixXd covariance(const Eigen::MatrixXd& points, double length) {
    const Eigen::MatrixXd smooth =
        Matern52::value(scaled_squared_distances(points, points, Eigen::Vector2d(length, 2 * length)));
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

template <class Correlation>
void expect_slope() {
  for (double s : {1e-3, 0.1, 1.0, 7.0}) {
    const double step = 1e-4 * s;
    const auto value = [](double at) { return Correlation::value(Eigen::Array<double, 1, 1>(at))[0]; };
    const double slope = Correlation::slope(Eigen::Array<double, 1, 1>(s))[0];
    EXPECT_NEAR(slope, (value(s + step) - value(s - step)) / (2 * step), 1e-6 * std::abs(slope)) << s;
  }
}

TEST(Correlation, SlopesAreDerivatives) {
  expect_slope<SquaredExponential>();
  expect_slope<Matern52>();
}

TEST(Correlation, AtNoDistanceItIsOneAndTheSlopeIsFinite) {
  const Eigen::Array<double, 1, 1> nothing(0.0);
  EXPECT_EQ(SquaredExponential::value(nothing)[0], 1);
  EXPECT_EQ(Matern52::value(nothing)[0], 1);
  EXPECT_DOUBLE_EQ(SquaredExponential::slope(nothing)[0], -0.5);
  EXPECT_DOUBLE_EQ(Matern52::slope(nothing)[0], -5.0 / 6);
}

TEST(Correlation, DistancesAreScaledByTheirLengths) {
  const Eigen::MatrixXd a = sobol_points(5, 3, 0), b = sobol_points(4, 3, 5);
  const Eigen::Vector3d length(0.2, 1, 30);
  const Eigen::ArrayXXd s = scaled_squared_distances(a, b, length);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j)
      EXPECT_NEAR(s(i, j), (a.row(i) - b.row(j)).transpose().cwiseQuotient(length).squaredNorm(), 1e-12);
}

}  // namespace
}  // namespace percal
