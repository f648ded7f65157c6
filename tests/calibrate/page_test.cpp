// The page of a calibration against the made-up result of the small job.
#include <gmock/gmock.h>

#include "calibrate/small_job.hpp"
#include "page/page_words.hpp"
#include "percal/calibrate/page/page.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::figure_of;
using test::section_of;
using test::series_of;
using test::words_of;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

auto near(double value) { return DoubleNear(value, 1e-9); }

class CalibratePageOfResult : public calibrate_test::SmallJob {
 protected:
  CalibratePageOfResult() {
    const auto job = read_job();
    result = calibration_to_json(job, calibrate_test::made_up_result(job));
    page = calibrate_page(result);
  }
  json result;
  Page page;
};

TEST_F(CalibratePageOfResult, TheSummaryIsTheModulusWithItsInterval) {
  EXPECT_EQ(page.title, "Jelly");
  EXPECT_THAT(page.summary, HasSubstr("quasi-static E of soft 30 kPa (24 kPa to 39 kPa)"));
  EXPECT_THAT(page.summary, HasSubstr("90 %"));
}

TEST_F(CalibratePageOfResult, SaysEveryNumberWithItsInterval) {
  const std::string words = words_of(page);
  for (const char* what :
       {"mu | modulus | 10 kPa | 1 MPa | 100 kPa",
        "soft | 1 | 100 kPa (80 kPa to 130 kPa) | 33 kPa (20 kPa to 50 kPa) | 90 kPa",
        "soft | 1 | 30 kPa (24 kPa to 39 kPa) | 10 kPa (8 kPa to 13 kPa)",
        "mu | 100 kPa | 80 kPa to 130 kPa | 81 kPa to 120 kPa",
        "mu_hard | 200 kPa | below 20 kPa to above 2 MPa | 30 kPa to 1 MPa | not identifiable",
        "alpha | 6 | 5 to above 12 | 5 to 11 | at its bound", "deviance above the best | 0 | 2.5",
        "steel -> lead | 1 | 7.0 % | 3.1 % | 6.0 %", "scatter: shots | 64.0 %", "E of soft: three more shots | 0.8",
        "The strain and the modulus go together.", "Dehn predicts better.", "Twice the runs would help.",
        "held | mu/alpha | 0.156 | mu = 90 kPa, alpha = 5", "synthetic: tension"})
    EXPECT_THAT(words, HasSubstr(what));
}

TEST_F(CalibratePageOfResult, TheCurveHasItsPointsItsBandAndWhatIsLeft) {
  const Figure *curve = figure_of(page, "curve_1_1"), *left = figure_of(page, "curve_1_1_residuals");
  ASSERT_TRUE(curve && left);
  EXPECT_THAT(series_of(*curve, "synthetic")->y, ElementsAre(near(5.5), near(11)));
  EXPECT_THAT(series_of(*curve, "model")->y, ElementsAre(near(5.2), near(10.5)));
  EXPECT_THAT(series_of(*curve, "90 % of one point")->low, ElementsAre(near(4.8), near(9.8)));
  EXPECT_THAT(series_of(*left, "synthetic less model")->y, ElementsAre(near(0.3), near(0.5)));
  EXPECT_THAT(curve->caption, HasSubstr("2 of 2 points lie in the band"));
}

TEST_F(CalibratePageOfResult, TheRidgeHasOutlinesBestAndPublishedPoints) {
  const Figure* ridge = figure_of(page, "ridge_1");
  ASSERT_TRUE(ridge);
  const Series *outline = series_of(*ridge, "free"), *published = series_of(*ridge, "somebody's");
  ASSERT_TRUE(outline && published);
  EXPECT_THAT(outline->x, ElementsAre(near(0.6), near(1.1)));
  EXPECT_THAT(outline->y, ElementsAre(near(140), near(70)));
  EXPECT_THAT(published->y, ElementsAre(near(80), near(120)));
}

TEST_F(CalibratePageOfResult, DepthsStandAgainstMeasuredOnesAndTheImpactParameter) {
  const Figure *depths = figure_of(page, "depths_1"), *soft = figure_of(page, "impact_parameter_1");
  ASSERT_TRUE(depths && soft);
  ASSERT_TRUE(series_of(*depths, "balls, fitted") && series_of(*depths, "balls, predicted"));
  EXPECT_THAT(series_of(*depths, "balls, fitted")->x, ElementsAre(near(10), near(16), near(40))) << "radii";
  EXPECT_THAT(series_of(*soft, "measured")->x, ElementsAre(near(468), near(702), near(850.5)));
  EXPECT_EQ(series_of(*soft, "went at least so deep")->y.size(), 1u);
  EXPECT_THAT(soft->caption, HasSubstr("free: 10.0 % from the measured depths"));
}

TEST_F(CalibratePageOfResult, ProfilesFreshRunsAndRoundsHaveFigures) {
  const Figure *profiles = figure_of(page, "profiles_1"), *fresh = figure_of(page, "fresh_1"),
               *rounds = figure_of(page, "error_vs_time");
  ASSERT_TRUE(profiles && fresh && rounds);
  EXPECT_THAT(series_of(*profiles, "mu")->x, ElementsAre(near(0.8), near(1)));
  EXPECT_THAT(profiles->caption, HasSubstr("Too flat to be known: mu_hard"));
  EXPECT_THAT(series_of(*fresh, "fresh runs")->y, ElementsAre(0.8)) << "the other one passed through";
  EXPECT_THAT(series_of(*rounds, "contact stiffness 0.5")->y, ElementsAre(near(3), near(1.1)));
}

TEST_F(CalibratePageOfResult, EveryReadingHasASectionAndEveryFigureItsWords) {
  EXPECT_TRUE(section_of(page, "hypothesis-1") && section_of(page, "hypothesis-2"));
  for (const Section& section : page.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) {
        EXPECT_GT(figure->caption.size(), 30u) << figure->name;
        EXPECT_GT(figure->alt.size(), 30u) << figure->name;
        EXPECT_THAT(figure->caption + figure->alt, Not(HasSubstr("nan"))) << figure->name;
      }
}

TEST_F(CalibratePageOfResult, WithoutAReadingItSaysSo) {
  result["hypotheses"] = json::array();
  EXPECT_THAT(calibrate_page(result).summary, HasSubstr("No hypothesis could be fitted"));
}

}  // namespace
}  // namespace percal
