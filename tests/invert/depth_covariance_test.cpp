#include "percal/invert/depth_covariance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "percal/invert/kernel/kernel.hpp"
#include "percal/math/draws.hpp"

namespace percal {
namespace {

MeshPoints some_points() {
  MeshPoints points{(2 * sobol_points(9, sphere_inputs, 3)).array() - 1, Eigen::VectorXd(9)};
  for (int i = 0; i < 9; ++i) points.h[i] = i % 3 == 0 ? 0.6 : 1.5;
  return points;
}

CovarianceParameters some_parameters() {
  CovarianceParameters p;
  p.amplitude = 0.4;
  p.length.setOnes();
  p.length.head<7>() << 0.8, 1.5, 2, 1, 3, 1.2, 0.9;
  p.mesh_amplitude = 0.15;
  p.mesh_length.setOnes();
  p.mesh_length.head<7>() << 1.8, 0.5, 2.5, 1.3, 0.9, 2, 1.4;
  p.mesh_order = 1.3;
  p.noise = 0.03;
  p.noise_order = 0.6;
  return p;
}

constexpr double plane_deviation = 2;

TEST(DepthCovariance, GradientsByTheParametersAreDerivatives) {
  const MeshPoints points = some_points();
  const Eigen::MatrixXd half = sobol_points(9, 9, 1).array() - 0.5;
  const Eigen::MatrixXd g = half + half.transpose();
  const auto sum = [&](const CovarianceParameters& p) {
    return g.cwiseProduct(DepthCovariance(p, plane_deviation).of_runs(points)).sum();
  };
  const CovarianceParameters gradient =
      DepthCovariance(some_parameters(), plane_deviation).contracted_gradient(points, g);
  const auto expect = [&](double by, const std::function<void(CovarianceParameters&, double)>& change) {
    constexpr double step = 1e-5;
    CovarianceParameters above = some_parameters(), below = some_parameters();
    change(above, step);
    change(below, -step);
    EXPECT_NEAR(by, (sum(above) - sum(below)) / (2 * step), 1e-7);
  };
  expect(gradient.amplitude, [](auto& p, double d) { p.amplitude *= std::exp(d); });
  expect(gradient.mesh_amplitude, [](auto& p, double d) { p.mesh_amplitude *= std::exp(d); });
  expect(gradient.noise, [](auto& p, double d) { p.noise *= std::exp(d); });
  expect(gradient.noise_order, [](auto& p, double d) { p.noise_order += d; });
  expect(gradient.mesh_order, [](auto& p, double d) { p.mesh_order += d; });
  for (int j = 0; j < sphere_inputs; ++j) {
    expect(gradient.length[j], [j](auto& p, double d) { p.length[j] *= std::exp(d); });
    expect(gradient.mesh_length[j], [j](auto& p, double d) { p.mesh_length[j] *= std::exp(d); });
  }
}

TEST(DepthCovariance, AWeightedSumIsTheProductWithTheWeights) {
  const MeshPoints points = some_points();
  const DepthCovariance covariance(some_parameters(), plane_deviation);
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(9, -1, 2);
  for (double h : {0.0, 0.6, 1.2}) {
    const auto value = [&](const Eigen::VectorXd& at) {
      return covariance.between({at.transpose(), Eigen::VectorXd::Constant(1, h)}, points).row(0).dot(weights);
    };
    const Eigen::VectorXd at = Eigen::VectorXd::LinSpaced(sphere_inputs, -0.9, 1.4);
    const auto sum = WeightedCovariance(covariance, points, weights).at(at, h);
    EXPECT_NEAR(sum.value, value(at), 1e-10);
    for (int j = 0; j < sphere_inputs; ++j) {
      const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(sphere_inputs, j);
      EXPECT_NEAR(sum.gradient[j], (value(at + step) - value(at - step)) / 2e-5, 1e-6);
    }
  }
}

TEST(EmulatorKernel, HasMaternsCorrelationAndItsSlope) {
  std::vector<double> s{0, 1e-12, 1e-3, 0.1, 1, 7, 60, 900, 1e4, 0.3, 2};
  std::vector<double> values(s.size()), slopes(s.size());
  emulator_kernel().matern52(s.data(), static_cast<long>(s.size()), values.data(), slopes.data());
  for (std::size_t i = 0; i < s.size(); ++i) {
    const long double r = std::sqrt(5 * static_cast<long double>(s[i])), decay = std::exp(-r);
    const double roundings = (4 + static_cast<double>(r)) * 0x1p-52;
    EXPECT_NEAR(values[i], static_cast<double>((1 + r + r * r / 3) * decay), roundings * values[i]) << s[i];
    EXPECT_NEAR(slopes[i], static_cast<double>(-(1 + r) * decay * 5 / 6), -roundings * slopes[i]) << s[i];
  }
  EXPECT_EQ(values[0], 1);
  std::vector<double> alone(s.size() + 1, -1);
  emulator_kernel().matern52(s.data(), static_cast<long>(s.size()), alone.data(), nullptr);
  EXPECT_EQ(alone.back(), -1) << "none is written behind the last";
  alone.pop_back();
  EXPECT_EQ(alone, values);
}

TEST(DepthCovariance, DistancesAreScaledByTheirLengths) {
  const Eigen::MatrixXd a = sobol_points(5, 3, 0), b = sobol_points(4, 3, 5);
  const Eigen::Vector3d length(0.2, 1, 30);
  const Eigen::ArrayXXd s = scaled_squared_distances(a, b, length);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j)
      EXPECT_NEAR(s(i, j), (a.row(i) - b.row(j)).transpose().cwiseQuotient(length).squaredNorm(), 1e-12);
}

TEST(DepthCovariance, VariancesAreItsDiagonal) {
  const DepthCovariance covariance(some_parameters(), plane_deviation);
  const Eigen::VectorXd diagonal = covariance.between(some_points(), some_points()).diagonal();
  EXPECT_LT((covariance.variances(some_points()) - diagonal).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DepthFeatures, TheErosionEnergyIsTheIntegralOfTheTensionTest) {
  for (double alpha : {-6.0, -0.5, 1e-5, 2.0, 9.0}) {
    constexpr int steps = 20000;
    constexpr double strain = 0.8;
    double work = 0;  // of the nominal stress (2/alpha)(l^(alpha-1) - l^(-alpha/2-1)), midpoint rule
    for (int i = 0; i < steps; ++i) {
      const double l = 1 + strain * (i + 0.5) / steps;
      work += 2 / alpha * (std::pow(l, alpha - 1) - std::pow(l, -alpha / 2 - 1)) * strain / steps;
    }
    EXPECT_NEAR(log_erosion_energy(alpha, strain).value, std::log(work), 1e-6) << alpha;
  }
}

// However it is made: with no thickness, or of the layer's own material.
TEST(DepthFeatures, ACoverThatChangesNothingHasNoFeatures) {
  const SphereInputs bare{3, -1, 8, 0.6, 4.4, 5, -1.2};
  SphereInputs none = bare, same = bare;
  lay_on(none, cover_members[0], {.thickness = 0, .density = 1.2, .mu = 6, .alpha = 5, .erosion_strain = 0.4});
  lay_on(same, cover_members[0], {.thickness = 0.7, .density = 1, .mu = 1, .alpha = 8, .erosion_strain = 0.6});
  EXPECT_EQ(depth_features(none), depth_features(bare));
  Eigen::VectorXd difference = depth_features(same) - depth_features(bare);
  EXPECT_EQ(difference[index_of(&SphereInputs::cover_depth)], std::log(1.7));
  difference[index_of(&SphereInputs::cover_depth)] = 0;
  EXPECT_TRUE(difference.isZero(1e-12)) << difference.transpose();
}

TEST(DepthFeatures, GradientsComeBackToTheInputs) {
  const Eigen::VectorXd by_features = Eigen::VectorXd::LinSpaced(sphere_inputs, -1, 0.8);
  for (double alpha : {-7.0, -3e-5, 4e-5, 0.02, 3.0, 11.0}) {
    SphereInputs at{3, -1, alpha, 0.6, 4.4, 5, -1.2};
    lay_on(at, cover_members[0], {.thickness = 0.8, .density = 1.2, .mu = 6, .alpha = 5, .erosion_strain = 0.4});
    lay_on(at, cover_members[1], {.thickness = 0.2, .density = 0.9, .mu = 20, .alpha = -3, .erosion_strain = 0.2});
    const Eigen::VectorXd gradient = by_inputs(at, by_features);
    for (int j = 0; j < sphere_inputs; ++j) {
      const double step = j == index_of(&SphereInputs::alpha) ? 1e-5 : 1e-6;
      SphereInputs above = at, below = at;
      above.*sphere_input_order[j] += step;
      below.*sphere_input_order[j] -= step;
      const double difference = by_features.dot(depth_features(above) - depth_features(below)) / (2 * step);
      EXPECT_NEAR(gradient[j], difference, 1e-5) << "input " << j << ", alpha " << alpha;
    }
  }
}

}  // namespace
}  // namespace percal
