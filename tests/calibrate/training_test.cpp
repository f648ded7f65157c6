// A calibration's runs: what it does when they fail, and what it learns from the runs of others.
#include "percal/calibrate/training.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "calibrate/gel_job.hpp"
#include "percal/base/error.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/material/homogeneous.hpp"
#include "percal/observe/stored_run.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

// Steel into a thin layer on the coarsest mesh: a run takes a few milliseconds.
CalibrationJob quick_job() {
  CalibrationJob job = test::gel_job(4);
  for (MeasuredShot& shot : job.shots) {
    shot.layer_depth = 30 * shot.radius;
    shot.depth = 15 * shot.radius;
  }
  job.training = {.coarse = 2, .fine = 2, .verify = 2, .initial = 64, .batch = 40, .most = 104, .accuracy = 1e-6};
  job.hypotheses[0].held[1] = 7;
  job.bootstrap = 0;
  job.dehn = false;
  return job;
}

class CalibrationRuns : public testing::Test, protected test::TemporaryFolder {
 protected:
  Store store_{path("percal.store")};
  Campaign campaign_{&store_, 0};
  CalibrationJob job_ = quick_job();
  const CalibrationLimits limits_{};
};

// Most of the first design's 64 runs come to rest, then all fail that the fitted emulator asks for.
TEST_F(CalibrationRuns, FailuresAfterAFittedRoundLeaveNoHypothesis) {
  job_.training.failures_tolerated = 0.35;
  Training(job_, &store_, campaign_, limits_).fill_space();
  const auto design = store_.with_prefix(stored_spheres_prefix());
  const auto silent = [](const std::string&) {};
  const CalibrationResult undisturbed = calibrate(job_, store_, campaign_, limits_, silent);
  ASSERT_FALSE(undisturbed.hypotheses.empty()) << undisturbed.findings.at(0);

  Evaluation failed = from_payload(design.front().evaluation.payload);
  failed.result.outcome = Outcome::time_up;
  Store other(path("other.store"));
  for (const auto& [key, evaluation] : store_.with_prefix(stored_spheres_prefix()))
    if (std::ranges::find(design, key, &KeyedEvaluation::key) == design.end())
      other.put(key, {word(failed.result.outcome), to_payload(failed), 0});
  other.take_in(store_);
  Campaign with_failures(&other, 0);
  const CalibrationResult result = calibrate(job_, other, with_failures, limits_, silent);
  EXPECT_TRUE(result.hypotheses.empty());
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_NE(result.findings[0].find("more failed than the job tolerates"), std::string::npos) << result.findings[0];
}

// Single runs whose mesh phases fill one period: no two alike, and as many below the job's mesh as above.
TEST_F(CalibrationRuns, AreOnMeshesOfDrawnPhases) {
  job_.training.coarse = job_.training.fine = 3.5;
  Training(job_, &store_, campaign_, limits_).fill_space();
  std::vector<double> meshes;
  for (const StoredSphere& run : stored_spheres(store_)) meshes.push_back(run.problem.elements_per_radius);
  ASSERT_EQ(meshes.size(), 64u);
  std::ranges::sort(meshes);
  EXPECT_EQ(std::ranges::adjacent_find(meshes), meshes.end());
  EXPECT_GE(meshes.front(), 3.5 - 0.85);
  EXPECT_LE(meshes.back(), 3.5 + 0.85);
  EXPECT_NEAR(meshes[32], 3.5, 0.1);
  CalibrationJob other = job_;
  other.training.seed += 1;
  Store elsewhere(path("other.store"));
  Campaign campaign(&elsewhere, 0);
  Training(other, &elsewhere, campaign, limits_).fill_space();
  EXPECT_NE(stored_spheres(elsewhere).front().key, stored_spheres(store_).front().key) << "the seed chooses them";
}

