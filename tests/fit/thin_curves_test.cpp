#include "percal/fit/points/thin_curves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "percal/fit/interval/uncertainty.hpp"
#include "percal/fit/search/fit_curves.hpp"
#include "support/synthetic_curves.hpp"

namespace percal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr Ogden true_solid{.mu = 50e3, .alpha = 4};

CurveData raw_log(int rows, unsigned seed = 1) {
  test::NormalNumbers normal(seed);
  auto data =
      test::noisy_curve(true_solid, test::states({.points = rows, .low = 1, .high = 2}), {.absolute = 300}, normal);
  data.sources = {{.file = "log.csv", .x = "stretch", .y = "stress"}};
  return data;
}

TEST(ThinCurves, AShortCurveStaysAsItIs) {
  CurveData data = raw_log(2000);
  thin(data);
  EXPECT_EQ(data.points.size(), 1999u);
  EXPECT_TRUE(data.sources[0].warnings.empty());
}

TEST(ThinCurves, ALongOneIsAveragedAndSaidToBe) {
  CurveData data = raw_log(20000);
  thin(data);
  EXPECT_EQ(data.points.size(), 1000u);
  int rows = 0;
  for (const auto& point : data.points) rows += point.rows;
  EXPECT_EQ(rows, 19999);
  EXPECT_THAT(data.sources[0].warnings, ElementsAre(HasSubstr("19999 rows are averaged to 1000 points")));
}

// All that a fit says of the raw rows: values and intervals, since a mean of m rows counts as m.
TEST(ThinCurves, TheFitAndItsIntervalsAreThoseOfTheRows) {
  const CurveOptions absolute{.residual = Residual::absolute};
  const CurveData raw = raw_log(6000);
  CurveData thinned = raw;
  thin(thinned);
  const auto all = fit_curves(raw, absolute), few = fit_curves(thinned, absolute);
  EXPECT_NEAR(few.minima.at(0).solid.terms[0].mu / all.minima.at(0).solid.terms[0].mu, 1, 2e-5);
  EXPECT_NEAR(few.minima.at(0).solid.terms[0].alpha, all.minima.at(0).solid.terms[0].alpha, 1e-4);
  const auto width = [&](const CurveData& data, const CurveFit& fit) {
    const Interval mu = uncertainty_of(data, fit, {}).minima.at(0).parameters.at(0).interval;
    return mu.high - mu.low;
  };
  EXPECT_NEAR(width(thinned, few) / width(raw, all), 1, 0.1);
}

// A model that does not fit shows what weighs: most rows are below 1.2 here, in a fifth of the bins.
TEST(ThinCurves, APointCountsAsManyRowsAsItStandsFor) {
  CurveData raw;
  raw.sources = {{.file = "log.csv", .x = "stretch", .y = "stress"}};
  for (int i = 0; i < 6000; ++i) {
    const Strained strained{Deformation::uniaxial, i < 5000 ? 1 + 0.2 * i / 5000 : 1.2 + 0.8 * (i - 5000) / 1000};
    raw.points.push_back({strained, nominal_stress(Hyperelastic{{{40e3, 2}, {5e3, 9}}}, strained)});
  }
  CurveData thinned = raw;
  thin(thinned);
  const auto fitted = [](const CurveData& data) {
    return fit_curves(data, {.residual = Residual::absolute}).minima.at(0).solid.terms[0];
  };
  EXPECT_LT(thinned.points.size(), 1100u);
  EXPECT_NEAR(fitted(thinned).mu / fitted(raw).mu, 1, 1e-4);
  EXPECT_NEAR(fitted(thinned).alpha, fitted(raw).alpha, 1e-3);
}

// What a term that stands for noise gains by chance is chi squared of two at most, and its mean is not enough.
TEST(ThinCurves, FurtherTermsOfANoisyLogVanish) {
  int kept = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    CurveData data = raw_log(3000, seed);
    thin(data);
    const auto fit = fit_curves(data, {.model = Model::ogden2, .residual = Residual::absolute});
    kept += fit.minima.at(0).solid.terms.size() > 1;
  }
  EXPECT_LE(kept, 4);
}

TEST(ThinCurves, CurvesWithTwoStretchesAreThinnedInBoth) {
  CurveData data;
  data.sources = {{.file = "two.csv", .x = "x", .y = "y"}};
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      const Strained strained{Deformation::biaxial, 1 + 0.01 * i, 1 + 0.01 * j};
      data.points.push_back({strained, nominal_stress(true_solid, strained)});
    }
  thin(data);
  EXPECT_LE(data.points.size(), 3600u);
  for (const auto& point : data.points)
    EXPECT_NEAR(point.nominal_stress, nominal_stress(true_solid, point.strained),
                0.01 * std::abs(point.nominal_stress) + 300);
}

}  // namespace
}  // namespace percal
