// Targets of several layers: how a job says them, what a shot into one meets, and what depths tell of a cover.
#include <gmock/gmock.h>

#include "calibrate/gel_job.hpp"
#include "calibrate/small_job.hpp"
#include "percal/calibrate/best_scenes.hpp"
#include "percal/calibrate/kept_model.hpp"
#include "percal/calibrate/run_sizes.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/predict/predictor.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

constexpr double mesh_of_layers = 0.1;
enum { gel_mu, gel_alpha, gel_strain, skin_mu, skin_strain };
const std::vector<double> true_layers{200e3, 8, 0.8, 2e6, 0.5};

// A cover takes energy off the sphere by its thickness and by what it costs to erode it.
double layered_law(const SphereInputs& at) {
  double depth = test::smooth_law(at);
  for (const CoverMembers& cover : cover_members) {
    if (at.*cover.depth == 0) continue;
    const double energy = at.*cover.log_mu + log_erosion_energy(at.*cover.alpha, at.*cover.strain).value -
                          log_erosion_energy(at.alpha, at.erosion_strain).value;
    depth -= at.*cover.depth * (0.1 + 0.15 * energy + 0.1 * (at.*cover.strain - at.erosion_strain)) *
             (1 - 0.1 * (at.log_pi4 - 3));
  }
  return depth;
}

// Bare, under 1 mm and under 3 mm of skin, in turn.
CalibrationJob job_with_layers(int shots = 18) {
  CalibrationJob job = test::gel_job(shots);
  job.training.verify = 1 / mesh_of_layers;
  job.parameters.push_back({ParameterKind::modulus, {.name = "mu_skin", .unit = "Pa", .low = 2e5, .high = 2e7}});
  job.parameters.push_back({ParameterKind::erosion_strain, {.name = "strain_skin", .unit = "", .low = 0.2, .high = 1}});
  job.materials.push_back({.name = "skin",
                           .density = 1100,
                           .mu = SharedParameter{skin_mu},
                           .alpha = 9.0,
                           .erosion_strain = SharedParameter{skin_strain},
                           .rate_factor = {},
                           .curve_modulus = {}});
  job.targets = {{.name = "gel", .material = 0},
                 {.name = "skin", .material = 1},
                 {.name = "thin", .material = 0, .covers = {{1, 1e-3}}},
                 {.name = "thick", .material = 0, .covers = {{1, 3e-3}}}};
  job.hypotheses[0].held = {{gel_alpha, 8.0}};
  constexpr int in_turn[] = {0, 2, 3};
  for (int k = 0; k < shots; ++k) job.shots[k].target = in_turn[k % 3];
  return job;
}

void measure_layers(CalibrationJob& job, double scatter, unsigned seed) {
  Draws draws(seed);
  for (MeasuredShot& shot : job.shots) {
    const auto at = shot_inputs(shot, target_at(job, job.hypotheses[0], job.targets[shot.target], true_layers)).at;
    shot.depth = shot.radius * std::exp(layered_law(at) + scatter * draws.normal());
  }
}

// Of runs at numbers drawn from the parameters' boxes, as a calibration makes them.
const Emulator& emulator_of_layers() {
  static const Emulator emulator = [] {
    const CalibrationJob job = job_with_layers();
    const auto points = sobol_points(300, static_cast<int>(job.parameters.size()) + 1, 1);
    Draws draws(1);
    std::vector<TrainingRun> runs;
    for (int k = 0; k < 300; ++k) {
      std::vector<double> natural;
      for (std::size_t j = 0; j < job.parameters.size(); ++j) {
        const FreeParameter& p = job.parameters[j].free;
        const double low = p.searched(p.low), high = p.searched(p.high);
        natural.push_back(p.natural(low + (high - low) * points(k, static_cast<Eigen::Index>(j))));
      }
      const MeasuredShot& shot = job.shots[static_cast<std::size_t>(points(k, 5) * 18)];
      const auto at = shot_inputs(shot, target_at(job, job.hypotheses[0], job.targets[shot.target], natural)).at;
      runs.push_back({at, mesh_of_layers, layered_law(at) + 0.002 * draws.normal()});
    }
    return Emulator(runs, EmulatorOptions{});
  }();
  return emulator;
}

