#include "percal/predict/mixture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "percal/math/distributions.hpp"

namespace percal {
namespace {

TEST(Mixture, OfOneCentreIsItsDistribution) {
  const Mixture normal{.centres = Eigen::VectorXd::Constant(1, 2.0), .deviation = 0.5};
  EXPECT_NEAR(normal.quantile(0.975), 2 + 0.5 * normal_quantile(0.975), 1e-8);
  const Mixture student{.centres = Eigen::VectorXd::Constant(3, 2.0), .deviation = 0.5, .freedom = 4};
  EXPECT_NEAR(student.quantile(0.025), 2 + 0.5 * student_quantile(0.025, 4), 1e-8);
  EXPECT_NEAR(student.share_below(2), 0.5, 1e-12);
  EXPECT_EQ(student.spread(), 0);
}

// A hundred centres at the quantiles of a normal distribution are that distribution: variances add.
TEST(Mixture, AddsTheSpreadOfItsCentresToTheirOwnWidth) {
  Eigen::VectorXd centres(400);
  for (int k = 0; k < 400; ++k) centres[k] = normal_quantile((k + 0.5) / 400);
  const Mixture sum{.centres = centres, .deviation = 1};
  EXPECT_NEAR(sum.quantile(0.975), std::sqrt(2.0) * normal_quantile(0.975), 0.02);
}

TEST(Mixture, HasQuantilesThatItsSharesGiveBack) {
  const Mixture two{.centres = Eigen::Vector2d(-1, 5), .deviation = 0.1, .freedom = 3};
  for (const double share : {0.01, 0.3, 0.7, 0.99}) EXPECT_NEAR(two.share_below(two.quantile(share)), share, 1e-8);
  EXPECT_NEAR(two.spread(), 6 / std::sqrt(2.0), 1e-12);
}

TEST(Mixture, OfCentresFarFromZeroOrNowhereHasNoFaultyQuantile) {
  for (const double centre : {1e9, -1e12}) {
    const Mixture far{.centres = Eigen::Vector2d(centre, centre), .deviation = 1e-3};
    EXPECT_NEAR(far.quantile(0.025), centre - 1.96e-3, 1e-13 * std::abs(centre));
  }
  EXPECT_TRUE(std::isnan(Mixture{.centres = Eigen::Vector2d(1, NAN), .deviation = 1}.quantile(0.5)));
  EXPECT_TRUE(std::isnan(Mixture{.centres = Eigen::Vector2d(1, INFINITY), .deviation = 1}.quantile(0.5)));
}

}  // namespace
}  // namespace percal
