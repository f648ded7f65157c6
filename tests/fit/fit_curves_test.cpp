#include "percal/fit/search/fit_curves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "percal/base/error.hpp"
#include "percal/fit/interval/findings.hpp"
#include "percal/fit/read/read_curves.hpp"

namespace percal {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr Deformation three_tests[] = {Deformation::uniaxial, Deformation::equibiaxial, Deformation::simple_shear};

// Stresses of a solid in three deformations, each with a relative error of `noise` and the error's size beside it.
CurveData made_with(const Hyperelastic& solid, double noise = 0) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  CurveData data;
  for (const auto deformation : three_tests)
    for (int i = 0; i < 16; ++i) {
      const double amount = 0.625 + 0.1 * i - (deformation == Deformation::simple_shear ? 0.6 : 0.0);
      const double stress = nominal_stress(solid, Strained{deformation, amount});
      data.points.push_back(
          {{deformation, amount}, stress * (1 + noise * normal(random)), (0.01 + noise) * std::abs(stress) + 1});
    }
  return data;
}

Hyperelastic truth_of(Model model) {
  switch (model) {
    case Model::neo_hooke: return {{{1500, 2}}};
    case Model::mooney_rivlin: return {{{1200, 2}, {500, -2}}};
    case Model::ogden2: return {{{1300, 4.5}, {700, -3}}};
    case Model::ogden3: return {{{400, 9}, {1000, 2.5}, {600, -5}}};
    case Model::ogden: break;
  }
  return {{{1800, 7}}};
}

TEST(FitCurves, EveryModelRecoversItsTruth) {
  for (const Model model : all_models)
    for (const Residual residual : {Residual::relative, Residual::absolute, Residual::error}) {
      const Hyperelastic truth = truth_of(model);
      const auto fit = fit_curves(made_with(truth), {.model = model, .residual = residual});
      ASSERT_FALSE(fit.minima.empty()) << word(model);
      const auto& terms = fit.minima[0].solid.terms;
      ASSERT_EQ(terms.size(), truth.terms.size()) << word(model);
      for (std::size_t k = 0; k < terms.size(); ++k) {
        EXPECT_NEAR(terms[k].alpha, truth.terms[k].alpha, 1e-5) << word(model) << word(residual);
        EXPECT_NEAR(terms[k].mu, truth.terms[k].mu, 1e-5 * truth.terms[k].mu) << word(model) << word(residual);
      }
    }
}

TEST(FitCurves, AModelOfMoreTermsFallsBackToTheTruthOfFewer) {
  for (const Model model : {Model::ogden2, Model::ogden3}) {
    const auto fit = fit_curves(made_with(truth_of(Model::ogden)), {.model = model});
    ASSERT_FALSE(fit.minima.empty()) << word(model);
    ASSERT_EQ(fit.minima[0].solid.terms.size(), 1u) << word(model);
    EXPECT_NEAR(fit.minima[0].solid.terms[0].alpha, 7, 1e-6);
    EXPECT_THAT(findings(fit), Contains(HasSubstr("vanish")));
  }
  const auto mooney = fit_curves(made_with(Hyperelastic{{{1500, 2}, {-200, -2}}}), {.model = Model::mooney_rivlin});
  EXPECT_EQ(mooney.minima[0].solid.terms.size(), 1u);
}

TEST(FitCurves, FreeSignsLetASingleModulusBeNegative) {
  const Hyperelastic truth{{{1500, 2}, {-200, -2}}};
  const auto fit = fit_curves(made_with(truth), {.model = Model::mooney_rivlin, .signs = Signs::free});
  ASSERT_EQ(fit.minima[0].solid.terms.size(), 2u);
  EXPECT_NEAR(fit.minima[0].solid.terms[1].mu, -200, 1e-6);
  for (const Model model : {Model::ogden2, Model::ogden3, Model::mooney_rivlin}) {
    const auto data = made_with(truth, 0.02);
    const auto positive = fit_curves(data, {.model = model});
    const auto free = fit_curves(data, {.model = model, .signs = Signs::free});
    EXPECT_LE(free.minima[0].objective, positive.minima[0].objective * (1 + 1e-9)) << word(model);
  }
}