TEST(Layers, TheModelsDerivativesAreThoseOfItsValues) {
  CalibrationJob job = job_with_layers();
  job.hypotheses[0].held.clear();
  job.targets.push_back({.name = "both", .material = 0, .covers = {{1, 1e-3}, {0, 2e-3}}});
  job.shots[5].target = 4;
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulator_of_layers(), mesh_of_layers);
  Eigen::VectorXd at(5);
  for (int k = 0; k < 5; ++k) at[k] = model.parameters[k].searched(true_layers[k]);
  const ModelAnswer answer = model.log_depths(at, job.shots, Want::values);
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(5, k);
    const Eigen::VectorXd difference = (model.log_depths(at + step, job.shots, Want::values).value -
                                        model.log_depths(at - step, job.shots, Want::values).value) /
                                       2e-5;
    EXPECT_LT((answer.jacobian.col(k) - difference).cwiseAbs().maxCoeff(), 1e-5) << model.parameters[k].name;
  }
  std::vector<MeasuredShot> faster = job.shots, slower = job.shots;
  for (std::size_t i = 0; i < job.shots.size(); ++i)
    faster[i].speed *= std::exp(1e-5), slower[i].speed *= std::exp(-1e-5);
  const Eigen::VectorXd by_speed =
      (model.log_depths(at, faster, Want::values).value - model.log_depths(at, slower, Want::values).value) / 2e-5;
  EXPECT_LT((model.speed_exponents(at, job.shots) - by_speed).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Layers, AShotsInputsAreThoseOfItsRun) {
  const CalibrationJob job = job_with_layers();
  for (const MeasuredShot& shot : job.shots) {
    const CoveredMaterial target = target_at(job, job.hypotheses[0], job.targets[shot.target], true_layers);
    constexpr double rows_to_the_faces = 79.5;  // elements per radius: 1 mm and 3 mm are whole numbers of them
    const Problem problem = shot_problem(job, shot, target, rows_to_the_faces * shot.radius / 1.59e-3);
    const Eigen::VectorXd rounding = in_order(shot_inputs(shot, target).at) - in_order(inputs_of(problem));
    EXPECT_LT(rounding.cwiseAbs().maxCoeff(), 1e-9) << shot.label << ": " << rounding.transpose();
    EXPECT_NEAR(problem.whole_depth(), shot.layer_depth / shot.radius, 1e-9);
  }
}

// Of a cover depths tell little more than what it costs to pass: its modulus where its strain is known, both far less well.
TEST(Layers, AModulusIsFoundWhereTheStrainIsKnown) {
  CalibrationJob job = job_with_layers();
  measure_layers(job, 0.01, 3);
  const auto interval_of_skin = [&](const Hypothesis& hypothesis) {
    const JobModel model = finite_element_model(job, hypothesis, emulator_of_layers(), mesh_of_layers);
    const JobFit fit = fit_job(job, model, used_shots(job), thorough_search());
    const auto intervals = region_intervals(fit.problem, fit.minima, 0.95, thorough_search());
    const auto place = std::ranges::find(model.of_job, static_cast<int>(skin_mu)) - model.of_job.begin();
    return std::ranges::find(intervals, place, &ProfileInterval::parameter)->interval;
  };
  Hypothesis known = job.hypotheses[0];
  known.held[gel_strain] = true_layers[gel_strain];
  known.held[skin_strain] = true_layers[skin_strain];
  const Interval free = interval_of_skin(job.hypotheses[0]), held = interval_of_skin(known);
  EXPECT_LT(held.low, true_layers[skin_mu]);
  EXPECT_GT(held.high, true_layers[skin_mu]);
  EXPECT_LT(held.high / held.low, 3);
  EXPECT_LT(free.low, true_layers[skin_mu]);
  EXPECT_GT(free.high, true_layers[skin_mu]);
  EXPECT_GT(free.high / free.low, 1.5 * held.high / held.low);
}

