// The tables and plots of a calibration, from a result made by hand.
#include "percal/calibrate/result_text.hpp"

#include <gmock/gmock.h>

#include "calibrate/small_job.hpp"
#include "percal/calibrate/plots.hpp"

namespace percal {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

using Row = std::vector<std::string>;

class CalibrationText : public calibrate_test::SmallJob {
 protected:
  CalibrationJob job = read_job();
  CalibrationResult result = calibrate_test::made_up_result(job);

  std::vector<TextTable> tables(ShotTables shots = ShotTables::where_few) const {
    return hypothesis_tables(job, result, result.hypotheses[0], shots);
  }
  // The row that begins so, of the table that is called so.
  Row row(const std::vector<TextTable>& all, const std::string& title, const std::string& first) const {
    for (const TextTable& table : all)
      if (table.title.starts_with(title))
        for (const Row& row : table.rows)
          if (!row.empty() && row[0] == first) return row;
    return {};
  }
};

TEST_F(CalibrationText, ParametersHaveValueIntervalsAndVerdict) {
  EXPECT_THAT(row(tables(), "parameters", "mu"),
              ElementsAre("mu", "100 kPa", "80 kPa to 130 kPa", "81 kPa to 120 kPa", ""));
  EXPECT_THAT(row(tables(), "parameters", "mu_hard"),
              ElementsAre("mu_hard", "200 kPa", "below 20 kPa to above 2 MPa", "30 kPa to 1 MPa", "not identifiable"));
  EXPECT_THAT(row(tables(), "parameters", "alpha"),
              ElementsAre("alpha", "6", "5 to above 12", "5 to 11", "at its bound"));
}

TEST_F(CalibrationText, ModuliStandInBothConventions) {
  EXPECT_THAT(row(tables(), "moduli", "soft"),
              ElementsAre("soft", "100 kPa", "80 kPa to 130 kPa", "33 kPa", "20 kPa to 50 kPa", "90 kPa", "30 kPa",
                          "24 kPa to 39 kPa", "10 kPa"));
}

TEST_F(CalibrationText, PredictionsStandBesideTheirGoalAndTheClosedForm) {
  EXPECT_THAT(row(tables(), "predicted", "steel -> lead"),
              ElementsAre("steel -> lead", "3", "4.00 %", "1", "6.00 %", "+6.00 %", "7.00 %, met", "3.10 %", "1 of 1"));
  EXPECT_THAT(row(tables(), "predicted", "leave one out: balls"),
              ElementsAre("leave one out: balls", "-", "-", "4", "12.50 %", "-1.00 %", "-", "15.10 %", "3 of 4"));
}

TEST_F(CalibrationText, AMissedGoalIsSaid) {
  result.hypotheses[0].cross_validations[0].prediction.mean_absolute = 0.0701;
  EXPECT_EQ(row(tables(), "predicted", "steel -> lead").at(6), "7.00 %, missed");
}

TEST_F(CalibrationText, SetsStandBesideTheClosedForm) {
  EXPECT_THAT(row(tables(), "depths by set", "balls, fitted"),
              ElementsAre("balls, fitted", "2", "8.00 %", "-2.00 %", "2 of 2", "11.00 %"));
}

TEST_F(CalibrationText, ShotsAreShownWhereTheyAreFewOrAskedFor) {
  const std::string censored = "steel 3 mm at 80 m/s into soft";
  EXPECT_EQ(row(tables(), "shots", censored).at(1), "at least 60 mm");
  EXPECT_EQ(row(tables(), "shots", censored).at(3), "-");
  while (job.shots.size() <= few_shots) job.shots.push_back(job.shots.front());
  EXPECT_TRUE(row(tables(), "shots", censored).empty());
  EXPECT_FALSE(row(tables(ShotTables::all), "shots", censored).empty());
}

TEST_F(CalibrationText, SaysWhereTheErrorComesFrom) {
  EXPECT_THAT(row(tables(), "where the error of E of soft", "rate factor"), ElementsAre("rate factor", "6 %", "36 %"));
}

TEST_F(CalibrationText, SourcesThatAreNextToNothingAreOneRow) {
  result.hypotheses[0].budgets[0].sources.push_back({"speed", 0.003, 0.0009});
  result.hypotheses[0].budgets[0].sources.push_back({"depth", 0.004, 0.0016});
  EXPECT_TRUE(row(tables(), "where the error of E of soft", "speed").empty());
  EXPECT_THAT(row(tables(), "where the error of E of soft", "everything else"),
              ElementsAre("everything else", "0.5 %", "0.25 %"));
}

TEST_F(CalibrationText, FindingsAreNotes) {
  EXPECT_THAT(tables().back().notes, Contains("note: The strain and the modulus go together."));
}

TEST_F(CalibrationText, HypothesesStandSideBySide) {
  const std::vector<TextTable> all{hypotheses_side_by_side(job, result)};
  EXPECT_THAT(all[0].rows.at(0), ElementsAre("hypothesis", "1", "2"));
  EXPECT_THAT(all[0].notes, Contains("2: held"));
  EXPECT_THAT(row(all, "hypotheses", "mu means"), ElementsAre("mu means", "true", "mu/alpha"));
  EXPECT_THAT(row(all, "hypotheses", "contact stiffness"), ElementsAre("contact stiffness", "0.5", "0.156"));
  EXPECT_THAT(row(all, "hypotheses", "mu"), ElementsAre("mu", "100 kPa", "90 kPa held"));
  EXPECT_THAT(row(all, "hypotheses", "E of soft"), ElementsAre("E of soft", "30 kPa", "30 kPa"));
  EXPECT_THAT(row(all, "hypotheses", "balls, fitted"), ElementsAre("balls, fitted", "8.00 %", "8.00 %"));
  EXPECT_THAT(row(all, "hypotheses", "by hand, predicted"), ElementsAre("by hand, predicted", "-", "-"));
}

TEST_F(CalibrationText, EmulatorsSayWhyTheyStoppedAndHowTheirErrorFell) {
  const auto all = emulator_tables(result);
  EXPECT_EQ(row(all, "emulators", "contact stiffness 0.5").back(), "30 runs were made");
  EXPECT_THAT(row(all, "error against time", "30"), ElementsAre("30", "8.0 s", "1.10 %"));
  EXPECT_THAT(all[0].notes, Contains(HasSubstr("25 stopped")));
}

TEST_F(CalibrationText, CostSaysTheBudgetAndWhatMoreTimeWouldBuy) {
  EXPECT_THAT(cost_sentences(result.cost),
              ElementsAre(HasSubstr("9.0 s in all of a budget of 60 s"), "Twice the runs would help."));
}

TEST_F(CalibrationText, PlotsCarryTheirPointsAsCsv) {
  const auto plots = calibration_plots(job, result);
  ASSERT_EQ(plots.size(), 4u);
  EXPECT_EQ(plots[0].name, "ridge_mu");
  EXPECT_THAT(plots[0].csv, HasSubstr("\"free\",level set,1,0.6,140000\n"));
  EXPECT_THAT(plots[0].csv, HasSubstr("\"somebody's\",published,0,0.7,120000\n"));
  EXPECT_THAT(plots[0].script, HasSubstr("somebody''s"));
  EXPECT_EQ(plots[1].name, "depths_1");
  EXPECT_THAT(plots[1].csv, HasSubstr("\"the fast one\",\"by hand\",0.02,yes,0.022,0.018,0.026,no\n"));
  EXPECT_EQ(plots[2].name, "depths_2");
  EXPECT_EQ(plots[3].name, "error_vs_time");
  EXPECT_THAT(plots[3].csv, HasSubstr("\"contact stiffness 0.5\",30,8,0.011,0.05\n"));
}

}  // namespace
}  // namespace percal
