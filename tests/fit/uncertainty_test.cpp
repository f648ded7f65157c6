#include "percal/fit/interval/uncertainty.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "percal/fit/interval/curve_calibration.hpp"
#include "percal/fit/read/read_curves.hpp"
#include "percal/math/distributions.hpp"
#include "support/synthetic_curves.hpp"

namespace percal {
namespace {

using test::gel;
using test::NormalNumbers;
using testing::HasSubstr;

CurveData noisy(const test::Stretches& stretches, const test::Noise& noise, unsigned seed = 7) {
  NormalNumbers normal(seed);
  return test::noisy_curve(gel, test::states(stretches), noise, normal);
}

CurveData with_standard_errors(CurveData data, const test::Noise& noise) {
  for (auto& point : data.points) point.standard_error = noise.at(nominal_stress(gel, point.strained));
  return data;
}

Uncertainty of(const CurveData& data, const CurveOptions& options, const UncertaintyOptions& wanted = {}) {
  return uncertainty_of(data, fit_curves(data, options), wanted);
}

std::string all(const std::vector<std::string>& sentences) {
  std::string text;
  for (const auto& sentence : sentences) text += sentence + "\n";
  return text;
}

// The smallest sum of squares at this alpha, over that of the best fit less 1, times n - 2: t^2 at an end of the interval.
double rise(const CurveData& data, double alpha, double best_alpha) {
  const auto smallest = [&](double at) {
    double product = 0, square = 0, sum = 0;
    for (const auto& [strained, stress, error, source, rows, time] : data.points) {
      const double unit = nominal_stress(Ogden{1, at}, strained) / stress;
      product += unit, square += unit * unit;
    }
    for (const auto& [strained, stress, error, source, rows, time] : data.points)
      sum += std::pow(1 - product / square * nominal_stress(Ogden{1, at}, strained) / stress, 2);
    return sum;
  };
  return (smallest(alpha) / smallest(best_alpha) - 1) * (static_cast<double>(data.points.size()) - 2);
}

TEST(Uncertainty, TheIntervalOfALinearParameterIsStudentsInterval) {
  const auto data = noisy({.low = 0.9, .high = 1.1}, {.absolute = 100});
  const auto result = of(data, {.model = Model::neo_hooke, .residual = Residual::absolute});
  double product = 0, square = 0, sum = 0;
  for (const auto& [strained, stress, error, source, rows, time] : data.points) {
    const double unit = nominal_stress(Ogden{1, 2}, strained);
    product += unit * stress, square += unit * unit;
  }
  const double mu = product / square;
  for (const auto& [strained, stress, error, source, rows, time] : data.points)
    sum += std::pow(stress - mu * nominal_stress(Ogden{1, 2}, strained), 2);
  const int degrees = static_cast<int>(data.points.size()) - 1;
  const double half = student_quantile(0.975, degrees) * std::sqrt(sum / degrees / square);
  ASSERT_EQ(result.minima.size(), 1u);
  ASSERT_EQ(result.minima[0].parameters.size(), 1u);
  const auto& found = result.minima[0].parameters[0];
  EXPECT_EQ(found.name, "mu");
  EXPECT_NEAR(found.value, mu, 1e-6 * mu);
  EXPECT_NEAR(found.interval.low, mu - half, 1e-4 * half);
  EXPECT_NEAR(found.interval.high, mu + half, 1e-4 * half);
  EXPECT_NEAR(result.scatter, std::sqrt(sum / degrees), 1e-6 * result.scatter);
  EXPECT_EQ(result.degrees_of_freedom, degrees);
}

TEST(Uncertainty, AnIntervalOfAlphaEndsWhereTheRefittedObjectiveHasRisenByStudentsSquare) {
  const auto data = noisy({}, {.relative = 0.05});
  const auto result = of(data, {});
  const auto& alpha = result.minima.at(0).parameters.at(1);
  ASSERT_EQ(alpha.name, "alpha");
  const double t = student_quantile(0.975, static_cast<double>(data.points.size()) - 2);
  EXPECT_NEAR(rise(data, alpha.interval.low, alpha.value), t * t, 1e-3 * t * t);
  EXPECT_NEAR(rise(data, alpha.interval.high, alpha.value), t * t, 1e-3 * t * t);
  EXPECT_TRUE(alpha.identifiable);
  EXPECT_LT(result.minima[0].correlation(0, 1), 0);
  EXPECT_NEAR(result.scatter, 0.05, 0.015);
}

TEST(Uncertainty, ASmallStretchRangeDeterminesMuAndNotAlpha) {
  const auto data = noisy({.points = 48, .low = 0.98, .high = 1.02}, {.absolute = 800});
  const auto result = of(data, {.residual = Residual::absolute});
  const auto& mu = result.minima.at(0).parameters.at(0);
  const auto& alpha = result.minima.at(0).parameters.at(1);
  EXPECT_TRUE(mu.identifiable);
  EXPECT_LT(mu.interval.low, gel.mu);
  EXPECT_GT(mu.interval.high, gel.mu);
  EXPECT_TRUE(alpha.interval.low_open && alpha.interval.high_open) << alpha.interval.low << " " << alpha.interval.high;
  EXPECT_FALSE(alpha.identifiable);
  EXPECT_THAT(
      all(result.findings),
      HasSubstr("The stretch range 0.98 to 1.02 does not determine alpha: its 95 % interval reaches both ends"));
}

TEST(Uncertainty, AnIntervalThatIsClosedButVeryWideHardlyDeterminesAlpha) {
  const auto data = noisy({.points = 24, .low = 0.95, .high = 1.05}, {.absolute = 200});
  const auto result = of(data, {.residual = Residual::absolute});
  EXPECT_FALSE(result.minima.at(0).parameters.at(1).identifiable);
  EXPECT_THAT(all(result.findings), HasSubstr("The stretch range 0.95 to 1.05 hardly determines alpha"));
}

TEST(Uncertainty, PlanarTensionHasAnIntervalForEachSignOfAlpha) {
  const auto data = noisy({.deformation = Deformation::planar}, {.relative = 0.02});
  const auto result = of(data, {});
  ASSERT_EQ(result.minima.size(), 2u);
  const auto& one = result.minima[0].parameters.at(1);
  const auto& other = result.minima[1].parameters.at(1);
  EXPECT_NEAR(one.value, -other.value, 1e-5);
  EXPECT_NEAR(one.interval.low, -other.interval.high, 1e-4);
  EXPECT_NEAR(one.interval.high, -other.interval.low, 1e-4);
  EXPECT_GT(std::min(std::abs(one.interval.low), std::abs(one.interval.high)), 0);
  EXPECT_THAT(all(result.findings), HasSubstr("for its own sign"));
}

// Of short tension whose best minimum has the wrong exponent.
TEST(Uncertainty, TheRegionHoldsATruthThatTheBestMinimumMisses) {
  constexpr Ogden solid{.mu = 20e3, .alpha = -5};
  const auto holds = [&](const Interval& piece) { return piece.low <= solid.alpha && solid.alpha <= piece.high; };
  for (const unsigned seed : {33u, 34u}) {
    NormalNumbers normal(seed);
    const auto data =
        test::noisy_curve(solid, test::states({.points = 20, .low = 1.03, .high = 1.6}), {.absolute = 630}, normal);
    const auto result = of(data, {.residual = Residual::absolute});
    const ParameterRegion& alpha = result.region.at(1);
    EXPECT_EQ(alpha.name, "alpha");
    EXPECT_FALSE(holds(result.minima.at(0).parameters.at(1).interval)) << seed;
    ASSERT_EQ(alpha.pieces.size(), 2u) << seed;
    EXPECT_TRUE(holds(alpha.pieces[0])) << seed;
    EXPECT_THAT(all(result.findings), HasSubstr("The data do not choose between 2 minima")) << seed;
  }
}

TEST(Uncertainty, StandardErrorsThatTheResidualsBearOutAreUsed) {
  const test::Noise noise{.relative = 0.03, .absolute = 60};
  const auto data = with_standard_errors(noisy({}, noise), noise);
  const auto result = of(data, {.residual = Residual::error});
  EXPECT_EQ(result.errors, ErrorSource::standard_errors);
  EXPECT_NEAR(result.scatter, 1, 0.4);
  // Twice the errors make intervals twice as wide.
  auto twice = data;
  for (auto& point : twice.points) *point.standard_error *= 1.2;
  const auto wider = of(twice, {.residual = Residual::error});
  ASSERT_EQ(wider.errors, ErrorSource::standard_errors);
  const auto width = [](const Uncertainty& uncertainty) {
    const auto& interval = uncertainty.minima.at(0).parameters.at(1).interval;
    return interval.high - interval.low;
  };
  EXPECT_NEAR(width(wider) / width(result), 1.2, 0.01);
}

TEST(Uncertainty, TheIntervalOfALinearParameterWithKnownErrorsIsTheNormalDistributions) {
  const test::Noise noise{.absolute = 100};
  NormalNumbers normal(11);
  const Ogden rubber{.mu = 11640, .alpha = 2};
  auto data = test::noisy_curve(rubber, test::states({}), noise, normal);
  double square = 0;
  for (auto& point : data.points) {
    point.standard_error = noise.absolute;
    square += std::pow(nominal_stress(Ogden{1, 2}, point.strained) / noise.absolute, 2);
  }
  const auto result = of(data, {.model = Model::neo_hooke, .residual = Residual::error});
  ASSERT_EQ(result.errors, ErrorSource::standard_errors);
  const auto& mu = result.minima.at(0).parameters.at(0);
  const double half = normal_quantile(0.975) / std::sqrt(square);
  EXPECT_NEAR(mu.interval.high - mu.value, half, 1e-4 * half);
  EXPECT_NEAR(mu.value - mu.interval.low, half, 1e-4 * half);
}

TEST(Uncertainty, StandardErrorsThatTheResidualsContradictAreNotBelieved) {
  const test::Noise noise{.relative = 0.03, .absolute = 60};
  auto data = with_standard_errors(noisy({}, noise), noise);
  for (auto& point : data.points) *point.standard_error *= 0.2;
  const auto result = of(data, {.residual = Residual::error});
  EXPECT_EQ(result.errors, ErrorSource::residuals);
  EXPECT_THAT(all(result.findings), HasSubstr("times as large as the standard errors say"));
}

TEST(Uncertainty, ASystematicMisfitIsCalledOne) {
  const auto treloar = read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {.where = {"mode=UT"}});
  const auto result = of(treloar, {.residual = Residual::absolute});
  EXPECT_THAT(all(result.findings), HasSubstr("systematic, not noise"));
  EXPECT_GT(*result.neighbour_correlation, 0.5);
  const auto noise = of(noisy({}, {.relative = 0.02}), {});
  EXPECT_THAT(all(noise.findings), testing::Not(HasSubstr("systematic")));
}

// Treloar's two minima differ by half a per cent: neither can be ruled out.
TEST(Uncertainty, EveryMinimumThatThePointsCannotRuleOutHasIntervals) {
  const auto treloar = read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {.where = {"mode=UT"}});
  const auto result = of(treloar, {.residual = Residual::absolute});
  ASSERT_EQ(result.minima.size(), 2u);
  for (const auto& about : result.minima) {
    const auto& alpha = about.parameters.at(1);
    EXPECT_LT(alpha.interval.low, alpha.value);
    EXPECT_GT(alpha.interval.high, alpha.value);
  }
}