// The parameters of each truth drawn anew, from the emulator itself: a `seed` for each set of truths.
class SlowLayersCoverage : public testing::TestWithParam<unsigned> {};
TEST_P(SlowLayersCoverage, IntervalsHoldTheTruth) {
  const CalibrationJob job = job_with_layers();
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulator_of_layers(), mesh_of_layers);
  const auto count = static_cast<Eigen::Index>(model.parameters.size());
  const std::vector<double> low{120e3, 8, 0.5, 8e5, 0.35}, high{400e3, 8, 1.1, 6e6, 0.75};
  Draws draws(GetParam());
  std::vector<int> held(model.parameters.size());
  for (int truth = 0; truth < 100; ++truth) {
    CalibrationJob shot = job;
    Eigen::VectorXd at(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const FreeParameter& p = model.parameters[k];
      const double a = p.searched(low[model.of_job[k]]), b = p.searched(high[model.of_job[k]]);
      at[k] = a + (b - a) * draws.uniform();
    }
    const Eigen::VectorXd depths = model.log_depths(at, shot.shots, Want::values).value;
    for (std::size_t i = 0; i < shot.shots.size(); ++i)
      shot.shots[i].depth = std::exp(depths[static_cast<Eigen::Index>(i)] + 0.03 * draws.normal());
    const JobFit fit = fit_job(shot, model, used_shots(shot), quick_search());
    for (const ProfileInterval& one : region_intervals(fit.problem, fit.minima, 0.95, quick_search())) {
      const double value = model.parameters[one.parameter].natural(at[one.parameter]);
      held[one.parameter] += value >= one.interval.low && value <= one.interval.high;
    }
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    EXPECT_GE(held[k], 89) << model.parameters[k].name;
    EXPECT_LE(held[k], 100) << model.parameters[k].name;
    RecordProperty(model.parameters[k].name, held[k]);
  }
}
INSTANTIATE_TEST_SUITE_P(Slow, SlowLayersCoverage, testing::Values(17u));

TEST(Layers, AKeptModelAnswersAsBefore) {
  CalibrationJob job = job_with_layers();
  measure_layers(job, 0.01, 3);
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulator_of_layers(), mesh_of_layers);
  const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
  CalibrationResult result;
  result.hypotheses.resize(1);
  result.hypotheses[0].for_shots = for_shots(job, 0, model, fit);
  const auto kept = kept_model(job, emulator_of_layers(), result);
  ASSERT_TRUE(kept);
  const page::Json json{{"command", "calibrate"}, {"shot_model", shot_model_to_json(*kept)}};
  const ShotModel read = shot_model_of(page::Json::parse(json.dump()), "result.json");
  ASSERT_EQ(read.hypotheses[0].materials.size(), 4u);
  EXPECT_EQ(read.hypotheses[0].materials[3].name, "thick");
  EXPECT_EQ(read.hypotheses[0].materials[3].points.front().covers.at(0).thickness, 3e-3);
  const std::vector<SphereShot> shots{job.shots[5]};
  ASSERT_EQ(job.shots[5].target, 3);
  const double predicted = Predictor(read, 0, 3, 0.95).best_depths(shots)[0];
  EXPECT_NEAR(std::log(predicted), model.log_depths(fit.at, std::span(job.shots).subspan(5, 1), Want::values).value[0],
              1e-9);
  EXPECT_GT(Predictor(read, 0, 0, 0.95).best_depths(shots)[0], predicted) << "bare gel";
}

using calibrate_test::layers_of_a_job;

