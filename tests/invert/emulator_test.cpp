#include "percal/invert/emulator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include "percal/base/error.hpp"
#include "percal/invert/emulator_search.hpp"
#include "percal/math/draws.hpp"

namespace percal {
namespace {

// Standard normal numbers that are the same everywhere.
class Noise {
 public:
  double operator()() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * M_PI * uniform());
  }

 private:
  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) / 9007199254740992.0; }
  std::mt19937_64 engine_{20090401};
};

SphereInputs in_the_box(const Eigen::VectorXd& u) {
  return {1.6 + 3 * u[0], -2.8 + 2.7 * u[1], 4 + 8 * u[2], 0.3 + 0.9 * u[3], 4.3 + 0.5 * u[4], 4 + 2 * u[5]};
}

std::vector<SphereInputs> box_points(int count, int skip) {
  const Eigen::MatrixXd points = sobol_points(count, sphere_inputs, skip);
  std::vector<SphereInputs> at;
  for (int i = 0; i < count; ++i) at.push_back(in_the_box(points.row(i)));
  return at;
}

// A depth as smooth and as curved as a sphere's; layer depth and K/mu hardly matter.
double smooth_depth(const SphereInputs& at) {
  const double pi4 = at.log_pi4, density = -at.log_pi5, alpha = at.alpha, strain = at.erosion_strain;
  return 0.4 * density + std::log(2 + 0.5 * pi4 * pi4) - 0.05 * alpha - 0.8 * strain - 0.02 * alpha * strain +
         0.05 * std::sin(2 * pi4 + strain) + 0.01 * at.log_layer_depth;
}
double mesh_part(const SphereInputs& at) { return 0.06 + 0.02 * (at.log_pi4 - 3) + 0.03 * (at.erosion_strain - 0.7); }

std::vector<TrainingRun> runs_of(const std::vector<SphereInputs>& at, double h, double noise, Noise& normal) {
  std::vector<TrainingRun> runs;
  for (const SphereInputs& point : at)
    runs.push_back({point, h, smooth_depth(point) + mesh_part(point) * (h / 0.1) + noise * normal()});
  return runs;
}

void append(std::vector<TrainingRun>& runs, const std::vector<TrainingRun>& more) {
  runs.insert(runs.end(), more.begin(), more.end());
}

// Three meshes, coarse runs most of all.
std::vector<TrainingRun> three_meshes(double noise, Noise& normal) {
  auto runs = runs_of(box_points(120, 0), 0.15, noise, normal);
  append(runs, runs_of(box_points(40, 1000), 0.1, noise, normal));
  append(runs, runs_of(box_points(25, 2000), 0.05, noise, normal));
  return runs;
}

// Root mean square of the errors of ln depth at fresh points, and of the errors over what is stated.
struct FreshErrors {
  double error = 0, standardised = 0;
};
FreshErrors at_fresh_points(const Emulator& emulator, double h,
                            const std::function<double(const SphereInputs&)>& truth) {
  const auto at = box_points(200, 5000);
  const DepthAnswers answers = emulator.depth(at, h, true);
  FreshErrors sums;
  for (int i = 0; i < 200; ++i) {
    const double error = answers.log_depth[i] - truth(at[i]);
    sums.error += error * error / 200;
    sums.standardised += error * error / answers.covariance(i, i) / 200;
  }
  return {std::sqrt(sums.error), std::sqrt(sums.standardised)};
}

// Of the function without noise on the mesh of 0.1, at fresh points that `change` has been applied to.
double error_where(const Emulator& emulator, const std::function<void(SphereInputs&)>& change) {
  double sum = 0;
  for (SphereInputs point : box_points(50, 900)) {
    change(point);
    const double error = emulator.depth({point}, 0.1, false).log_depth[0] - smooth_depth(point) - mesh_part(point);
    sum += error * error / 50;
  }
  return std::sqrt(sum);
}