TEST(Uncertainty, TheBootstrapsAgreeWithTheProfileWhereErrorsAreAsAssumed) {
  const auto data = noisy({.points = 60}, {.relative = 0.03});
  const auto result = of(data, {}, {.bootstrap = 400});
  for (const auto& parameter : result.minima.at(0).parameters) {
    ASSERT_TRUE(parameter.bootstrap);
    const double width = parameter.interval.high - parameter.interval.low;
    for (const Interval& interval :
         {parameter.bootstrap->points, parameter.bootstrap->residuals, parameter.bootstrap->parametric}) {
      EXPECT_NEAR((interval.high - interval.low) / width, 1, 0.25) << parameter.name;  // 400 draws: 7 %
      EXPECT_LT(interval.low, parameter.value);
      EXPECT_GT(interval.high, parameter.value);
    }
  }
  EXPECT_EQ(result.minima[0].bootstrap_failed, 0);
}

TEST(Uncertainty, TheSameSeedGivesTheSameBits) {
  const auto data = noisy({}, {.relative = 0.03});
  const auto low = [&](unsigned seed) {
    return of(data, {}, {.bootstrap = 20, .seed = seed}).minima.at(0).parameters.at(0).bootstrap->points.low;
  };
  EXPECT_EQ(low(1), low(1));
  EXPECT_NE(low(1), low(2));
}

