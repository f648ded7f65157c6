// Where spheres rest in the end: read, fitted, predicted, and told by the solver's runs.
#include <gmock/gmock.h>

#include "calibrate/beside_law.hpp"
#include "calibrate/law_checks.hpp"
#include "calibrate/shots_of_the_solver.hpp"
#include "percal/base/error.hpp"
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/math/statistics.hpp"
#include "percal/predict/predictor.hpp"
#include "support/ball_job.hpp"
#include "support/program.hpp"
#include "support/replaced.hpp"

// A name of its own: folders are compiled as units.
namespace percal::final_depth_tests {
namespace {

using test::true_gel;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double element = 0.1, shot_scatter = 0.06;

class FinalDepthJob : public test::Program {
 protected:
  std::string job_of(const std::string& rows, const std::string& keys = "") const {
    write("shots.csv", "speed_m_s,depth_mm,final_mm,outcome,left_m_s\n" + rows);
    return write("job.toml", test::ball_job() + R"(depth_column = "depth_mm"
final_depth_column = "final_mm"
outcome_column = "outcome"
speed_left_column = "left_m_s"
)" + keys);
  }
  CalibrationJob read(const std::string& rows, const std::string& keys = "") const {
    return read_calibration_job(job_of(rows, keys));
  }
  std::string refusal(const std::string& rows, const std::string& keys = "") const {
    try {
      read(rows, keys);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(FinalDepthJob, ADeepestDepthCountsBeforeIt) {
  const CalibrationJob job = read("40,18,16,,\n44,,17,stopped,\n60,,,passed,\n48,,19,,\n",
                                  "depth_error = \"10 %\"\nat_least_where = [\"speed_m_s=48\"]\n");
  std::vector<std::string> seen;
  for (const MeasuredShot& shot : job.shots) seen.push_back(seen_words(shot));
  EXPECT_THAT(seen, ElementsAre("depth", "final depth", "passed", "final depth at least"));
  EXPECT_EQ(job.groups.size(), 1u);
  EXPECT_DOUBLE_EQ(job.shots[0].depth, 0.018);
  EXPECT_DOUBLE_EQ(job.shots[1].depth, 0.017);
  EXPECT_DOUBLE_EQ(job.shots[1].depth_error, 0.0017);
  EXPECT_EQ(job.shots[3].datum, ShotDatum::at_least);
}

TEST_F(FinalDepthJob, RefusesWhatContradictsItself) {
  EXPECT_THAT(refusal("40,,16,,\n40,15,16,,\n"),
              testing::AllOf(HasSubstr("shots.csv:3"), HasSubstr("a final depth of 16 mm"), HasSubstr("15 mm")));
  EXPECT_THAT(refusal("60,,16,passed,\n"), HasSubstr("a final depth of a shot that passed"));
  EXPECT_THAT(refusal("60,,16,,20\n"), HasSubstr("a final depth of a shot that passed"));
  EXPECT_THAT(refusal("60,,-16,,\n"), testing::AllOf(HasSubstr("shots.csv:2"), HasSubstr("final_mm")));
  EXPECT_THAT(refusal("60,,26,,\n"), HasSubstr("a layer as deep as its shots"));
  EXPECT_THAT(refusal("60,,,,\n"), HasSubstr("a final depth"));
  job_of("60,,26,,\n");
  const test::Ended ended = run({"calibrate", "job.toml", "--check"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("layer_depth"));
}

// --- what it tells --------------------------------------------------------------------------------------------------

Emulators emulators_of_final_depths() {
  return test::with_number(test::emulator_of_the_smooth_law(), RunNumber::final_depth, test::final_law, 0.002);
}

// Steel and titanium balls of which every other one was dug out, the others were seen at their deepest.
CalibrationJob dug_out(const std::vector<double>& natural, int shots, unsigned seed) {
  CalibrationJob job = test::gel_job_at_speeds(shots, "final depths", element);
  Draws draws(seed);
  for (int k = 0; k < shots; ++k) {
    MeasuredShot& shot = job.shots[k];
    const SphereInputs at = test::inputs_at(job, shot, natural);
    double log_depth = test::smooth_law(at) + shot_scatter * draws.normal();
    if (k % 4 < 2) {
      shot.number = RunNumber::final_depth;
      shot.group = 1;
      log_depth += test::final_law(at);
    }
    shot.depth = shot.radius * std::exp(log_depth);
  }
  return job;
}

TEST(FinalDepth, IsTheDeepestTimesWhatItsEmulatorHasLearnt) {
  const CalibrationJob job = dug_out(true_gel, 8, 1);
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulators_of_final_depths(), element);
  Eigen::VectorXd at(3);
  for (int k = 0; k < 3; ++k) at[k] = job.parameters[k].free.searched(true_gel[k]);
  const ModelAnswer answer = model.log_depths(at, job.shots, Want::values_and_covariance);
  CalibrationJob deepest = job;
  for (MeasuredShot& shot : deepest.shots) shot.number = RunNumber::depth;
  const ModelAnswer of_deepest = model.log_depths(at, deepest.shots, Want::values_and_covariance);
  for (int k = 0; k < 8; ++k) {
    const bool is_final = job.shots[k].number == RunNumber::final_depth;
    const double share = is_final ? test::final_law(test::inputs_at(job, job.shots[k], true_gel)) : 0;
    EXPECT_NEAR(answer.value[k] - of_deepest.value[k], share, 0.003) << k;
    const double besides = answer.covariance(k, k) - of_deepest.covariance(k, k);
    EXPECT_EQ(besides > 0, is_final) << k;
  }
  test::expect_derivatives([&](const Eigen::VectorXd& x) { return model.log_depths(x, job.shots, Want::values); }, at);
  CalibrationJob faster = job;
  for (MeasuredShot& shot : faster.shots) shot.speed *= 1 + 1e-5;
  const Eigen::VectorXd by_speed = (model.log_depths(at, faster.shots, Want::values).value - answer.value) / 1e-5;
  EXPECT_LT((model.speed_exponents(at, job.shots) - by_speed).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(FinalDepth, SaysWhetherALayerIsPassedByTheDeepest) {
  CalibrationJob job = dug_out(true_gel, 12, 1);
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulators_of_final_depths(), element);
  const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
  job.shots[0].layer_depth = 1.02 * job.shots[0].depth;
  const ShotDepth final = shot_depths(job, model, fit, {0})[0];
  EXPECT_GT(*final.deepest, 1.1 * final.depth);
  EXPECT_GT(final.passes, 0.9);
  EXPECT_FALSE(shot_depths(job, model, fit, {2})[0].deepest);
}

// The closed form has no final depths: what it is told of them are bounds.
TEST(FinalDepth, BoundsTheClosedForm) {
  CalibrationJob job = dug_out(true_gel, 12, 1);
  const double with = fit_dehn(job).minimum.searched[1];
  for (MeasuredShot& shot : job.shots)
    if (shot.number == RunNumber::final_depth) shot.number = RunNumber::depth;
  EXPECT_GT(fit_dehn(job).minimum.searched[1], with + 0.1) << "taken for deepest depths they make it harder";
}

TEST(FinalDepth, IsKeptWrittenReadAndPredicted) {
  const Emulators emulators = emulators_of_final_depths();
  const CalibrationJob job = dug_out(true_gel, 12, 3);
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulators, element);
  const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
  auto [json, read] = test::kept_and_read(job, emulators, model, fit);
  const SphereShot shot = job.shots[0];
  const DepthPrediction predicted = Predictor(read, 0, 0, 0.95).depths(std::span(&shot, 1)).front();
  const NumberPrediction& final = predicted.beside.at(RunNumber::final_depth);
  const ShotDepth of_fit = shot_depths(job, model, fit, {0})[0];
  EXPECT_NEAR(final.value / of_fit.depth, 1, 1e-6);
  EXPECT_NEAR(std::log(final.shot.high / final.shot.low) / std::log(of_fit.high / of_fit.low), 1, 0.4);
  EXPECT_NEAR(final.value / predicted.depth, std::exp(test::final_law(test::inputs_at(job, job.shots[0], true_gel))),
              0.03);
  json["shot_model"]["beside"]["final_depth"]["runs"][0].erase(0);
  EXPECT_THROW(shot_model_of(json, "f"), page::MissingKey);
}

struct DugOut {
  int shots;
  bool one_scatter;  // of both kinds
};
class FinalDepthCoverage : public testing::TestWithParam<DugOut> {};

// Of 100 truths, half of the balls dug out and half seen at their deepest, one of each bounded and one only predicted: the intervals of
// the modulus, and of single shots.
TEST_P(FinalDepthCoverage, IntervalsHoldTheTruth) {
  const Emulators emulators = emulators_of_final_depths();
  const auto held = test::held_of_100_moduli(emulators, element, {1, 3}, [](const auto& natural, unsigned seed) {
    CalibrationJob job = dug_out(natural, GetParam().shots, seed);
    if (GetParam().one_scatter)
      for (MeasuredShot& shot : job.shots) shot.group = 0;
    for (const int k : {4, 6}) {
      MeasuredShot& shot = job.shots[k];  // about as deep as a cut that was made beforehand
      const SphereInputs at = test::inputs_at(job, shot, true_gel);
      const double share = shot.number == RunNumber::final_depth ? test::final_law(at) : 0;
      const double cut = shot.radius * std::exp(test::smooth_law(at) + share);
      shot.datum = shot.depth > cut ? ShotDatum::at_least : ShotDatum::at_most;
      shot.depth = cut;
    }
    return job;
  });
  test::expect_about_95_of_100(held);
}

INSTANTIATE_TEST_SUITE_P(Slow, FinalDepthCoverage, testing::Values(DugOut{12, true}, DugOut{24, false}),
                         [](const auto& made) {
                           return std::to_string(made.param.shots) + (made.param.one_scatter ? "OneScatter" : "Two");
                         });

// --- by the solver --------------------------------------------------------------------------------------------------

// Steel into a narrow layer on a coarse mesh, made by the solver as means over its phase and dug out: the modulus comes back.
TEST(SlowFinalDepth, ComesBackFromShotsOfTheSolver) {
  test::OwnCampaign own;
  CalibrationJob job = test::steel_balls_told_by(RunNumber::final_depth, "final depths");
  for (MeasuredShot& shot : job.shots) {
    const auto finals = test::solved_numbers(job, shot, true_gel, own.campaign);
    ASSERT_GT(finals.size(), 5u);
    shot.depth = mean(finals);
  }
  const CalibrationResult result = calibrate(job, own.store, own.campaign, {}, [](const std::string&) {});
  ASSERT_FALSE(result.hypotheses.empty()) << result.findings.at(0);
  const double mu = std::exp(result.hypotheses[0].minima[0].searched[0]);
  EXPECT_NEAR(mu / true_gel[0], 1, 0.15);
  ASSERT_EQ(result.emulator.beside.size(), 1u);
  EXPECT_GE(result.emulator.beside[0].runs, 60);
  RecordProperty("mu over the true one", std::to_string(mu / true_gel[0]));
  const page::Json json = calibration_to_json(job, result);
  EXPECT_THAT(json.dump(), HasSubstr("told the final depth: "));
  EXPECT_FALSE(calibrate_page(json).sections.empty());
}

// From the command line: calibrated, shown, predicted.
using SlowFinalDepthJob = FinalDepthJob;

TEST_F(SlowFinalDepthJob, IsCalibratedShownAndPredicted) {
  job_of("70,,20,,\n80,,25,,\n90,,30,,\n100,,36,,\n75,32,,,\n95,48,,,\n", R"(layer_width_radii = 5
[training]
coarse = 3
fine = 3
verify = 3
initial = 60
batch = 30
most = 150
)");
  write("job.toml", test::replaced(text_of(path("job.toml")), "layer_depth = \"25 mm\"", "layer_depth = \"120 mm\""));
  const test::Ended ended = run({"calibrate", "job.toml", "--store", "job.store", "--out", "found", "--details"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  for (const char* words : {"final depth 20 mm", "told the final depth", "the final depth over the deepest"})
    EXPECT_THAT(ended.out, HasSubstr(words));
  const page::Json found = page::Json::parse(text_of(path("found/result.json")));
  EXPECT_EQ(found["data"]["shots"][0]["seen"], "final depth");
  EXPECT_EQ(found["data"]["shots"][0]["measured_m"], 0.02);
  const page::Json& shot = found["hypotheses"][0]["shots"][0];
  EXPECT_GT(shot["deepest_m"], shot["depth_m"]);
  EXPECT_FALSE(found["hypotheses"][0]["shots"][4].contains("deepest_m"));
  EXPECT_GT(found["emulator"]["beside"]["final_depth"]["runs"], 24);
  const test::Ended predicted = run({"predict", "found", "--speed", "85m/s", "--out", "one"});
  ASSERT_EQ(predicted.code, 0) << predicted.err;
  EXPECT_THAT(predicted.out, HasSubstr("Its final depth: "));
  EXPECT_THAT(text_of(path("one/shots.csv")), HasSubstr("final_depth_shot_low_m"));
}

}  // namespace
}  // namespace percal::final_depth_tests
