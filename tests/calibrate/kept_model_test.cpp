// What a calibration keeps, from the fit to the prediction: do its intervals hold shots that the fit has not seen?
#include "percal/calibrate/kept_model.hpp"

#include <gtest/gtest.h>

#include "calibrate/gel_job.hpp"
#include "percal/predict/predictor.hpp"

namespace percal {
namespace {

constexpr double h = 0.1;

struct Kept {
  CalibrationJob job;
  ShotModel model;
};

// Fitted to the shots of the job that are used.
Kept kept_of(CalibrationJob job, const Emulator& emulator) {
  job.training.verify = 1 / h;
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulator, h);
  const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
  CalibrationResult result;
  result.hypotheses.resize(1);
  result.hypotheses[0].for_shots = for_shots(job, 0, model, fit);
  auto kept = kept_model(job, emulator, result);
  return {job, *kept};
}

TEST(KeptModel, PredictsItsOwnShotsAsTheFitHasThem) {
  const Emulator emulator = test::emulator_of_the_smooth_law();
  CalibrationJob job = test::gel_job();
  test::measure(job, {200e3, 8, 0.8}, 0.03, 5);
  const auto [read, model] = kept_of(job, emulator);
  const JobModel of_job = finite_element_model(read, read.hypotheses[0], emulator, h);
  const JobFit fit = fit_job(read, of_job, used_shots(read), quick_search());
  const auto depths = shot_depths(read, of_job, fit, all_shots(read));
  const Predictor gel(model, 0, 0, read.level);
  for (const ShotDepth& depth : depths) {
    const SphereShot shot = read.shots[depth.shot];
    const DepthPrediction predicted = gel.depths(std::span(&shot, 1)).front();
    EXPECT_NEAR(predicted.depth / depth.depth, 1, 1e-6);
    // A sample of the same region: as wide as the region's linear one, within what a ridge is curved.
    const double wide = std::log(predicted.shot.high / predicted.shot.low) / std::log(depth.high / depth.low);
    EXPECT_GT(wide, 0.7);
    EXPECT_LT(wide, 1.4);
  }
}

TEST(KeptModel, KnowsTheScatterOfItsShots) {
  const Emulator emulator = test::emulator_of_the_smooth_law();
  CalibrationJob job = test::gel_job(12);
  test::measure(job, {200e3, 8, 0.8}, 0.05, 5);
  const ShotModel model = kept_of(job, emulator).model;
  const MaterialSample& gel = model.hypotheses[0].materials[0];
  EXPECT_NEAR(gel.scatter, 0.05, 0.025);
  EXPECT_EQ(gel.freedom, 9);  // twelve shots, three parameters
  EXPECT_EQ(model.shots.size(), 12u);
  job.groups[0] = {"shots", false, 0.04};
  EXPECT_EQ(kept_of(job, emulator).model.hypotheses[0].materials[0].freedom, 0);
}

// Truths drawn over the box; of each, eight shots fitted and four predicted, two of them at higher speeds than any fitted one.
TEST(KeptModel, ItsIntervalsHoldShotsThatWereHeldBack) {
  const Emulator emulator = test::emulator_of_the_smooth_law();
  int within = 0, within_mean = 0, all = 0;
  const auto points = sobol_points(30, 3, 1);
  for (int t = 0; t < 30; ++t) {
    CalibrationJob job = test::gel_job(12);
    const std::vector<double> truth{100e3 * std::exp(points(t, 0) * std::log(5.0)), 5 + 6 * points(t, 1),
                                    0.4 + 0.8 * points(t, 2)};
    test::measure(job, truth, 0.05, 100 + static_cast<unsigned>(t));
    for (const int held_back : {3, 6, 10, 11}) job.shots[held_back].used = false;
    const Kept kept = kept_of(job, emulator);
    const Predictor gel(kept.model, 0, 0, 0.95);
    for (const MeasuredShot& shot : job.shots) {
      if (shot.used) continue;
      const SphereShot one = shot;
      const DepthPrediction predicted = gel.depths(std::span(&one, 1)).front();
      const double mean =
          shot.radius * std::exp(test::smooth_law(shot_inputs(shot, material_at(job, job.hypotheses[0], 0, truth)).at));
      within += predicted.shot.low <= shot.depth && shot.depth <= predicted.shot.high;
      within_mean += predicted.mean.low <= mean && mean <= predicted.mean.high;
      ++all;
    }
  }
  RecordProperty("within", within);
  RecordProperty("within_mean", within_mean);
  EXPECT_GE(within, 0.89 * all) << "of " << all;
  EXPECT_LE(within, 0.995 * all) << "of " << all;
  // Four predictions of one fit err together; fewer are independent.
  EXPECT_GE(within_mean, 0.82 * all) << "of " << all;
}

}  // namespace
}  // namespace percal
