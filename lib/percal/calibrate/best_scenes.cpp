#include "percal/calibrate/best_scenes.hpp"

#include <fmt/core.h>

#include "percal/calibrate/shot_problem.hpp"

namespace percal {

std::vector<BestScene> best_scenes(const CalibrationJob& job, const CalibrationResult& result) {
  std::vector<BestScene> scenes;
  for (const HypothesisResult& found : result.hypotheses) {
    if (found.minima.empty()) continue;
    const Hypothesis& hypothesis = job.hypotheses[found.index];
    const auto natural = natural_values(job, hypothesis, found.parameters, found.minima.front().searched);
    int number = 0;
    for (const MeasuredShot& shot : job.shots) {
      const MaterialAt material = material_at(job, hypothesis, shot.material, natural);
      Scene scene = shot_scene(job, shot, material, mesh_of(shot, material, job.training.verify));
      scene.target.name = job.materials[shot.material].name;
      scene.replicates = job.training.verify_replicates;
      scenes.push_back({fmt::format("hypothesis_{}_shot_{}", found.index + 1, ++number), std::move(scene)});
    }
  }
  return scenes;
}

}  // namespace percal
