#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "percal/base/error.hpp"
#include "percal/fit/interval/findings.hpp"
#include "percal/fit/read/read_curves.hpp"
#include "percal/fit/search/fit_curves.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

CurveData treloar(const std::string& mode) {
  return read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {.where = {"mode=" + mode}});
}

CurveData made_with(const Ogden& solid, Deformation deformation) {
  CurveData data;
  for (const double amount : {0.8, 0.9, 0.97, 1.05, 1.2, 1.35, 1.5}) {
    const Strained strained{deformation, deformation == Deformation::simple_shear ? amount - 0.7 : amount,
                            1.3 - 0.2 * amount};
    data.points.push_back({strained, nominal_stress(solid, strained)});
  }
  return data;
}

double sum_of_squares(const CurveData& data, const Ogden& solid, Residual residual) {
  double sum = 0;
  for (const auto& [strained, stress, standard_error, source, rows, time] : data.points) {
    if (residual == Residual::relative && stress == 0) continue;
    const double misfit = (stress - nominal_stress(solid, strained)) / (residual == Residual::relative ? stress : 1);
    sum += misfit * misfit;
  }
  return sum;
}

TEST(FitOgden, TheTruthIsRecoveredForBothSignsAndEveryMode) {
  for (const auto deformation :
       {Deformation::uniaxial, Deformation::equibiaxial, Deformation::biaxial, Deformation::planar_held})
    for (const double alpha : {-30.0, -9.0, -2.0, -0.5, 0.3, 1.0, 2.0, 14.0, 35.0})
      for (const auto residual : {Residual::relative, Residual::absolute}) {
        const Ogden truth{.mu = 12345, .alpha = alpha};
        const auto fit = fit_ogden(made_with(truth, deformation), residual);
        ASSERT_FALSE(fit.minima.empty());
        EXPECT_NEAR(fit.minima[0].solid.terms[0].alpha, alpha, 1e-6) << word(deformation) << word(residual);
        EXPECT_NEAR(fit.minima[0].solid.terms[0].mu, truth.mu, 1e-6 * truth.mu);
        EXPECT_NEAR(*fit.minima[0].r2, 1, 1e-9);
        EXPECT_TRUE(fit.minima[0].converged);
      }
}

TEST(FitOgden, TreloarUniaxialHasTwoMinimaAndTheBetterIsNegative) {
  const auto fit = fit_ogden(treloar("UT"), Residual::absolute);
  ASSERT_EQ(fit.minima.size(), 2u);
  EXPECT_NEAR(fit.minima[0].solid.terms[0].alpha, -7.785, 5e-4);
  EXPECT_NEAR(fit.minima[1].solid.terms[0].alpha, 3.901, 5e-4);
  EXPECT_NEAR(*fit.minima[1].above_best, 0.0055, 1e-4);
  EXPECT_EQ(fit.minima[0].above_best, 0);
  const auto sentences = findings(fit);
  ASSERT_FALSE(sentences.empty());
  EXPECT_THAT(sentences[0], HasSubstr("negative alpha (-7.785)"));
  EXPECT_THAT(sentences[0], HasSubstr("0.555 % larger"));
}

TEST(FitOgden, EveryMinimumIsStationaryAndNoNeighbourIsLower) {
  for (const std::string mode : {"UT", "ET", "PS"})
    for (const auto residual : {Residual::relative, Residual::absolute}) {
      const auto data = treloar(mode);
      for (const auto& minimum : fit_ogden(data, residual).minima) {
        EXPECT_NEAR(minimum.objective, sum_of_squares(data, minimum.solid.terms[0], residual),
                    1e-9 * minimum.objective);
        for (const double factor : {0.999, 1.001})
          for (const double shift : {-0.01, 0.0, 0.01})
            EXPECT_LT(minimum.objective,
                      sum_of_squares(data, {minimum.solid.terms[0].mu * factor, minimum.solid.terms[0].alpha + shift},
                                     residual));
      }
    }
}

