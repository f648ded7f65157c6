#include "percal/atlas/atlas.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "percal/atlas/check.hpp"
#include "percal/base/error.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/math/draws.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

// Reach goes as a power of everything, with a scatter of 2 %.
TrainingRun made_up_run(const Eigen::RowVectorXd& shares, double scatter) {
  TrainingRun run{.at = {.log_pi4 = 1 + 4 * shares[0],
                         .log_pi5 = -2 * shares[1],
                         .alpha = 2 + 10 * shares[2],
                         .erosion_strain = 0.3 + shares[3],
                         .log_layer_depth = 4.3,
                         .log_bulk_ratio = 4},
                  .h = 0.1 + 0.1 * shares[4]};
  run.log_depth = 0.6 * run.at.log_pi4 - run.at.log_pi5 - 0.05 * run.at.alpha - 0.7 * run.at.erosion_strain + scatter;
  return run;
}

Atlas made_up_atlas(int count = 500) {
  Atlas atlas{.name = "made up", .setting = "none"};
  const Eigen::MatrixXd points = sobol_points(count, 5, 0);
  Draws draws(1);
  for (int k = 0; k < count; ++k) atlas.runs.push_back(made_up_run(points.row(k), 0.02 * draws.normal()));
  return atlas;
}

TEST(Atlas, ComesBackFromItsText) {
  const Atlas atlas = made_up_atlas(20);
  const Atlas read = parse_atlas(atlas_text("a setting with spaces=1", atlas.runs), "made_up.csv");
  EXPECT_EQ(read.setting, "a setting with spaces=1");
  ASSERT_EQ(read.runs.size(), atlas.runs.size());
  for (std::size_t k = 0; k < read.runs.size(); ++k) {
    EXPECT_LT((in_order(read.runs[k].at) - in_order(atlas.runs[k].at)).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_NEAR(read.runs[k].log_depth, atlas.runs[k].log_depth, 1e-4);
    EXPECT_NEAR(read.runs[k].h, atlas.runs[k].h, 1e-4);
  }
  EXPECT_EQ(atlas_text(read.setting, read.runs), atlas_text("a setting with spaces=1", atlas.runs));
}

TEST(Atlas, ATextThatIsNoneIsRefusedWithItsLine) {
  const auto refusal = [](const std::string& text) {
    try {
      parse_atlas(text, "a.csv");
    } catch (const BadInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string good = atlas_text("s", made_up_atlas(3).runs);
  EXPECT_EQ(refusal(good), "");
  EXPECT_THAT(refusal(good.substr(good.find("pi4"))), HasSubstr("setting"));
  std::string short_of = good, negative = good;
  short_of.replace(short_of.find(",reach"), 6, ",depth");
  EXPECT_THAT(refusal(short_of), HasSubstr("reach"));
  negative.replace(negative.rfind(',') + 1, 1, "-");
  EXPECT_THAT(refusal(negative), HasSubstr("a.csv:7"));
}

TEST(Atlas, TheNearestRunsKeepTheirOrder) {
  const Atlas atlas = made_up_atlas(50);
  const auto nearest = nearest_runs(atlas.runs, 10, [&](const TrainingRun& run) { return std::abs(run.at.alpha - 6); });
  ASSERT_EQ(nearest.size(), 10);
  for (const TrainingRun& run : nearest) EXPECT_LT(std::abs(run.at.alpha - 6), 1.5);
  EXPECT_EQ(nearest_runs(atlas.runs, 1000, [](const TrainingRun&) { return 0.0; }).size(), 50);
}

// What calibrations and scenes run by default, with the wall at 20 radii. After a change of the solver: percal atlas check, and data/atlas/README.md.
TEST(Atlas, TheOneThatPercalCarriesIsOfTheDefaultSetting) {
  Scene scene;
  scene.particle = {.radius = 1e-3, .density = 7800, .speed = 100};
  scene.target.density = 1000;
  scene.target.mu_as_given = 3e5;
  scene.target.alpha = 8;
  scene.target.depth = 0.075;
  scene.target.width = 0.02;
  scene.target.erosion = StrainErosion{0.8};
  const Problem problem = reduce(scene).problem;
  const Atlas* atlas = own_atlas(setting_of(problem));
  ASSERT_TRUE(atlas);
  EXPECT_GT(atlas->runs.size(), 2000);
  EXPECT_FALSE(own_atlas("another"));
  // A run of it as a problem, and back.
  const TrainingRun& run = atlas->runs[7];
  const Problem again = problem_of(atlas->setting, run);
  EXPECT_EQ(setting_of(again), atlas->setting);
  EXPECT_LT((in_order(training_run(again, 1).at) - in_order(run.at)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(element_size(again), run.h, 1e-9);
}

TEST(Atlas, AnswersNearAPlaceWithItsError) {
  const Atlas atlas = made_up_atlas();
  const Eigen::RowVectorXd middle = Eigen::RowVectorXd::Constant(5, 0.5);
  const TrainingRun wanted = made_up_run(middle, 0);
  const Emulator near = emulator_near(atlas, wanted.at);
  EXPECT_NEAR(near.depth({wanted.at}, wanted.h, false).log_depth[0], wanted.log_depth, 0.01);
  EXPECT_NEAR(near.noise(wanted.h), 0.02, 0.006);
}

TEST(AtlasCheck, HoldsWhereItsErrorsAreWhatItSays) {
  std::vector<CheckedPoint> points(100);
  Draws draws(3);
  for (CheckedPoint& point : points) {
    point.deviation = 0.03;
    point.log_depth = 0.03 * draws.normal();
  }
  const AtlasAgreement good = agreement(points);
  EXPECT_TRUE(holds(good));
  EXPECT_NEAR(good.standardised, 1, 0.2);
  EXPECT_NEAR(good.root_mean_square, 0.03, 0.006);
  for (CheckedPoint& point : points) point.log_depth += 0.06;  // another solver
  EXPECT_FALSE(holds(agreement(points)));
  EXPECT_TRUE(holds(agreement({})));
}

TEST(SlowAtlasCheck, TheSolverIsTheOneThatMadeIt) {
  Campaign campaign(nullptr, 2);
  Progress silent;
  for (const Atlas& atlas : own_atlases()) {
    const AtlasAgreement found = agreement(check_atlas(atlas, 40, campaign, silent));
    EXPECT_GE(found.points, 35);
    EXPECT_TRUE(holds(found)) << atlas.name << ": " << found.within95 << " of " << found.points;
  }
}

}  // namespace
}  // namespace percal
