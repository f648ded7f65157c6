// The pages of curve fits against results that their own writer made of made-up structs.
#include "percal/fit/page/page.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "page/page_words.hpp"
#include "percal/fit/page/fit_json.hpp"
#include "percal/fit/page/sections.hpp"
#include "percal/page/text.hpp"

namespace percal {
namespace {

using namespace page;
using test::figure_of;
using test::section_of;
using test::series_of;
using test::words_of;
using testing::HasSubstr;
using testing::Not;

FitRequest request() { return {.files = {"/a/rubber.csv"}, .columns = {.where = {"mode=UT"}}}; }

CurveMinimum minimum(double mu, double alpha) {
  return {.solid = {{{mu, alpha}}},
          .objective = 0.25,
          .above_best = 0.0,
          .r2 = 0.9876,
          .r2_of_test = {0.9876},
          .errors = {{0.05 * mu, 0.1}},
          .correlation = -0.5,
          .converged = true};
}

ParameterUncertainty parameter(const char* name, const char* unit, double value, const Interval& interval) {
  return {.name = name, .unit = unit, .value = value, .interval = interval, .bootstrap = {}};
}

// Three points of uniaxial tension, of which the last is 10 % above the solid with mu 2 kPa and alpha 4.
FinishedFit small_fit() {
  const Ogden solid{2000, 4};
  FinishedFit found;
  for (const double stretch : {1.2, 1.5, 2.0}) {
    const Strained strained{Deformation::uniaxial, stretch};
    found.data.points.push_back(
        {.strained = strained, .nominal_stress = nominal_stress(solid, strained) * (stretch == 2.0 ? 1.1 : 1)});
  }
  found.data.sources = {{.file = "/a/rubber.csv", .x = "stretch", .y = "stress_kPa", .points = 3}};
  found.fit.minima = {minimum(2000, 4)};
  found.fit.tests = {{.name = "uniaxial tension", .file = "/a/rubber.csv", .points = 3}};
  found.fit.points = 3;
  found.fit.points_of_mode = {{Deformation::uniaxial, 3}};
  found.fit.left_out_zero_stress = 1;
  Uncertainty& uncertainty = found.uncertainty.emplace();
  uncertainty.options.level = 0.9;
  uncertainty.scatter = 0.05;
  uncertainty.degrees_of_freedom = 10;
  uncertainty.findings = {"the points are few"};
  uncertainty.minima = {
      {.minimum = 0,
       .parameters = {parameter("mu", "Pa", 2000, {1900, 2100, false, true}), parameter("alpha", "", 4, {3.5, 4.5})},
       .correlation = Eigen::MatrixXd::Identity(2, 2)}};
  uncertainty.minima[0].parameters[1].identifiable = false;
  return found;
}

Json json_of(const FinishedFit& found) {
  return fit_to_json(request(), found, {.cpu_seconds = 0.4, .wall_seconds = 0.5});
}
Page page_of(const FinishedFit& found) { return fit_page(json_of(found)); }
std::string answer_of(const Json& result) { return as_text(fit_page(result), {.columns = 80}); }

TEST(FitPage, HasTheNumbersOfItsResult) {
  Json result = json_of(small_fit());
  result["sources"][0]["sha256"] = std::string(64, 'a');
  const std::string words = words_of(fit_page(result));
  for (const char* there : {"rubber.csv", "2 kPa", "1.9 kPa to above 2.1 kPa", "3.5 to 4.5, not identifiable", "0.9876",
                            "the points are few", "aaaaaaaaaaaaaaaa...", "1 point: their stress is zero",
                            "rows without mode=UT", "20090401", "0.5 s"})
    EXPECT_THAT(words, HasSubstr(there));
}

TEST(FitPage, TheAnswerIsMinimaStabilityAndWhatAReaderMustKnowOnOneScreen) {
  FinishedFit found = small_fit();
  found.fit.minima.push_back(minimum(1000, -3));
  found.fit.minima[1].above_best = 0.3;
  const std::string answer = answer_of(json_of(found));
  for (const char* there :
       {"3 points (3 uniaxial), relative residuals; 1 of zero stress left out.", "minimum  mu, kPa", "90 % interval",
        "1.9 to above 2.1", "3.5 to 4.5", "30 %", "Drucker-stable", "note: the points are few"})
    EXPECT_THAT(answer, HasSubstr(there));
  for (const char* elsewhere : {"2 mu/alpha", "scatter", "SHA-256"}) EXPECT_THAT(answer, Not(HasSubstr(elsewhere)));
  EXPECT_LE(std::count(answer.begin(), answer.end(), '\n'), 24);
}

TEST(FitPage, StandardErrorsStandWhereIntervalsWereNotAskedFor) {
  FinishedFit found = small_fit();
  found.uncertainty.reset();
  const std::string answer = answer_of(json_of(found));
  EXPECT_THAT(answer, HasSubstr("2 \u00b1 0.1  4 \u00b1 0.1"));
  EXPECT_THAT(answer, Not(HasSubstr("interval")));
}

TEST(FitPage, TermsOfASumStandBelowTheirMinimumWithTheirIntervals) {
  FinishedFit found = small_fit();
  found.fit.options.model = Model::ogden2;
  found.fit.minima[0].solid.terms = {{2000, 4}, {500, -2}};
  found.fit.minima[0].errors.resize(2);
  auto& about = found.uncertainty->minima[0];
  about.parameters = {parameter("mu_1", "Pa", 2000, {1900, 2100}), parameter("mu_2", "Pa", 500, {400, 600}),
                      parameter("alpha_1", "", 4, {3.5, 4.5}), parameter("alpha_2", "", -2, {-3, -1})};
  about.small_strain_modulus = Interval{2450, 2550};
  const Page page = page_of(found);
  const Section* result = section_of(page, "result");
  ASSERT_NE(result, nullptr);
  const std::string words = words_of(*result);
  EXPECT_THAT(words, HasSubstr("1 | 2.5 | 2.45 to 2.55 | - | - | 0.9876 | 0 %"));
  EXPECT_THAT(words, HasSubstr("term 2 | 0.5 | 0.4 to 0.6 | -2 | -3 to -1"));
}

TEST(FitPage, ComparedModelsAreAnAnswerWhereTheyWereAskedFor) {
  EXPECT_EQ(section_of(page_of(small_fit()), "models"), nullptr);
  FinishedFit found = small_fit();
  const ComparedModel fitted{
      .model = Model::ogden, .fit = found.fit, .why_not = "", .left_out = {}, .mean_relative_deviation = 0.123};
  found.comparison = {fitted, {.model = Model::ogden3, .fit = {}, .why_not = "found 3 points", .left_out = {}}};
  const std::string answer = answer_of(json_of(found));
  for (const char* there : {"ogden            2  2 kPa  0.9876", "12.3 %", "ogden3: too few points."})
    EXPECT_THAT(answer, HasSubstr(there));
}

TEST(FitPage, AResultThatLacksAKeyIsRefusedByItsName) {
  for (const char* key : {"minima", "uncertainty", "comparison", "rate_factor", "data", "stability", "search"}) {
    Json result = json_of(small_fit());
    result.erase(key);
    try {
      fit_page(result);
      FAIL() << key;
    } catch (const MissingKey& missing) {
      EXPECT_EQ(missing.key, key);
    }
  }
}

// 2 mu/alpha = 1 kPa; its relative variance is 0.05^2 + (0.1/4)^2 + 2 * 0.5 * 0.05 * 0.1/4, Student's t of 90 % at 10 is 1.8125.
TEST(FitPage, GivesTheModulusInTheOtherConventionWithItsInterval) {
  const double half = 1.8124611 * std::sqrt(0.0025 + 0.000625 + 0.00125);
  const auto errors = page_of_fit::curve_errors(json_of(small_fit()));
  ASSERT_TRUE(errors.has_value());
  const auto mu1 = page_of_fit::mu_over_alpha({2000, 4}, errors);
  EXPECT_DOUBLE_EQ(mu1.value, 1000);
  EXPECT_NEAR(mu1.half_width.value(), 1000 * half, 1e-4);
  EXPECT_THAT(words_of(page_of(small_fit())), HasSubstr("2 mu/alpha | 1 kPa | 880.1 Pa to 1.12 kPa (linearised)"));
}

// By differences of the curve in mu and alpha.
TEST(FitPage, TheBandIsThatOfTheParametersCovariance) {
  const Hyperelastic solid{std::vector<Ogden>{{2000, 4}}};
  const Strained strained{Deformation::uniaxial, 1.7};
  const auto stress = [&](double mu, double alpha) { return nominal_stress(Ogden{mu, alpha}, strained); };
  const double by_mu = (stress(2001, 4) - stress(1999, 4)) / 2,
               by_alpha = (stress(2000, 4.001) - stress(2000, 3.999)) / 0.002;
  const double variance =
      std::pow(100 * by_mu, 2) + std::pow(0.1 * by_alpha, 2) - 2 * 0.5 * 100 * 0.1 * by_mu * by_alpha;
  const double half = page_of_fit::half_width(solid, page_of_fit::curve_errors(json_of(small_fit())).value(), strained);
  EXPECT_NEAR(half, 1.8124611 * std::sqrt(variance), 1e-5 * half);
}

TEST(FitPage, DrawsPointsCurveAndBandAndTheResiduals) {
  const Page page = page_of(small_fit());
  const Figure* curve = figure_of(page, "curve_uniaxial");
  ASSERT_NE(curve, nullptr);
  ASSERT_NE(series_of(*curve, "uniaxial tension: points"), nullptr);
  EXPECT_EQ(series_of(*curve, "uniaxial tension: points")->x.size(), 3u);
  const Series* fit = series_of(*curve, "fit");
  ASSERT_NE(fit, nullptr);
  EXPECT_NEAR(fit->y.back(), nominal_stress(Ogden{2000, 4}, Strained{Deformation::uniaxial, 2.0}) / 1000, 1e-9);
  EXPECT_EQ(curve->chart.series.front().mark, Mark::band);
  const Figure* residuals = figure_of(page, "residuals");
  ASSERT_NE(residuals, nullptr);
  const auto& missed = series_of(*residuals, "uniaxial tension")->y;
  EXPECT_NEAR(missed[0], 0, 1e-9);
  EXPECT_NEAR(missed[2], 100 * 0.1 / 1.1, 1e-9);
}

TEST(FitPage, WithoutStandardErrorsThereIsNoBandAndThePageSaysSo) {
  FinishedFit found = small_fit();
  found.fit.minima[0].errors = {{}};
  const Page page = page_of(found);
  for (const Series& series : figure_of(page, "curve_uniaxial")->chart.series) EXPECT_NE(series.mark, Mark::band);
  EXPECT_THAT(words_of(page), HasSubstr("No band: the fit gives no standard errors"));
}

TEST(FitPage, AResultWithoutAMinimumSaysSo) {
  FinishedFit found = small_fit();
  found.fit.minima.clear();
  found.uncertainty = Uncertainty{};
  const std::string answer = answer_of(json_of(found));
  EXPECT_THAT(answer, HasSubstr("there is no result"));
  EXPECT_THAT(answer, HasSubstr("note: No positive modulus fits"));
}

Json small_factor() {
  const auto about = [](const char* name, const char* unit, double value) {
    return parameter(name, unit, value, {0.9 * value, 1.1 * value});
  };
  RateFactor found;
  found.factor = about("the rate factor", "", 3);
  found.mu_slow = about("mu at the low rate", "Pa", 2000);
  found.mu_fast = about("mu at the high rate", "Pa", 6000);
  found.alpha = about("alpha", "", 4);
  found.slow.alone = found.fast.alone = {2000, 4};
  found.findings = {"One shape serves both rates."};
  const CurveData curve = small_fit().data;
  return rate_factor_to_json(request(), {curve, curve}, found, {});
}

TEST(RateFactorPage, HasTheFactorBothModuliAndTheCurves) {
  const Page page = fit_page(small_factor());
  const std::string words = words_of(page);
  for (const char* there : {"rate factor | 3 | 2.7 to 3.3", "mu at the high rate | 6 kPa", "3 kPa at the high rate",
                            "low rate | 0 | 2 kPa | 4 | 1 kPa"})
    EXPECT_THAT(words, HasSubstr(there));
  ASSERT_NE(figure_of(page, "curve_uniaxial"), nullptr);
  EXPECT_NE(series_of(*figure_of(page, "curve_uniaxial"), "fit, low rate"), nullptr);
}

TEST(RateFactorPage, TheAnswerIsTheFactorAndWhetherOneShapeServes) {
  const std::string answer = answer_of(small_factor());
  for (const char* there : {"2.7 to 3.3", "mu at the low rate", "note: One shape serves both rates."})
    EXPECT_THAT(answer, HasSubstr(there));
  EXPECT_THAT(answer, Not(HasSubstr("alone")));
}

}  // namespace
}  // namespace percal