EmulatorSettings plausible_settings() {
  EmulatorSettings settings;
  settings.amplitude = 0.3;
  settings.length = {3, 4, 10, 1.5, 2, 5};
  settings.mesh_amplitude = 0.05;
  settings.mesh_length = {3, 4, 10, 1.5, 2, 5};
  settings.noise = 0.02;
  settings.noise_order = 0.5;
  return settings;
}

bool same_bits(const DepthAnswers& a, const DepthAnswers& b) {
  const auto same = [](const auto& x, const auto& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), sizeof(double) * x.size()) == 0;
  };
  return same(a.log_depth, b.log_depth) && same(a.gradient, b.gradient) && same(a.covariance, b.covariance);
}

TEST(Emulator, AKnownFunctionAndItsNoiseAreFound) {
  constexpr double noise = 0.02;
  Noise normal;
  const Emulator emulator(runs_of(box_points(200, 0), 0.1, noise, normal), EmulatorOptions{});
  EXPECT_NEAR(emulator.noise(0.1), noise,
              0.2 * noise);  // 200 runs know it to 5 %; what the surface takes, to a little more
  const auto truth = [](const SphereInputs& at) { return smooth_depth(at) + mesh_part(at); };
  const FreshErrors fresh = at_fresh_points(emulator, 0.1, truth);
  EXPECT_LT(fresh.error, noise);
  EXPECT_NEAR(fresh.standardised, 1, 0.35);
}

TEST(Emulator, LeaveOneOutStatesItsOwnError) {
  Noise normal;
  const Emulator emulator(runs_of(box_points(200, 0), 0.1, 0.02, normal), EmulatorOptions{});
  const LeaveOneOut left_out = emulator.leave_one_out();
  EXPECT_NEAR(left_out.standardised_deviation, 1, 0.12);  // 1/sqrt(2 N) is 0.05
  EXPECT_GE(left_out.coverage95, 0.91);
  EXPECT_LE(left_out.coverage95, 0.98);
  EXPECT_GT(left_out.root_mean_square, 0.02);
  EXPECT_LT(left_out.root_mean_square, 0.03);
}

// Without a length, and with the same one for all, an emulator is that of six inputs: to the bit, whatever the length.
TEST(Emulator, AnErosionLengthThatNoRunVariesIsNoInput) {
  Noise normal;
  const auto runs = three_meshes(0.02, normal);
  auto with_one_length = runs;
  for (TrainingRun& run : with_one_length) run.at.log_erosion_length = -1.3;
  const Emulator without(runs, EmulatorOptions{}), with(with_one_length, EmulatorOptions{});
  EXPECT_EQ(without.settings().inputs(), inputs_of_all);
  auto at = box_points(5, 300);
  const DepthAnswers expected = without.depth(at, 0.1, true);
  for (SphereInputs& point : at) point.log_erosion_length = -0.2;
  EXPECT_TRUE(same_bits(with.depth(at, 0.1, true), expected));
}

TEST(Emulator, LearnsWhatALengthDoes) {
  Noise normal;
  auto runs = runs_of(box_points(150, 0), 0.25, 0.01, normal);
  const auto of_length = [](double log_length) { return -0.3 * log_length - 0.1 * log_length * log_length; };
  const Eigen::MatrixXd places = sobol_points(150, 1, 77);
  for (int i = 0; i < 150; ++i) {
    runs[i].at.log_erosion_length = -2 + 2 * places(i, 0);
    runs[i].log_depth += of_length(runs[i].at.log_erosion_length);
  }
  const Emulator emulator(runs, EmulatorOptions{});
  EXPECT_EQ(emulator.settings().inputs(), inputs_without_covers);
  SphereInputs at = box_points(1, 300).front();
  at.log_erosion_length = -1;
  const DepthAnswers answer = emulator.depth({at}, 0.25, false);
  SphereInputs above = at, below = at;
  above.log_erosion_length += 1e-5;
  below.log_erosion_length -= 1e-5;
  const Eigen::VectorXd ends = emulator.depth({above, below}, 0.25, false).log_depth;
  const double slope = answer.gradient(0, index_of(&SphereInputs::log_erosion_length));
  EXPECT_NEAR(slope, (ends[0] - ends[1]) / 2e-5, 1e-6);
  EXPECT_NEAR(slope, -0.1, 0.05);
}

