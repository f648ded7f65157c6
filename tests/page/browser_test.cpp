// Pages of real results in headless Chromium: nothing is wider than the page, at 320 and 1280 pixels, and nothing is fetched.
// Skips where there is no chromium or no gnuplot.
#include <gmock/gmock.h>

#include <regex>

#include "support/browser.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using test::Ended;
using testing::HasSubstr;

class SlowBrowser : public test::Program {
 protected:
  void SetUp() override {
    if (!test::chromium_is_there()) GTEST_SKIP() << "chromium is not there";
    if (std::system("command -v gnuplot > /dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not there";
  }

  // In windows of a phone and of a screen: what is found at fault, "" where there is nothing.
  std::string looked_at(const std::string& page) const {
    std::string found;
    test::Browser browser(path("profile"));
    for (const int width : {320, 1280}) {
      browser.resize(width, 800);
      browser.open_page(path(page));
      found += browser.value_of(test::what_does_not_fit).get<std::string>();
    }
    for (const std::string& address : browser.fetched()) found += "; fetched " + address;
    for (const std::string& words : browser.complaints()) found += "; " + words;
    return found;
  }
  void expect_fits(const std::string& result) const {
    const Ended ended = run({"report", result, "-o", "page.html", "--quiet"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(looked_at("page.html"), "") << result;
  }
  void expect_runs(std::vector<std::string> arguments) const {
    const Ended ended = run(arguments);
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
};

TEST_F(SlowBrowser, AFitFits) {
  expect_runs({"fit", PERCAL_DATA "/public/treloar1944_rubber_primary.csv", "--compare", "--weights", "tests",
               "--bootstrap", "20", "--out", "fit.out", "--quiet"});
  expect_fits("fit.out/result.json");
}

TEST_F(SlowBrowser, ARateFactorFits) {
  expect_runs({"fit", "--rate-factor", PERCAL_DATA "/synthetic/gelatin_12wt_quasistatic.csv",
               PERCAL_DATA "/synthetic/gelatin_12wt_highrate.csv", "--out", "rate.out", "--quiet"});
  expect_fits("rate.out/result.json");
}

TEST_F(SlowBrowser, AnImpactFits) {
  expect_runs({"impact", test::test_data + "layer.toml", "--replicates", "3", "--threads", "1", "--history",
               "history.csv", "--out", "impact.out", "--quiet"});
  expect_fits("impact.out/result.json");
}

TEST_F(SlowBrowser, AScaledSystemFits) {
  std::string job = text_of(test::guha2009 + "similar.toml");
  job = std::regex_replace(job, std::regex("(^|\n)output_scene[^\n]*"), "");
  for (const char* scene : {"gold.toml", "steel.toml"}) write(scene, text_of(test::guha2009 + scene));
  expect_runs({"scale", write("similar.toml", job), "--out", "scale.out", "--quiet"});
  expect_fits("scale.out/result.json");
}

TEST_F(SlowBrowser, AStudyOfErrorAgainstTimeFits) {
  expect_runs({"study", test::test_data + "layer.toml", "--error-vs-time", "--meshes", "3,4,5,6", "--replicates", "3",
               "--threads", "1", "--out", "study.out", "--quiet"});
  expect_fits("study.out/result.json");
}

TEST_F(SlowBrowser, WhatDoesNotFitIsSeen) {
  const std::string page =
      "<!DOCTYPE html><html><body><p style=\"width:700px\">wide</p><img "
      "src=\"http://nowhere.invalid/x.png\"></body></html>";
  write("page.html", page);
  const std::string words = looked_at("page.html");
  EXPECT_THAT(words, HasSubstr("P \"wide\"  ends at 7"));
  EXPECT_THAT(words, HasSubstr("fetched http://nowhere.invalid/x.png"));
}

}  // namespace
}  // namespace percal
