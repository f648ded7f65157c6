// Depths at half the speed, channels and records of a flight: read, fitted, learnt without a datum, told by the solver's runs.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "calibrate/beside_law.hpp"
#include "calibrate/shots_of_the_solver.hpp"
#include "percal/base/error.hpp"
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/job/trajectory.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/math/statistics.hpp"
#include "support/ball_job.hpp"
#include "support/program.hpp"
#include "support/replaced.hpp"

// A name of its own: folders are compiled as units.
namespace percal::numbers_beside_tests {
namespace {

using test::true_gel;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double element = 0.1, shot_scatter = 0.06;

class NumbersJob : public test::Program {
 protected:
  CalibrationJob read(const std::string& columns, const std::string& rows, const std::string& keys) const {
    write("shots.csv", columns + "\n" + rows);
    return read_calibration_job(write("job.toml", test::ball_job() + keys));
  }
  template <class Read>
  static std::string refusal(const Read& read) {
    try {
      read();
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(NumbersJob, DepthsAtHalfTheSpeedAndChannelsAreRead) {
  const CalibrationJob half = read("speed_m_s,depth_mm,half_mm", "40,18,11\n44,,13\n",
                                   "depth_column = \"depth_mm\"\nhalf_speed_depth_column = \"half_mm\"\n");
  EXPECT_THAT((std::vector{seen_words(half.shots[0]), seen_words(half.shots[1])}),
              ElementsAre("depth", "depth at half the speed"));
  EXPECT_DOUBLE_EQ(half.shots[1].depth, 0.013);
  EXPECT_EQ(half.groups[0].name, "shots");
  const CalibrationJob channels =
      read("speed_m_s,radius_mm", "40,2.3\n44,2.5\n", "channel_radius_column = \"radius_mm\"\n");
  EXPECT_EQ(channels.shots[0].number, RunNumber::channel_radius);
  EXPECT_EQ(channels.groups[0].name, "channel radii");
  const CalibrationJob learnt =
      read("speed_m_s,depth_mm", "40,18\n44,20\n",
           "depth_column = \"depth_mm\"\n[training]\nlearn = [\"channel_radius\", \"final_depth\"]\n");
  EXPECT_THAT(numbers_of(learnt), ElementsAre(RunNumber::final_depth, RunNumber::channel_radius));
}

TEST_F(NumbersJob, RefusesWhatContradictsItself) {
  const std::string columns = "speed_m_s,depth_mm,half_mm,radius_mm,left_m_s",
                    keys =
                        "depth_column = \"depth_mm\"\nhalf_speed_depth_column = \"half_mm\"\n"
                        "channel_radius_column = \"radius_mm\"\nspeed_left_column = \"left_m_s\"\n";
  const auto refused = [&](const std::string& row) { return refusal([&] { read(columns, row + "\n", keys); }); };
  EXPECT_THAT(refused("40,15,16,,"),
              AllOf(HasSubstr("shots.csv:2"), HasSubstr("half the speed of 16 mm"), HasSubstr("15 mm")));
  EXPECT_THAT(refused("40,15,,2,"), AllOf(HasSubstr("channel radius beside a depth"), HasSubstr("a block of its own")));
  EXPECT_THAT(refused("40,,9,2,"), HasSubstr("channel radius beside a depth"));
  EXPECT_THAT(refused("60,,,2,20"), HasSubstr("channel radius of a shot that passed"));
  EXPECT_THAT(refusal([&] {
                read("speed_m_s,depth_mm", "40,18\n",
                     "depth_column = \"depth_mm\"\n[training]\nlearn = [\"radius\"]\n");
              }),
              AllOf(HasSubstr("training.learn"), HasSubstr("\"radius\""), HasSubstr("channel_radius")));
}

// --- records --------------------------------------------------------------------------------------------------------

// v = v_0 (1 - t/T): stops at T v_0/2, has half of its speed left at three quarters of that.
struct Flight {
  double speed = 80, stop = 1.2e-3, shown = 1.5e-3, reading = 0;  // m/s, s, s, m
  double together = 0;                                            // of the errors of neighbouring frames
  int frames = 60;
  unsigned seed = 1;
  double deepest() const { return 0.5 * speed * stop; }
  std::string csv(bool of_speeds = false) const {
    Draws draws(seed);
    std::string text = of_speeds ? "time_ms,speed_m_s\n" : "time_ms,depth_mm\n";
    double error = draws.normal();
    for (int k = 0; k < frames; ++k) {
      const double t = shown * k / (frames - 1), left = std::max(0.0, 1 - t / stop);
      const double value = of_speeds ? speed * left : 1e3 * (deepest() * (1 - left * left) + reading * error);
      error = together * error + std::sqrt(1 - together * together) * draws.normal();
      text += std::to_string(1e3 * t) + "," + std::to_string(value) + "\n";
    }
    return text;
  }
};

class Records : public NumbersJob {
 protected:
  std::string job_of(const std::string& csv, const std::string& keys = "", const std::string& speed = "80 m/s") const {
    write("flight.csv", csv);
    return test::replaced(test::ball_job(), R"(file = "shots.csv"
diameter = "3.18 mm"
particle_density = "7800 kg/m3"
speed_column = "speed_m_s"
layer_depth = "25 mm")",
                          "layer_depth = \"120 mm\"\n[[shots.points]]\ndiameter = \"3.18 mm\"\nparticle_density = "
                          "\"7800 kg/m3\"\nspeed = \"" +
                              speed + "\"\ntrajectory = \"flight.csv\"\n" + keys);
  }
  MeasuredShot shot_of(const std::string& csv, const std::string& keys = "") const {
    return read_calibration_job(write("job.toml", job_of(csv, keys))).shots.at(0);
  }
};

TEST_F(Records, SayOneNumberByHowFarTheyGo) {
  const Flight whole;
  const MeasuredShot stopped = shot_of(whole.csv());
  EXPECT_EQ(seen_words(stopped), "depth");
  EXPECT_NEAR(stopped.depth / whole.deepest(), 1, 0.005);
  const MeasuredShot by_speed = shot_of(whole.csv(true), "trajectory_speed = \"speed\"\n");
  EXPECT_EQ(seen_words(by_speed), "depth");
  EXPECT_NEAR(by_speed.depth / whole.deepest(), 1, 0.005);
  const Flight cut{.shown = 0.9e-3};
  const MeasuredShot half = shot_of(cut.csv());
  EXPECT_EQ(seen_words(half), "depth at half the speed");
  EXPECT_NEAR(half.depth / cut.deepest(), 0.75, 0.005);
  const Flight begun{.shown = 0.3e-3};
  const MeasuredShot least = shot_of(begun.csv());
  EXPECT_EQ(seen_words(least), "at least");
  EXPECT_NEAR(least.depth / begun.deepest(), 1 - 0.75 * 0.75, 1e-6);
  EXPECT_EQ(least.depth_error, 0);
  EXPECT_DOUBLE_EQ(shot_of(cut.csv(), "depth_error = \"5 %\"\n").depth_error, 0.05 * half.depth)
      << "a given one counts";
}

TEST_F(Records, KnowHowWellTheyAreRead) {
  for (const double together : {0.0, 0.5}) {
    int within = 0;
    std::vector<double> sizes;
    for (unsigned seed = 0; seed < 200; ++seed) {
      const Flight flight{.shown = 1e-3, .reading = 0.2e-3, .together = together, .seed = seed};
      const MeasuredShot half = shot_of(flight.csv());
      ASSERT_EQ(seen_words(half), "depth at half the speed");
      within += std::abs(half.depth - 0.75 * flight.deepest()) <= 2.2 * half.depth_error;  // of 12 degrees of freedom
      sizes.push_back(half.depth_error / half.depth);
    }
    RecordProperty(together > 0 ? "within_together" : "within", within);
    EXPECT_GE(within, together > 0 ? 152 : 170);
    std::ranges::nth_element(sizes, sizes.begin() + 100);
    EXPECT_LT(sizes[100], 0.05);
  }
}

// Drag by the square of the speed and a constant strength: v = u tan(c_0 - u c t), bent most at its beginning.
TEST_F(Records, OfABentFlightAreReadToTwoHundredths) {
  constexpr double speed = 80, slow = 25, per_length = 40;  // m/s, m/s, 1/m
  const double angle = std::atan(speed / slow);
  std::string csv = "time_ms,depth_mm\n";
  for (int k = 0; k < 40; ++k) {
    const double phase = angle * (1 - k / 50.0);
    csv += std::to_string(1e3 * (angle - phase) / (slow * per_length)) + "," +
           std::to_string(1e3 * std::log(std::cos(phase) / std::cos(angle)) / per_length) + "\n";
  }
  const MeasuredShot half = shot_of(csv);
  ASSERT_EQ(seen_words(half), "depth at half the speed");
  const double expected = std::log(std::cos(std::atan(0.5 * speed / slow)) / std::cos(angle)) / per_length;
  EXPECT_NEAR(half.depth / expected, 1, 0.02);
}

// A record of depths that are counted from elsewhere, by so many mm.
std::string shifted(double mm) {
  const Flight flight;
  std::string csv = "time_ms,depth_mm\n";
  for (int k = 0; k < flight.frames; ++k) {
    const double t = flight.shown * k / (flight.frames - 1), left = std::max(0.0, 1 - t / flight.stop);
    csv += std::to_string(1e3 * t) + "," + std::to_string(mm + 1e3 * flight.deepest() * (1 - left * left)) + "\n";
  }
  return csv;
}
// Twenty frames of 80 m/s and, a long time after, as many of this share of it.
std::string of_two_speeds(double share) {
  std::string csv = "time_ms,speed_m_s\n";
  for (int k = 0; k < 40; ++k)
    csv += std::to_string(0.001 * k + (k < 20 ? 0 : 1)) + "," + std::to_string(k < 20 ? 80 : share * 80) + "\n";
  return csv;
}

TEST_F(Records, RefuseWhatIsNoRecordOfThisShot) {
  const auto refused = [&](const std::string& csv, const std::string& keys, const std::string& speed = "80 m/s") {
    return refusal([&] { read_calibration_job(write("job.toml", job_of(csv, keys, speed))); });
  };
  const std::string good = Flight{}.csv();
  EXPECT_THAT(refused(good, "", "140 m/s"),
              AllOf(HasSubstr("flight.csv:2"), HasSubstr("begins with 80"), HasSubstr("140 m/s")));
  EXPECT_THAT(refused(good, "depth = \"30 mm\"\n"), AllOf(HasSubstr("trajectory"), HasSubstr("one of the two")));
  EXPECT_THAT(refused(good, "outcome = \"passed\"\n"), HasSubstr("beside a trajectory"));
  EXPECT_THAT(refused("time_ms,depth_mm\n0,0\n1,2\n", ""), HasSubstr("8 frames or more"));
  EXPECT_THAT(refused(test::replaced(good, "\n0.050847,", "\n0.010000,"), ""),
              AllOf(HasSubstr("flight.csv:4"), HasSubstr("times that rise")));
  EXPECT_THAT(refused(shifted(-60), ""),
              AllOf(HasSubstr("flight.csv"), HasSubstr("a depth of -0.01"), HasSubstr("depths below the surface")));
  EXPECT_THAT(
      refused(of_two_speeds(0.4), "trajectory_speed = \"speed\"\n"),
      AllOf(HasSubstr("flight.csv"), HasSubstr("no frames where half of the speed at impact, 40 m/s, is left")));
  EXPECT_THAT(refused(good, "trajectory_time = \"clock\"\n"), AllOf(HasSubstr("clock"), HasSubstr("time_ms")));
  EXPECT_THAT(refused(good, "trajectory_depth = \"depth\"\ntrajectory_speed = \"depth\"\n"),
              HasSubstr("one of the two"));
  EXPECT_THAT(refusal([&] {
                read_calibration_job(
                    write("job.toml", test::replaced(job_of(good, "trajectory_time = \"time\"\ndepth = \"30 mm\"\n"),
                                                     "trajectory = \"flight.csv\"\n", "")));
              }),
              HasSubstr("this without trajectory"));
}

// --- what they tell -------------------------------------------------------------------------------------------------

Emulators emulators_of_numbers() {
  return test::with_number(
      test::with_number(test::emulator_of_the_smooth_law(), RunNumber::half_speed_depth, test::half_speed_law, 0.002),
      RunNumber::channel_radius, test::channel_law, 0.002);
}

// Every third ball was seen at its deepest, at half of its speed, or left its channel.
CalibrationJob filmed(const std::vector<double>& natural, int shots, unsigned seed) {
  CalibrationJob job = test::gel_job_at_speeds(shots, "channel radii", element);
  Draws draws(seed);
  for (int k = 0; k < shots; ++k) {
    MeasuredShot& shot = job.shots[k];
    const SphereInputs at = test::inputs_at(job, shot, natural);
    double log_value = test::smooth_law(at) + shot_scatter * draws.normal();
    if (k % 3 == 1) {
      shot.number = RunNumber::half_speed_depth;
      log_value += test::half_speed_law(at);
    }
    if (k % 3 == 2) {
      shot.number = RunNumber::channel_radius;
      shot.group = 1;
      log_value = test::channel_law(at) + 0.02 * draws.normal();
    }
    shot.depth = shot.radius * std::exp(log_value);
  }
  return job;
}

TEST(NumbersBeside, AreReadFromARunThatStopped) {
  ImpactResult run{.outcome = Outcome::stopped, .depth = 20};
  run.half_speed_depth = 12;
  run.channel.largest = {1, 2.5, 2};
  EXPECT_NEAR(kind_of(RunNumber::half_speed_depth).log_of(run).value(), std::log(0.6), 1e-12);
  EXPECT_NEAR(kind_of(RunNumber::channel_radius).log_of(run).value(), std::log(2.5), 1e-12);
  run.outcome = Outcome::passed_through;
  EXPECT_FALSE(kind_of(RunNumber::half_speed_depth).log_of(run));
  EXPECT_FALSE(kind_of(RunNumber::channel_radius).log_of(run));
}

TEST(NumbersBeside, AChannelIsNoShareOfTheDepth) {
  const CalibrationJob job = filmed(true_gel, 9, 1);
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulators_of_numbers(), element);
  Eigen::VectorXd at(3);
  for (int k = 0; k < 3; ++k) at[k] = job.parameters[k].free.searched(true_gel[k]);
  const ModelAnswer answer = model.log_depths(at, job.shots, Want::values_and_covariance);
  for (int k = 0; k < 9; ++k) {
    const SphereInputs inputs = test::inputs_at(job, job.shots[k], true_gel);
    const double expected = k % 3 == 2   ? test::channel_law(inputs)
                            : k % 3 == 1 ? test::smooth_law(inputs) + test::half_speed_law(inputs)
                                         : test::smooth_law(inputs);
    EXPECT_NEAR(answer.value[k], expected + std::log(job.shots[k].radius), 0.02) << k;
  }
  EXPECT_EQ(answer.covariance(0, 2), 0) << "emulators of their own";
  EXPECT_NE(answer.covariance(0, 1), 0) << "both lean on the deepest depth";
  EXPECT_FALSE(tells_depth(job.shots[2]));
  EXPECT_TRUE(tells_depth(job.shots[1]));
}

class FilmedCoverage : public testing::TestWithParam<RunNumber> {};

// Of 100 truths, with the balls that were not seen so left out.
TEST_P(FilmedCoverage, IntervalsHoldTheTruth) {
  const Emulators emulators = emulators_of_numbers();
  const auto held = test::held_of_100_moduli(emulators, element, {1, 8}, [](const auto& natural, unsigned seed) {
    CalibrationJob job = filmed(natural, 36, seed);
    std::erase_if(job.shots, [&](const MeasuredShot& shot) { return shot.number != GetParam(); });
    if (GetParam() == RunNumber::channel_radius)
      job.groups.erase(job.groups.begin());
    else
      job.groups.pop_back();
    for (MeasuredShot& shot : job.shots) shot.group = 0;
    return job;
  });
  test::expect_about_95_of_100(held);
}

INSTANTIATE_TEST_SUITE_P(Slow, FilmedCoverage, testing::Values(RunNumber::half_speed_depth, RunNumber::channel_radius),
                         [](const auto& made) {
                           return made.param == RunNumber::channel_radius ? "Channels" : "HalfSpeed";
                         });

// --- by the solver --------------------------------------------------------------------------------------------------

class NumbersOfTheSolver : public testing::TestWithParam<RunNumber> {};

// Steel into a narrow layer on a coarse mesh, means of the solver's runs over its phase: the modulus comes back.
TEST_P(NumbersOfTheSolver, ComeBackFromShotsOfTheSolver) {
  test::OwnCampaign own;
  CalibrationJob job = test::steel_balls_told_by(GetParam(), "numbers");
  for (MeasuredShot& shot : job.shots) {
    const auto found = test::solved_numbers(job, shot, true_gel, own.campaign);
    ASSERT_EQ(found.size(), 20u);
    shot.depth = mean(found);
  }
  const CalibrationResult result = calibrate(job, own.store, own.campaign, {}, [](const std::string&) {});
  ASSERT_FALSE(result.hypotheses.empty()) << result.findings.at(0);
  const double mu = std::exp(result.hypotheses[0].minima[0].searched[0]);
  RecordProperty("mu over the true one", std::to_string(mu / true_gel[0]));
  EXPECT_NEAR(mu / true_gel[0], 1, 0.15);
  const page::Json json = calibration_to_json(job, result);
  EXPECT_THAT(json.dump(), HasSubstr(kind_of(GetParam()).learnt));
  EXPECT_FALSE(calibrate_page(json).sections.empty());
}

INSTANTIATE_TEST_SUITE_P(Slow, NumbersOfTheSolver,
                         testing::Values(RunNumber::half_speed_depth, RunNumber::channel_radius), [](const auto& made) {
                           return made.param == RunNumber::channel_radius ? "Channels" : "HalfSpeed";
                         });

// Learnt though no shot tells it, shown and predicted.
using SlowLearntNumbers = NumbersJob;

TEST_F(SlowLearntNumbers, AnswerForShotsThatWereNotFired) {
  write("shots.csv", "speed_m_s,depth_mm\n70,27\n80,34\n90,40\n100,47\n");
  write("job.toml", test::replaced(test::ball_job(), "layer_depth = \"25 mm\"", "layer_depth = \"120 mm\"") +
                        R"(depth_column = "depth_mm"
layer_width_radii = 5
[training]
coarse = 3
fine = 3
verify = 3
initial = 60
batch = 30
most = 150
learn = ["half_speed_depth", "channel_radius"]
)");
  const test::Ended ended = run({"calibrate", "job.toml", "--store", "job.store", "--out", "found", "--details"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const test::Ended predicted = run({"predict", "found", "--speed", "85m/s", "--out", "one"});
  ASSERT_EQ(predicted.code, 0) << predicted.err;
  EXPECT_THAT(predicted.out, AllOf(HasSubstr("Its depth at half the speed: "),
                                   HasSubstr("Its largest channel radius: "), HasSubstr("Besides the depth")));
  const page::Json one = page::Json::parse(text_of(path("one/result.json")));
  const double radius = one["shots"][0]["channel_radius"]["value_m"], depth = one["shots"][0]["depth_m"];
  EXPECT_GT(radius, 1.59e-3);
  EXPECT_LT(radius, 4 * 1.59e-3);
  EXPECT_GT(one["shots"][0]["half_speed_depth"]["value_m"], 0.4 * depth);
  EXPECT_THAT(text_of(path("one/shots.csv")), HasSubstr("channel_radius_shot_low_m"));
}

}  // namespace
}  // namespace percal::numbers_beside_tests