TEST(Uncertainty, PointsOnTheModelHaveNoScatterAndNoIntervals) {
  const auto exact = of(noisy(test::Stretches{}, {}), {});
  EXPECT_TRUE(exact.minima.empty());
  EXPECT_THAT(all(exact.findings), HasSubstr("exactly"));
  const auto few = of(noisy({.points = 2, .low = 0.7, .high = 1.2}, {.relative = 0.02}), {});
  EXPECT_TRUE(few.minima.empty());
  EXPECT_THAT(all(few.findings), HasSubstr("no more points than parameters"));
}

TEST(Uncertainty, TwoTermsHaveAnIntervalForEachParameterAndForTheirSum) {
  const auto treloar = read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {});
  const auto fit = fit_curves(treloar, {.model = Model::ogden2});
  const auto result = uncertainty_of(treloar, fit, {});
  const auto& about = result.minima.at(0);
  ASSERT_EQ(about.parameters.size(), 4u);
  EXPECT_EQ(about.parameters[3].name, "alpha_2");
  ASSERT_TRUE(about.small_strain_modulus);
  const double mu = small_strain_modulus(fit.minima[0].solid);
  EXPECT_LT(about.small_strain_modulus->low, mu);
  EXPECT_GT(about.small_strain_modulus->high, mu);
}

