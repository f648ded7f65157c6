// The pages of the three kinds of study, and which page a result gets.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "percal/base/error.hpp"
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

json mesh(int n, double depth, double error, double cpu_seconds) {
  const json band = {{"value", error}, {"low", error / 2}, {"high", nullptr}};
  return {{"elements_per_radius", n},
          {"time_step_factor", 0.8},
          {"arithmetic", "single"},
          {"outcome", "stopped"},
          {"depth_m", depth},
          {"depth_standard_error_m", 1e-7},
          {"cpu_s", cpu_seconds},
          {"error", {{"value", -error}, {"low", -0.05}, {"high", nullptr}}},
          {"error_of_mean_of", {{"1", band}, {"3", band}, {"10", band}}}};
}

json error_vs_time() {
  json result = json::parse(R"({
    "schema": 1, "percal": "0.1.0", "command": "study", "study": "error vs time",
    "input": {"scene": "/a/gold.toml", "toml": "[particle]\nname = \"gold\"\n[target]\nname = \"skin\"\n"},
    "ladder": {"elements_per_radius": [10, 20], "replicates": 5, "time_step_factor": 0.8},
    "convergence": {"outcome": "fitted", "extrapolated_depth_m": 28e-6, "extrapolated_depth_low_m": 27e-6, "extrapolated_depth_high_m": 29e-6,
                    "fitted_from_elements_per_radius": 10, "form": "a h^2", "a_m": -1e-4, "b_m": 0.0, "order": 2.0, "observed_order": 2.2,
                    "standard_deviation_m": 1e-7, "spread_of_a_run": 0.0138},
    "half_steps": [], "change_by_half_the_step": [{"elements_per_radius": 10, "share": 0.012, "standard_error": 0.015, "is_significant": false, "cost_ratio": 1.96}],
    "advice": [{"target_error": 0.02, "found": true, "elements_per_radius": 20, "replicates": 3, "discretisation_error": 0.009, "noise_error": 0.008,
                "error": 0.012, "cpu_s": 1234.5, "cpu_low_s": 1.0, "cpu_high_s": null, "cost_estimated": false}],
    "findings": ["the mesh is coarse"], "runs": 3, "reused": 7, "cpu_s": 1.5, "wall_s": 2.0, "isa": "x86_64_v3"})");
  result["meshes"] = {mesh(10, 27e-6, 0.04, 0.5), mesh(20, 27.7e-6, 0.02, 4)};
  result["double_precision"] = mesh(10, 27.1e-6, 0.04, 0.7);
  return result;
}

TEST(ErrorVsTimePage, HasTheNumbersOfItsResult) {
  const std::string words = words_of(study_page(error_vs_time()));
  for (const char* there :
       {"gold into skin (gold.toml)", "Extrapolated depth 28 um (27 um to 29 um)", "1.38 %", "20 | 3 | 0.90 % | 0.80 %",
        "1234 s | 1 s | no bound", "half the time step | 10 | +1.20 % | 1.50 % | no", "-5.0 % to no bound",
        "the mesh is coarse", "observed order 2.2"})
    EXPECT_THAT(words, HasSubstr(there));
}

TEST(ErrorVsTimePage, DrawsTheErrorOfEveryMeshAgainstTheTimeOfAllRuns) {
  const Page page = study_page(error_vs_time());
  const Figure* figure = figure_of(page, "error_vs_time");
  ASSERT_NE(figure, nullptr);
  const Series* ten = series_of(*figure, "mean of 10");
  ASSERT_NE(ten, nullptr);
  EXPECT_THAT(ten->x, ElementsAre(5, 40));
  EXPECT_THAT(ten->y, ElementsAre(4, 2));
  EXPECT_THAT(ten->low, ElementsAre(2, 1));
  EXPECT_THAT(ten->high, ElementsAre(4, 2));  // no bound: no bar
  EXPECT_TRUE(figure->chart.x.logarithmic && figure->chart.y.logarithmic);
}

// 28 um - 1e-4 h^2 at h = 0 and 0.1, in um.
TEST(ErrorVsTimePage, DrawsTheMeshStudyWithItsFit) {
  const Page page = study_page(error_vs_time());
  const Figure* figure = figure_of(page, "mesh_study");
  ASSERT_NE(figure, nullptr);
  const Series* fitted = series_of(*figure, "fitted");
  ASSERT_NE(fitted, nullptr);
  EXPECT_NEAR(fitted->y.front(), 28, 1e-9);
  EXPECT_NEAR(fitted->y.back(), 27, 1e-9);
}

TEST(ErrorVsTimePage, WithoutAFitItSaysThatNoErrorCanBeGiven) {
  json result = error_vs_time();
  result["convergence"] = {{"outcome", "too few grids"}};
  EXPECT_THAT(study_page(result).summary, HasSubstr("No error can be given: too few grids"));
}

