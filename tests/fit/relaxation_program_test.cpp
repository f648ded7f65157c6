// percal fit --relaxation as a user runs it.
#include <gmock/gmock.h>

#include <filesystem>

#include "fit/fit_runs.hpp"
#include "percal/text/file.hpp"
#include "support/relaxing_tests.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string muscle = PERCAL_DATA "/public/vanloocke2008_muscle_rates.csv";
const std::string relaxation_docs = PERCAL_DATA "/../docs/";

class RelaxationProgram : public test::FitRuns {
 protected:
  // A table of one test or more, with a column of time or without.
  std::string table_of(const std::string& name, const std::vector<test::RampAndHold>& tests, bool times = true) const {
    CurveData data;
    for (const auto& one : tests) test::add_test(data, one);
    test::NormalNumbers normal(20090401);
    test::fill_stresses(data, test::relaxing_gel, 0.01, normal);
    std::string text = times ? "time_s,stretch,stress_Pa\n" : "stretch,stress_Pa\n";
    for (const StressPoint& point : data.points)
      text += (times ? std::to_string(*point.time) + "," : "") + std::to_string(point.strained.amount) + "," +
              std::to_string(point.nominal_stress) + "\n";
    return write(name, text);
  }
  std::string three_tests() const { return table_of("three.csv", {{.rate = 1}, {.rate = 0.1}, {.rate = 0.01}}); }
  json parsed(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const Ended ended = fit(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return json::parse(ended.out);
  }
  void refused(std::vector<std::string> arguments, const std::string& words) const {
    const Ended ended = fit(arguments);
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr(words));
  }
};

TEST_F(RelaxationProgram, FindsTheSeriesWithIntervals) {
  const json found = parsed({three_tests(), "--mode", "uniaxial", "--relaxation", "auto"})["relaxation"];
  EXPECT_EQ(found["terms"], 2);
  EXPECT_NEAR(found["mu_0_Pa"].get<double>(), 20e3, 1e3);
  EXPECT_NEAR(found["mu_inf_Pa"].get<double>(), 7e3, 500);
  EXPECT_EQ(found["rungs"].size(), 4u);
  EXPECT_EQ(found["histories"].size(), 3u);
  EXPECT_EQ(found["uncertainty"]["order"], json({"mu_0_Pa", "mu_inf_Pa", "alpha", "g_1", "g_2", "tau_1_s", "tau_2_s"}));
  const json& time = found["uncertainty"]["parameters"]["tau_2_s"];
  EXPECT_LT(time["low"], 20);
  EXPECT_GT(time["high"], 20);
}

TEST_F(RelaxationProgram, WithoutItNothingIsSaidOfTimes) {
  const json result = parsed({three_tests(), "--mode", "uniaxial"});
  EXPECT_TRUE(result["relaxation"].is_null());
  EXPECT_EQ(result["input"]["relaxation"], "");
  EXPECT_TRUE(result["input"]["times"].is_null());
  EXPECT_EQ(result["cards"].size(), 1u);
}

