// Two results side by side: what differs is shown, what does not is not.
#include "percal/page/comparison.hpp"

#include <gmock/gmock.h>

#include "calibrate/small_job.hpp"
#include "page/page_words.hpp"
#include "percal/base/error.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/page/html.hpp"

namespace percal {
namespace {

using namespace page;
using nlohmann::json;
using test::figure_of;
using test::section_of;
using test::series_of;
using test::words_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Comparison : public calibrate_test::SmallJob {
 protected:
  Comparison() {
    const auto job = read_job();
    first = calibration_to_json(job, calibrate_test::made_up_result(job));
    second = first;
  }
  Page both() const {
    return compared({"a.json", first, calibrate_page(first)}, {"b.json", second, calibrate_page(second)});
  }
  json first, second;
};

TEST_F(Comparison, EqualResultsDifferInNothing) {
  const Page same = both();
  EXPECT_THAT(same.summary, HasSubstr("every number is the same"));
  EXPECT_THAT(words_of(*section_of(same, "inputs")), HasSubstr("Nothing"));
  EXPECT_EQ(section_of(same, "numbers")->blocks.size(), 1u) << "a sentence and no table";
  EXPECT_FALSE(section_of(same, "figures"));
}

TEST_F(Comparison, LinesOfTheJobThatDifferStandSideBySide) {
  std::string text = first["input"]["toml"];
  text.replace(text.find("level = 0.9"), 11, "level = 0.8\n# more");
  second["input"]["toml"] = text;
  const std::string words = words_of(*section_of(both(), "inputs"));
  EXPECT_THAT(words, HasSubstr("2 | level = 0.9 | level = 0.8"));
  EXPECT_THAT(words, HasSubstr("- / 3 | - | # more"));
  EXPECT_THAT(words, Not(HasSubstr("bootstrap = 20"))) << "a line of both";
}

TEST_F(Comparison, AnotherProcessorIsSaid) {
  second["cost"]["isa"] = "x86_64_v4";
  EXPECT_THAT(words_of(*section_of(both(), "inputs")), HasSubstr("isa | x86_64_v2 | x86_64_v4"));
}

TEST_F(Comparison, ANumberIsShownWithItsDifferenceOverBothErrors) {
  // The interval from 80 kPa to 130 kPa is an error of 12.5 kPa, of both together 17.7 kPa.
  second["hypotheses"][0]["parameters"][0]["value_Pa"] = 1.5e5;
  const Page page = both();
  EXPECT_THAT(words_of(*section_of(page, "numbers")),
              HasSubstr("hypotheses: free: parameters: mu: value | 100 kPa \u00b1 12.5 kPa | 150 kPa \u00b1 12.5 kPa | "
                        "50 kPa (+50.00 %) | +2.8"));
  EXPECT_THAT(page.summary, HasSubstr("mu: value: 100 kPa in A, 150 kPa in B, 2.8 combined errors"));
}

TEST_F(Comparison, OtherNumbersThatDifferAreListedAfterTheMainOnes) {
  second["hypotheses"][0]["error_budgets"][0]["influence"] = -1.0;
  const std::string words = words_of(*section_of(both(), "numbers"));
  EXPECT_LT(words.find("The main numbers"), words.find("Other numbers that differ"));
  EXPECT_THAT(words, HasSubstr("error budgets: E of soft: influence | -1.7 | -1 | 0.7"));
}

TEST_F(Comparison, TheLongListIsFolded) {
  second["hypotheses"][0]["error_budgets"][0]["influence"] = -1.0;
  const Page page = both();
  EXPECT_THAT(html(page, {}), HasSubstr("<details><summary>Other numbers that differ"));
}

TEST_F(Comparison, AChangeOverNextToNothingIsNoPercentage) {
  second["hypotheses"][0]["error_budgets"][0]["influence"] = -1.0;
  first["hypotheses"][0]["error_budgets"][0]["influence"] = 1e-7;
  const std::string words = words_of(*section_of(both(), "numbers"));
  EXPECT_THAT(words, HasSubstr("influence | 1e-07 | -1 | -1 | -\n"));
}

TEST_F(Comparison, FiguresThatDifferAreOverlaid) {
  second["hypotheses"][0]["curves"][0]["stress_Pa"] = {6000.0, 12000.0};
  const Page page = both();
  const Figure* curve = figure_of(page, "curve_1_1");
  ASSERT_TRUE(curve);
  const Series *ours = series_of(*curve, "A: model"), *theirs = series_of(*curve, "B: model");
  ASSERT_TRUE(ours && theirs);
  EXPECT_NEAR(ours->y.front(), 5.2, 1e-9);
  EXPECT_NEAR(theirs->y.front(), 6.0, 1e-9);
  EXPECT_NE(ours->colour, theirs->colour);
  ASSERT_TRUE(series_of(*curve, "the same in both"));
  EXPECT_NEAR(series_of(*curve, "the same in both")->y.front(), 5.5, 1e-9) << "the measured points, once";
  EXPECT_FALSE(figure_of(page, "ridge_mu")) << "the same in both";
}

TEST_F(Comparison, CostsStandSideBySideAndAreNoDifferenceOfTheResult) {
  second["cost"]["cpu_s"] = 80.0;
  const Page page = both();
  EXPECT_THAT(words_of(*section_of(page, "cost")), HasSubstr("processor time | 8 s | 80 s"));
  EXPECT_THAT(page.summary, HasSubstr("every number is the same"));
}

TEST_F(Comparison, ResultsOfTwoCommandsAreRefused) {
  try {
    compared({"a.json", first, {}}, {"b.json", {{"schema", 2}, {"command", "identify"}}, {}});
    FAIL() << "nothing was thrown";
  } catch (const BadInput& error) {
    EXPECT_THAT(std::string(error.what()), AllOf(HasSubstr("b.json"), HasSubstr("calibrate")));
  }
}

TEST(ComparisonOfImpacts, ErrorsAreFoundBesideTheirNumbersWithTheUnit) {
  const json first{{"schema", 2},
                   {"command", "impact"},
                   {"depth_m", 20e-6},
                   {"depth_standard_error_m", 3e-7},
                   {"input", {{"toml", "a"}}}};
  json second = first;
  second["depth_m"] = 21e-6;
  second["depth_standard_error_m"] = 4e-7;
  const Page page = compared({"a", first, {}}, {"b", second, {}});
  EXPECT_THAT(words_of(*section_of(page, "numbers")),
              HasSubstr("depth | 20 um \u00b1 300 nm | 21 um \u00b1 400 nm | 1 um (+5.00 %) | +2"));
}

}  // namespace
}  // namespace percal
