// The impacts of an identification as scenes, and their evaluation.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "percal/campaign/campaign.hpp"
#include "percal/identify/job.hpp"

namespace percal {

// A target material of the job: its modulus as given, and its erosion strain.
struct TargetMaterial {
  double density = 0;  // kg/m3
  double mu = 0;       // Pa, as given
  double alpha = 0;
  double erosion_strain = 0;
};

// A sphere into the job's layer, scaled with the sphere.
Scene impact_scene(const IdentifyJob& job, const ParticleScene& particle, const TargetMaterial& target,
                   const VolumetricChoice& volumetric, double elements_per_radius);

// One scene with its replicates, evaluated.
struct Shooting {
  Scene scene;
  Reduction reduction;
  std::vector<Evaluation> runs;
  Penetration penetration;
};
std::vector<Shooting> shoot(Campaign& campaign, const std::vector<Scene>& scenes, int replicates, const char* label);

// The same where the atlas may bear a part: as many runs as bring the error of a depth that is joined with it to that of the replicates alone,
// one at least. Where they do not agree with it, and of more than the usual replicates, all are made, and the depth is theirs.
// `known`: what the atlas says of a shot.
using KnownDepth = std::function<std::optional<AtlasDepth>(const Shooting&)>;
std::optional<AtlasDepth> known_to_atlas(const Shooting& shot);
std::vector<Shooting> shoot_beside_atlas(Campaign& campaign, const std::vector<Scene>& scenes, int replicates,
                                         const char* label, const KnownDepth& known = known_to_atlas);

}  // namespace percal