class JobsWithTargets : public calibrate_test::SmallJob {
 protected:
  using Changes = std::vector<std::pair<std::string, std::string>>;
  CalibrationJob read_with(const std::string& targets, Changes changes = {}) const {
    changes.insert(changes.begin(),
                   {{"[materials.soft]", targets + "\n[materials.soft]"},
                    {"name = \"by hand\"\nmaterial = \"hard\"", "name = \"by hand\"\ntarget = \"dressed\""}});
    return read_job(changes);
  }
  std::string refusal(const std::string& targets, const Changes& changes = {}) const {
    try {
      read_with(targets, changes);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(JobsWithTargets, AreReadFromTheTopDown) {
  const CalibrationJob job = read_with(layers_of_a_job);
  ASSERT_EQ(job.targets.size(), job.materials.size() + 1);
  const CalibrationTarget& dressed = job.targets.back();
  ASSERT_EQ(dressed.covers.size(), 2u);
  EXPECT_EQ(job.materials[dressed.covers[1].material].name, "soft");
  EXPECT_DOUBLE_EQ(dressed.covers[1].thickness, 0.5e-3);
  EXPECT_FALSE(job.dehn);
  EXPECT_TRUE(read_job().dehn);
}

TEST_F(JobsWithTargets, BestScenesHaveTheirLayersByName) {
  const CalibrationJob job = read_with(layers_of_a_job);
  const auto scenes = best_scenes(job, calibrate_test::made_up_result(job));
  const Scene scene = parse_scene(scene_to_toml(scenes.back().scene, "found"), "found");
  EXPECT_EQ(scene.target.name, "soft");
  ASSERT_EQ(scene.below.size(), 2u);
  EXPECT_EQ(scene.below[0].name, "hard");
  EXPECT_EQ(scene.below[1].name, "hard");
  EXPECT_DOUBLE_EQ(scene.target.depth, 0.5e-3);
  EXPECT_DOUBLE_EQ(scene.below[0].depth, 2e-3);
  EXPECT_NEAR(scene.below[1].depth, 37.5e-3, 1e-12);
}

TEST_F(JobsWithTargets, WhatCannotBeIsRefused) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = layers_of_a_job;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THAT(refusal(with("material = \"soft\"", "material = \"sofft\"")), HasSubstr("\"sofft\""));
  EXPECT_THAT(refusal(with("[targets.dressed]", "[targets.soft]")), HasSubstr("the name of a material"));
  EXPECT_THAT(refusal(with("2 mm", "0 mm")), HasSubstr("thickness"));
  EXPECT_THAT(refusal(with("2 mm", "39 mm")), HasSubstr("more than a radius below the covers"));
  EXPECT_THAT(
      refusal(std::string(layers_of_a_job) + "[[targets.dressed.covers]]\nmaterial = \"soft\"\nthickness = \"1 mm\"\n"),
      HasSubstr("3 of them"));
  EXPECT_THAT(refusal("[targets.dressed]\nmaterial = \"hard\"\n"), HasSubstr("covers"));
  EXPECT_THAT(refusal(layers_of_a_job, {{"target = \"dressed\"", "material = \"hard\""}}),
              HasSubstr("a target without shots"));
  EXPECT_THAT(refusal(layers_of_a_job, {{"target = \"dressed\"", "target = \"undressed\""}}),
              HasSubstr("soft, hard, dressed"));
  EXPECT_THAT(refusal(layers_of_a_job, {{"target = \"dressed\"", "target = \"dressed\"\nmaterial = \"hard\""}}),
              HasSubstr("one of the two"));
  EXPECT_THAT(refusal(layers_of_a_job, {{"level = 0.9", "level = 0.9\ndehn = true"}}),
              HasSubstr("the closed form knows one layer"));
}

TEST_F(JobsWithTargets, ACoverThinnerThanTwoElementsIsRefused) {
  const CalibrationJob job = read_with(layers_of_a_job);
  try {
    largest_run(job);
    FAIL() << "0.5 mm at four elements in a millimetre";
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("coarse = 5 or more"));
  }
  EXPECT_NO_THROW(largest_run(read_with(layers_of_a_job, {{"coarse = 4", "coarse = 5"}})));
}

}  // namespace
}  // namespace percal
