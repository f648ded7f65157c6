// Intervals and rate factors of percal fit as a user gets them.
#include <gmock/gmock.h>

#include <set>

#include "fit/fit_runs.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;

const std::string slow = PERCAL_DATA "/synthetic/gelatin_12wt_quasistatic.csv";
const std::string fast = PERCAL_DATA "/synthetic/gelatin_12wt_highrate.csv";
const std::string treloar_file = PERCAL_DATA "/public/treloar1944_rubber_primary.csv";

class UncertaintyProgram : public test::FitRuns {
 protected:
  json parsed(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const Ended ended = fit(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return json::parse(ended.out);
  }
  // The two rates in one file, the high rate first.
  std::string one_file() const {
    std::string text = "rate_1_s,mode,stretch,stress_kPa\n";
    for (const auto& [file, rate] : {std::pair{fast, "1000"}, {slow, "0.01"}}) {
      std::istringstream lines(read_file(file));
      for (std::string line; std::getline(lines, line);)
        if (line.rfind("uniaxial", 0) == 0) text += rate + ("," + line.substr(0, line.rfind(','))) + "\n";
    }
    return write("rates.csv", text);
  }
};

void expect_inside(const json& interval, double truth) {
  EXPECT_LE(interval["low"].get<double>(), truth);
  EXPECT_GE(interval["high"].get<double>(), truth);
  EXPECT_EQ(interval["low_open"], false);
  EXPECT_EQ(interval["high_open"], false);
}

TEST_F(UncertaintyProgram, AFitHasIntervalsOfEveryParameter) {
  const json result = parsed({slow, "--residual", "error", "--bootstrap", "50"})["uncertainty"];
  EXPECT_EQ(result["level"], 0.95);
  EXPECT_EQ(result["errors"], "standard errors");
  EXPECT_EQ(result["degrees_of_freedom"], 24);
  const json& best = result["minima"].at(0);
  expect_inside(best["parameters"]["mu_Pa"], 11640);
  expect_inside(best["parameters"]["alpha"], 9);
  EXPECT_EQ(best["correlation"].at(0).at(0), 1);
  EXPECT_LT(best["correlation"].at(0).at(1).get<double>(), 0);
  for (const char* kind : {"points", "residuals", "parametric"})
    EXPECT_LT(best["parameters"]["alpha"]["bootstrap"][kind]["low"].get<double>(),
              best["parameters"]["alpha"]["bootstrap"][kind]["high"].get<double>());
}

TEST_F(UncertaintyProgram, ALowerLevelMakesNarrowerIntervals) {
  const auto width = [&](const char* level) {
    const json alpha = parsed({slow, "--level", level})["uncertainty"]["minima"][0]["parameters"]["alpha"];
    return alpha["high"].get<double>() - alpha["low"].get<double>();
  };
  EXPECT_NEAR(width("0.6827") / width("0.95"), 1.0 / 2.06, 0.02);  // Student's t with 24 degrees of freedom
  EXPECT_EQ(fit({slow, "--level", "95"}).code, 2);
}

TEST_F(UncertaintyProgram, IntervalsMayBeLeftOut) {
  EXPECT_TRUE(parsed({slow, "--no-intervals"})["uncertainty"].is_null());
  EXPECT_THAT(fit({slow}).out, HasSubstr("95 % interval"));
  const std::string without = fit({slow, "--no-intervals"}).out;
  EXPECT_THAT(without, AllOf(HasSubstr("±"), testing::Not(HasSubstr("interval"))));
}

TEST_F(UncertaintyProgram, TheRateFactorHasAnIntervalAndATestOfItsShape) {
  const json result = parsed({"--rate-factor", slow, fast, "--residual", "error"});
  expect_inside(result["rate_factor"], 9.74);
  expect_inside(result["mu_slow_Pa"], 11640);
  expect_inside(result["mu_fast_Pa"], 9.74 * 11640);
  expect_inside(result["alpha"], 9);
  EXPECT_EQ(result["one_shape"]["serves"], true);
  EXPECT_GT(result["one_shape"]["chance"].get<double>(), 0.05);
  EXPECT_EQ(result["sources"].size(), 2u);
  const Ended text = fit({"--rate-factor", slow, fast});
  for (const char* part : {"rate factor", "mu at the low rate", "95 % interval", "note: One shape serves both rates"})
    EXPECT_THAT(text.out, HasSubstr(part));
  const std::string name = std::filesystem::path(slow).stem().string();
  EXPECT_TRUE(this->result(name + ".out/result.json")["rate_factor"].is_object());
}

TEST_F(UncertaintyProgram, AColumnOfRatesDoesTheSameAsTwoFiles) {
  const json two = parsed({"--rate-factor", slow, fast});
  const json one = parsed({"--rate-factor", one_file(), "--rate-column", "rate_1_s"});
  EXPECT_EQ(one["rate_factor"], two["rate_factor"]);
  EXPECT_EQ(one["alpha"], two["alpha"]);
}

TEST_F(UncertaintyProgram, ARateFactorWithoutTwoCurvesIsRefused) {
  EXPECT_EQ(fit({"--rate-factor", slow}).code, 2);
  EXPECT_EQ(fit({"--rate-factor", slow, fast, slow}).code, 2);
  EXPECT_EQ(fit({"--rate-factor", slow, fast, "--model", "ogden2"}).code, 2);
  EXPECT_EQ(fit({slow, "--rate-column", "stretch"}).code, 2);
  const Ended many = fit({"--rate-factor", slow, "--rate-column", "stretch"});
  EXPECT_EQ(many.code, 2);
  EXPECT_THAT(many.err, HasSubstr("26 different rates"));
  EXPECT_EQ(fit({"--rate-factor", slow, "--rate-column", "nonsense"}).code, 2);
  EXPECT_EQ(fit({"--rate-factor", slow, fast, "--check"}).code, 0);
}

// Every key of the two results, in code font on the page of the format.
void collect(const json& value, std::set<std::string>& keys) {
  if (value.is_object())
    for (const auto& [key, inner] : value.items()) {
      keys.insert(key);
      collect(inner, keys);
    }
  for (const auto& inner : value)
    if (inner.is_structured()) collect(inner, keys);
}

TEST_F(UncertaintyProgram, ThePageOfTheFormatNamesEveryKey) {
  const std::string page = read_file(PERCAL_DATA "/../docs/formats/fit.md");
  std::set<std::string> keys;
  collect(parsed({slow, "--bootstrap", "5"})["uncertainty"], keys);
  json rate = parsed({"--rate-factor", slow, fast});
  for (const char* key : {"input", "sources", "cost"}) rate.erase(key);
  collect(rate, keys);
  for (const auto& key : keys) EXPECT_THAT(page, testing::ContainsRegex("`[^`]*" + key)) << key;
}

}  // namespace
}  // namespace percal
