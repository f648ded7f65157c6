// Prisms as data of a calibration: read, run as the scene of a block has them, learnt by an emulator of their own, kept and predicted.
#include <gmock/gmock.h>

#include "calibrate/gel_job.hpp"
#include "calibrate/law_checks.hpp"
#include "calibrate/shots_of_the_solver.hpp"
#include "percal/base/error.hpp"
#include "percal/calibrate/calibration.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/predict/prediction.hpp"
#include "percal/scene/scene_toml.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string rhombus = R"(shape = "rhombus"
name = "steel rhombus"
side = "6.0 mm"
tip_angle = "60 deg"
mass = "0.7027 g"
thickness = "3.10 mm"
)";

const std::string gel_of_bodies = R"([parameters.strain]
kind = "erosion strain"
low = 0.2
high = 0.45
[materials.gel]
density = "1010 kg/m3"
mu = "837 kPa"
alpha = 14.8
erosion_strain = "strain"
)";

class BodiesJob : public test::Program {
 protected:
  // Four prisms, and two balls where they are asked for.
  std::string text_of_job(const std::string& body = rhombus, const std::string& more = "") const {
    write("prisms.csv", "speed_m_s,depth_mm\n25,15\n33,24\n40,32\n48,41\n");
    return gel_of_bodies + R"([[shots]]
name = "prisms"
material = "gel"
file = "prisms.csv"
speed_column = "speed"
depth_column = "depth"
layer_depth = "100 mm"
layer_width = "37.5 mm"
[shots.body]
)" + body + more;
  }
  CalibrationJob read(const std::string& text) const { return read_calibration_job(write("job.toml", text)); }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "nothing was refused";
  }
};

const std::string balls = R"([[shots]]
name = "balls"
material = "gel"
layer_depth = "100 mm"
[[shots.points]]
diameter = "3.18 mm"
particle_density = "7800 kg/m3"
speed = "83 m/s"
depth = "40 mm"
)";

TEST_F(BodiesJob, HaveTheSizeAndTheMassOfTheirShape) {
  const CalibrationJob job = read(text_of_job(rhombus, balls));
  ASSERT_EQ(job.bodies.size(), 1u);
  ASSERT_EQ(job.shots.size(), 5u);
  EXPECT_EQ(bodies_of(job), (std::set<int>{0, 1}));
  const MeasuredShot& prism = job.shots[0];
  EXPECT_EQ(prism.label, "steel rhombus at 25 m/s");
  EXPECT_NEAR(prism.radius, 3e-3, 1e-12);
  EXPECT_NEAR(prism.density, 0.7027e-3 / (36e-6 * std::sqrt(0.75) * 3.1e-3), 1e-6);
  EXPECT_EQ(prism.body, job.bodies[0]);
  EXPECT_NEAR(job.bodies[0]->scene.mesh.fine_depth.value(), 1.2 * 41.0 / 3, 1e-9) << "of the deepest shot";
  EXPECT_FALSE(job.shots[4].body);
  EXPECT_NEAR(job.shots[4].layer_width / job.shots[4].radius, 20, 1e-9) << "the prisms' wall is theirs alone";
}

TEST_F(BodiesJob, AreRunAsASceneOfABlockIs) {
  const CalibrationJob job = read(text_of_job());
  const Scene scene = parse_scene("geometry = \"block\"\n[particle]\n" + rhombus + R"(speed = "40 m/s"
[target]
density = "1010 kg/m3"
mu = "837 kPa"
alpha = 14.8
depth = "100 mm"
width = "37.5 mm"
[target.erosion]
strain = 0.3
[mesh]
fine_depth = 16.4
)",
                                  "scene");
  const CoveredMaterial material = target_at(job, job.hypotheses[0], job.targets[0], {0.3});
  const MeasuredShot& shot = job.shots[2];
  const double mesh = mesh_of(shot, material, 6);
  const Problem expected = reduce(scene).problem, problem = shot_problem(job, shot, material, mesh);
  EXPECT_EQ(evaluation_key(problem, "any"), evaluation_key(expected, "any"));
  EXPECT_NEAR(element_size(problem), 1.0 / 6, 1e-10) << "over half the thickness";
  const SphereInputs at = shot_inputs(shot, material).at, of_run = inputs_of(problem);
  for (const auto input : sphere_input_order) EXPECT_NEAR(at.*input, of_run.*input, 1e-9);
}

TEST_F(BodiesJob, OfOneShapeAreOne) {
  const std::string other = text_of_job().substr(gel_of_bodies.size());
  const CalibrationJob job = read(text_of_job() + other);
  EXPECT_EQ(job.bodies.size(), 1u);
  EXPECT_EQ(job.shots[0].body, job.shots[7].body);
  std::string square = other;
  square.replace(square.find("60 deg"), 6, "90 deg");
  EXPECT_THAT(refusal(text_of_job() + square), AllOf(HasSubstr("name"), HasSubstr("again, of another body")));
  square.replace(square.find("steel rhombus"), 13, "square");
  EXPECT_EQ(read(text_of_job() + square).bodies.size(), 2u);
}