TEST(OmissionsPage, HasEveryVariantAndEveryOmission) {
  const json result = json::parse(R"({
    "schema": 1, "command": "study", "study": "omissions", "replicates": 5, "spread_of_a_run": 0.0146,
    "input": {"scene": "gold.toml", "toml": ""}, "baseline": {"depth_m": 27.7e-6, "depth_spread_m": 4e-7},
    "left_out": [{"what": "rotation", "why": "it is round", "audited_by": [], "why_not_audited": "no friction"},
                 {"what": "elastic particle", "why": "rigid", "audited_by": ["elastic particle"], "why_not_audited": ""}],
    "omissions": [{"name": "eroded nodes", "kind": "physics", "depth_m": 25.5e-6, "change": -0.08, "change_standard_error": 0.01, "effect": "clear",
                   "cost_ratio": 0.78, "how": "they stay"},
                  {"name": "bottom", "kind": "domain", "depth_m": null, "outcome": "passed through", "change": null, "effect": "ends otherwise"}],
    "skipped": [{"name": "rate", "kind": "physics", "why": "refused"}], "conclusions": ["physics counts"]})");
  const Page page = study_page(result);
  const std::string words = words_of(page);
  for (const char* there : {"eroded nodes | 1 | physics | 25.5 um | - | -8.0 % | 1.0 % | clear | 0.78 | they stay",
                            "bottom | 2 | domain | passed through", "rotation | it is round | not: no friction",
                            "elastic particle | rigid | elastic particle", "Not run: rate: refused", "physics counts"})
    EXPECT_THAT(words, HasSubstr(there));
  EXPECT_THAT(series_of(*figure_of(page, "changes"), "clear")->low, ElementsAre(testing::DoubleEq(-10)));
}

TEST(ExtremesPage, HasEveryCellAndItsTroubles) {
  const json result = json::parse(R"({
    "schema": 1, "command": "study", "study": "extremes", "outcomes": {"stopped": 1, "refused": 1},
    "summary": {"worst_closure": 0.011, "smallest_jacobian": 0.0064, "smallest_step": 0.0001, "cells_with_troubles": 1},
    "cells": [{"group": "alpha", "cell": "alpha -20", "outcome": "stopped", "reason": "", "troubles": ["too deep"], "energy_closure": -0.011, "tip_over_radius": 2.187},
              {"group": "nu", "cell": "nu 0.5", "outcome": "refused", "reason": "nu is too large", "troubles": []}]})");
  const Page page = study_page(result);
  const std::string words = words_of(page);
  for (const char* there : {"refused | 1", "alpha, alpha -20: too deep",
                            "alpha -20 | 1 | alpha | stopped | 2.187 | -1.100 %", "nu is too large", "1.10 %"})
    EXPECT_THAT(words, HasSubstr(there));
  EXPECT_THAT(series_of(*figure_of(page, "energy_errors"), "stopped")->y, ElementsAre(testing::DoubleEq(1.1)));
}

// --- which page -------------------------------------------------------------------------------------------------

std::string refusal(const json& result) {
  try {
    page_of_result(result, "x.json");
  } catch (const BadInput& fault) {
    return fault.what();
  }
  return "none";
}

TEST(PageOfResult, WhatIsNoResultIsRefusedWithWhatIsAccepted) {
  EXPECT_THAT(refusal(json::array()), HasSubstr("x.json"));
  EXPECT_THAT(refusal(json::object()), testing::AllOf(HasSubstr("schema: found nothing"), HasSubstr("accepted: 1")));
  EXPECT_THAT(refusal({{"schema", 99}, {"command", "fit"}}), HasSubstr("found 99"));
  EXPECT_THAT(refusal({{"schema", 1}, {"command", "cook"}}),
              testing::AllOf(HasSubstr("command: found \"cook\""),
                             HasSubstr("fit, scale, impact, study, identify, calibrate")));
  EXPECT_THAT(refusal({{"schema", 1}, {"command", "study"}, {"study", "x"}}),
              testing::AllOf(HasSubstr("x.json: study"), HasSubstr("omissions")));
}

// A result cut down to its head gives a page, if an empty one.
TEST(PageOfResult, AnEmptyResultOfEveryCommandHasAPage) {
  for (const char* command : {"fit", "scale", "impact", "identify", "calibrate"})
    EXPECT_NE(page_of_result({{"schema", 1}, {"command", command}}, "x.json").title, "") << command;
  for (const char* study : {"error vs time", "omissions", "extremes"})
    EXPECT_NE(page_of_result({{"schema", 1}, {"command", "study"}, {"study", study}}, "x.json").title, "") << study;
}

}  // namespace
}  // namespace percal