// The covariance again, from differences instead of jets and in (mu, alpha) instead of (ln mu, alpha).
TEST(FitOgden, StandardErrorsAreThoseOfTheLinearisedModel) {
  const auto data = treloar("ET");
  const auto fit = fit_ogden(data, Residual::relative);
  const auto& best = fit.minima[0];
  double a = 0, b = 0, c = 0;
  for (const auto& [strained, stress, standard_error, source, rows, time] : data.points) {
    const double by_mu = nominal_stress(Ogden{1, best.solid.terms[0].alpha}, strained) / stress;
    const double by_alpha =
        (nominal_stress(Ogden{best.solid.terms[0].mu, best.solid.terms[0].alpha + 1e-4}, strained) -
         nominal_stress(Ogden{best.solid.terms[0].mu, best.solid.terms[0].alpha - 1e-4}, strained)) /
        2e-4 / stress;
    a += by_mu * by_mu, b += by_mu * by_alpha, c += by_alpha * by_alpha;
  }
  const double variance = best.objective / (static_cast<double>(data.points.size()) - 2), determinant = a * c - b * b;
  EXPECT_NEAR(*best.errors[0].mu, std::sqrt(variance * c / determinant), 1e-5 * *best.errors[0].mu);
  EXPECT_NEAR(*best.errors[0].alpha, std::sqrt(variance * a / determinant), 1e-5 * *best.errors[0].alpha);
  EXPECT_NEAR(*best.correlation, -b / std::sqrt(a * c), 1e-6);
}

TEST(FitOgden, TheUnitOfStressDoesNotMatter) {
  auto data = treloar("UT");
  const auto fit = fit_ogden(data, Residual::absolute);
  for (auto& point : data.points) point.nominal_stress *= 1e-12;
  const auto scaled = fit_ogden(data, Residual::absolute);
  ASSERT_EQ(scaled.minima.size(), fit.minima.size());
  for (std::size_t i = 0; i < fit.minima.size(); ++i) {
    // The objective is flat to rounding within about the root of epsilon.
    EXPECT_NEAR(scaled.minima[i].solid.terms[0].alpha, fit.minima[i].solid.terms[0].alpha, 1e-6);
    EXPECT_NEAR(scaled.minima[i].solid.terms[0].mu * 1e12, fit.minima[i].solid.terms[0].mu,
                1e-6 * fit.minima[i].solid.terms[0].mu);
    EXPECT_NEAR(scaled.minima[i].objective * 1e24, fit.minima[i].objective, 1e-9 * fit.minima[i].objective);
  }
}

TEST(FitOgden, ZeroStressIsLeftOutOfRelativeResidualsAndCounted) {
  auto data = made_with({1000, 3}, Deformation::uniaxial);
  data.points.push_back({{Deformation::uniaxial, 1}, 0});
  data.points.push_back({{Deformation::uniaxial, 1.1}, 0});
  const auto relative = fit_ogden(data, Residual::relative);
  EXPECT_EQ(relative.left_out_zero_stress, 2);
  EXPECT_EQ(relative.points, 7);
  EXPECT_NEAR(relative.minima[0].solid.terms[0].alpha, 3, 1e-6);
  const auto absolute = fit_ogden(data, Residual::absolute);
  EXPECT_EQ(absolute.left_out_zero_stress, 0);
  EXPECT_EQ(absolute.points, 9);
}