TEST_F(BodiesJob, AreRefusedWhereTheirRunsLackWhatIsAsked) {
  const auto with = [&](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const std::string job = text_of_job();
  EXPECT_THAT(refusal(with(job, "layer_depth", "radius = \"3 mm\"\nlayer_depth")),
              AllOf(HasSubstr("job.toml:"), HasSubstr("radius"), HasSubstr("beside [shots.body]")));
  const std::string sphere = "radius = \"2 mm\"\ndensity = \"7800 kg/m3\"\n";
  EXPECT_THAT(refusal(text_of_job("shape = \"sphere\"\n" + sphere)),
              AllOf(HasSubstr("shape"), HasSubstr("a prism or a polyhedron")));
  EXPECT_THAT(refusal(text_of_job(sphere)), AllOf(HasSubstr("shape"), HasSubstr("no such key")));
  EXPECT_THAT(refusal(text_of_job(with(rhombus, "thickness = \"3.10 mm\"", ""))), HasSubstr("thickness"));
  EXPECT_THAT(
      refusal(with(job, "erosion_strain = \"strain\"", "erosion_strain = \"strain\"\nerosion_length = \"1 mm\"")),
      HasSubstr("an erosion length"));
  EXPECT_THAT(refusal(with(job, "erosion_strain = \"strain\"",
                           "erosion_strain = \"strain\"\nrate_exponent = 0.1\nreference_rate = \"1000 1/s\"")),
              HasSubstr("a rate_exponent"));
  EXPECT_THAT(refusal(with(job, "depth_column", "final_depth_column")),
              AllOf(HasSubstr("body"), HasSubstr("final depth")));
  EXPECT_THAT(refusal(job + "[training]\npassage = true\n"), HasSubstr("training.passage"));
  EXPECT_THAT(refusal(with(job, "layer_depth = \"100 mm\"", "layer_depth = \"2 mm\"")), HasSubstr("half the width"));
  EXPECT_THAT(refusal(job + "[training]\nbody_initial = 10\n"), HasSubstr("body_initial"));
}

// --- what it tells --------------------------------------------------------------------------------------------------

constexpr double prism_shift = 0.4, element_of_both = 0.1;

// A prism's depth follows another law than a sphere's.
Emulators emulators_of_both() {
  Emulators emulators = test::emulator_of_the_smooth_law();
  std::vector<TrainingRun> runs = emulators.depth().runs();
  runs.resize(90);
  for (TrainingRun& run : runs) run.log_depth += prism_shift + 0.1 * run.at.log_pi4;
  emulators.of.emplace(EmulatorOf{1}, Emulator(runs, EmulatorOptions{}));
  return emulators;
}

// Balls of which every other one is a prism of the same radius.
CalibrationJob balls_and_prisms(const std::vector<double>& natural) {
  CalibrationJob job = test::gel_job();
  ShotBody body;
  body.scene = parse_scene("geometry = \"block\"\n[particle]\n" + rhombus +
                               "speed = \"1 m/s\"\n[target]\ndensity = \"1010 kg/m3\"\nmu = \"1 MPa\"\nalpha = 6\n"
                               "depth = \"12 cm\"\nwidth = \"6 cm\"\n",
                           "body");
  job.bodies = {std::make_shared<const ShotBody>(body)};
  job.training.verify = 1 / element_of_both;
  test::measure(job, natural, 0.01, 4);
  for (std::size_t k = 1; k < job.shots.size(); k += 2) {
    MeasuredShot& shot = job.shots[k];
    shot.body = job.bodies[0];
    shot.depth *= std::exp(
        prism_shift + 0.1 * shot_inputs(shot, target_at(job, job.hypotheses[0], job.targets[0], natural)).at.log_pi4);
  }
  return job;
}

const std::vector<double> gel_under_both{2e5, 8, 0.8};

TEST(Bodies, HaveDepthsOfTheirOwnEmulator) {
  const CalibrationJob job = balls_and_prisms(gel_under_both);
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulators_of_both(), element_of_both);
  Eigen::VectorXd at(3);
  for (int k = 0; k < 3; ++k) at[k] = job.parameters[k].free.searched(gel_under_both[k]);
  const ModelAnswer answer = model.log_depths(at, job.shots, Want::values_and_covariance);
  for (std::size_t k = 0; k < job.shots.size(); ++k)
    EXPECT_NEAR(answer.value[static_cast<Eigen::Index>(k)], std::log(job.shots[k].depth), 0.04) << k;
  EXPECT_GT(answer.covariance(0, 2), 0) << "of two balls";
  EXPECT_GT(answer.covariance(1, 3), 0) << "of two prisms";
  EXPECT_EQ(answer.covariance(0, 1), 0) << "of a ball and a prism";
  test::expect_derivatives([&](const Eigen::VectorXd& x) { return model.log_depths(x, job.shots, Want::values); }, at);
}

