#include "percal/calibrate/kept_model.hpp"

#include <algorithm>

#include "percal/calibrate/shot_problem.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

constexpr int sample_size = 120;  // points of the sample

// The scatter groups of a target's fitted shots, of all its shots where none is fitted, of all shots where it has none.
std::vector<int> groups_of(const CalibrationJob& job, int target) {
  std::vector<int> fitted, own, all;
  for (const MeasuredShot& shot : job.shots) {
    all.push_back(shot.group);
    if (shot.target != target) continue;
    own.push_back(shot.group);
    if (shot.used) fitted.push_back(shot.group);
  }
  return !fitted.empty() ? fitted : !own.empty() ? own : all;
}

}  // namespace

ShotHypothesis for_shots(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit) {
  const Hypothesis& read = job.hypotheses[hypothesis];
  ShotHypothesis kept{.name = read.name, .materials = {}};
  for (std::size_t t = 0; t < job.targets.size(); ++t) {
    const auto groups = groups_of(job, static_cast<int>(t));
    const int group = *std::ranges::max_element(groups, {}, [&](int g) { return fit.best().scatter[g]; });
    kept.materials.push_back({.name = job.targets[t].name,
                              .points = {},
                              .scatter = fit.best().scatter[group],
                              .freedom = scatter_freedom(fit, group)});
  }
  constexpr double as_the_data_say = 1;
  for (const Eigen::VectorXd& at : plausible_points(fit, sample_size, as_the_data_say, job.training.seed)) {
    const auto natural = natural_values(job, read, model.of_job, at);
    for (std::size_t t = 0; t < job.targets.size(); ++t)
      kept.materials[t].points.push_back(target_at(job, read, job.targets[t], natural));
  }
  return kept;
}

std::optional<ShotModel> kept_model(const CalibrationJob& job, const Emulator& emulator, CalibrationResult& result) {
  if (result.hypotheses.empty()) return std::nullopt;
  ShotModel kept{.level = job.level,
                 .elements = job.training.verify,
                 .passage = learns_passage(job),
                 .replicates = usual_replicates,
                 .scene = {},
                 .shots = {},
                 .runs = emulator.runs(),
                 .settings = emulator.settings(),
                 .hypotheses = {}};
  for (const MeasuredShot& shot : job.shots) {
    FiredShot fired{};
    static_cast<SphereShot&>(fired) = shot;
    fired.label = shot.label;
    fired.material = shot.target;
    if (shot.datum != ShotDatum::none && shot.datum != ShotDatum::at_most && shot.datum != ShotDatum::stopped)
      fired.depth = shot.datum == ShotDatum::speed_left ? shot.layer_depth : shot.depth;
    fired.seen = word(shot.datum);
    fired.fitted = shot.used;
    kept.shots.push_back(fired);
  }
  for (HypothesisResult& found : result.hypotheses) {
    found.for_shots.contradicted = found.verdict.agreement == DataAgreement::disagrees;
    found.for_shots.mesh_error = found.mesh_error;
    kept.hypotheses.push_back(std::move(found.for_shots));
  }
  const CoveredMaterial& material = kept.hypotheses.front().materials[kept.shots.front().material].points.front();
  Scene scene;
  scene.mesh.elements_per_radius = mesh_of(kept.shots.front(), material, kept.elements);
  scene.solver = job.solver;
  if (kept.passage) scene.output.after = RunUntil::passage;
  scene.replicates = kept.replicates;
  kept.scene = scene_to_toml(scene_of_shot(std::move(scene), kept.shots.front(), material), "");
  return kept;
}

}  // namespace percal
