#include "percal/identify/layer_width.hpp"

#include <algorithm>
#include <cmath>

#include "percal/scene/width.hpp"

namespace percal {
namespace {

// The exponent that makes the true modulus of a mu/alpha one least.
double mildest_alpha(const IdentifyJob& job) {
  if (const auto* given = std::get_if<AlphaGiven>(&job.alpha)) return given->alpha;
  const auto& candidates = std::get<AlphaScan>(job.alpha).candidates;
  return *std::min_element(candidates.begin(), candidates.end(),
                           [](double a, double b) { return std::abs(a) < std::abs(b); });
}

double softest_tissue(const IdentifyJob& job) {
  double mu = job.ridge.start;
  if (const auto* scan = std::get_if<AlphaScan>(&job.alpha))
    for (const RidgePair& pair : scan->target) mu = std::min(mu, pair.mu);
  return mu;
}

double softest_formulation(const IdentifyJob& job) {
  double mu = INFINITY;
  for (const Formulation& f : job.gelatin.formulations)
    mu = std::min(mu, f.mu_high_rate.value_or(f.mu_quasi_static * job.gelatin.rate_factor));
  return mu;
}

struct SoftestOf {
  const IdentifyJob& job;
  double operator()(const PairGiven& pair) const { return pair.mu; }
  double operator()(const IdentifiedTissue&) const { return softest_tissue(job); }
  double operator()(const IdentifiedModel&) const { return softest_formulation(job); }
};

}  // namespace

double widest_needed(const IdentifyJob& job) {
  const double alpha = mildest_alpha(job);
  const auto needed = [&](double particle_density, double speed, double target_density, double mu) {
    return usual_width(target_density * speed * speed / true_modulus(mu, alpha, job.convention),
                       particle_density / target_density);
  };
  // The model system is similar to this one: the same pi4 and density ratio.
  double widest = needed(job.calibration.density, job.calibration.speed, job.tissue.density, softest_tissue(job));
  for (const PredictionSet& set : job.predictions)
    for (const PredictedShot& shot : set.shots)
      widest = std::max(widest,
                        needed(shot.density, shot.speed, set.target_density, std::visit(SoftestOf{job}, set.material)));
  return widest;
}

}  // namespace percal
