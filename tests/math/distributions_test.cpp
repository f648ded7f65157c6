#include "percal/math/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "percal/math/draws.hpp"

namespace percal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Printed tables, to their last digit.
TEST(Distributions, QuantilesAreTheTables) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959964, 5e-7);
  EXPECT_NEAR(student_quantile(0.975, 7), 2.365, 5e-4);
  EXPECT_NEAR(student_quantile(0.975, 1), 12.706, 5e-4);
  EXPECT_NEAR(chi_squared_quantile(0.95, 2), 5.991, 5e-4);
  EXPECT_NEAR(f_quantile(0.95, 2, 10), 4.10, 5e-3);
}

TEST(Distributions, WithoutLimitOfFreedomTAndFAreTheNormalsAndChiSquareds) {
  EXPECT_EQ(student_quantile(0.975, infinity), normal_quantile(0.975));
  EXPECT_NEAR(student_quantile(0.975, 1e7), normal_quantile(0.975), 1e-6);
  EXPECT_NEAR(2 * f_quantile(0.95, 2, infinity), chi_squared_quantile(0.95, 2), 1e-12);
}

// Mills' ratio: Phi(-x) = phi(x)/x (1 - 1/x^2 + 3/x^4 - ...).
TEST(Distributions, TheTailsAreExact) {
  const double x = 1e4, expected = -x * x / 2 - std::log(x * std::sqrt(2 * M_PI)) - 1 / (x * x);
  EXPECT_NEAR(log_normal_cdf(-x), expected, 1e-15 * x * x);
  EXPECT_NEAR(log_normal_cdf_slope(-x) / x, 1 + 1 / (x * x), 1e-12);
  EXPECT_NEAR(log_normal_cdf(9), -1.1285884059538406e-19, 1e-31);
  EXPECT_EQ(log_normal_cdf(60), 0);
  EXPECT_EQ(log_normal_cdf_slope(60), 0);
  for (const double z : {-30.0, -3.0, -1e-3, 1e-3, 2.0, 6.0}) {
    const double h = 1e-5, slope = (log_normal_cdf(z + h) - log_normal_cdf(z - h)) / (2 * h);
    EXPECT_NEAR(log_normal_cdf_slope(z), slope, 1e-7 * (1 + std::abs(slope))) << z;
  }
}

TEST(Draws, AreTheSameOnEveryMachineAndHaveTheirMoments) {
  EXPECT_EQ(std::mt19937_64(5489)(), 14514284786278117030u);  // the standard's own first number
  Draws draws(1);
  double sum = 0, squares = 0;
  std::vector<int> count(6);
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double z = draws.normal();
    sum += z;
    squares += z * z;
    ++count[draws.index(6)];
  }
  EXPECT_NEAR(sum / n, 0, 0.013);  // four standard errors
  EXPECT_NEAR(squares / n, 1, 0.018);
  for (const int times : count) EXPECT_NEAR(times, n / 6.0, 4 * std::sqrt(n * 5 / 36.0));
}

// A result that was tampered with asks for them.
TEST(Distributions, AreNoNumberOutsideOfTheirArguments) {
  EXPECT_TRUE(std::isnan(student_quantile(-1e308, 5)));
  EXPECT_TRUE(std::isnan(chi_squared_quantile(2, 5)));
  EXPECT_TRUE(std::isnan(normal_quantile(2)));
}

}  // namespace
}  // namespace percal