TEST_F(RelaxationProgram, TheSceneItWritesIsOneThatRuns) {
  const Ended ended = fit({three_tests(), "--mode", "uniaxial", "--relaxation", "2", "--out", path("found")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string target = read_file(path("found/target.toml"));
  EXPECT_THAT(target, AllOf(HasSubstr("[target]\nmu = "), HasSubstr("[[target.relaxation]]\nshare = ")));
  const std::string scene =
      target.substr(0, target.find("\n\n[[")) + "\ndensity = \"1030 kg/m3\"\ndepth = \"20 mm\"\n" +
      target.substr(target.find("\n\n[[")) +
      "\n[particle]\nshape = \"sphere\"\nradius = \"1 mm\"\ndensity = \"7800 kg/m3\"\nspeed = \"5 "
      "m/s\"\n";
  const Ended run_of_scene = run({"impact", write("scene.toml", scene), "--check"});
  EXPECT_EQ(run_of_scene.code, 0) << run_of_scene.err;
}

TEST_F(RelaxationProgram, ThePageHasTheHistoriesAndNoCardIsWritten) {
  const Ended ended = fit({three_tests(), "--mode", "uniaxial", "--relaxation", "2", "--out", path("found")});
  EXPECT_THAT(ended.out, AllOf(HasSubstr("Instantaneous shear modulus"), HasSubstr("How many terms"),
                               HasSubstr("target.toml beside the result")));
  ASSERT_EQ(run({"report", path("found")}).code, 0);
  EXPECT_THAT(read_file(path("found/report.html")), HasSubstr("Stress over time"));
  const Ended card = run({"card", "write", path("found"), "--solver", "abaqus"});
  EXPECT_EQ(card.code, 2);
  EXPECT_THAT(card.err, HasSubstr("no card"));
}

TEST_F(RelaxationProgram, RatesStandForTimesWhereNothingIsHeld) {
  const std::string slow = table_of("slow.csv", {{.rate = 0.01, .ramp_rows = 40, .hold_rows = 0}}, false),
                    fast = table_of("fast.csv", {{.rate = 1, .ramp_rows = 40, .hold_rows = 0}}, false);
  const json found = parsed({slow, fast, "--mode", "uniaxial", "--relaxation", "1", "--rate", "0.01 1/s=" + slow,
                             "--rate", "1 1/s=" + fast})["relaxation"];
  EXPECT_NEAR(found["longest_record_s"].get<double>(), 30, 1e-9);
  EXPECT_NEAR(found["shortest_interval_s"].get<double>(), 0.3 / 40, 1e-9);
  const std::string held = table_of("held.csv", {{.rate = 0.01}}, false);
  refused({held, "--mode", "uniaxial", "--relaxation", "1", "--rate", "0.01 1/s"}, "a stretch that is held over 31 rows");
  refused({slow, "--mode", "uniaxial", "--relaxation", "1", "--rate", "5 mm/min"}, "--gauge-length");
  refused({slow, "--mode", "uniaxial", "--relaxation", "1", "--rate", "5 m"}, "a positive rate");
  refused({slow, "--mode", "uniaxial", "--relaxation", "1", "--rate", "1 1/s=" + fast}, "which is not fitted");
}

TEST_F(RelaxationProgram, WhatIsNotUnderstoodIsRefused) {
  const std::string untimed = table_of("untimed.csv", {{.rate = 0.1}}, false), timed = three_tests();
  refused({untimed, "--mode", "uniaxial", "--relaxation", "2"}, "no column of time");
  refused({timed, "--mode", "uniaxial", "--relaxation", "4"}, "1, 2, 3 or auto");
  refused({timed, "--mode", "uniaxial", "--relaxation", "some"}, "\"some\"");
  refused({timed, "--mode", "uniaxial", "--relaxation", "1", "--rate", "0.1 1/s"}, "beside the column of time");
  refused({timed, "--mode", "uniaxial", "--relaxation", "1", "--without", "holds"}, "--without");
  refused({timed, "--mode", "uniaxial", "--rate", "0.1 1/s"}, "--relaxation");
}

// docs/how-to/relaxation.md
TEST_F(RelaxationProgram, MuscleAtThreeRatesRelaxesButNotByOneSeries) {
  const Ended run_of_docs =
      fit({muscle, "--mode", "compression", "--where", "direction=fibre", "--relaxation", "auto"});
  ASSERT_EQ(run_of_docs.code, 0) << run_of_docs.err;
  EXPECT_THAT(run_of_docs.out, AllOf(HasSubstr("Instantaneous shear modulus 377.2 Pa (336 Pa to 420 Pa)"),
                                     HasSubstr("tau_2 may be longer than the longest record, 353 s"),
                                     HasSubstr("Neighbouring residuals are alike"), Not(HasSubstr("tau_1 may be"))));
  const json result = json::parse(read_file(path("vanloocke2008_muscle_rates.out/result.json")));
  const json& found = result["relaxation"];
  EXPECT_EQ(found["terms"], 2);
  EXPECT_NEAR(found["rungs"][0]["aicc_above_lowest"].get<double>(), 224, 1);
  EXPECT_NEAR(found["series"][0]["time_s"].get<double>(), 10.2, 0.1);
  const std::string how_to = read_file(relaxation_docs + "how-to/relaxation.md");
  for (const char* words : {"377 Pa", "336 to 420 Pa", "353 s"}) EXPECT_THAT(how_to, HasSubstr(words));
}

TEST_F(RelaxationProgram, EveryKeyOfTheBlockIsOnThePageOfTheFormat) {
  const std::string page = read_file(relaxation_docs + "formats/fit.md");
  const json found = parsed({three_tests(), "--mode", "uniaxial", "--relaxation", "1"})["relaxation"];
  for (const auto& [key, value] : found.items()) EXPECT_NE(page.find("`" + key + "`"), page.npos) << key;
  for (const char* block : {"minima", "rungs", "histories", "series", "instantaneous"})
    for (const auto& [key, value] : found[block][0].items()) EXPECT_NE(page.find("`" + key + "`"), page.npos) << key;
  for (const auto& [key, value] : found["uncertainty"].items()) EXPECT_NE(page.find("`" + key + "`"), page.npos) << key;
}

}  // namespace
}  // namespace percal
