// Shots that tell whether a layer was passed, or with which speed: read, fitted, predicted.
#include <gmock/gmock.h>

#include "calibrate/gel_job.hpp"
#include "percal/base/error.hpp"
#include "percal/calibrate/kept_model.hpp"
#include "percal/invert/reach.hpp"
#include "percal/predict/predictor.hpp"
#include "support/ball_job.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PassageJob : public test::Program {
 protected:
  CalibrationJob read(const std::string& rows, const std::string& keys = "",
                      const std::string& header = "speed_m_s,depth_mm,outcome,left_m_s") const {
    write("shots.csv", header + "\n" + rows);
    return read_calibration_job(
        write("job.toml",
              test::ball_job() +
                  (keys.empty()
                       ? "depth_column = \"depth_mm\"\noutcome_column = \"outcome\"\nspeed_left_column = \"left_m_s\"\n"
                       : keys)));
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

TEST_F(PassageJob, TakesOfEachRowWhatSaysMost) {
  const CalibrationJob job = read("40,18,stopped,\n50,,stopped,\n60,,Perforated,\n70,,passed,30\n80,,,45\n55,,,0\n");
  std::vector<ShotDatum> data;
  for (const MeasuredShot& shot : job.shots) data.push_back(shot.datum);
  EXPECT_THAT(data, ElementsAre(ShotDatum::depth, ShotDatum::stopped, ShotDatum::passed, ShotDatum::speed_left,
                                ShotDatum::speed_left, ShotDatum::stopped));
  EXPECT_DOUBLE_EQ(job.shots[0].depth, 0.018);
  EXPECT_DOUBLE_EQ(job.shots[1].depth, 0.025);
  EXPECT_DOUBLE_EQ(job.shots[3].depth, reach_of_passage(0.025, 30.0 / 70));
  EXPECT_TRUE(learns_passage(job));
}

TEST_F(PassageJob, ASpeedLeftHasAnErrorOfItsReach) {
  const CalibrationJob job = read("70,30\n",
                                  "speed_left_column = \"left_m_s\"\nspeed_left_error = \"3 m/s\"\n"
                                  "speed_error = \"1 m/s\"\n",
                                  "speed_m_s,left_m_s");
  const MeasuredShot& shot = job.shots[0];
  const double up = reach_of_passage(0.025, 33.0 / 70), down = reach_of_passage(0.025, 27.0 / 70);
  EXPECT_NEAR(shot.depth_error, (up - down) / 2, 0.02 * shot.depth_error);
  // A faster shot than was noted has lost more than was thought, and was to go deeper.
  EXPECT_GT(known_log_error(shot, 0.7), std::hypot(shot.depth_error / shot.depth, 0.7 / 70));
}

TEST_F(PassageJob, RefusesWhatContradictsItself) {
  EXPECT_THAT(refusal("40,18,passed,\n"), HasSubstr("a depth of a shot that passed"));
  EXPECT_THAT(refusal("40,,stopped,20\n"), HasSubstr("a speed left of a shot that was stopped"));
  EXPECT_THAT(refusal("40,18,,20\n"), HasSubstr("a depth of a shot that passed"));
  EXPECT_THAT(refusal("40,,passed,41\n"), HasSubstr("less than the speed at impact"));
  EXPECT_THAT(refusal("40,,,\n"), HasSubstr("nothing was seen"));
  EXPECT_THAT(refusal("40,,fail,\n"), testing::AllOf(HasSubstr("\"fail\""), HasSubstr("perforated")));
  EXPECT_THAT(
      refusal("40,18,,\n60,,passed,\n", "depth_column = \"depth_mm\"\noutcome_column = \"outcome\"\nat_least = true\n"),
      HasSubstr("no depth alone is known"));
}

TEST_F(PassageJob, AShotThatIsOnlyPredictedNeedsNoDepth) {
  const CalibrationJob job = read("40\n",
                                  "use = \"predict\"\n[[shots]]\nname = \"told\"\nmaterial = \"gel\"\n"
                                  "layer_depth = \"25 mm\"\n[[shots.points]]\ndiameter = \"3.18 mm\"\n"
                                  "particle_density = \"7800 kg/m3\"\nspeed = \"40 m/s\"\ndepth = \"18 mm\"\n",
                                  "speed_m_s");
  EXPECT_EQ(job.shots[0].datum, ShotDatum::none);
  EXPECT_FALSE(learns_passage(job));
}

// --- recovering the truth -------------------------------------------------------------------------------------------

constexpr double element = 0.1, shot_scatter = 0.06;
const std::vector<double> truth_in_the_middle{250e3, 8, 0.8};

// Balls at rising speeds through a layer that about half of them pass; nothing but the modulus is sought.
CalibrationJob layer_job(int shots) {
  CalibrationJob job = test::gel_job(shots);
  job.hypotheses[0].held = {{1, 8.0}, {2, 0.8}};
  job.training.verify = 1 / element;
  for (int k = 0; k < shots; ++k) {
    job.shots[k].density = 7800;
    job.shots[k].speed = 35 * std::pow(3.0, k / (shots - 1.0));
  }
  return job;
}

double true_reach(const CalibrationJob& job, const MeasuredShot& shot, const std::vector<double>& natural) {
  const auto at = shot_inputs(shot, target_at(job, job.hypotheses[0], job.targets[shot.target], natural)).at;
  return shot.radius * std::exp(test::smooth_law(at));
}

// Layers as deep as a shot in the middle goes at the truth in the middle: passed by some at any other truth.
void shoot(CalibrationJob& job, const std::vector<double>& natural, bool speeds_left, unsigned seed) {
  Draws draws(seed);
  for (MeasuredShot& shot : job.shots) {
    MeasuredShot middle = shot;
    middle.speed = 60;
    shot.layer_depth = true_reach(job, middle, truth_in_the_middle);
    const double reach = true_reach(job, shot, natural) * std::exp(shot_scatter * draws.normal());
    shot.datum = reach > shot.layer_depth ? ShotDatum::passed : ShotDatum::stopped;
    shot.depth = shot.layer_depth;
    if (!speeds_left) continue;
    shot.depth = reach;
    if (shot.datum == ShotDatum::stopped)
      shot.datum = ShotDatum::depth;
    else
      shot.datum = ShotDatum::speed_left, shot.speed_left = shot.speed * share_left(shot.layer_depth, reach);
  }
}

struct Held {
  int modulus = 0, v50 = 0;
};

// Of 100 truths, the intervals of the modulus and of the speed that half pass a layer at.
Held held_of_100(int shots, bool speeds_left) {
  const Emulator emulator = test::emulator_of_the_smooth_law();
  Held held;
  for (int t = 0; t < 100; ++t) {
    CalibrationJob job = layer_job(shots);
    std::vector<double> natural = truth_in_the_middle;
    natural[0] *= std::exp(0.4 * (t / 50.0 - 1));
    shoot(job, natural, speeds_left, 1000 + static_cast<unsigned>(t));
    const JobModel model = finite_element_model(job, job.hypotheses[0], emulator, element);
    const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
    const auto intervals = region_intervals(fit.problem, fit.minima, 0.95, quick_search());
    if (!intervals.empty())
      held.modulus += intervals[0].interval.low <= natural[0] && natural[0] <= intervals[0].interval.high;
    CalibrationResult result;
    result.hypotheses.resize(1);
    result.hypotheses[0].for_shots = for_shots(job, 0, model, fit);
    const auto kept = kept_model(job, emulator, result);
    const MeasuredShot& shot = job.shots.front();
    const SolvedShot v50 = Predictor(*kept, 0, 0, 0.95).solve(ShotNumber::speed, shot, shot.layer_depth);
    MeasuredShot at = shot;
    at.speed = v50.mean.low;
    const bool low = true_reach(job, at, natural) <= shot.layer_depth;
    at.speed = v50.mean.high;
    held.v50 += low && true_reach(job, at, natural) >= shot.layer_depth;
  }
  return held;
}

struct WhatWasSeen {
  int shots;
  bool speeds_left;  // and depths; else outcomes alone
};
class PassageCoverage : public testing::TestWithParam<WhatWasSeen> {};

TEST_P(PassageCoverage, RecoversTheModulusAndTheSpeedThatHalfPass) {
  const Held held = held_of_100(GetParam().shots, GetParam().speeds_left);
  RecordProperty("modulus", held.modulus);
  RecordProperty("v50", held.v50);
  for (const int count : {held.modulus, held.v50}) {
    EXPECT_GE(count, 89);
    EXPECT_LE(count, 99);
  }
}

INSTANTIATE_TEST_SUITE_P(Slow, PassageCoverage, testing::Values(WhatWasSeen{16, false}, WhatWasSeen{10, true}),
                         [](const auto& seen) { return seen.param.speeds_left ? "SpeedsLeft" : "Outcomes"; });

// The scatter that outcomes tell is the one that made them.
TEST(Passage, OutcomesTellTheirScatter) {
  const Emulator emulator = test::emulator_of_the_smooth_law();
  CalibrationJob job = layer_job(200);
  for (int k = 0; k < 200; ++k) job.shots[k].speed = 50 * std::pow(1.5, k / 199.0);
  shoot(job, truth_in_the_middle, false, 7);
  const JobFit fit =
      fit_job(job, finite_element_model(job, job.hypotheses[0], emulator, element), used_shots(job), quick_search());
  EXPECT_NEAR(fit.best().scatter[0], shot_scatter, 0.4 * shot_scatter);
}

}  // namespace
}  // namespace percal