TEST(Emulator, GradientsAreDerivatives) {
  Noise normal;
  const Emulator emulator(three_meshes(0.02, normal), plausible_settings());
  for (const SphereInputs& at : box_points(5, 300))
    for (double h : {0.0, 0.07}) {
      const Eigen::MatrixXd gradient = emulator.depth({at}, h, false).gradient;
      for (int j = 0; j < sphere_inputs; ++j) {
        constexpr double step = 1e-5;
        SphereInputs above = at, below = at;
        above.*sphere_input_order[j] += step;
        below.*sphere_input_order[j] -= step;
        const Eigen::VectorXd ends = emulator.depth({above, below}, h, false).log_depth;
        EXPECT_NEAR(gradient(0, j), (ends[0] - ends[1]) / (2 * step), 1e-6) << "input " << j;
      }
    }
}

// The scales of the inputs and of the plane's prior come from the runs, and hardly change with one of them.
TEST(Emulator, LeaveOneOutIsWhatTrainingWithoutTheRunSays) {
  Noise normal;
  const auto runs = three_meshes(0.02, normal);
  const LeaveOneOut left_out = Emulator(runs, plausible_settings()).leave_one_out();
  for (std::size_t i = 0; i < runs.size(); i += 17) {
    auto others = runs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Emulator without(others, plausible_settings());
    const DepthAnswers answer = without.depth({runs[i].at}, runs[i].h, true);
    const double error = answer.log_depth[0] - runs[i].log_depth;
    EXPECT_NEAR(left_out.error[i], error, 1e-4) << i;
    EXPECT_NEAR(left_out.standardised[i],
                error / std::hypot(std::sqrt(answer.covariance(0, 0)), without.noise(runs[i].h)), 1e-2)
        << i;
  }
}

TEST(Emulator, AFewFineRunsCorrectTheCoarseOnes) {
  Noise normal;
  auto runs = runs_of(box_points(120, 0), 0.15, 0.01, normal);
  const auto truth = [](const SphereInputs& at) { return smooth_depth(at) + 0.5 * mesh_part(at); };
  const double coarse_alone = at_fresh_points(Emulator(runs, EmulatorOptions{}), 0.05, truth).error;
  append(runs, runs_of(box_points(20, 2000), 0.05, 0.01, normal));
  const double corrected = at_fresh_points(Emulator(runs, EmulatorOptions{}), 0.05, truth).error;
  EXPECT_GT(coarse_alone, 0.06);
  EXPECT_LT(corrected, 0.04);
}

TEST(Emulator, DepthsOnNoMeshAreWithinTheErrorStated) {
  Noise normal;
  const Emulator emulator(three_meshes(0.01, normal), EmulatorOptions{});
  EXPECT_NEAR(emulator.settings().mesh_order, 1, 0.4);
  const FreshErrors fresh = at_fresh_points(emulator, 0, smooth_depth);
  EXPECT_LT(fresh.error, 0.03);
  EXPECT_LT(fresh.standardised, 1.5);
}

TEST(Emulator, TheNoiseOfFineMeshesIsToldFromThatOfCoarseOnes) {
  Noise normal;
  auto runs = runs_of(box_points(150, 0), 0.15, 0.03, normal);
  append(runs, runs_of(box_points(150, 1000), 0.05, 0.01, normal));
  const Emulator emulator(runs, EmulatorOptions{});
  EXPECT_NEAR(emulator.noise(0.15), 0.03, 0.006);
  EXPECT_NEAR(emulator.noise(0.05), 0.01, 0.004);
}

