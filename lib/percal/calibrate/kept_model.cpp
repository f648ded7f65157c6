#include "percal/calibrate/kept_model.hpp"

#include <algorithm>
#include <tuple>

#include "percal/calibrate/shot_problem.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

constexpr int sample_size = 120;  // points of the sample

// The scatter groups of a target's fitted shots of which the number was measured, of all its such shots where none is fitted, of all such
// shots where it has none, of all shots.
std::vector<int> groups_of(const CalibrationJob& job, int target, RunNumber number) {
  std::vector<int> fitted, own, such, all;
  for (const MeasuredShot& shot : job.shots) {
    all.push_back(shot.group);
    if (shot.number != number) continue;
    such.push_back(shot.group);
    if (shot.target != target) continue;
    own.push_back(shot.group);
    if (shot.used) fitted.push_back(shot.group);
  }
  return !fitted.empty() ? fitted : !own.empty() ? own : !such.empty() ? such : all;
}

// The largest of them.
SampleScatter scatter_of(const CalibrationJob& job, const JobFit& fit, int target, RunNumber number) {
  const auto groups = groups_of(job, target, number);
  const int group = *std::ranges::max_element(groups, {}, [&](int g) { return fit.best().scatter[g]; });
  return {fit.best().scatter[group], scatter_freedom(fit, group)};
}

}  // namespace

ShotHypothesis for_shots(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit) {
  const Hypothesis& read = job.hypotheses[hypothesis];
  ShotHypothesis kept{.name = read.name, .materials = {}};
  for (std::size_t t = 0; t < job.targets.size(); ++t) {
    const SampleScatter of_depth = scatter_of(job, fit, static_cast<int>(t), RunNumber::depth);
    kept.materials.push_back(
        {.name = job.targets[t].name, .points = {}, .scatter = of_depth.scatter, .freedom = of_depth.freedom});
    for (const RunNumber number : numbers_of(job))
      kept.materials.back().beside[number] = scatter_of(job, fit, static_cast<int>(t), number);
  }
  constexpr double as_the_data_say = 1;
  for (const Eigen::VectorXd& at : plausible_points(fit, sample_size, as_the_data_say, job.training.seed)) {
    const auto natural = natural_values(job, read, model.of_job, at);
    for (std::size_t t = 0; t < job.targets.size(); ++t)
      kept.materials[t].points.push_back(target_at(job, read, job.targets[t], natural));
  }
  return kept;
}

std::optional<ShotModel> kept_model(const CalibrationJob& job, const Emulators& emulators, CalibrationResult& result) {
  if (result.hypotheses.empty()) return std::nullopt;
  ShotModel kept{.level = job.level,
                 .elements = job.training.verify,
                 .passage = learns_passage(job),
                 .replicates = usual_replicates,
                 .scene = {},
                 .shots = {},
                 .runs = {},
                 .settings = {},
                 .hypotheses = {}};
  for (const auto& [of, emulator] : emulators.of) {
    LearntNumber learnt{emulator.runs(), emulator.settings()};
    if (of.body != 0)
      kept.bodies.push_back({job.bodies[of.body - 1], std::move(learnt)});
    else if (of.number != RunNumber::depth)
      kept.beside[of.number] = std::move(learnt);
    else
      std::tie(kept.runs, kept.settings) = std::tie(learnt.runs, learnt.settings);
  }
  for (const MeasuredShot& shot : job.shots) {
    FiredShot fired{};
    static_cast<SphereShot&>(fired) = shot;
    fired.label = shot.label;
    fired.material = shot.target;
    if (tells_depth(shot) && shot.datum != ShotDatum::at_most && shot.datum != ShotDatum::stopped)
      fired.depth = shot.datum == ShotDatum::speed_left ? shot.layer_depth : shot.depth;
    fired.seen = seen_words(shot);
    fired.fitted = shot.used;
    kept.shots.push_back(fired);
  }
  for (HypothesisResult& found : result.hypotheses) {
    found.for_shots.contradicted = found.verdict.agreement == DataAgreement::disagrees;
    found.for_shots.mesh_error = found.mesh_error;
    kept.hypotheses.push_back(std::move(found.for_shots));
  }
  const auto scene_of_runs = [&](int body) {
    const FiredShot& shot = *std::ranges::find(kept.shots, body, place_of_body);
    const CoveredMaterial& material = kept.hypotheses.front().materials[shot.material].points.front();
    Scene scene;
    scene.mesh.elements_per_radius = mesh_of(shot, material, kept.elements);
    scene.solver = job.solver;
    if (kept.passage) scene.output.after = RunUntil::passage;
    scene.replicates = kept.replicates;
    return scene_to_toml(scene_of_shot(std::move(scene), shot, material), "");
  };
  if (!kept.runs.empty()) kept.scene = scene_of_runs(0);
  for (KeptBody& body : kept.bodies) body.scene = scene_of_runs(body.body->place);
  return kept;
}

}  // namespace percal
