// The pages of impacts and of scaling against results made by hand.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "page/page_words.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::figure_of;
using test::series_of;
using test::words_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

json small_impact() {
  return json::parse(R"({
    "schema": 1, "percal": "0.1.0", "command": "impact", "outcome": "stopped", "isa": "x86_64_v3",
    "input": {"scene": "/a/gold.toml",
              "toml": "[particle]\nname = \"gold\"\nradius = \"1e-06 m\"\n\n[target]\nname = \"skin\"\nalpha = 8.5\n"},
    "depth_m": 27.5e-6, "depth_spread_m": 4e-7, "depth_standard_error_m": 2.31e-7, "depth_at_least_m": null,
    "mu_as_given_Pa": 63.75e6, "mu_true_Pa": 63.75e6, "convention": "true", "bulk_modulus_Pa": 3.1875e9,
    "bulk_was_chosen": true, "mach": 0.36, "elements": 22050, "steps": 5722, "energy_worst_closure": 0.0029,
    "energy": {"particle": 0.0, "elastic": 0.25, "eroded": 0.745, "sum": 0.995},
    "runs": [{"speed_factor": 1.0, "outcome": "stopped", "depth_m": 27.2e-6, "steps": 5722, "cpu_s": 0.87, "reused": false},
             {"speed_factor": 1.001, "outcome": "stopped", "depth_m": 27.8e-6, "steps": 5731, "cpu_s": 0.9, "reused": true}],
    "history": {"time_s": [0, 1e-7, 2e-7], "tip_m": [0, 2e-5, 2.75e-5], "speed_m_s": [651, 300, 0], "force_N": [0, 1e-3, 5e-4],
                "energy": {"particle": [1, 0.4, 0], "elastic": [0, 0.2, 0.25], "eroded": [0, 0.4, 0.745], "contact": [0, 0, 0]}},
    "accuracy": null, "left_out": [{"what": "rotation", "why": "it is round"}], "warnings": ["Mach number 0.36"],
    "wall_s": 2.0, "cpu_s": 0.87, "reused": 1})");
}

TEST(ImpactPage, HasTheNumbersOfItsResult) {
  const std::string words = words_of(impact_page(small_impact()));
  for (const char* there :
       {"Impact: gold into skin", "Depth 27.5 um, standard error 230 nm", "mu, true | 63.75 MPa", "2 mu/alpha | 15 MPa",
        "3.188 GPa, chosen by the program", "radius | 1 um", "eroded elements | 74.50 %", "sum | 99.50 %",
        "rotation: it is round", "Mach number 0.36", "x86_64_v3", "1.001 | stopped | 27.8 um"})
    EXPECT_THAT(words, HasSubstr(there));
}

TEST(ImpactPage, ASceneInTheOtherConventionShowsBothNumbersToo) {
  json result = small_impact();
  result["convention"] = "mu/alpha";
  result["mu_as_given_Pa"] = 15e6;
  EXPECT_THAT(words_of(impact_page(result)),
              testing::AllOf(HasSubstr("mu, true | 63.75 MPa"), HasSubstr("2 mu/alpha | 15 MPa")));
}

TEST(ImpactPage, StacksTheEnergyLedgerOverTime) {
  const Page page = impact_page(small_impact());
  const Figure* figure = figure_of(page, "energy_over_time");
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(figure->chart.x.label, "time since contact, us");
  const Series* elastic = series_of(*figure, "elastic");
  ASSERT_NE(elastic, nullptr);
  EXPECT_THAT(elastic->low, ElementsAre(1, 0.4, 0));
  EXPECT_THAT(elastic->high, ElementsAre(1, testing::DoubleEq(0.6), 0.25));
  EXPECT_EQ(series_of(*figure, "contact springs"), nullptr);  // never there
  EXPECT_THAT(figure->caption, HasSubstr("within 0.5 %"));
  ASSERT_NE(figure_of(page, "tip_over_time"), nullptr);
  EXPECT_THAT(figure_of(page, "tip_over_time")->chart.series[0].y,
              ElementsAre(0, testing::DoubleEq(20), testing::DoubleEq(27.5)));
}

TEST(ImpactPage, WithoutAHistoryItSaysHowToGetOne) {
  json result = small_impact();
  result["history"] = nullptr;
  const Page page = impact_page(result);
  EXPECT_EQ(figure_of(page, "energy_over_time"), nullptr);
  EXPECT_THAT(words_of(page), HasSubstr("--history FILE.csv"));
}

TEST(ImpactPage, SaysWhereTheErrorComesFrom) {
  json result = small_impact();
  EXPECT_THAT(words_of(impact_page(result)), HasSubstr("The error of the mesh is not in it"));
  result["accuracy"] = {
      {"target_error", 0.02}, {"discretisation_error", 0.0125}, {"noise_error", 0.0075}, {"error", 0.0146}};
  EXPECT_THAT(words_of(impact_page(result)),
              testing::AllOf(HasSubstr("mesh | 1.2 %"), HasSubstr("noise of erosion | 0.8 %")));
}

TEST(ImpactPage, AParticleThatPassedThroughHasALowerBound) {
  json result = small_impact();
  result.update({{"outcome", "passed through"}, {"depth_m", nullptr}, {"depth_at_least_m", 75e-6}});
  EXPECT_THAT(impact_page(result).summary, HasSubstr("deeper than 75 um"));
}

TEST(ScalePage, HasGroupsSystemsAndWhatStandsInTheWay) {
  const json result = json::parse(R"({
    "schema": 1, "version": "0.1.0", "command": "scale", "job": "similar.toml", "input": "[prototype]\n", "tolerance": 0.01,
    "prototype": {"particle": "gold", "target": "skin", "convention": "mu/alpha", "mu_true_Pa": 63.75e6, "alpha": 8.5, "radius_m": 1e-6,
                  "strain_rate_1_s": 1e8},
    "model": {"particle": "steel", "target": "gelatin", "convention": "mu/alpha", "mu_true_Pa": 481127, "alpha": 8.5, "radius_m": 1.59e-3},
    "groups": [{"symbol": "pi4", "formula": "rho_t v^2 / mu", "name": "inertia", "prototype": 6.64786, "model": 6.64786,
                "agreement": "agree", "difference": 0.0},
               {"symbol": "pi9", "formula": "rate a / v", "name": "strain rate", "prototype": null, "model": null,
                "agreement": "missing", "difference": null, "missing_in_model": ["rate"]}],
    "derived": [{"quantity": "mu_true_Pa", "value": 481127, "from": "pi4"}],
    "not_similar_because": ["the radius is given twice"], "modulus_ratio": 0.007547})");
  const std::string words = words_of(scale_page(result));
  for (const char* there :
       {"1 of 2 groups agree", "0.007547 times", "pi4 | rho_t v^2 / mu | inertia | 6.64786 | 6.64786 | +0.00 % | agree",
        "missing; model lacks rate", "the radius is given twice", "true shear modulus | 63.75 MPa | 481.127 kPa",
        "2 mu/alpha | 15 MPa | 113.2 kPa", "particle radius | 1 um | 1.59 mm", "strain rate | 1e+08 1/s | -",
        "true shear modulus | 481.127 kPa | pi4", "[prototype]"})
    EXPECT_THAT(words, HasSubstr(there));
}

}  // namespace
}  // namespace percal
