// The page of a calibration against the made-up result of the small job.
#include "percal/calibrate/page/page.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "calibrate/small_job.hpp"
#include "page/page_words.hpp"
#include "percal/page/text.hpp"

namespace percal {
namespace {

using nlohmann::json;
using page::Detail;
using page::List;
using page::Tone;
using test::Block;
using test::Figure;
using test::figure_of;
using test::Page;
using test::Section;
using test::section_of;
using test::series_of;
using test::words_of;
using testing::AllOf;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

auto near(double value) { return DoubleNear(value, 1e-9); }

class CalibratePageOfResult : public calibrate_test::SmallJob {
 protected:
  CalibrationJob job = read_job();
  CalibrationResult found = calibrate_test::made_up_result(job);
  json result = calibration_to_json(job, found);
  Page page = calibrate_page(result);

  std::string words(const std::string& id) const {
    const Section* section = section_of(page, id);
    return section ? words_of(*section) : "no section " + id;
  }
  void make_again() {
    result = calibration_to_json(job, found);
    page = calibrate_page(result);
  }
};

TEST_F(CalibratePageOfResult, TheSummaryIsTheModulusWithItsInterval) {
  EXPECT_EQ(page.title, "Jelly");
  EXPECT_THAT(page.summary, HasSubstr("quasi-static E of soft 30 kPa (24 kPa to 39 kPa)"));
  EXPECT_THAT(page.summary, HasSubstr("90 %"));
}

TEST_F(CalibratePageOfResult, TheAnswerHasTheNumbersUnderEveryHypothesis) {
  EXPECT_THAT(words("asked"),
              HasSubstr("mu, mu_hard, alpha, strain from 6 shots (4 fitted) and 1 curve (synthetic: tension), under 2 "
                        "hypotheses."));
  EXPECT_THAT(
      words("answer"),
      AllOf(HasSubstr("E of soft | 1 | 30 kPa | 24 kPa to 39 kPa"),
            HasSubstr("E of soft | 2 | 30 kPa | 24 kPa to 39 kPa"), HasSubstr("mu of hard | 1 | 200 kPa | -"),
            HasSubstr("alpha | 1 | 6 | 5 to above 12"), HasSubstr("alpha | 2 | 5 | held"),
            HasSubstr("strain | 1 | 0.9 | 0.7 to 1.1"), HasSubstr("depths are off by | 1 | 10.0 % | 3 of 3 within"),
            HasSubstr("2: held"), HasSubstr("Not identifiable under 1: mu_hard."),
            HasSubstr("At a bound of the search under 1: alpha.")));
}

TEST_F(CalibratePageOfResult, WithOneHypothesisTheAnswerHasBothRatesAndNoColumnOfHypotheses) {
  found.hypotheses.resize(1);
  make_again();
  EXPECT_THAT(words("answer"),
              AllOf(HasSubstr("\nmu of soft | 100 kPa | 80 kPa to 130 kPa"),
                    HasSubstr("\nE of soft | 30 kPa | 24 kPa to 39 kPa"), HasSubstr("Not identifiable: mu_hard.")));
}

TEST_F(CalibratePageOfResult, TheAnswerSaysWhatToDoNextAndWhatItCost) {
  found.hypotheses[0].advice = {
      {"E of soft: a curve", 0.9}, {"E of soft: three more shots", 0.8}, {"mu of hard: a curve", 0.97}};
  make_again();
  EXPECT_THAT(
      words("next"),
      AllOf(HasSubstr("E of soft: three more shots would leave 80 % of its interval."),
            HasSubstr("mu of hard: no shot or curve that was looked at would make its interval 5 % narrower."),
            Not(HasSubstr("E of soft: a curve")), HasSubstr("Twice the runs would help."),
            HasSubstr("20 runs, 10 more from the store, 8.0 s of processor time, 9.0 s in all of a budget of 60 s")));
}

TEST_F(CalibratePageOfResult, TheAnswerFitsOnATerminalOf80Columns) {
  std::istringstream lines(page::as_text(page, {.columns = 80, .detail = Detail::answer}));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_LE(count, 40);
}

TEST_F(CalibratePageOfResult, ASentenceIsSaidOnce) {
  const auto times = [&](const std::string& sentence) {
    const std::string all = words_of(page);
    int count = 0;
    for (auto at = all.find(sentence); at != std::string::npos; at = all.find(sentence, at + 1)) ++count;
    return count;
  };
  found.hypotheses[1].findings.push_back("Only the second says so.");
  make_again();
  EXPECT_EQ(times("The strain and the modulus go together."), 1) << "of both hypotheses";
  EXPECT_EQ(times("Twice the runs would help."), 1);
  EXPECT_EQ(times("Dehn predicts better."), 1);
  EXPECT_THAT(words("findings"), HasSubstr("The strain and the modulus go together."));
  EXPECT_THAT(words("hypothesis-2"), HasSubstr("Only the second says so."));
}

TEST_F(CalibratePageOfResult, FindingsAreNotes) {
  for (const Block& block : section_of(page, "findings")->blocks) EXPECT_EQ(std::get<List>(block).tone, Tone::note);
}

TEST_F(CalibratePageOfResult, SaysEveryNumberWithItsInterval) {
  const std::string all = words_of(page);
  for (const char* what :
       {"mu | modulus | 10 kPa | 1 MPa | 100 kPa",
        "soft | 1 | 100 kPa (80 kPa to 130 kPa) | 33 kPa (20 kPa to 50 kPa) | 90 kPa",
        "soft | 1 | 30 kPa (24 kPa to 39 kPa) | 10 kPa (8 kPa to 13 kPa)",
        "mu | 100 kPa | 80 kPa to 130 kPa | 81 kPa to 120 kPa",
        "mu_hard | 200 kPa | below 20 kPa to above 2 MPa | 30 kPa to 1 MPa | not identifiable",
        "alpha | 6 | 5 to above 12 | 5 to 11 | at its bound", "1 of 20 bootstrap replicates did not converge",
        "deviance above the best | 0 | 2.5", "balls, fitted | 8.0 % | -2.0 % | 2 of 2 | 11.0 %",
        "80.0 % | E of soft: three more shots", "stopped because | 30 runs were made",
        "outcomes | 5 passed through, 25 stopped", "30 | 8.0 s | 1.1 %"})
    EXPECT_THAT(all, HasSubstr(what));
}

TEST_F(CalibratePageOfResult, HypothesesStandSideBySide) {
  EXPECT_THAT(words("hypotheses"),
              AllOf(HasSubstr("hypothesis | 1 | 2"), HasSubstr("mu means | true | mu/alpha"),
                    HasSubstr("a held erosion strain is | engineering | true"), HasSubstr("mu | 100 kPa | 90 kPa held"),
                    HasSubstr("mu_hard | 200 kPa | -"), HasSubstr("balls, fitted | 8.0 % | 8.0 %"),
                    HasSubstr("by hand, predicted | - | -")));
}

TEST_F(CalibratePageOfResult, ShotsStandBesideTheClosedForm) {
  EXPECT_THAT(words("hypothesis-1"),
              HasSubstr("steel 3 mm at 80 m/s into soft | at least 60 mm | 66 mm | 54 mm to 78 mm"));
  EXPECT_THAT(words("depths"),
              AllOf(HasSubstr("steel 3 mm at 40 m/s into soft | +10.0 % | +10.0 % | +10.0 %"),
                    HasSubstr("the fast one | 22 mm, predicted | 22 mm, predicted | 22 mm, predicted")));
}

TEST_F(CalibratePageOfResult, PredictionsStandBesideTheirGoalAndTheClosedForm) {
  EXPECT_THAT(words("predictions"),
              AllOf(HasSubstr("steel -> lead | 1 | 7.0 % | 3.1 % | 6.0 %, met"),
                    HasSubstr("leave one out: balls | 4 | - | 15.1 % | 12.5 %"), HasSubstr("s of soft | 300 kPa | -")));
  EXPECT_THAT(words("hypothesis-1"), HasSubstr("steel -> lead | 3 | 4.0 % | 6.0 % | +6.0 % | 1 of 1"));
  found.hypotheses[0].cross_validations[0].prediction.mean_absolute = 0.0701;
  make_again();
  EXPECT_THAT(words("predictions"), HasSubstr("7.0 %, missed"));
}

TEST_F(CalibratePageOfResult, SourcesOfErrorThatAreNextToNothingAreOneRow) {
  found.hypotheses[0].budgets[0].sources.push_back({"speed", 0.003, 0.0009});
  found.hypotheses[0].budgets[0].sources.push_back({"depth", 0.004, 0.0016});
  make_again();
  EXPECT_THAT(words("hypothesis-1"),
              AllOf(HasSubstr("rate factor | 36.0 % (6 %)"), HasSubstr("everything else | 0.2 % (0.5 %)"),
                    Not(HasSubstr("speed |")),
                    HasSubstr("E of soft: 30 kPa (24 kPa to 39 kPa, 90 %), standard deviation 10 %.")));
}

TEST_F(CalibratePageOfResult, AKeyThatIsMissingIsRefusedByName) {
  for (const char* key : {"level", "data", "dehn", "findings", "cost"}) {
    json without = result;
    without.erase(key);
    try {
      calibrate_page(without);
      ADD_FAILURE() << key;
    } catch (const page::MissingKey& missing) {
      EXPECT_EQ(missing.key, key);
    }
  }
  result["hypotheses"][0]["moduli"][0].erase("youngs_quasi_static_true");
  EXPECT_THROW(calibrate_page(result), page::MissingKey) << "it is not taken for one without a rate factor";
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
  const Figure* ridge = figure_of(page, "ridge_mu");
  ASSERT_TRUE(ridge);
  const auto *outline = series_of(*ridge, "free"), *published = series_of(*ridge, "somebody's");
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

TEST_F(CalibratePageOfResult, EachBallHasItsPointsALineAndABandOverItsSpeeds) {
  const Figure* speeds = figure_of(page, "speed_1_1");
  ASSERT_TRUE(speeds);
  const Series* steel = series_of(*speeds, "steel 3 mm");
  ASSERT_TRUE(steel);
  EXPECT_THAT(steel->x, ElementsAre(near(40), near(60)));
  std::vector<Mark> marks;
  for (const Series& one : speeds->chart.series)
    if (one.colour == steel->colour) marks.push_back(one.mark);
  EXPECT_THAT(marks, ElementsAre(Mark::band, Mark::line, Mark::points));
}

TEST_F(CalibratePageOfResult, ProfilesFreshRunsAndRoundsHaveFigures) {
  const Figure *profiles = figure_of(page, "profiles_1"), *fresh = figure_of(page, "fresh_1"),
               *rounds = figure_of(page, "error_vs_time");
  ASSERT_TRUE(profiles && fresh && rounds);
  EXPECT_THAT(series_of(*profiles, "mu")->x, ElementsAre(near(0.8), near(1)));
  EXPECT_THAT(profiles->caption, HasSubstr("Too flat to be known: mu_hard"));
  EXPECT_THAT(series_of(*fresh, "fresh runs")->y, ElementsAre(0.8)) << "the other one passed through";
  EXPECT_THAT(series_of(*rounds, "the emulator's")->y, ElementsAre(near(3), near(1.1)));
}

TEST_F(CalibratePageOfResult, EveryHypothesisHasASectionAndEveryFigureItsWords) {
  EXPECT_TRUE(section_of(page, "hypothesis-1") && section_of(page, "hypothesis-2"));
  for (const Section& section : page.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) {
        EXPECT_GT(figure->caption.size(), 30u) << figure->name;
        EXPECT_GT(figure->alt.size(), 30u) << figure->name;
        EXPECT_THAT(figure->caption + figure->alt, Not(HasSubstr("nan"))) << figure->name;
      }
}

TEST_F(CalibratePageOfResult, WithoutAHypothesisItSaysSo) {
  result["hypotheses"] = json::array();
  EXPECT_THAT(calibrate_page(result).summary, HasSubstr("No hypothesis could be fitted"));
}

}  // namespace
}  // namespace percal
