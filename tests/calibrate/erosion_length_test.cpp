// Jobs whose erosion is judged over a length: what they say, what is refused, the meshes of their runs, what depths tell of it.
#include <gmock/gmock.h>

#include "calibrate/gel_job.hpp"
#include "calibrate/small_job.hpp"
#include "percal/calibrate/best_scenes.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/calibrate/run_sizes.hpp"
#include "percal/calibrate/training.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/scene/scene_toml.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

using testing::HasSubstr;
using Replacements = std::vector<std::pair<std::string, std::string>>;

class JobsWithALength : public calibrate_test::SmallJob {
 protected:
  // Of both materials, as a text behind erosion_length.
  static Replacements lengths(const std::string& soft, const std::string& hard) {
    return {
        {"erosion_strain = \"strain\"\nrate_factor",
         "erosion_strain = \"strain\"\nerosion_length = \"" + soft + "\"\nrate_factor"},
        {"erosion_strain = 0.8", "erosion_strain = 0.8\nerosion_length = \"" + hard + "\""},
        {"[materials.soft]",
         "[parameters.length]\nkind = \"erosion length\"\nlow = \"0.2 mm\"\nhigh = \"0.7 mm\"\n\n[materials.soft]"}};
  }
  std::string refusal(const Replacements& changes) const {
    try {
      largest_run(read_job(changes));
    } catch (const BadInput& error) {
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(JobsWithALength, ShareItOrGiveIt) {
  const CalibrationJob job = read_job(lengths("length", "0.4 mm"));
  ASSERT_EQ(job.parameters.size(), 5u);
  EXPECT_EQ(job.parameters[4].kind, ParameterKind::erosion_length);
  EXPECT_EQ(job.parameters[4].free.unit, "m");
  EXPECT_DOUBLE_EQ(job.parameters[4].free.high, 0.7e-3);
  EXPECT_TRUE(job.parameters[4].free.logarithmic);
  EXPECT_EQ(std::get<SharedParameter>(*job.materials[0].erosion_length).index, 4);
  EXPECT_DOUBLE_EQ(std::get<double>(*job.materials[1].erosion_length), 0.4e-3);
  EXPECT_FALSE(has_erosion_length(read_job()));
}

TEST_F(JobsWithALength, HaveDefaultsOfTheirOwnForTheirMeshes) {
  Replacements changes = lengths("length", "0.4 mm");
  changes.push_back({"coarse = 4\nfine = 6\nverify = 7\n", ""});
  const TrainingSettings training = read_job(changes).training;
  EXPECT_EQ(training.coarse, 4);
  EXPECT_EQ(training.fine, 6);
  EXPECT_EQ(training.verify, 6);
}

TEST_F(JobsWithALength, AreRefusedByName) {
  const std::string one_alone = refusal({{"erosion_strain = 0.8", "erosion_strain = 0.8\nerosion_length = \"1 mm\""}});
  EXPECT_THAT(one_alone, testing::AllOf(HasSubstr("materials.hard.erosion_length"), HasSubstr("soft has none")));
  const std::string other_kind = refusal(lengths("alpha", "0.4 mm"));
  EXPECT_THAT(other_kind, testing::AllOf(HasSubstr("materials.soft.erosion_length"), HasSubstr("kind \"exponent\"")));
  EXPECT_THAT(refusal(lengths("4 Pa", "0.4 mm")), HasSubstr("positive length"));
  Replacements three = lengths("length", "0.4 mm");
  three.push_back({"coarse = 4", "coarse = 2.9"});
  EXPECT_THAT(refusal(three), testing::AllOf(HasSubstr("training.coarse"), HasSubstr("from 3 to 1000")));
}

// On the meshes drawn about three elements some have fewer.
TEST_F(JobsWithALength, NeedThreeElementsInItOnEveryMesh) {
  Replacements changes = lengths("length", "0.4 mm");
  EXPECT_EQ(refusal(changes), "accepted");
  changes.push_back({"coarse = 4", "coarse = 3.1"});
  EXPECT_THAT(refusal(changes), testing::AllOf(HasSubstr("training.coarse"), HasSubstr("fewer than 3"),
                                               HasSubstr("6 of 6 shots"), HasSubstr("4 or more")));
}

TEST_F(JobsWithALength, AreRefusedWithCountsWhereTheirMeshesCannotBe) {
  const std::string fine = refusal(lengths("length", "1 nm"));
  EXPECT_THAT(fine, testing::AllOf(HasSubstr("training.verify"), HasSubstr("2 of 6 shots"),
                                   HasSubstr("7e+06 elements per radius")));
  Replacements long_one = lengths("8 mm", "0.4 mm");
  long_one.pop_back();  // no parameter
  EXPECT_THAT(refusal(long_one), testing::AllOf(HasSubstr("training.coarse"), HasSubstr("fewer than one per radius"),
                                                HasSubstr("4 of 6 shots")));
}

TEST_F(JobsWithALength, WriteItIntoTheirScenes) {
  const CalibrationJob job = read_job({{"erosion_strain = \"strain\"\nrate_factor",
                                        "erosion_strain = \"strain\"\nerosion_length = \"0.5 mm\"\nrate_factor"},
                                       {"erosion_strain = 0.8", "erosion_strain = 0.8\nerosion_length = \"0.4 mm\""}});
  const auto scenes = best_scenes(job, calibrate_test::made_up_result(job));
  ASSERT_EQ(scenes.size(), job.shots.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Scene scene = parse_scene(scene_to_toml(scenes[i].scene, "found"), scenes[i].name);
    const double length = job.shots[i].target == 0 ? 0.5e-3 : 0.4e-3;
    EXPECT_DOUBLE_EQ(std::get<AverageWithin>(scene.target.erosion_average).length, length);
    EXPECT_NEAR(scene.mesh.elements_per_radius * length / job.shots[i].radius, job.training.verify, 1e-9);
  }
}

// What only such a result has.
TEST_F(JobsWithALength, HaveTheirKeysOnTheFormatsPage) {
  const CalibrationJob job = read_job(lengths("length", "0.4 mm"));
  CalibrationResult made_up = calibrate_test::made_up_result(read_job());
  made_up.shot_model.emplace().settings.length[index_of(&SphereInputs::log_erosion_length)] = 0.8;
  made_up.hypotheses[0].fresh[0].elements_in_length = 7;
  const nlohmann::json result = calibration_to_json(read_job(), made_up);
  EXPECT_EQ(result["shot_model"]["settings"]["length"]["ln_erosion_length_over_radius"], 0.8);
  EXPECT_EQ(result["hypotheses"][0]["fresh_runs"][0]["elements_in_erosion_length"], 7);
  const std::string page = text_of(std::string(PERCAL_DATA) + "/../docs/formats/calibrate.md");
  for (const char* key : {"`ln_erosion_length_over_radius`", "`elements_in_erosion_length`", "`erosion_length`"})
    EXPECT_THAT(page, HasSubstr(key));
}

// --- runs and fits --------------------------------------------------------------------------------------------------

class RunsWithALength : public testing::Test, protected test::TemporaryFolder {
 protected:
  // Into a thin layer: some milliseconds a run.
  RunsWithALength() {
    job_ = test::gel_job_with_length(4);
    job_.parameters[3].free.low = 0.6e-3;
    job_.parameters[3].free.high = 1.2e-3;
    for (MeasuredShot& shot : job_.shots) {
      shot.layer_depth = 25 * shot.radius;
      shot.depth = 12 * shot.radius;
    }
    job_.training.initial = 64;
    job_.training.most = 64;
  }
  CalibrationJob job_;
};

// Elements are the same share of the length for balls of both sizes, but for the phase; and those of jobs without one are no use.
TEST_F(RunsWithALength, AreOnMeshesWithAsManyElementsInTheLength) {
  Store store(path("percal.store"));
  Campaign campaign(&store, 0);
  const CalibrationLimits limits;
  Training training(job_, &store, campaign, limits);
  training.fill_space();
  const auto runs = stored_spheres(store);
  ASSERT_EQ(runs.size(), 64u);
  for (const StoredSphere& run : runs) {
    const double length = *erosion_length(run.problem), phase = phase_span / 2 * length;
    EXPECT_GE(1 / element_size(run.problem), 3 - 1e-9);
    EXPECT_NEAR(1 / element_size(run.problem), 4, phase + 1e-9);
  }
  ASSERT_TRUE(training.has_emulator());
  EXPECT_EQ(training.emulator().settings().inputs(), inputs_without_covers);
  CalibrationJob local = job_;
  local.text = "another";
  local.materials[0].erosion_length.reset();
  local.parameters.pop_back();
  EXPECT_EQ(Training(local, &store, campaign, limits).report().foreign, 0);
  CalibrationJob other = job_;
  other.text = "a third";
  EXPECT_GT(Training(other, &store, campaign, limits).report().foreign, 30);
}

// A length that is short beside the first ball: no mesh of a fixed number of elements per radius will do.
TEST_F(RunsWithALength, BeginWhateverTheFirstBallsSize) {
  job_.parameters[3].free.low = 0.05e-3;
  Store store(path("percal.store"));
  Campaign campaign(&store, 0);
  EXPECT_EQ(Training(job_, &store, campaign, {}).report().foreign, 0);
}

class FitsWithALength : public testing::Test {
 protected:
  FitsWithALength() {
    job_.hypotheses[0].held = {{1, truth_[1]}, {2, truth_[2]}};
    for (int k = 0; k < 16; ++k) job_.shots[k].radius = (k % 4 + 1) * 0.5e-3;
    test::measure(job_, truth_, 0.02, 5);
  }
  JobFit fit() const {
    const JobModel model = finite_element_model(job_, job_.hypotheses[0], emulator_, 0.25);
    return fit_job(job_, model, used_shots(job_), quick_search());
  }
  const std::vector<double> truth_{200e3, 7, 0.8, 0.35e-3};
  const Emulator emulator_ = test::emulator_of_the_smooth_law(200, 0.002, true);
  CalibrationJob job_ = test::gel_job_with_length(16);
};

TEST_F(FitsWithALength, RecoverItWhereAllElseIsKnown) {
  job_.hypotheses[0].held[0] = truth_[0];
  const JobFit found = fit();
  ASSERT_EQ(found.of_model.size(), 1u);
  const double error = std::sqrt(found.best().covariance(0, 0));
  EXPECT_NEAR(found.best().searched[0], std::log(truth_[3]), 3 * error);
  EXPECT_LT(error, 0.1);
}

// A law that is a power of l/a is the same power of a, whatever l: depths of all sizes tell mu^-0.49 l^-0.3 alone.
TEST_F(FitsWithALength, RecoverWhatItIsWithTheModulus) {
  const JobFit found = fit();
  ASSERT_EQ(found.of_model.size(), 2u);
  const Eigen::Vector2d powers(0.35 + 0.02 * truth_[1], 0.3), truth(std::log(truth_[0]), std::log(truth_[3]));
  EXPECT_NEAR(powers.dot(found.best().searched), powers.dot(truth), 0.03);
  EXPECT_GT(std::sqrt(found.best().covariance(1, 1)), 0.3) << "alone it is not told";
}

}  // namespace
}  // namespace percal
