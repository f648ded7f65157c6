#include "percal/study/ladder.hpp"

#include <gtest/gtest.h>

#include "percal/base/error.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/kept_ladder.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

Scene gold() { return read_scene(PERCAL_DATA "/guha2009/gold.toml"); }
LadderOptions ladder(std::vector<double> meshes, int replicates) {
  return {.meshes = std::move(meshes), .replicates = replicates, .time_step_factor = std::nullopt};
}
const LadderOptions tiny = ladder({4, 2, 3, 1, 3}, 3);

class LadderTest : public testing::Test, protected test::TemporaryFolder {
 protected:
  Store store{path("percal.store")};
};

TEST_F(LadderTest, RunsEveryMeshTwoHalfStepsAndOneInDouble) {
  Scene scene = gold();
  scene.solver.end_time = 2e-9;  // about a radius: these runs are not to stop
  Campaign campaign(&store, 1);
  const Ladder ladder = run_ladder(scene, tiny, campaign, nullptr);
  EXPECT_EQ(ladder.options.meshes, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(ladder.refinement, Refinement::no_limit);
  EXPECT_EQ(ladder.scene_mesh, 14);
  ASSERT_EQ(ladder.meshes.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(ladder.meshes[i].elements_per_radius, i + 1);
    EXPECT_EQ(ladder.meshes[i].replicates, 3);
    EXPECT_EQ(ladder.meshes[i].penetration.outcomes.size(), 3u);
    EXPECT_EQ(ladder.meshes[i].arithmetic, Arithmetic::single_precision);
  }
  ASSERT_EQ(ladder.half_steps.size(), 2u);
  for (const Rung& half : ladder.half_steps) {
    EXPECT_EQ(half.time_step_factor, gold().solver.time_step_factor / 2);
    EXPECT_NEAR(half.steps / ladder.on_mesh(half.elements_per_radius).steps, 2, 0.3);
  }
  EXPECT_EQ(ladder.double_precision.arithmetic, Arithmetic::double_precision);
  EXPECT_EQ(campaign.cost().runs, ladder_runs(ladder.options));
  Campaign again(&store, 1);
  EXPECT_EQ(run_ladder(scene, tiny, again, nullptr).meshes[2].penetration.depths, ladder.meshes[2].penetration.depths);
  EXPECT_EQ(again.cost().runs, 0) << "all from the store";
}

TEST_F(LadderTest, RefusesFewerThanFourMeshesAndThreeReplicates) {
  EXPECT_THROW(checked(ladder({5, 5, 7, 10}, 5), gold()), BadInput);
  EXPECT_THROW(checked(ladder({0, 5, 7, 10}, 5), gold()), BadInput);
  EXPECT_THROW(checked(ladder({5, 7, 10, 14}, 2), gold()), BadInput);
  EXPECT_EQ(checked({}, gold()).time_step_factor, gold().solver.time_step_factor);
}

TEST_F(LadderTest, DepthsConvergeWithoutErosionOrOverALength) {
  Scene scene = gold();
  EXPECT_EQ(refinement(scene), Refinement::no_limit);
  scene.target.erosion_average = AverageWithin{0.5 * scene.particle.radius};
  EXPECT_EQ(refinement(scene), Refinement::second_order);
  scene.target.erosion_average = NoAverage{};
  scene.target.erosion = NoErosion{};
  EXPECT_EQ(refinement(scene), Refinement::any_order);
}

TEST_F(LadderTest, BeginsWithThreeElementsInAnErosionLength) {
  Scene scene = gold();
  EXPECT_EQ(usual_ladder(scene).meshes, LadderOptions{}.meshes);
  scene.target.erosion_average = AverageWithin{0.3 * scene.particle.radius};
  EXPECT_EQ(usual_ladder(scene).meshes, (std::vector<double>{10, 14, 20, 27}));
  scene.target.erosion_average = AverageWithin{0.1 * scene.particle.radius};
  EXPECT_EQ(usual_ladder(scene).meshes, (std::vector<double>{30, 42, 59, 82})) << "four at least";
  EXPECT_THROW(checked(ladder({10, 30, 42, 59}, 3), scene), BadInput);
}

TEST_F(LadderTest, GradedColumnsThatAreCountedOutGrowAlikeOnEveryMesh) {
  Scene scene = gold();
  scene.mesh.graded_columns = 7;  // beside 14 elements per radius
  const double growth = reduce(scene).mesh.growth;
  EXPECT_EQ(rung_scene(scene, 14, 0.8, Arithmetic::single_precision).mesh.graded_columns, 7);
  for (const double mesh : {9.5, 28.0, 50.0}) {
    Scene rung = rung_scene(scene, mesh, 0.8, Arithmetic::single_precision);
    EXPECT_LE(reduce(rung).mesh.growth, growth) << mesh;
    --*rung.mesh.graded_columns;
    EXPECT_GT(reduce(rung).mesh.growth, growth) << mesh;
  }
  scene.mesh.graded_columns.reset();
  EXPECT_FALSE(rung_scene(scene, 28, 0.8, Arithmetic::single_precision).mesh.graded_columns.has_value());
}

TEST_F(LadderTest, TheStudyOfASceneIsFoundWhateverItsMeshStepAndArithmetic) {
  Scene other = gold();
  other.mesh.elements_per_radius = 30;
  other.solver.time_step_factor = 0.3;
  other.solver.arithmetic = Arithmetic::double_precision;
  other.replicates = 9;
  other.output.history = true;
  EXPECT_EQ(study_key(other), study_key(gold()));
  other.mesh.fine_width = 0.8;
  EXPECT_NE(study_key(other), study_key(gold()));
  other = gold();
  other.particle.speed *= 1.01;
  EXPECT_NE(study_key(other), study_key(gold()));
}

TEST_F(LadderTest, TheNewestStudyIsTheOneThatIsKept) {
  const std::string key = study_key(gold());
  EXPECT_FALSE(kept_ladder(store, key).has_value());
  const LadderOptions first = checked({}, gold()), second = checked(tiny, gold());
  keep_ladder(store, key, first);
  EXPECT_EQ(kept_ladder(store, key), first);
  keep_ladder(store, key, second);
  EXPECT_EQ(kept_ladder(store, key), second);
  keep_ladder(store, key, second);
  EXPECT_EQ(store.size(), 2) << "the same again is no news";
  keep_ladder(store, key, first);
  EXPECT_EQ(kept_ladder(store, key), first);
}

TEST_F(LadderTest, AStoredStudyThatIsNoneIsToldAsAFailure) {
  store.put("k ladder=1", {"study", "{}", 0});
  EXPECT_THROW(kept_ladder(store, "k"), IoFailure);
}

}  // namespace
}  // namespace percal