TEST(FitOgden, PlanarTensionAndShearDoNotTellTheSign) {
  for (const auto deformation : {Deformation::planar, Deformation::simple_shear}) {
    const auto fit = fit_ogden(made_with({1000, 8}, deformation), Residual::relative);
    ASSERT_EQ(fit.minima.size(), 2u);
    EXPECT_EQ(fit.minima[1].above_best, 0);
    EXPECT_NEAR(fit.minima[0].solid.terms[0].alpha, 8, 1e-6);
    EXPECT_NEAR(fit.minima[1].solid.terms[0].alpha, -8, 1e-6);
  }
  EXPECT_THAT(findings(fit_ogden(made_with({1000, 8}, Deformation::planar), Residual::absolute))[0],
              HasSubstr("do not tell the sign"));
  auto noisy = made_with({1000, 8}, Deformation::planar);
  for (std::size_t i = 0; i < noisy.points.size(); ++i) noisy.points[i].nominal_stress *= i % 2 ? 1.02 : 0.98;
  EXPECT_THAT(findings(fit_ogden(noisy, Residual::relative))[0], HasSubstr("do not tell the sign"));
}

TEST(FitOgden, AnAlphaBeyondTheSearchIsReportedAtTheBound) {
  const auto fit = fit_ogden(made_with({1000, 60}, Deformation::uniaxial), Residual::absolute);
  ASSERT_FALSE(fit.minima.empty());
  EXPECT_TRUE(fit.minima[0].at_bound);
  EXPECT_EQ(fit.minima[0].solid.terms[0].alpha, largest_alpha);
  EXPECT_EQ(fit.minima[0].errors[0].alpha, std::nullopt);
  EXPECT_THAT(findings(fit), testing::Contains(HasSubstr("at the bound")));
}

TEST(FitOgden, AVanishingAlphaIsFoundAndItsSignCalledOpen) {
  auto data = made_with({1000, 0}, Deformation::uniaxial);
  for (std::size_t i = 0; i < data.points.size(); ++i) data.points[i].nominal_stress *= i % 2 ? 1.01 : 0.99;
  const auto fit = fit_ogden(data, Residual::relative);
  EXPECT_LT(std::abs(fit.minima[0].solid.terms[0].alpha), 0.2);
  EXPECT_THAT(findings(fit), testing::Contains(HasSubstr("its sign is open")));
}

TEST(FitOgden, StressesOfTheWrongSignHaveNoMinimum) {
  const auto fit = fit_ogden(made_with({-1000, 3}, Deformation::uniaxial), Residual::absolute);
  EXPECT_TRUE(fit.minima.empty());
  EXPECT_THAT(findings(fit)[0], HasSubstr("No positive modulus"));
}

TEST(FitOgden, PointsThatCannotHoldTwoParametersAreRefused) {
  CurveData data;
  EXPECT_THROW(fit_ogden(data, Residual::relative), BadInput);
  data.points = {
      {{Deformation::uniaxial, 1.5}, 10}, {{Deformation::uniaxial, 1.5}, 11}, {{Deformation::uniaxial, 1}, 1}};
  EXPECT_THROW(fit_ogden(data, Residual::relative), BadInput);
  data.points = {{{Deformation::uniaxial, 1.5}, 0}, {{Deformation::uniaxial, 1.6}, 0}};
  EXPECT_THROW(fit_ogden(data, Residual::absolute), BadInput);
}

TEST(FitOgden, TwoPointsAreMetExactlyAndHaveNoStandardErrors) {
  auto data = made_with({1000, 3}, Deformation::uniaxial);
  data.points = {data.points[0], data.points[6]};
  const auto fit = fit_ogden(data, Residual::relative);
  EXPECT_NEAR(fit.minima[0].solid.terms[0].alpha, 3, 1e-6);
  EXPECT_EQ(fit.minima[0].errors[0].mu, std::nullopt);
}

TEST(FitOgden, SeveralModesAreFittedTogether) {
  const auto data = read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {});
  const auto fit = fit_ogden(data, Residual::relative);
  EXPECT_EQ(fit.points, 53);
  EXPECT_EQ(fit.points_of_mode.at(Deformation::uniaxial), 24);
  EXPECT_EQ(fit.points_of_mode.at(Deformation::equibiaxial), 16);
  EXPECT_EQ(fit.points_of_mode.at(Deformation::planar), 13);
}

}  // namespace
}  // namespace percal
