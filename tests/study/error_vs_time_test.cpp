// The analysis of ladders made by hand: depths with a known limit, order and noise.
#include "percal/study/error_vs_time.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "percal/study/page/error_vs_time.hpp"
#include "study/made_ladder.hpp"

namespace percal {
namespace {

using study_test::ladder_of;
using study_test::local_ladder_of;
using study_test::pass_through;
using study_test::rung_at;
using testing::HasSubstr;

TEST(ErrorVsTime, FindsTheLimitAndTheErrorOfEveryMesh) {
  const Ladder ladder = ladder_of(1, 1, 1e-4);
  const ErrorVsTime study = error_vs_time(ladder);
  ASSERT_TRUE(study.is_fitted());
  EXPECT_NEAR(study.limit.value, 27, 0.01);
  EXPECT_NEAR(study.convergence.observed_order, 1, 1e-3);
  EXPECT_NEAR(study.model.noise.on(7), 1e-4, 1e-12);
  ASSERT_EQ(study.errors.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const RungError& error = study.errors[i];
    const double exact = 1.0 / ladder.meshes[i].elements_per_radius;
    EXPECT_NEAR(error.signed_error.value, exact, 1e-3);
    EXPECT_NEAR(error.discretisation, exact, 1e-3);
    EXPECT_LT(error.signed_error.low, exact);
    EXPECT_GT(error.signed_error.high, exact);
  }
}

TEST(ErrorVsTime, TheNoiseOfAMeanFallsWithTheRootOfItsRuns) {
  const ErrorVsTime study = error_vs_time(ladder_of(0, 1, 0.02));
  for (const RungError& error : study.errors)
    for (std::size_t c = 0; c < replicate_counts.size(); ++c)
      EXPECT_NEAR(error.combined[c].value, 0.02 / std::sqrt(replicate_counts[c]), 1e-9);
}

TEST(ErrorVsTime, ALuckyCrossingOfTheLimitIsNoSmallError) {
  Ladder ladder = ladder_of(1, 1, 1e-4);
  ladder.meshes[1].penetration.depth = 27;  // while the finer meshes are up to 10 % off
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_GT(study.errors[1].discretisation, 0.08);
  for (std::size_t i = 1; i < 6; ++i)
    EXPECT_LE(study.errors[i].discretisation, study.errors[i - 1].discretisation) << "largest of this and finer meshes";
}

TEST(ErrorVsTime, CoarseMeshesOffTheCurveAreLeftOutOfTheFitAndSaidSo) {
  Ladder ladder = ladder_of(-1, 1, 1e-3);
  ladder.meshes[0].penetration.depth = 26;
  ladder.meshes[1].penetration.depth = 28;  // the curve goes on from 24.3 to 26
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_EQ(study.first_fitted, 2u);
  EXPECT_NEAR(study.limit.value, 27, 0.1);
  EXPECT_FALSE(study.errors[1].uncertainty.has_value());
  EXPECT_TRUE(study.errors[2].uncertainty.has_value());
  EXPECT_THAT(study.findings, testing::Contains(HasSubstr("the fit is over 10 elements per radius and more")));
}

TEST(ErrorVsTime, DepthsThatConvergeToNothingGiveNoError) {
  Ladder ladder = ladder_of(1, 1, 1e-4);
  for (Rung& rung : ladder.meshes) rung.penetration.depth = 10 * std::pow(rung.elements_per_radius, -0.5) - 0.5;
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_FALSE(study.is_fitted());
  EXPECT_TRUE(study.errors.empty());
  EXPECT_THAT(study.findings, testing::Contains(HasSubstr("converge to none above zero")));
}

TEST(ErrorVsTime, WithoutFourMeshesThatStoppedThereIsAnAccountAndNoNumber) {
  Ladder ladder = ladder_of(1, 1, 0.01);
  pass_through(ladder.meshes[2]);  // 14, 20 and 28 remain
  pass_through(ladder.half_steps[0]);
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_FALSE(study.is_fitted());
  EXPECT_TRUE(study.errors.empty());
  EXPECT_FALSE(study.half_step[0].share.has_value());
  EXPECT_THAT(study.findings,
              testing::Contains(HasSubstr("10 elements per radius: passed through (5 runs): no depth")));
  EXPECT_THAT(study.findings, testing::Contains(HasSubstr("an extrapolation needs 4")));
  const AdvisedSetting advice = advise(ladder, study, 0.02);
  EXPECT_FALSE(advice.is_found);
  EXPECT_THAT(advice.why_not, HasSubstr("no depth to extrapolate to"));
  const auto json = error_vs_time_to_json({}, ladder, study, {advice}, {});
  EXPECT_EQ(json["convergence"]["outcome"], "too few grids");
  EXPECT_TRUE(json["convergence"]["extrapolated_depth_m"].is_null());
  EXPECT_TRUE(json["meshes"][2]["depth_m"].is_null());
  EXPECT_TRUE(json["meshes"][5]["error"].is_null());
  EXPECT_TRUE(json["advice"][0]["elements_per_radius"].is_null());
}

TEST(ErrorVsTime, MeshesCoarserThanOneThatDidNotStopAreNotUsed) {
  Ladder ladder = ladder_of(1, 1, 1e-4);
  pass_through(ladder.meshes[1]);
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_EQ(study.first_used, 2u);
  EXPECT_EQ(study.errors.size(), 4u);
  EXPECT_NEAR(study.limit.value, 27, 0.01);
}

TEST(ErrorVsTime, OfALocalRuleSaysTheDistanceFromTheFinestMeshAndNoError) {
  const Ladder ladder = local_ladder_of(1, 1, 0.02);  // a fit would find 27 and errors of 3.6 to 20 %
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_TRUE(study.is_answered());
  EXPECT_FALSE(study.is_fitted());
  EXPECT_TRUE(study.errors.empty());
  EXPECT_THAT(study.findings, testing::ElementsAre(HasSubstr("no limit in the element's size")));
  ASSERT_EQ(study.from_finest.size(), 6u);
  const ErrorBand& coarsest = study.from_finest.front();
  EXPECT_NEAR(coarsest.value, (1 + 1 / 5.0) / (1 + 1 / 28.0) - 1, 1e-12);
  const double both = std::hypot(10 / 5.0, 10 / 28.0) * 0.02 / std::sqrt(5.0);
  EXPECT_NEAR(coarsest.high - coarsest.value, 1.96 * both * (1 + coarsest.value), 1e-9);
  EXPECT_EQ(study.from_finest.back().high, 0);
  const auto json = error_vs_time_to_json({}, ladder, study, {advise(ladder, study, 0.02)}, {});
  EXPECT_EQ(json["convergence"]["outcome"], "no limit");
  EXPECT_NEAR(json["convergence"]["spread_of_a_run"].get<double>(), 0.02, 1e-12);
  EXPECT_TRUE(json["convergence"]["extrapolated_depth_m"].is_null());
  EXPECT_TRUE(json["meshes"][5]["error"].is_null());
  EXPECT_TRUE(json["advice"][0]["discretisation_error"].is_null());
}

TEST(ErrorVsTime, TheNoiseOfErosionIsPooledInProportionToTheElements) {
  const ErrorVsTime study = error_vs_time(local_ladder_of(0.1, 1, 0.03));
  EXPECT_NEAR(study.model.noise.on(10), 0.03, 1e-12);
  EXPECT_NEAR(study.model.noise.on(20), 0.015, 1e-12);
}

TEST(ErrorVsTime, OverALengthTheFitIsAParabolaWhateverTheNoiseLooksLike) {
  Ladder ladder = ladder_of(0, 1, 0);
  ladder.meshes.clear();
  for (const auto& [mesh, depth] :
       {std::pair{7.0, 20.25}, {10, 20.27}, {14, 20.15}, {19, 20.24}, {27, 20.46}})  // gold, a length of 0.43 radii
    ladder.meshes.push_back(rung_at(mesh, depth, 0.45 / mesh * depth));
  const ErrorVsTime free = error_vs_time(ladder);
  EXPECT_GT(free.limit.value, 20.46 * 1.04) << "a h + b h^2 goes on where the last two meshes point";
  ladder.refinement = Refinement::second_order;
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_EQ(study.convergence.fit.form, ErrorForm::second_order);
  EXPECT_NEAR(study.limit.value, 20.46, 0.3);
  EXPECT_THAT(study.findings, testing::Not(testing::Contains(HasSubstr("observed order"))));
}

TEST(ErrorVsTime, OfALocalRuleNeedsAFinestMeshThatStopped) {
  Ladder ladder = local_ladder_of(1, 1, 0.02);
  pass_through(ladder.meshes.back());
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_FALSE(study.is_answered());
  EXPECT_THAT(advise(ladder, study, 0.02).why_not, HasSubstr("the finest mesh"));
}

TEST(ErrorVsTime, AChangeIsSignificantBeyondTwoStandardErrors) {
  Ladder ladder = ladder_of(0, 1, 0.01);
  ladder.double_precision.penetration.depth = 27 * 1.01;  // the difference's standard error is 0.63 %
  EXPECT_FALSE(error_vs_time(ladder).double_precision.is_significant());
  ladder.double_precision.penetration.depth = 27 * 1.02;
  const ErrorVsTime study = error_vs_time(ladder);
  EXPECT_TRUE(study.double_precision.is_significant());
  EXPECT_NEAR(*study.double_precision.standard_error, 0.01 * std::sqrt(2.0 / 5), 1e-9);
  EXPECT_THAT(study.findings, testing::Contains(HasSubstr("double precision changes the depth by +2.0 %")));
}

TEST(Advice, IsTheCheapestSettingOfTheLadder) {
  const Ladder ladder = ladder_of(0.2, 1, 0.02);  // mesh errors 4, 2.9, 2, 1.4, 1, 0.7 %
  const AdvisedSetting five = advise(ladder, error_vs_time(ladder), 0.05);
  EXPECT_TRUE(five.is_found);
  EXPECT_FALSE(five.cost_is_estimated);
  EXPECT_EQ(five.elements_per_radius, 5);  // sqrt(0.05^2 - 0.04^2) = 0.03: one run will do
  EXPECT_EQ(five.replicates, 1);
  EXPECT_NEAR(five.cpu_seconds, 0.125, 1e-9);
  const AdvisedSetting two = advise(ladder, error_vs_time(ladder), 0.02);
  // 14: 0.02^2 - 0.0143^2 = 0.014^2, three runs of 2.7 s; 20: two runs of 8 s; 10 has no room for noise.
  EXPECT_EQ(two.elements_per_radius, 14);
  EXPECT_EQ(two.replicates, 3);
  EXPECT_LE(two.error, 0.02);
  EXPECT_NEAR(two.error, std::hypot(*two.discretisation_error, two.noise_error), 1e-12);
  EXPECT_LE(*two.cpu_seconds_low, two.cpu_seconds);
  EXPECT_GE(two.cpu_seconds_high.value_or(HUGE_VAL), two.cpu_seconds);
}

TEST(Advice, BeyondTheLadderIsMarkedAsAnEstimate) {
  const Ladder ladder = ladder_of(0.35, 1, 1e-3);  // the finest is 1.25 % off
  const AdvisedSetting advice = advise(ladder, error_vs_time(ladder), 0.01);
  ASSERT_TRUE(advice.is_found);
  EXPECT_TRUE(advice.cost_is_estimated);
  EXPECT_NEAR(advice.elements_per_radius, 35, 3);  // 0.35/n = 1 %
  EXPECT_NEAR(advice.cpu_seconds / (1e-3 * std::pow(advice.elements_per_radius, 3)), advice.replicates, 0.05);
  EXPECT_TRUE(advice_to_json(advice)["cost_estimated"]);
}

TEST(Advice, TrustsTheFitToOneAndAHalfTimesTheFinestMesh) {
  const Ladder ladder = ladder_of(0.5, 1, 1e-3);  // 51 elements per radius would have 1 %
  const AdvisedSetting advice = advise(ladder, error_vs_time(ladder), 0.01);
  EXPECT_FALSE(advice.is_found);
  EXPECT_THAT(advice.why_not, HasSubstr("up to 42 elements per radius"));
}

TEST(Advice, OfALocalRuleIsTheRunsOnTheScenesOwnMesh) {
  Ladder ladder = local_ladder_of(1, 1, 0.03);
  const AdvisedSetting on_rung = advise(ladder, error_vs_time(ladder), 0.02);
  ASSERT_TRUE(on_rung.is_found);
  EXPECT_EQ(on_rung.elements_per_radius, 10);
  EXPECT_EQ(on_rung.replicates, 3);  // (3/2)^2
  EXPECT_FALSE(on_rung.discretisation_error.has_value());
  EXPECT_NEAR(on_rung.error, 0.03 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(on_rung.cpu_seconds, 3, 1e-9);
  EXPECT_FALSE(on_rung.cost_is_estimated);
  ladder.scene_mesh = 12;
  const AdvisedSetting between = advise(ladder, error_vs_time(ladder), 0.02);
  EXPECT_EQ(between.elements_per_radius, 12);
  EXPECT_EQ(between.replicates, 2) << "a run scatters by 2.5 % there";
  EXPECT_TRUE(between.cost_is_estimated);
  EXPECT_NEAR(between.cpu_seconds, 2 * 1.728, 1e-6);
  EXPECT_THAT(advise(ladder, error_vs_time(ladder), 0.001).why_not, HasSubstr("a run scatters by 2.5 %"));
}

TEST(Advice, ThereIsNoneWhereDepthsScatterFromMeshToMesh) {
  Ladder ladder = ladder_of(0, 1, 1e-3);
  for (std::size_t i = 0; i < 6; ++i) ladder.meshes[i].penetration.depth = i % 2 ? 26.0 : 28.0;
  const AdvisedSetting advice = advise(ladder, error_vs_time(ladder), 0.01);
  EXPECT_FALSE(advice.is_found);
  EXPECT_THAT(advice.why_not, HasSubstr("scatter from mesh to mesh"));
}

TEST(ErrorCsv, HasALineForEveryRungAndAllOfTheSameLength) {
  Ladder ladder = ladder_of(1, 1, 0.01);
  pass_through(ladder.meshes[0]);
  std::istringstream lines(error_vs_time_csv(study_test::result_of(ladder)));
  int rows = -1;
  for (std::string line; std::getline(lines, line); ++rows) EXPECT_EQ(std::ranges::count(line, ','), 31) << line;
  EXPECT_EQ(rows, 9);
}

TEST(AdviceWithoutALadder, AsksForTheRunsThatScatterNeedsBesideWhatIsKnown) {
  EXPECT_EQ(advise(10, 0.04, 0.02).replicates, 4);
  EXPECT_NEAR(advise(10, 0.04, 0.02).error, 0.02, 1e-15);
  const AdvisedSetting beside = advise(10, 0.04, 0.01, 0.02);
  EXPECT_EQ(beside.replicates, 12) << "1/0.01^2 - 1/0.02^2 = 12/0.04^2";
  EXPECT_NEAR(beside.error, 0.01, 1e-15);
  EXPECT_EQ(advise(10, 0.04, 0.03, 0.02).replicates, 1) << "one verifies what is known well enough";
  EXPECT_LT(advise(10, 0.04, 0.03, 0.02).error, 0.02);
}

}  // namespace
}  // namespace percal