// A hundred-thousandth of the whole modulus stands in the term that decides at large stretches.
TEST(Uncertainty, ASmallModulusWithALargeExponentIsSearchedAroundItself) {
  const auto treloar = read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {});
  const auto fit = fit_curves(treloar, {.model = Model::ogden3, .residual = Residual::absolute});
  const auto result = uncertainty_of(treloar, fit, {});
  const auto& first = result.minima.at(0).parameters.at(0);
  EXPECT_NEAR(first.value / fit.minima[0].solid.terms[0].mu, 1, 1e-3);
  EXPECT_LT(first.interval.low, first.value);
  EXPECT_FALSE(first.interval.low_open);
}

TEST(PointBootstrap, DrawnRowsKeepTheirDataAndTheirModel) {
  const auto data = noisy({.points = 5}, {.relative = 0.02});
  const auto fit = fit_curves(data, {});
  const auto curve = curve_problem(data, Residual::relative);
  const auto problem = calibration_of(curve, fit.options, fit.minima[0].solid, ErrorSource::residuals);
  const auto part = drawn(problem, {3, 0, 3});
  const Eigen::VectorXd at = searched(problem, fit.minima[0].solid);
  const auto whole = problem.model(at, Want::values), answer = part.model(at, Want::values);
  for (int i = 0; i < 3; ++i) {
    const int row = i == 1 ? 0 : 3;
    EXPECT_EQ(answer.value[i], whole.value[row]);
    EXPECT_EQ(answer.jacobian.row(i), whole.jacobian.row(row));
    EXPECT_EQ(part.data[static_cast<std::size_t>(i)].value, problem.data[static_cast<std::size_t>(row)].value);
  }
}

}  // namespace
}  // namespace percal