TEST(FitCurves, EveryTestCountsTheSameHoweverManyPointsItHas) {
  const auto data = made_with(truth_of(Model::ogden2), 0.05);
  auto repeated = data;
  for (const auto& point : data.points)
    if (point.strained.deformation == Deformation::equibiaxial)
      for (int i = 0; i < 33; ++i) repeated.points.push_back(point);
  const auto alpha = [](const CurveData& points, const Weighting& weighting) {
    return fit_curves(points, {.weighting = weighting}).minima[0].solid.terms[0].alpha;
  };
  EXPECT_NEAR(alpha(data, EqualTests{}), alpha(repeated, EqualTests{}), 1e-6);
  EXPECT_GT(std::abs(alpha(data, EqualPoints{}) - alpha(repeated, EqualPoints{})), 0.01);
}

TEST(FitCurves, ASharePutsATestFirstAndUnknownNamesAreRefused) {
  const auto data = made_with(truth_of(Model::ogden3), 0.05);
  const EqualTests shear{{{"simple_shear", 1e6}}};
  const auto fit = fit_curves(data, {.weighting = shear});
  double weights = 0;
  for (const auto& test : fit.tests) weights += test.weight * test.points;
  EXPECT_NEAR(weights, fit.points, 1e-9 * fit.points);
  CurveData alone = data;
  std::erase_if(alone.points, [](const auto& p) { return p.strained.deformation != Deformation::simple_shear; });
  EXPECT_NEAR(std::abs(fit.minima[0].solid.terms[0].alpha),
              std::abs(fit_ogden(alone, Residual::relative).minima[0].solid.terms[0].alpha), 1e-3);
  EXPECT_THROW(fit_curves(data, {.weighting = EqualTests{{{"planar", 2}}}}), BadInput);
  EXPECT_EQ(fit_curves(data, {.weighting = EqualTests{{{"compression", 2}}}}).tests.size(), 4u);
}

TEST(FitCurves, ARobustLossIsNotDrawnByOutliers) {
  auto data = made_with(truth_of(Model::ogden), 0.01);
  for (const std::size_t i : {3u, 15u, 30u, 40u}) data.points[i].nominal_stress *= 4;
  const auto error = [&](Loss loss) {
    const auto fit = fit_curves(data, {.residual = Residual::absolute, .loss = loss});
    return std::abs(fit.minima[0].solid.terms[0].mu / 1800 - 1);
  };
  EXPECT_GT(error(Loss::squares), 0.1);
  EXPECT_LT(error(Loss::huber), 0.05);
  EXPECT_LT(error(Loss::cauchy), 0.02);
}

TEST(FitCurves, RobustFitsOfSeveralTermsHaveTheSameTruth) {
  auto data = made_with(truth_of(Model::ogden2), 0.001);
  data.points[5].nominal_stress *= 3;
  const auto fit = fit_curves(data, {.model = Model::ogden2, .loss = Loss::cauchy});
  ASSERT_EQ(fit.minima[0].solid.terms.size(), 2u);
  EXPECT_NEAR(fit.minima[0].solid.terms[0].alpha, 4.5, 0.2);
  EXPECT_NEAR(fit.minima[0].solid.terms[1].alpha, -3, 0.2);
  EXPECT_TRUE(fit.loss_scale.has_value());
}

TEST(FitCurves, ErrorWeightedResidualsNeedErrors) {
  auto data = made_with(truth_of(Model::ogden));
  data.points[0].standard_error = 0;
  data.points[1].standard_error.reset();
  const auto fit = fit_curves(data, {.residual = Residual::error});
  EXPECT_EQ(fit.left_out_no_error, 2);
  EXPECT_EQ(fit.points, 46);
  for (auto& point : data.points) point.standard_error.reset();
  EXPECT_THROW(fit_curves(data, {.residual = Residual::error}), BadInput);
}

TEST(FitCurves, TheErrorOfAPointSetsItsWeight) {
  auto data = made_with(truth_of(Model::ogden));
  data.points[7].nominal_stress *= 2;
  data.points[7].standard_error = 1e12;
  const auto fit = fit_curves(data, {.residual = Residual::error});
  EXPECT_NEAR(fit.minima[0].solid.terms[0].alpha, 7, 1e-6);
}

TEST(FitCurves, TheInformationCriterionIsItsFormula) {
  const auto data = made_with(truth_of(Model::mooney_rivlin), 0.03);
  const auto fit = fit_curves(data, {.model = Model::mooney_rivlin});
  const double n = 48, k = 3;
  EXPECT_NEAR(*fit.aicc, n * std::log(fit.minima[0].objective / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1), 1e-9);
  const auto more = fit_curves(data, {.model = Model::ogden3});
  EXPECT_LT(more.minima[0].objective, fit.minima[0].objective);
  EXPECT_LT(*fit.aicc, *more.aicc);  // noise is no reason for four more parameters
}