TEST_F(CalibrationRuns, ThoseOfOthersAreLearntFromUnlessTheJobHasBegunWithoutThem) {
  Training begun(job_, &store_, campaign_, limits_);
  CalibrationJob other = job_;
  other.text = "another job";
  Training(other, &store_, campaign_, limits_).fill_space();
  EXPECT_EQ(Training(job_, &store_, campaign_, limits_).report().foreign, 0) << "it goes on as it began";
  CalibrationJob third = job_;
  third.text = "a third one";
  EXPECT_GT(Training(third, &store_, campaign_, limits_).report().foreign, 30);
}

// What a job began with elsewhere says nothing about the runs that it finds here.
TEST_F(CalibrationRuns, ThoseOfOthersAreLearntFromAnewByAnotherSolverOrProcessor) {
  store_.put_note(foreign_note(job_, sphere_key_prefix("another level")), "");
  CalibrationJob other = job_;
  other.text = "another job";
  Training(other, &store_, campaign_, limits_).fill_space();
  EXPECT_GT(Training(job_, &store_, campaign_, limits_).report().foreign, 30);
}

// Fitted, only predicted or none; with a curve or without.
TEST_F(CalibrationRuns, EveryCombinationOfEmptyPartsIsCalibratedOrRefused) {
  MeasuredCurve curve{.name = "tension", .data = {}, .relative_error = 0.02};
  for (const double stretch : {1.1, 1.3, 1.6, 2.0}) {
    const Strained state{Deformation::uniaxial, stretch};
    curve.data.points.push_back({.strained = state, .nominal_stress = nominal_stress(Ogden{200e3, 7}, state)});
  }
  curve.group = 1;
  for (const char* shots : {"fitted", "predicted", "none"})
    for (const bool with_curve : {true, false}) {
      SCOPED_TRACE(std::string(shots) + (with_curve ? ", a curve" : ""));
      CalibrationJob job = quick_job();
      job.bootstrap = 3;
      job.dehn = true;
      job.sets[0].leave_one_out = true;
      job.training.most = job.training.initial;
      job.training.verify_replicates = 1;
      if (std::string(shots) == "none") job.shots.clear();
      for (MeasuredShot& shot : job.shots) shot.used = std::string(shots) == "fitted";
      if (with_curve) {
        job.groups.push_back({"curves", true, 0});
        job.curves.push_back(curve);
      }
      const auto found = [&] { return calibrate(job, store_, campaign_, limits_, [](const std::string&) {}); };
      if (std::string(shots) != "fitted" && !with_curve) {
        EXPECT_THROW(found(), BadInput);
        continue;
      }
      const CalibrationResult result = found();
      ASSERT_EQ(result.hypotheses.size(), 1u);
      EXPECT_EQ(result.hypotheses[0].fresh.size(), std::string(shots) == "fitted" ? 4u : 0u);
      EXPECT_EQ(result.hypotheses[0].shots.size(), job.shots.size());
      EXPECT_FALSE(calibrate_page(calibration_to_json(job, result)).sections.empty());
    }
}

// The atlas is of the default setting with the wall at 20 radii.
TEST_F(CalibrationRuns, BeginWithRunsOfTheAtlasWhereItIsOfTheirSetting) {
  EXPECT_EQ(Training(job_, &store_, campaign_, limits_).report().from_atlas, 0) << "the wall is nearer";
  for (MeasuredShot& shot : job_.shots) shot.layer_width = 20 * shot.radius;
  Training training(job_, &store_, campaign_, limits_);
  ASSERT_TRUE(training.has_emulator()) << "before any run";
  const auto& runs = training.emulator().runs();
  EXPECT_EQ(training.report().from_atlas, static_cast<int>(runs.size()));
  EXPECT_EQ(runs.size(), 600);
  for (const TrainingRun& run : runs) EXPECT_LT(run.log_depth, run.at.log_layer_depth) << "no shot tells of passing";
  training.fill_space();
  EXPECT_EQ(training.report().runs, 0) << "the design is the atlas";
}

}  // namespace
}  // namespace percal
