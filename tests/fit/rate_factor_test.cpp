#include "percal/fit/interval/rate_factor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "percal/base/error.hpp"
#include "percal/fit/read/read_curves.hpp"
#include "support/synthetic_curves.hpp"

namespace percal {
namespace {

using test::gel;
using test::NormalNumbers;
using testing::HasSubstr;

CurveData noisy(const Ogden& solid, unsigned seed) {
  NormalNumbers normal(seed);
  return test::noisy_curve(solid, test::states({}), {.relative = 0.02}, normal);
}

CurveData synthetic(const std::string& name) {
  return read_curves({PERCAL_DATA "/synthetic/gelatin_12wt_" + name + ".csv"}, {});
}

void expect_inside(const ParameterUncertainty& parameter, double truth) {
  EXPECT_LE(parameter.interval.low, truth) << parameter.name;
  EXPECT_GE(parameter.interval.high, truth) << parameter.name;
  EXPECT_TRUE(parameter.identifiable) << parameter.name;
}

TEST(RateFactor, TheSyntheticPairGivesBackItsParameters) {
  for (const auto residual : {Residual::relative, Residual::error}) {
    const auto rate = fit_rate_factor(synthetic("quasistatic"), synthetic("highrate"), residual, 0.95);
    expect_inside(rate.factor, 9.74);
    expect_inside(rate.mu_slow, 11640);
    expect_inside(rate.mu_fast, 9.74 * 11640);
    expect_inside(rate.alpha, 9);
    EXPECT_TRUE(rate.one_shape.serves);
    EXPECT_TRUE(rate.converged);
    EXPECT_EQ(rate.degrees_of_freedom, 26 + 26 - 3);
    EXPECT_LT(rate.factor.interval.high / rate.factor.interval.low, 1.05);
  }
}

TEST(RateFactor, TheModuliAreInTheRatioOfTheFactor) {
  const auto rate = fit_rate_factor(noisy(gel, 1), noisy({5 * gel.mu, gel.alpha}, 2), Residual::relative, 0.95);
  EXPECT_NEAR(rate.mu_fast.value / rate.mu_slow.value, rate.factor.value, 1e-6 * rate.factor.value);
}

// Unknowns of the same curves the other way round: the factor turns over, with its interval.
TEST(RateFactor, ExchangedCurvesGiveTheReciprocal) {
  const auto slow = noisy(gel, 1), fast = noisy({5 * gel.mu, gel.alpha}, 2);
  const auto rate = fit_rate_factor(slow, fast, Residual::relative, 0.95);
  const auto turned = fit_rate_factor(fast, slow, Residual::relative, 0.95);
  EXPECT_NEAR(rate.factor.value * turned.factor.value, 1, 1e-6);
  EXPECT_NEAR(rate.factor.interval.low * turned.factor.interval.high, 1, 1e-4);
  EXPECT_NEAR(rate.one_shape.f, turned.one_shape.f, 1e-4);
}

TEST(RateFactor, TwoShapesAreToldApart) {
  const auto rate = fit_rate_factor(noisy(gel, 1), noisy({5 * gel.mu, 8}, 2), Residual::relative, 0.95);
  EXPECT_FALSE(rate.one_shape.serves);
  EXPECT_LT(rate.one_shape.chance, 1e-3);
  EXPECT_THAT(rate.findings.at(0), HasSubstr("One shape does not serve both rates"));
  EXPECT_NEAR(rate.fast.alone.alpha, 8, 0.3);
}

// The noisier curve counts less: its errors are found from its own scatter.
TEST(RateFactor, EachCurveHasErrorsOfItsOwnSize) {
  NormalNumbers normal(3);
  const auto slow = test::noisy_curve(gel, test::states({}), {.relative = 0.002}, normal);
  const auto fast = test::noisy_curve({5 * gel.mu, gel.alpha}, test::states({}), {.relative = 0.05}, normal);
  const auto rate = fit_rate_factor(slow, fast, Residual::relative, 0.95);
  EXPECT_NEAR(rate.slow.scatter, 0.002, 0.001);
  EXPECT_NEAR(rate.fast.scatter, 0.05, 0.02);
  EXPECT_NEAR(rate.alpha.value, rate.slow.alone.alpha, 0.02);
}

TEST(RateFactor, ACurveThatCannotBeFittedAloneIsRefused) {
  const auto good = noisy(gel, 1);
  EXPECT_THROW(fit_rate_factor(good, noisy({-gel.mu, gel.alpha}, 1), Residual::relative, 0.95), BadInput);
  CurveData two = good;
  two.points.resize(2);
  EXPECT_THROW(fit_rate_factor(two, good, Residual::relative, 0.95), BadInput);
}

}  // namespace
}  // namespace percal
