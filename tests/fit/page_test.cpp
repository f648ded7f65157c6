// The pages of curve fits against results made by hand.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "percal/fit/page/parts.hpp"
#include "page/page_words.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::figure_of;
using test::section_of;
using test::series_of;
using test::words_of;
using testing::HasSubstr;
using testing::Not;

json minimum(double mu, double alpha) {
  return {{"mu_Pa", mu},
          {"alpha", alpha},
          {"terms",
           {{{"mu_Pa", mu}, {"alpha", alpha}, {"mu_standard_error_Pa", 0.05 * mu}, {"alpha_standard_error", 0.1}}}},
          {"objective", 0.25},
          {"objective_above_best", 0.0},
          {"r2", 0.9876},
          {"r2_of_test", {{"uniaxial tension", 0.9876}}},
          {"correlation", -0.5},
          {"converged", true},
          {"at_bound", false}};
}

// Three points of uniaxial tension, of which the last is 10 % above the solid with mu 2 kPa and alpha 4.
json small_fit() {
  const Ogden solid{2000, 4};
  json amounts = {1.2, 1.5, 2.0}, stresses = json::array();
  for (const double stretch : {1.2, 1.5, 2.0})
    stresses.push_back(nominal_stress(solid, Strained{Deformation::uniaxial, stretch}) * (stretch == 2.0 ? 1.1 : 1));
  return {
      {"schema", 1},
      {"version", "0.1.0"},
      {"command", "fit"},
      {"model", "ogden"},
      {"residual", "relative"},
      {"objective_unit", "1"},
      {"loss", "squares"},
      {"signs", "positive"},
      {"points", 3},
      {"left_out_zero_stress", 1},
      {"left_out_no_error", 0},
      {"input", {{"where", {"mode=UT"}}, {"weights", "points"}}},
      {"sources",
       {{{"file", "/a/rubber.csv"},
         {"sha256", std::string(64, 'a')},
         {"x", "stretch"},
         {"y", "stress_kPa"},
         {"error", nullptr},
         {"stress", "nominal"},
         {"points", 3}}}},
      {"tests", {{{"name", "uniaxial tension"}, {"deformation", "uniaxial"}, {"points", 3}, {"weight_of_point", 1.0}}}},
      {"data",
       {{{"name", "uniaxial tension"},
         {"deformation", "uniaxial"},
         {"amount", amounts},
         {"across", {nullptr, nullptr, nullptr}},
         {"stress_Pa", stresses},
         {"error_Pa", {nullptr, nullptr, nullptr}}}}},
      {"minima", {minimum(2000, 4)}},
      {"uncertainty",
       {{"level", 0.9},
        {"errors", "residuals"},
        {"scatter", 0.05},
        {"degrees_of_freedom", 10},
        {"seed", 20090401},
        {"bootstrap_replicates", 0},
        {"findings", {"the points are few"}},
        {"minima",
         {{{"minimum", 0},
           {"parameters",
            {{"mu_Pa",
              {{"low", 1900.0}, {"high", 2100.0}, {"low_open", false}, {"high_open", true}, {"identifiable", true}}},
             {"alpha",
              {{"low", 3.5}, {"high", 4.5}, {"low_open", false}, {"high_open", false}, {"identifiable", false}}}}}}}}}},
      {"stability", nullptr},
      {"findings", {"alpha is positive"}},
      {"cost", {{"wall_s", 0.5}, {"cpu_s", 0.4}}}};
}

TEST(FitPage, HasTheNumbersOfItsResult) {
  const std::string words = words_of(fit_page(small_fit()));
  for (const char* there : {"rubber.csv", "2 kPa", "1.9 kPa to 2.1 kPa (open)", "3.5 to 4.5, not identifiable",
                            "0.9876", "the points are few", "alpha is positive", "aaaaaaaaaaaaaaaa...",
                            "1 point: their stress is zero", "rows without mode=UT", "20090401", "0.1.0"})
    EXPECT_THAT(words, HasSubstr(there));
}

// 2 mu/alpha = 1 kPa; its relative variance is 0.05^2 + (0.1/4)^2 + 2 * 0.5 * 0.05 * 0.1/4, Student's t of 90 % at 10 is 1.8125.
TEST(FitPage, GivesTheModulusInTheOtherConventionWithItsInterval) {
  const double half = 1.8124611 * std::sqrt(0.0025 + 0.000625 + 0.00125);
  const auto errors = page::curve_errors(small_fit());
  ASSERT_TRUE(errors.has_value());
  const auto mu1 = page::mu_over_alpha({2000, 4}, errors);
  EXPECT_DOUBLE_EQ(mu1.value, 1000);
  EXPECT_NEAR(mu1.half_width.value(), 1000 * half, 1e-4);
  EXPECT_THAT(words_of(fit_page(small_fit())), HasSubstr("2 mu/alpha | 1 kPa | 880.1 Pa to 1.12 kPa (linearised)"));
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
  const double half = page::half_width(solid, page::curve_errors(small_fit()).value(), strained);
  EXPECT_NEAR(half, 1.8124611 * std::sqrt(variance), 1e-5 * half);
}

TEST(FitPage, DrawsPointsCurveAndBandAndTheResiduals) {
  const Page page = fit_page(small_fit());
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
  json result = small_fit();
  result["minima"][0]["terms"][0]["mu_standard_error_Pa"] = nullptr;
  const Page page = fit_page(result);
  for (const Series& series : figure_of(page, "curve_uniaxial")->chart.series) EXPECT_NE(series.mark, Mark::band);
  EXPECT_THAT(words_of(page), HasSubstr("No band: the fit gives no standard errors"));
}

TEST(FitPage, AResultWithoutPointsSaysThatItHasNone) {
  json result = small_fit();
  result.erase("data");
  EXPECT_THAT(words_of(fit_page(result)), HasSubstr("This result keeps no points"));
}

TEST(FitPage, AResultWithoutAMinimumSaysSo) {
  json result = small_fit();
  result["minima"] = json::array();
  result["uncertainty"] = nullptr;
  EXPECT_THAT(words_of(fit_page(result)), HasSubstr("there is no result"));
}

TEST(RateFactorPage, HasTheFactorBothModuliAndTheCurves) {
  json result = small_fit();
  const auto parameter = [](double value) {
    return json{{"value", value},    {"low", 0.9 * value}, {"high", 1.1 * value},
                {"low_open", false}, {"high_open", false}, {"identifiable", true}};
  };
  result.update({{"rate_factor", parameter(3)},
                 {"mu_slow_Pa", parameter(2000)},
                 {"mu_fast_Pa", parameter(6000)},
                 {"alpha", parameter(4)},
                 {"level", 0.95}});
  result["data"][0]["name"] = "low rate";
  const Page page = fit_page(result);
  const std::string words = words_of(page);
  for (const char* there :
       {"rate factor | 3 | 2.7 to 3.3", "mu at the high rate, true | 6 kPa", "2 mu/alpha at the high rate | 3 kPa"})
    EXPECT_THAT(words, HasSubstr(there));
  ASSERT_NE(figure_of(page, "curve_uniaxial"), nullptr);
  EXPECT_NE(series_of(*figure_of(page, "curve_uniaxial"), "fit, low rate"), nullptr);
}

}  // namespace
}  // namespace percal
