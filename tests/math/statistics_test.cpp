#include "percal/math/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "percal/base/error.hpp"

namespace percal {
namespace {

using Values = std::vector<double>;

constexpr double round_off = 1e-13;  // relative, of sums of a few terms

TEST(Mean, IsTheCentreAndTheDeviationIsTheSamples) {
  Values values{2, 4, 4, 4, 5, 5, 7, 9};
  EXPECT_DOUBLE_EQ(mean(values), 5);
  EXPECT_DOUBLE_EQ(sample_deviation(values), std::sqrt(32.0 / 7));
}

TEST(MeanRelativeError, CountsDeviationsOfBothSigns) {
  EXPECT_DOUBLE_EQ(mean_relative_error(Values{110, 90}, Values{100, 100}), 0.1);
}

// The textbook sample x = 1..5, y = 2, 4, 5, 4, 5: slope 0.6, intercept 2.2, SSE 2.4, sum of squares of x 10.
TEST(LinearTrend, HasTheTextbooksLineAndStandardErrors) {
  auto line = linear_trend(Values{1, 2, 3, 4, 5}, Values{2, 4, 5, 4, 5});
  EXPECT_NEAR(line.slope, 0.6, round_off);
  EXPECT_NEAR(line.intercept, 2.2, round_off);
  EXPECT_NEAR(line.r2, 0.6, round_off);
  EXPECT_NEAR(line.slope_error.value(), std::sqrt(0.8 / 10), round_off);
  EXPECT_NEAR(line.intercept_error.value(), std::sqrt(0.8 * (1 / 5.0 + 9 / 10.0)), round_off);
  EXPECT_NEAR(line.error_at(3).value(), std::sqrt(0.8 / 5), round_off);
  EXPECT_EQ(line.points, 5);
}

TEST(LinearTrend, ThroughTwoPointsHasNoStandardError) {
  auto line = linear_trend(Values{1, 3}, Values{1, 5});
  EXPECT_DOUBLE_EQ(line.slope, 2);
  EXPECT_DOUBLE_EQ(line.at(0), -1);
  EXPECT_FALSE(line.slope_error || line.intercept_error || line.error_at(1));
}

TEST(LinearTrend, OfAnExactLineFarFromTheOriginIsThatLine) {
  Values x, y;
  for (int i = 0; i < 6; ++i) {
    x.push_back(1e6 + i);
    y.push_back(3 * x.back() - 7);
  }
  auto line = linear_trend(x, y);
  EXPECT_NEAR(line.slope, 3, 1e-9);
  EXPECT_NEAR(line.at(1e6 + 2.5), 3 * (1e6 + 2.5) - 7, 1e-8);
}

// Over many noisy lines, the slope's error in units of its standard error has deviation sqrt(f/(f-2)), f = 18 degrees
// of freedom.
TEST(LinearTrend, StandardErrorsDescribeTheScatterOfRepeatedFits) {
  constexpr unsigned seed = 20240607;
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.3);
  Values deviations;
  for (int repeat = 0; repeat < 4000; ++repeat) {
    Values x, y;
    for (int i = 0; i < 20; ++i) {
      x.push_back(0.1 * i);
      y.push_back(1.5 * x.back() - 2 + noise(random));
    }
    auto line = linear_trend(x, y);
    deviations.push_back((line.slope - 1.5) / *line.slope_error);
  }
  EXPECT_NEAR(mean(deviations), 0, 0.06) << "seed " << seed;  // 3.5 standard errors of the mean of 4000
  EXPECT_NEAR(sample_deviation(deviations), std::sqrt(18.0 / 16), 0.05) << "seed " << seed;
}

TEST(LinearTrend, RefusesPointsThatMakeNoLine) {
  EXPECT_THROW(linear_trend(Values{}, Values{}), BadInput);
  EXPECT_THROW(linear_trend(Values{1}, Values{1}), BadInput);
  EXPECT_THROW(linear_trend(Values{2, 2, 2}, Values{1, 2, 3}), BadInput);
  EXPECT_THROW(linear_trend(Values{1, 2}, Values{1, 2, 3}), BadInput);
}

class PowerLawOfExactPoints : public testing::TestWithParam<Misfit> {};

TEST_P(PowerLawOfExactPoints, ComesBackWithTheExponentGivenOrFree) {
  Values x{7, 8, 10, 12}, y;
  for (double value : x) y.push_back(131.09 * std::pow(value, 1.8));
  auto fixed = fit_power_law(x, y, 1.8, GetParam());
  EXPECT_NEAR(fixed.factor, 131.09, 1e-10);
  EXPECT_FALSE(fixed.exponent_error);
  auto free = fit_power_law(x, y, GetParam());
  EXPECT_EQ(free.outcome, FitOutcome::converged);
  EXPECT_NEAR(free.factor, 131.09, 1e-8);
  EXPECT_NEAR(free.exponent, 1.8, 1e-10);
  EXPECT_NEAR(free.at(9), 131.09 * std::pow(9, 1.8), 1e-7);
}
INSTANTIATE_TEST_SUITE_P(Misfits, PowerLawOfExactPoints, testing::Values(Misfit::absolute, Misfit::relative),
                         [](const auto& info) { return info.param == Misfit::absolute ? "absolute" : "relative"; });

// sum (1 - k)^2 + (1 - k/4)^2 is least at k = 20/17, sum (1 - k)^2 + (4 - k)^2 at 5/2: x^0 makes every base 1.
TEST(PowerLaw, RelativeAndAbsoluteMisfitsWeighThePointsDifferently) {
  Values x{1, 2}, y{1, 4};
  EXPECT_NEAR(fit_power_law(x, y, 0, Misfit::absolute).factor, 2.5, round_off);
  EXPECT_NEAR(fit_power_law(x, y, 0, Misfit::relative).factor, 20.0 / 17, round_off);
  EXPECT_NEAR(fit_power_law(x, y, 0, Misfit::absolute).objective, 4.5, round_off);
}

// At the minimum the objective rises whichever way the two parameters are moved.
TEST(PowerLaw, WithAFreeExponentIsAtTheMinimumOfItsObjective) {
  Values x{7, 8, 10, 12}, y{3.7, 5.9, 8.1, 12.3};
  for (auto misfit : {Misfit::absolute, Misfit::relative}) {
    auto law = fit_power_law(x, y, misfit);
    ASSERT_EQ(law.outcome, FitOutcome::converged);
    auto objective = [&](double factor, double exponent) {
      double sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        double residual = y[i] - factor * std::pow(x[i], exponent);
        sum += std::pow(misfit == Misfit::relative ? residual / y[i] : residual, 2);
      }
      return sum;
    };
    EXPECT_NEAR(law.objective, objective(law.factor, law.exponent), 1e-10);
    for (auto [df, dn] : {std::pair{1e-4, 0.0}, {-1e-4, 0.0}, {0.0, 1e-4}, {0.0, -1e-4}, {1e-4, -1e-4}})
      EXPECT_GT(objective(law.factor * (1 + df), law.exponent + dn), law.objective);
  }
}