TEST(FitCurves, MoreParametersThanPointsAreRefused) {
  auto data = made_with(truth_of(Model::ogden2));
  data.points.resize(5);
  EXPECT_NO_THROW(fit_curves(data, {.model = Model::ogden2}));
  EXPECT_THROW(fit_curves(data, {.model = Model::ogden3}), BadInput);
}

TEST(FitCurves, ResidualsHaveTheDerivativesOfTheirDifferences) {
  const auto data = made_with(truth_of(Model::ogden2), 0.05);
  for (const Residual residual : {Residual::relative, Residual::absolute, Residual::error}) {
    const auto problem = curve_problem(data, residual);
    const Hyperelastic solid{{{1100, 3.5}, {900, -2.5}}};
    const auto at = residuals_of(problem, Model::ogden2, solid);
    for (int parameter = 0; parameter < 4; ++parameter) {
      const auto moved = [&](double h) {
        Hyperelastic other = solid;
        if (parameter < 2)
          other.terms[parameter].mu *= std::exp(h);
        else
          other.terms[parameter - 2].alpha += h;
        return residuals_of(problem, Model::ogden2, other).value;
      };
      const Eigen::VectorXd difference = (moved(1e-5) - moved(-1e-5)) / 2e-5;
      EXPECT_LT((difference - at.jacobian.col(parameter)).norm(), 1e-7 * difference.norm()) << parameter;
    }
  }
}

TEST(FitCurves, TensionAndCompressionAreTwoTestsAndFilesAreToldApart) {
  const auto meat = read_curves({PERCAL_DATA "/public/stpierre2023_meat_tension_compression_shear.csv"},
                                {.where = {"material_label=ac"}});
  const auto problem = curve_problem(meat, Residual::relative);
  ASSERT_EQ(problem.tests.size(), 3u);
  EXPECT_EQ(problem.tests[0].name, "uniaxial compression");
  const auto both = read_curves(
      {PERCAL_DATA "/public/treloar1944_rubber_primary.csv", PERCAL_DATA "/public/meunier2008_silicone_modes.csv"}, {});
  const auto tests = curve_problem(both, Residual::relative).tests;
  ASSERT_EQ(tests.size(), 7u);
  EXPECT_EQ(tests[0].name, "treloar1944_rubber_primary uniaxial tension");
}

CurveData treloar_tension() {
  return read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {.where = {"mode=UT"}});
}

// The last points draw one exponent to the bound; the others are where an independent constrained search has them.
TEST(FitCurves, BesideAnExponentAtTheBoundTheOthersReachTheirMinimum) {
  const auto fit = fit_curves(treloar_tension(), {.model = Model::ogden3, .residual = Residual::absolute});
  const auto& best = fit.minima.at(0);
  EXPECT_TRUE(best.at_bound && best.converged);
  EXPECT_NEAR(best.objective / 4.4777458e10, 1, 1e-7);
  EXPECT_EQ(best.solid.terms.at(0).alpha, 40);
  EXPECT_NEAR(best.solid.terms.at(1).alpha, 7.134492, 1e-4);
  EXPECT_NEAR(best.solid.terms.at(1).mu, 45.5750, 1e-3);
  EXPECT_NEAR(best.solid.terms.at(2).alpha, -4.179757, 1e-4);
  EXPECT_NEAR(best.solid.terms.at(2).mu, 532065.9, 5);
  for (std::size_t i = 0; i + 1 < fit.minima.size(); ++i)  // none twice
    EXPECT_GT(fit.minima[i + 1].objective / fit.minima[i].objective, 1 + 1e-9);
}

TEST(FitCurves, ANegativeSumOfModuliIsTheReasonWhereItIs) {
  const auto fit = fit_curves(treloar_tension(),
                              {.model = Model::mooney_rivlin, .residual = Residual::absolute, .signs = Signs::free});
  EXPECT_TRUE(fit.minima.empty());
  EXPECT_THAT(findings(fit).at(0), HasSubstr("C10 + C01 = 409 kPa - 751.2 kPa"));
  EXPECT_NEAR(fit_curves(treloar_tension(), {.model = Model::mooney_rivlin, .residual = Residual::absolute})
                  .minima.at(0)
                  .solid.terms.at(0)
                  .mu,
              570.8e3, 100);
}

}  // namespace
}  // namespace percal
