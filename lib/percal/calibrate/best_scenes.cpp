#include "percal/calibrate/best_scenes.hpp"

#include <fmt/core.h>

#include "percal/calibrate/shot_problem.hpp"

namespace percal {
namespace {

// By their materials; covers lie the other way round than in the scene.
void name_layers(Scene& scene, const CalibrationJob& job, const CalibrationTarget& target) {
  std::vector<std::string*> from_below;
  for (LowerLayerScene& layer : scene.below) from_below.insert(from_below.begin(), &layer.name);
  from_below.push_back(&scene.target.name);
  *from_below[0] = job.materials[target.material].name;
  for (std::size_t k = 0; k < target.covers.size(); ++k)
    *from_below[k + 1] = job.materials[target.covers[k].material].name;
}

}  // namespace

std::vector<BestScene> best_scenes(const CalibrationJob& job, const CalibrationResult& result) {
  std::vector<BestScene> scenes;
  for (const HypothesisResult& found : result.hypotheses) {
    if (found.minima.empty()) continue;
    const Hypothesis& hypothesis = job.hypotheses[found.index];
    const auto natural = natural_values(job, hypothesis, found.parameters, found.minima.front().searched);
    int number = 0;
    for (const MeasuredShot& shot : job.shots) {
      const CalibrationTarget& target = job.targets[shot.target];
      const CoveredMaterial material = target_at(job, hypothesis, target, natural);
      Scene scene = shot_scene(job, shot, material, mesh_of(shot, material, job.training.verify));
      name_layers(scene, job, target);
      scene.replicates = usual_replicates;
      scenes.push_back({fmt::format("hypothesis_{}_shot_{}", found.index + 1, ++number), std::move(scene)});
    }
  }
  return scenes;
}

}  // namespace percal
