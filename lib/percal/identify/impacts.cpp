#include "percal/identify/impacts.hpp"

#include <cmath>

#include "percal/atlas/expected.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/problem/replicates.hpp"

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

namespace {

// Each with its own number of replicates.
void run(Campaign& campaign, std::vector<Shooting*> shots, const char* label) {
  std::vector<Problem> all;
  for (const Shooting* shot : shots) {
    const auto walk = replicates_of(shot->reduction.problem, shot->scene.replicates);
    all.insert(all.end(), walk.begin(), walk.end());
  }
  Progress progress(label, static_cast<long>(all.size()));
  const std::vector<Evaluation> runs = campaign.evaluate(all, &progress);
  auto next = runs.begin();
  for (Shooting* shot : shots) {
    shot->runs.assign(next, next + shot->scene.replicates);
    next += shot->scene.replicates;
    shot->penetration = summarise(shot->runs, shot->reduction.problem, shot->reduction.scales);
  }
}

std::vector<Shooting> unshot(const std::vector<Scene>& scenes, int replicates) {
  std::vector<Shooting> shots;
  for (const Scene& scene : scenes) {
    shots.push_back({.scene = scene, .reduction = reduce(scene), .runs = {}, .penetration = {}});
    shots.back().scene.replicates = replicates;
    refuse_what_is_too_large(shots.back().reduction.problem, scene.source);
  }
  return shots;
}

// Runs beside which the atlas makes the error no larger than that of `replicates` alone.
int runs_beside(const AtlasDepth& atlas, int replicates) {
  int runs = 1;
  while (joined_error(atlas, runs) > atlas.noise / std::sqrt(replicates)) ++runs;
  return runs;
}

bool agree(const Penetration& penetration, const AtlasDepth& atlas) {
  return penetration.depth && std::abs(std::log(*penetration.depth / atlas.depth)) <=
                                  allowed_apart(atlas, static_cast<int>(penetration.depths.size()));
}

std::vector<Shooting*> places(std::vector<Shooting>& shots) {
  std::vector<Shooting*> all;
  for (Shooting& shot : shots) all.push_back(&shot);
  return all;
}

}  // namespace

std::vector<Shooting> shoot(Campaign& campaign, const std::vector<Scene>& scenes, int replicates, const char* label) {
  std::vector<Shooting> shots = unshot(scenes, replicates);
  run(campaign, places(shots), label);
  return shots;
}

std::optional<AtlasDepth> known_to_atlas(const Shooting& shot) {
  const auto expected = expected_depth(shot.reduction.problem);
  return expected ? std::optional(in_metres(*expected, shot.scene.particle.radius)) : std::nullopt;
}

std::vector<Shooting> shoot_beside_atlas(Campaign& campaign, const std::vector<Scene>& scenes, int replicates,
                                         const char* label, const KnownDepth& known) {
  if (replicates > usual_replicates) return shoot(campaign, scenes, replicates, label);
  std::vector<Shooting> shots = unshot(scenes, replicates);
  std::vector<std::optional<AtlasDepth>> said(shots.size());
  campaign.side_by_side(static_cast<int>(shots.size()), [&](int i) { said[i] = known(shots[i]); });
  for (std::size_t i = 0; i < shots.size(); ++i)
    if (said[i]) shots[i].scene.replicates = runs_beside(*said[i], replicates);
  run(campaign, places(shots), label);
  std::vector<Shooting*> alone;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    if (!said[i]) continue;
    if (agree(shots[i].penetration, *said[i])) {
      shots[i].penetration = joined(shots[i].penetration, *said[i]);
    } else if (shots[i].scene.replicates < replicates) {
      shots[i].scene.replicates = replicates;
      alone.push_back(&shots[i]);
    }
  }
  if (!alone.empty()) run(campaign, alone, label);
  return shots;
}

}  // namespace percal