TEST(Emulator, OneMeshLeavesNoMeshPart) {
  Noise normal;
  const Emulator emulator(runs_of(box_points(60, 0), 1.0 / 7, 0.02, normal), EmulatorOptions{});
  EXPECT_EQ(emulator.settings().mesh_amplitude, 0);
  EXPECT_EQ(emulator.noise(1.0 / 7), emulator.noise(1.0 / 20));
  const auto at = box_points(4, 500);
  EXPECT_TRUE(same_bits(emulator.depth(at, 1.0 / 7, true), emulator.depth(at, 0, true)));
}

TEST(Emulator, TheSameRunsGiveTheSameBits) {
  Noise normal;
  const auto runs = three_meshes(0.02, normal);
  const auto at = box_points(6, 700);
  const DepthAnswers first = Emulator(runs, EmulatorOptions{}).depth(at, 0.05, true);
  const DepthAnswers second = Emulator(runs, EmulatorOptions{}).depth(at, 0.05, true);
  EXPECT_TRUE(same_bits(first, second));
}

TEST(Emulator, AnInputThatNeverVariesDoesNoHarm) {
  const auto hold = [](SphereInputs& point) { point.log_layer_depth = 4.5, point.log_pi5 = -1; };
  Noise normal;
  auto at = box_points(120, 0);
  for (SphereInputs& point : at) hold(point);
  const Emulator emulator(runs_of(at, 0.1, 0.01, normal), EmulatorOptions{});
  EXPECT_LT(error_where(emulator, hold), 0.03);
}

TEST(Emulator, AnInputThatFollowsAnotherDoesNoHarm) {
  const auto follow = [](SphereInputs& point) { point.log_bulk_ratio = std::max(std::log(50.0), point.log_pi4 + 2.4); };
  Noise normal;
  auto at = box_points(120, 0);
  for (SphereInputs& point : at) follow(point);
  const Emulator emulator(runs_of(at, 0.1, 0.01, normal), EmulatorOptions{});
  EXPECT_LT(error_where(emulator, follow), 0.03);
}

TEST(Emulator, TooFewRunsAndNumbersThatAreNoneAreRefused) {
  Noise normal;
  auto runs = runs_of(box_points(12, 0), 0.1, 0.02, normal);
  const Emulator smallest(runs, EmulatorOptions{});
  EXPECT_TRUE(std::isfinite(smallest.depth({runs[3].at}, 0.1, true).covariance(0, 0)));
  auto broken = runs;
  broken[4].log_depth = std::nan("");
  EXPECT_THROW(Emulator(broken, EmulatorOptions{}), BadInput);
  broken = runs;
  broken[4].at.erosion_strain = 0;
  EXPECT_THROW(Emulator(broken, EmulatorOptions{}), BadInput);
  runs.pop_back();
  EXPECT_THROW(Emulator(runs, EmulatorOptions{}), BadInput);
}

TEST(Emulator, RunsThatAllSayTheSameAreLearntAsThat) {
  std::vector<TrainingRun> runs;
  for (const SphereInputs& at : box_points(40, 0)) runs.push_back({at, 0.1, 2.5});
  EXPECT_NEAR(Emulator(runs, EmulatorOptions{}).depth(box_points(1, 77), 0.1, false).log_depth[0], 2.5, 1e-6);
}

// ---- the choice of the next runs ---------------------------------------------------------------------------------

struct Choice {
  std::vector<TrainingRun> runs;
  std::vector<Emulator::CandidateRun> candidates;
  std::vector<SphereInputs> targets = box_points(3, 4000);
  std::vector<double> weights{1, 0.7, 1.3};
};

Choice some_choice() {
  Choice choice;
  Noise normal;
  choice.runs = runs_of(box_points(60, 0), 0.15, 0.02, normal);
  append(choice.runs, runs_of(box_points(10, 200), 0.05, 0.02, normal));
  // Four about each target: what one of them tells, the others need not.
  for (int i = 0; i < 12; ++i) {
    SphereInputs at = choice.targets[i % 3];
    at.log_pi4 += 0.25 * (i / 3);
    at.log_pi5 += 0.3 * (i % 2);
    choice.candidates.push_back({at, i < 3 ? 0.05 : 0.15, i < 3 ? 3.0 : 1.0});
  }
  return choice;
}