// In units of y: one table in Pa or kPa has one exponent, one relative objective, and a factor in those units.
TEST(PowerLaw, FollowsTheUnitOfY) {
  Values x{7, 8, 12}, kilo{3.77, 5.67, 11.64}, plain{3770, 5670, 11640};
  auto in_kilo = fit_power_law(x, kilo, Misfit::absolute), in_plain = fit_power_law(x, plain, Misfit::absolute);
  EXPECT_NEAR(in_plain.factor / in_kilo.factor, 1000, 1e-6);
  EXPECT_NEAR(in_plain.exponent, in_kilo.exponent, 1e-9);
  EXPECT_NEAR(in_plain.factor_error.value() / in_kilo.factor_error.value(), 1000, 1e-5);
}

// The logarithms make a straight line; for small scatter the relative fit's errors are that line's.
TEST(PowerLaw, StandardErrorsAreTheLogarithmicLinesForSmallScatter) {
  Values x{1, 2, 3, 5, 8, 13}, y, log_x, log_y;
  std::array scatter{1e-4, -2e-4, 1.5e-4, 0.5e-4, -1e-4, 0.3e-4};
  for (std::size_t i = 0; i < x.size(); ++i) {
    y.push_back(2 * std::pow(x[i], 1.3) * (1 + scatter[i]));
    log_x.push_back(std::log(x[i]));
    log_y.push_back(std::log(y[i]));
  }
  auto law = fit_power_law(x, y, Misfit::relative);
  auto line = linear_trend(log_x, log_y);
  EXPECT_NEAR(law.exponent_error.value() / line.slope_error.value(), 1, 1e-3);
  EXPECT_NEAR(law.factor_error.value() / (law.factor * line.intercept_error.value()), 1, 1e-3);
}

// s^2 (J^T J)^-1 with J the derivatives of k x^n after k and n themselves.
TEST(PowerLaw, StandardErrorsOfTheAbsoluteFitAreThoseOfItsOwnParameters) {
  Values x{7, 8, 10, 12}, y{3.7, 5.9, 8.1, 12.3};
  auto law = fit_power_law(x, y, Misfit::absolute);
  double kk = 0, kn = 0, nn = 0;
  for (double value : x) {
    double by_factor = std::pow(value, law.exponent), by_exponent = law.at(value) * std::log(value);
    kk += by_factor * by_factor;
    kn += by_factor * by_exponent;
    nn += by_exponent * by_exponent;
  }
  double scatter = law.objective / 2, determinant = kk * nn - kn * kn;
  EXPECT_NEAR(law.factor_error.value(), std::sqrt(scatter * nn / determinant), 1e-6 * *law.factor_error);
  EXPECT_NEAR(law.exponent_error.value(), std::sqrt(scatter * kk / determinant), 1e-6 * *law.exponent_error);
}

TEST(PowerLaw, RefusesWhatHasNoLogarithmAndTooFewPoints) {
  EXPECT_THROW(fit_power_law(Values{1, 0}, Values{1, 1}, 1.8, Misfit::absolute), BadInput);
  EXPECT_THROW(fit_power_law(Values{1, 2}, Values{1, -1}, Misfit::absolute), BadInput);
  EXPECT_THROW(fit_power_law(Values{1, 2}, Values{1, std::nan("")}, Misfit::absolute), BadInput);
  EXPECT_THROW(fit_power_law(Values{}, Values{}, 1.8, Misfit::absolute), BadInput);
  EXPECT_THROW(fit_power_law(Values{2, 2}, Values{1, 3}, Misfit::absolute), BadInput);
  EXPECT_NO_THROW(fit_power_law(Values{2}, Values{1}, 1.8, Misfit::absolute));
}

}  // namespace
}  // namespace percal
