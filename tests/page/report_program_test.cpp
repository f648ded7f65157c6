// percal report as a user runs it, on results that the program has just written.
#include <gmock/gmock.h>

#include "page/markup_faults.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string treloar = PERCAL_DATA "/public/treloar1944_rubber_primary.csv";

class Report : public test::Program {
 protected:
  std::string fit_result() const {
    EXPECT_EQ(run({"fit", treloar, "--residual", "absolute", "--weights", "tests", "--out", "fit.out", "--quiet"}).code,
              0);
    return "fit.out/result.json";
  }
};

TEST_F(Report, WritesAPageBesideTheResultAndSaysSo) {
  const Ended ended = run({"report", fit_result()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("fit.out/report.html"));
  const std::string page = read("fit.out/report.html");
  EXPECT_THAT(test::markup_faults(page), IsEmpty());
  EXPECT_THAT(page, HasSubstr("treloar1944_rubber_primary.csv"));
  EXPECT_EQ(files("fit.out"), (std::set<std::string>{"fit.out/result.json", "fit.out/report.html"}));
}

TEST_F(Report, KeepsEveryPlotAsFilesToo) {
  ASSERT_EQ(run({"report", fit_result(), "-o", "page.html", "--plots", "plots", "--quiet"}).code, 0);
  EXPECT_THAT(read("plots/residuals.csv"), HasSubstr("uniaxial tension"));
  EXPECT_EQ(read("plots/curve_equibiaxial.csv").substr(0, 7), "series,");
  if (!files("plots").contains("plots/residuals.svg")) GTEST_SKIP() << "gnuplot is not there";
  EXPECT_THAT(read("plots/residuals.svg"), HasSubstr("<svg"));
  EXPECT_THAT(read("plots/residuals.png"), HasSubstr("PNG"));
}

TEST_F(Report, WithoutGnuplotThePointsAreInTables) {
  const std::string result = fit_result();
  const Ended ended = run({"report", result, "-o", "page.html"}, [] { setenv("PATH", "/nowhere", 1); });
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("plots were not drawn"));
  EXPECT_THAT(read("page.html"), AllOf(HasSubstr("gnuplot is not there"), Not(HasSubstr("<svg"))));
  EXPECT_THAT(test::markup_faults(read("page.html")), IsEmpty());
}

TEST_F(Report, AFolderStandsForItsResult) {
  fit_result();
  EXPECT_EQ(run({"report", "fit.out", "--quiet"}).code, 0);
  EXPECT_THAT(read("fit.out/report.html"), HasSubstr("treloar1944_rubber_primary.csv"));
  EXPECT_THAT(run({"report", "."}).err, HasSubstr("./result.json: there is no such file"));
}

TEST_F(Report, OpensThePageOrSaysWhatToOpen) {
  const std::string result = fit_result();
  const Ended without = run({"report", result, "--open"}, [] { setenv("PATH", "/nowhere", 1); });
  EXPECT_EQ(without.code, 4);
  EXPECT_THAT(without.err, HasSubstr("no xdg-open here: open fit.out/report.html in a browser"));
  write("bin/xdg-open", "#!/bin/sh\necho \"$1\" > opened\n");
  std::filesystem::permissions(path("bin/xdg-open"), std::filesystem::perms::owner_all);
  EXPECT_EQ(run({"report", result, "--open"}, [&] { setenv("PATH", path("bin").c_str(), 1); }).code, 0);
  EXPECT_EQ(read("opened"), path("fit.out/report.html") + "\n");
}

TEST_F(Report, WhatIsNoResultIsRefused) {
  const std::pair<std::string, std::string> cases[] = {
      {write("a.json", "{\"schema\": 2"), "not JSON"},
      {write("b.json", "[1]"), "JSON that is no object"},
      {write("c.json", "{}"), "schema: found nothing; accepted: 2"},
      {write("d.json", "{\"schema\": 1, \"command\": \"fit\"}"), "d.json: schema: found 1; accepted: 2"},
      {write("e.json", "{\"schema\": 2, \"command\": \"impact\"}"),
       "found nothing; accepted: a value, as every result of percal impact"},
      {write("f.json", "{\"schema\": 2, \"command\": \"cook\"}"),
       "command: found \"cook\"; accepted: a result of fit, scale"},
      {write("g.json", "{\"schema\": 1e509}"), "g.json:1: found 1e509"},
      {write("h.json", std::string(20000, '[')), "nested too deeply"},
      {write("i.json",
             R"({"schema": 2, "command": "fit", "input": )" + std::string(50000, '[') + std::string(50000, ']') + "}"),
       "nested too deeply"},
      {path("nowhere.json"), "nowhere.json"}};
  for (const auto& [file, words] : cases) {
    const Ended ended = run({"report", file, "-o", "page.html"});
    EXPECT_EQ(ended.code, 2) << file;
    EXPECT_THAT(ended.err, HasSubstr(words)) << file;
  }
  EXPECT_FALSE(files().contains("page.html"));
}

TEST_F(Report, APageThatCannotBeWrittenIsCodeFour) {
  const std::string result = fit_result();
  write("file", "");
  EXPECT_EQ(run({"report", result, "-o", "file/page.html"}).code, 4);
  EXPECT_EQ(run({"report", result, "-o", "page.html", "--plots", "file/plots"}).code, 4);
  EXPECT_EQ(run({"report", result, "-o", "page.html"}, test::into_a_full_disk).code, 4);
}

TEST_F(Report, TheSameResultGivesTheSamePage) {
  const std::string result = fit_result();
  ASSERT_EQ(run({"report", result, "-o", "a.html", "--quiet"}).code, 0);
  ASSERT_EQ(run({"report", result, "-o", "b.html", "--quiet"}).code, 0);
  EXPECT_EQ(read("a.html"), read("b.html"));
}

}  // namespace
}  // namespace percal
