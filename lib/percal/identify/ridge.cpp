#include "percal/identify/ridge.hpp"

#include <algorithm>
#include <cmath>

#include "percal/campaign/depth_search.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

DepthOfModulus forward_model(Campaign& campaign, const IdentifyJob& job, double alpha, double strain) {
  return [&campaign, &job, alpha, strain](double log_modulus) {
    const TargetMaterial target{job.tissue.density, std::exp(log_modulus), alpha, strain};
    const Scene scene = impact_scene(job, job.calibration, target, job.volumetric, job.ridge.elements_per_radius);
    const Reduction reduction = reduce(scene);
    std::vector<Evaluation> runs;  // the searches run side by side: the replicates of one do not
    for (const Problem& one : replicates_of(reduction.problem, job.ridge.replicates))
      runs.push_back(campaign.evaluate(one));
    return answer_of(summarise(runs, reduction.problem, reduction.scales));
  };
}

// The pairs of a scan's target, if alpha comes from one.
const std::vector<RidgePair>& known_pairs(const IdentifyJob& job) {
  static const std::vector<RidgePair> none;
  const auto* scan = std::get_if<AlphaScan>(&job.alpha);
  return scan ? scan->target : none;
}

void shoot_at_known_pairs(Campaign& campaign, const IdentifyJob& job, double alpha, std::vector<RidgePoint>& ridge) {
  const auto* scan = std::get_if<AlphaScan>(&job.alpha);
  if (!scan) return;
  std::vector<Scene> scenes;
  std::vector<RidgePoint*> points;
  for (RidgePoint& point : ridge)
    if (point.known) {
      const TargetMaterial target{job.tissue.density, point.known->mu, alpha, point.known->erosion_strain};
      scenes.push_back(impact_scene(job, job.calibration, target, job.volumetric, scan->elements_per_radius));
      points.push_back(&point);
    }
  auto shots = shoot(campaign, scenes, scan->replicates, "known pairs");
  for (std::size_t i = 0; i < shots.size(); ++i) points[i]->at_known = std::move(shots[i]);
}

}  // namespace

std::vector<RidgePoint> find_ridge(Campaign& campaign, const IdentifyJob& job, double alpha) {
  std::vector<RidgePoint> ridge;
  for (const double strain : job.ridge.erosion_strains) {
    RidgePoint point;
    point.erosion_strain = strain;
    for (const RidgePair& pair : known_pairs(job))
      if (std::abs(pair.erosion_strain - strain) < 1e-9) point.known = pair;
    ridge.push_back(point);
  }
  // The searches start where the job says, not at the target's moduli: those are what they are compared with.
  const auto found = search_side_by_side(campaign, static_cast<int>(ridge.size()), "ridge", [&](int k) {
    return invert_modulus(forward_model(campaign, job, alpha, ridge[k].erosion_strain),
                          {.target = job.penetration, .start = std::log(job.ridge.start)});
  });
  for (std::size_t k = 0; k < ridge.size(); ++k) {
    RidgePoint& point = ridge[k];
    point.inversion = found[k];
    if (point.inversion.outcome != InversionOutcome::found) continue;
    point.mu = std::exp(point.inversion.log_modulus);
    point.solver_error = point.inversion.log_modulus_error;
    if (job.penetration_error)
      point.data_error = *job.penetration_error / job.penetration / std::abs(point.inversion.slope);
  }
  shoot_at_known_pairs(campaign, job, alpha, ridge);
  return ridge;
}

std::optional<StrainOnRidge> strain_at(const std::vector<RidgePoint>& ridge, double mu) {
  const RidgePoint* before = nullptr;
  for (const RidgePoint& point : ridge) {
    if (point.mu == 0) continue;
    if (before) {
      const double from = std::log(before->mu), to = std::log(point.mu), at = std::log(mu);
      if ((at - from) * (at - to) <= 0 && from != to) {
        const double share = (at - from) / (to - from),
                     slope = (point.erosion_strain - before->erosion_strain) / (to - from);
        const double error = std::max(std::hypot(before->solver_error, before->data_error),
                                      std::hypot(point.solver_error, point.data_error));
        return StrainOnRidge{before->erosion_strain + share * (point.erosion_strain - before->erosion_strain),
                             std::abs(slope) * error};
      }
    }
    before = &point;
  }
  return std::nullopt;
}

}  // namespace percal
