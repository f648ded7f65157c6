#include "percal/identify/impacts.hpp"

#include "percal/impact/target/size.hpp"

namespace percal {

Scene impact_scene(const IdentifyJob& job, const ParticleScene& particle, const TargetMaterial& target,
                   const VolumetricChoice& volumetric, double elements_per_radius) {
  Scene scene;
  scene.source = job.file;
  scene.particle = particle;
  scene.particle.elasticity = Elasticity::rigid;  // as in every published run that a job is compared with
  scene.target = {.name = "layer",
                  .density = target.density,
                  .mu_as_given = target.mu,
                  .convention = job.convention,
                  .alpha = target.alpha,
                  .volumetric = volumetric,
                  .depth = job.layer.depth * particle.radius,
                  .width = job.layer.width * particle.radius,
                  .bottom = job.layer.bottom,
                  .erosion = StrainErosion{target.erosion_strain, job.measure}};
  scene.mesh.elements_per_radius = elements_per_radius;
  scene.solver = job.solver;
  return scene;
}

std::vector<Shooting> shoot(Campaign& campaign, const std::vector<Scene>& scenes, int replicates, const char* label) {
  std::vector<Shooting> shots;
  std::vector<Problem> problems;
  for (const Scene& scene : scenes) {
    shots.push_back({.scene = scene, .reduction = reduce(scene), .runs = {}, .penetration = {}});
    problems.push_back(shots.back().reduction.problem);
    shots.back().scene.replicates = replicates;
    refuse_what_is_too_large(problems.back(), scene.source);
  }
  Progress progress(label, static_cast<long>(problems.size()) * replicates);
  auto runs = campaign.replicate(problems, replicates, &progress);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    shots[i].runs = std::move(runs[i]);
    shots[i].penetration = summarise(shots[i].runs, problems[i], shots[i].reduction.scales);
  }
  return shots;
}

}  // namespace percal
