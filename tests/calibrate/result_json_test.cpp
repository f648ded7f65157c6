// result.json of a calibration, from a result made by hand.
#include <gmock/gmock.h>

#include "calibrate/small_job.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/page/text.hpp"

namespace percal {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class CalibrationJson : public calibrate_test::SmallJob {
 protected:
  json made() const {
    const auto job = read_job();
    return calibration_to_json(job, calibrate_test::made_up_result(job));
  }
};

TEST_F(CalibrationJson, HasTheInputTheVersionAndTheCost) {
  const json result = made();
  EXPECT_EQ(result["command"], "calibrate");
  EXPECT_EQ(result["input"]["toml"], calibrate_test::small_job);
  EXPECT_EQ(result["title"], "Jelly");
  EXPECT_EQ(result["seed"], 7);
  EXPECT_EQ(result["cost"]["isa"], "x86_64_v2");
  EXPECT_EQ(result["cost"]["budget_s"], 60);
  EXPECT_TRUE(result["schema"].is_number_integer());
  EXPECT_TRUE(result["percal"].is_string());
}

TEST_F(CalibrationJson, HasThePiecesOfARegionAndThePageHasThemInWords) {
  const auto job = read_job();
  auto result = calibrate_test::made_up_result(job);
  result.hypotheses[0].intervals[2].region = {{5, 6}, {9, 12}};
  const json made = calibration_to_json(job, result);
  EXPECT_EQ(made["hypotheses"][0]["parameters"][2]["region"], json::parse("[[5.0, 6.0], [9.0, 12.0]]"));
  EXPECT_TRUE(made["hypotheses"][0]["parameters"][0].contains("region_Pa"));
  EXPECT_THAT(page::as_text(calibrate_page(made), {.detail = page::Detail::more}), HasSubstr("5 to 6 or 9 to 12"));
}

TEST_F(CalibrationJson, PutsUnitsIntoTheNamesOfKeys) {
  const json parameters = made()["hypotheses"][0]["parameters"];
  EXPECT_NEAR(parameters[0]["value_Pa"], 1e5, 1e-6);
  EXPECT_FALSE(parameters[0].contains("value"));
  EXPECT_NEAR(parameters[2]["value"], 6, 1e-12);
  EXPECT_FALSE(parameters[2].contains("value_Pa"));
  EXPECT_TRUE(parameters[2]["at_bound"]);
  EXPECT_NEAR(parameters[3]["value"], 0.9, 1e-12);
}

TEST_F(CalibrationJson, IntervalsSayWhichEndIsOpen) {
  const json parameters = made()["hypotheses"][0]["parameters"];
  EXPECT_EQ(parameters[1]["interval_Pa"], json({{"low", 2e4}, {"high", 2e6}, {"low_open", true}, {"high_open", true}}));
  EXPECT_FALSE(parameters[1]["identifiable"]);
  EXPECT_EQ(parameters[2]["interval"]["high_open"], true);
  EXPECT_EQ(parameters[2]["interval"]["low_open"], false);
  EXPECT_NEAR(parameters[0]["profile"]["value_Pa"][0], 8e4, 1e-6);
  EXPECT_NEAR(parameters[0]["profile"]["rise"][0], 2.7, 1e-12);
}

TEST_F(CalibrationJson, WritesNullForWhatIsNotThere) {
  const json result = made();
  const json& free = result["hypotheses"][0];
  EXPECT_TRUE(free["shots"][2]["deviation"].is_null());  // a least depth
  EXPECT_TRUE(free["shots"][2]["measured_m"].is_null());
  EXPECT_EQ(free["shots"][2]["measured_at_least_m"], 0.06);
  EXPECT_TRUE(free["ridges"][0]["rise"][0][0].is_null());  // it was infinite
  EXPECT_TRUE(free["minima"][0]["scatter"][2]["standard_deviation"].is_null());
  EXPECT_TRUE(free["moduli"][1]["mu_true"]["interval_Pa"]["high"].is_null());  // it was no number
  EXPECT_TRUE(free["moduli"][1]["youngs_quasi_static_true"].is_null());
  EXPECT_TRUE(free["fresh_runs"][1]["depth_m"].is_null());
  EXPECT_TRUE(free["sets"][1]["mean_deviation"].is_null());  // no shots
  EXPECT_TRUE(free["leave_one_out"][0]["goal"].is_null());
  const json& held = result["hypotheses"][1];
  EXPECT_TRUE(held["parameters"].is_null());
  EXPECT_TRUE(held["bootstrap"].is_null());
  EXPECT_TRUE(held["fresh_mean_deviation"].is_null());
  EXPECT_TRUE(result["data"]["parameters"][1]["prior_Pa"].is_null());
}

TEST_F(CalibrationJson, ReadsBackAsItWasWritten) {
  const json result = made();
  EXPECT_EQ(json::parse(result.dump()), result);
}

TEST_F(CalibrationJson, NamesTheAxesAndThePointsOfARidge) {
  const json ridge = made()["hypotheses"][0]["ridges"][0];
  EXPECT_EQ(ridge["x_parameter"], "strain");
  EXPECT_EQ(ridge["y_parameter"], "mu");
  EXPECT_EQ(ridge["x"], json({0.5, 1}));
  EXPECT_EQ(ridge["y_Pa"], json({5e4, 2e5}));
  EXPECT_EQ(ridge["contours"][0]["y_Pa"], json({1.4e5, 7e4}));
}

TEST_F(CalibrationJson, RepeatsTheDataOfTheJob) {
  const json data = made()["data"];
  EXPECT_EQ(data["shots"].size(), 6u);
  EXPECT_EQ(data["shots"][0]["set"], "balls");
  EXPECT_EQ(data["shots"][4]["scatter"], "few");
  EXPECT_EQ(data["curves"][0]["synthetic"], true);
  EXPECT_EQ(data["parameters"][2]["kind"], "exponent");
}

TEST_F(CalibrationJson, WithoutDehnThereIsNone) {
  const auto job = read_job();
  auto result = calibrate_test::made_up_result(job);
  EXPECT_EQ(calibration_to_json(job, result)["dehn"]["parameters"][1]["name"], "s of soft");
  result.dehn.reset();
  EXPECT_TRUE(calibration_to_json(job, result)["dehn"].is_null());
}

TEST_F(CalibrationJson, OfAFailedCalibrationHasTheReason) {
  const auto job = read_job();
  CalibrationResult result;
  result.findings = {"Too many runs failed."};
  const json written = calibration_to_json(job, result);
  EXPECT_TRUE(written["hypotheses"].empty());
  EXPECT_EQ(written["findings"][0], "Too many runs failed.");
}

}  // namespace
}  // namespace percal
