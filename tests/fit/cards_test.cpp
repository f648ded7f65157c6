#include "percal/fit/page/cards.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace percal {
namespace {

using ::testing::HasSubstr;

CurveFit two_terms() {
  CurveFit fit;
  fit.options.model = Model::ogden2;
  fit.points = 12;
  CurveMinimum best;
  best.solid.terms = {{60e6, 8}, {3.75e6, -2}};
  best.r2 = 0.997;
  fit.minima = {best};
  return fit;
}

Uncertainty about_two_terms() {
  Uncertainty uncertainty;
  uncertainty.options.level = 0.9;
  MinimumUncertainty best;
  best.small_strain_modulus = Interval{60e6, 67e6};
  best.parameters = {{.name = "mu_1", .unit = "Pa", .interval = {55e6, 1e99, false, true}, .bootstrap = {}},
                     {.name = "alpha_2", .unit = "", .interval = {-3, INFINITY}, .bootstrap = {}}};
  uncertainty.minima = {best};
  return uncertainty;
}

TEST(FitCards, HaveTheTermsAndNeitherDensityNorBulkModulus) {
  const auto cards = fit_cards({}, two_terms(), {}, {});
  ASSERT_EQ(cards.size(), 1u);
  ASSERT_EQ(cards[0].terms.size(), 2u);
  EXPECT_EQ(cards[0].terms[1].mu, 3.75e6);
  EXPECT_TRUE(std::isnan(cards[0].density));
  EXPECT_TRUE(std::isnan(cards[0].bulk_modulus));
  EXPECT_FALSE(cards[0].intervals);
  EXPECT_THAT(cards[0].fit_error, HasSubstr("R^2 0.997 in stress, residual relative, 12 points"));
  EXPECT_EQ(cards[0].comments, std::vector<std::string>{"fitted by percal: model ogden2"});
}

TEST(FitCards, NameTheIntervalsAsCardsDoAndLeaveOpenEndsOut) {
  const auto cards = fit_cards({}, two_terms(), about_two_terms(), {});
  ASSERT_TRUE(cards.at(0).intervals);
  const CardIntervals& intervals = *cards[0].intervals;
  EXPECT_EQ(intervals.level, 0.9);
  ASSERT_EQ(intervals.of.size(), 3u);
  EXPECT_EQ(intervals.of[0].parameter, "mu_true_Pa");
  EXPECT_EQ(intervals.of[1].parameter, "mu_true_Pa_1");
  EXPECT_EQ(intervals.of[1].low, 55e6);
  EXPECT_FALSE(intervals.of[1].high);
  EXPECT_EQ(intervals.of[2].parameter, "alpha_2");
  EXPECT_FALSE(intervals.of[2].high);
}

// A file has many materials: its rows were chosen by --where.
TEST(FitCards, KeepWhichMaterialTheyAreOf) {
  const auto cards = fit_cards({}, two_terms(), {}, {"material=Ecoflex 00-30", "stretch<3"});
  EXPECT_EQ(cards.at(0).name, "Ecoflex 00-30");
  EXPECT_EQ(cards[0].comments.back(), "rows where material=Ecoflex 00-30, stretch<3");
  EXPECT_EQ(fit_cards({}, two_terms(), {}, {"stretch<3"}).at(0).name, "fit");
}

TEST(FitCards, AreNoneWithoutAMinimum) { EXPECT_TRUE(fit_cards({}, {}, {}, {}).empty()); }

TEST(FitCards, NameTheFilesThatCanBeRead) {
  CurveData data;
  const std::string file = std::string(PERCAL_DATA) + "/public/treloar1944_rubber_primary.csv";
  for (const std::string& one : {file, file, std::string("nowhere.csv")}) {
    CurveSource source;
    source.file = one;
    data.sources.push_back(source);
  }
  const auto cards = fit_cards(data, two_terms(), {}, {});
  ASSERT_EQ(cards.at(0).data.size(), 1u);
  EXPECT_EQ(cards[0].data[0].file, "treloar1944_rubber_primary.csv");
  EXPECT_EQ(cards[0].data[0].sha256.size(), 64u);
}

}  // namespace
}  // namespace percal