// Noise so small, and surfaces so wavy, that a run says all about its place and little about others.
EmulatorSettings wavy_settings() {
  EmulatorSettings settings = plausible_settings();
  settings.noise = 0.002;
  settings.length = {1, 1.5, 4, 0.6, 1, 2};
  return settings;
}

double variance_left(const Choice& choice, const std::vector<TrainingRun>& runs) {
  const DepthAnswers answers = Emulator(runs, wavy_settings()).depth(choice.targets, 0.05, true);
  double sum = 0;
  for (int t = 0; t < 3; ++t) sum += choice.weights[t] * answers.covariance(t, t);
  return sum;
}

TEST(EmulatorChoice, EachRunIsTheOneThatLowersTheVarianceMostForItsCost) {
  const Choice choice = some_choice();
  const Emulator emulator(choice.runs, wavy_settings());
  const auto chosen = emulator.choose(choice.candidates, 9, choice.targets, choice.weights, 0.05);
  std::vector<TrainingRun> runs = choice.runs;
  std::vector<int> expected;
  for (int round = 0; round < 9; ++round) {
    const double before = variance_left(choice, runs);
    double best_gain = -1;
    int best = -1;
    for (int c = 0; c < static_cast<int>(choice.candidates.size()); ++c) {
      if (std::ranges::count(expected, c)) continue;
      const auto& candidate = choice.candidates[c];
      auto with = runs;
      with.push_back({candidate.at, candidate.h, smooth_depth(candidate.at)});
      const double gain = (before - variance_left(choice, with)) / candidate.cost;
      if (gain > best_gain) best_gain = gain, best = c;
    }
    expected.push_back(best);
    runs.push_back({choice.candidates[best].at, choice.candidates[best].h, smooth_depth(choice.candidates[best].at)});
  }
  EXPECT_EQ(chosen, expected);
}

TEST(EmulatorChoice, OfEqualRunsTheFirstIsTaken) {
  Choice choice = some_choice();
  choice.candidates.assign(5, choice.candidates[1]);
  const Emulator emulator(choice.runs, wavy_settings());
  EXPECT_EQ(emulator.choose(choice.candidates, 3, choice.targets, choice.weights, 0.05), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(emulator.choose(choice.candidates, 9, choice.targets, choice.weights, 0.05).size(), 5u);
}

TEST(EmulatorChoice, ARunThatIsTooDearIsNotTakenFirst) {
  Choice choice = some_choice();
  const Emulator emulator(choice.runs, wavy_settings());
  const int first = emulator.choose(choice.candidates, 1, choice.targets, choice.weights, 0.05)[0];
  choice.candidates[first].cost *= 1e6;
  EXPECT_NE(emulator.choose(choice.candidates, 1, choice.targets, choice.weights, 0.05)[0], first);
}

TEST(EmulatorSearch, AllFineRunsAreInTheSubsetAsFarAsTheyFit) {
  std::vector<TrainingRun> runs(300);
  for (int i = 0; i < 300; ++i) runs[i].h = i % 5 == 0 ? 0.05 : 0.15;
  const auto chosen = runs_for_search(runs, 100);
  EXPECT_EQ(chosen.size(), 100u);
  EXPECT_TRUE(std::ranges::is_sorted(chosen));
  EXPECT_EQ(std::ranges::count_if(chosen, [](int i) { return i % 5 == 0; }), 50);
  EXPECT_EQ(std::ranges::count_if(runs_for_search(runs, 200), [](int i) { return i % 5 == 0; }), 60);
  EXPECT_EQ(runs_for_search(runs, 500).size(), 300u);
}

}  // namespace
}  // namespace percal