TEST(Bodies, AreLeftOutOfTheClosedForm) {
  CalibrationJob job = balls_and_prisms(gel_under_both);
  const DehnResult with = fit_dehn(job);
  ASSERT_EQ(with.shots.size(), 4u);
  std::erase_if(job.shots, [](const MeasuredShot& shot) { return shot.body != nullptr; });
  EXPECT_DOUBLE_EQ(fit_dehn(job).minimum.searched[1], with.minimum.searched[1]);
}

TEST(Bodies, AreKeptWrittenReadAndPredicted) {
  const Emulators emulators = emulators_of_both();
  const CalibrationJob job = balls_and_prisms(gel_under_both);
  const JobModel model = finite_element_model(job, job.hypotheses[0], emulators, element_of_both);
  const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
  auto [json, read] = test::kept_and_read(job, emulators, model, fit);

  EXPECT_THROW(understood({.speed = "60 m/s"}, read), BadInput) << "of both";
  PredictWords words{.body = "steel rhombus", .speed = "60 m/s"};
  words.sphere.density = "7800 kg/m3";
  const PredictRequest request = understood(words, read);
  EXPECT_EQ(request.shots.front().body->name(), "steel rhombus");
  const double prism = predict(read, request).shots.front().depth.depth;
  SphereShot shot = request.shots.front();
  const SphereInputs at = shot_inputs(shot, read.hypotheses[0].materials[0].points.front()).at;
  EXPECT_NEAR(std::log(prism / shot.radius), test::smooth_law(at) + prism_shift + 0.1 * at.log_pi4, 0.05);
  words.sphere.diameter = "3 mm";
  EXPECT_THROW(understood(words, read), BadInput) << "its size is what it is";
  words.body = "sphere";
  EXPECT_FALSE(understood(words, read).shots.front().body);
  words.body = "square";
  EXPECT_THROW(understood(words, read), BadInput);

  EXPECT_TRUE(of_spheres(read, "f").bodies.empty());
  EXPECT_EQ(of_spheres(read, "f").shots.size(), 4u);
  ShotModel alone = read;
  alone.runs.clear();
  EXPECT_THROW(of_spheres(alone, "f"), BadInput);
  json["shot_model"]["shots"][1]["body"] = 2;
  EXPECT_THROW(shot_model_of(json, "f"), page::MissingKey);
}

// --- the whole of it, by the solver -----------------------------------------------------------------------------------

class SlowBodies : public BodiesJob {};

// Depths of prisms made at a known strain, fitted on the same coarse mesh: the strain comes back, alone by prisms.
TEST_F(SlowBodies, TellTheErosionStrainThatMadeTheirDepths) {
  constexpr double truth = 0.3;
  CalibrationJob job = read(text_of_job() + "[training]\ncoarse = 3\nfine = 3\nverify = 3\n");
  job.bootstrap = 0;
  const Campaign::Deadline none;
  Campaign campaign(nullptr, 2);
  for (MeasuredShot& shot : job.shots) {
    const CoveredMaterial material = target_at(job, job.hypotheses[0], job.targets[0], {truth});
    const auto runs = campaign.replicate({shot_problem(job, shot, material, mesh_of(shot, material, 3))}, 5, nullptr);
    double sum = 0;
    for (const Evaluation& run : runs.front()) sum += run.result.depth / 5;
    shot.depth = sum * shot.radius;
  }
  Store store(path("runs.store"));
  const CalibrationResult result = calibrate(job, store, campaign, {}, [](const std::string&) {});
  ASSERT_EQ(result.hypotheses.size(), 1u);
  const HypothesisResult& fitted = result.hypotheses[0];
  const double strain = std::exp(fitted.minima.front().searched[0]);
  EXPECT_NEAR(strain, truth, 0.05 * truth);
  EXPECT_LE(fitted.intervals[0].interval.low, truth);
  EXPECT_GE(fitted.intervals[0].interval.high, truth);
  EXPECT_EQ(fitted.fresh.size(), 4u);
  ASSERT_TRUE(result.shot_model);
  EXPECT_TRUE(result.shot_model->runs.empty()) << "no sphere was run";
  EXPECT_EQ(result.shot_model->bodies.size(), 1u);
  EXPECT_FALSE(result.dehn);
}

}  // namespace
}  // namespace percal
