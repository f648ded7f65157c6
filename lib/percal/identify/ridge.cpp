#include "percal/identify/ridge.hpp"

#include <algorithm>
#include <cmath>

#include "percal/atlas/expected.hpp"
#include "percal/campaign/depth_search.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

Reduction calibration_shot(const IdentifyJob& job, double alpha, double strain, double log_modulus) {
  const TargetMaterial target{job.tissue.density, std::exp(log_modulus), alpha, strain};
  return reduce(impact_scene(job, job.calibration, target, job.volumetric, job.ridge.elements_per_radius));
}

// Means over the phase, as the job has them.
DepthOfModulus means_of_runs(Campaign& campaign, const IdentifyJob& job, double alpha, double strain) {
  return [&campaign, &job, alpha, strain](double log_modulus) {
    const Reduction reduction = calibration_shot(job, alpha, strain, log_modulus);
    std::vector<Evaluation> runs;  // the searches run side by side: the replicates of one do not
    for (const Problem& one : replicates_of(reduction.problem, job.ridge.replicates))
      runs.push_back(campaign.evaluate(one));
    return answer_of(summarise(runs, reduction.problem, reduction.scales));
  };
}

// Where the atlas expects the end, single runs about it are enough: as many as two of the means have, or fewer beside a measured depth's error.
Inversion search_at(Campaign& campaign, const IdentifyJob& job, double alpha, double strain) {
  InversionOptions options{.target = job.penetration, .start = std::log(job.ridge.start)};
  const auto shot = [&job, alpha, strain](double log_modulus) {
    return calibration_shot(job, alpha, strain, log_modulus);
  };
  const auto root =
      job.ridge.replicates > usual_replicates
          ? std::nullopt
          : expected_root([&](double log_modulus) { return shot(log_modulus).problem; },
                          std::log(job.penetration / job.calibration.radius), options.start, options.most_step);
  if (!root) return invert_modulus(means_of_runs(campaign, job, alpha, strain), options);
  options.fewest_in_line = std::max(options.fewest_in_line, 2 * job.ridge.replicates);
  begin_at(*root, job.penetration_error.value_or(0) / job.penetration, options);
  double worst_closure = 0;
  return invert_modulus(one_run_an_answer(campaign, shot, worst_closure), options);
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
    return search_at(campaign, job, alpha, ridge[k].erosion_strain);
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
