#include "percal/calibrate/best_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "calibrate/small_job.hpp"
#include "percal/calibrate/cards.hpp"
#include "percal/calibrate/layer_width.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/scene/solver_words.hpp"

namespace percal {
namespace {

using BestScenes = calibrate_test::SmallJob;

// An erosion strain belongs to the element size that it was found with.
TEST_F(BestScenes, AreTheShotsOnTheMeshOfTheFreshRuns) {
  const CalibrationJob job = read_job();
  const auto scenes = best_scenes(job, calibrate_test::made_up_result(job));
  ASSERT_EQ(scenes.size(), job.shots.size()) << "one hypothesis was fitted";
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Scene scene = parse_scene(scene_to_toml(scenes[i].scene, "found"), scenes[i].name);
    EXPECT_EQ(scene.mesh.elements_per_radius, job.training.verify);
    EXPECT_EQ(scene.replicates, usual_replicates);
    EXPECT_EQ(scene.particle.radius, job.shots[i].radius);
    EXPECT_EQ(scene.particle.speed, job.shots[i].speed);
    const Problem problem = reduce(scene).problem;
    EXPECT_NEAR(problem.width, 5, 1e-9);
    EXPECT_EQ(problem.arithmetic, Arithmetic::double_precision);
  }
  EXPECT_NEAR(std::get<StrainErosion>(scenes[0].scene.target.erosion).limit, 0.9, 1e-12);
}

// For whoever uses the erosion strain in another program.
TEST_F(BestScenes, HaveTheNumericsThatTheCardsSay) {
  const CalibrationJob job = read_job();
  const CalibrationResult result = calibrate_test::made_up_result(job);
  const auto cards = calibration_cards(job, result.hypotheses[0]);
  ASSERT_FALSE(cards.empty());
  const std::string said = "its runs had " + in_words(best_scenes(job, result)[0].scene.solver);
  EXPECT_EQ(std::ranges::count(cards[0].comments, said), 1);
}

TEST_F(BestScenes, OfAJobWithoutAWidthAreAsWideAsAnyShotNeeds) {
  const CalibrationJob given = read_job();
  EXPECT_FALSE(given.width_was_chosen);
  for (const MeasuredShot& shot : given.shots) EXPECT_NEAR(shot.layer_width, 5 * shot.radius, 1e-12);
  const CalibrationJob chosen = read_job({{"layer_width_radii = 5\n", ""}});
  EXPECT_TRUE(chosen.width_was_chosen);
  for (const MeasuredShot& shot : chosen.shots) EXPECT_NEAR(shot.layer_width, 20 * shot.radius, 1e-12);
  EXPECT_EQ(width_needed(given),
            20);  // the lead ball at 50 m/s into 10 kPa: pi4 = 250, and more than ten times as dense
}

}  // namespace
}  // namespace percal
