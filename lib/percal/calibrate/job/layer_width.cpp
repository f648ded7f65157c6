// The width of the layers of a job that says none.     docs/formats/calibrate.md
#include "percal/calibrate/layer_width.hpp"

#include <algorithm>
#include <cmath>

#include "percal/calibrate/job/read_job.hpp"
#include "percal/scene/width.hpp"

namespace percal {
namespace {

struct Bounds {
  double low, high;
};

Bounds bounds_of(const CalibrationJob& job, const Hypothesis& hypothesis, const MaterialNumber& number) {
  const auto* shared = std::get_if<SharedParameter>(&number);
  if (!shared) return {std::get<double>(number), std::get<double>(number)};
  if (const auto held = hypothesis.held.find(shared->index); held != hypothesis.held.end())
    return {held->second, held->second};
  const FreeParameter& free = job.parameters[shared->index].free;
  return {free.low, free.high};
}

// The largest shares and the shortest times that the hypothesis allows.
PronySeries most_relaxed(const CalibrationJob& job, const Hypothesis& hypothesis, const CalibrationMaterial& material) {
  PronySeries series;
  for (const auto& [share, time] : material.relaxation)
    series.terms.push_back({bounds_of(job, hypothesis, share).high, bounds_of(job, hypothesis, time).low});
  return series;
}

// Pa: the softest that any hypothesis lets a material be at a shot's rate.
double softest(const CalibrationJob& job, const CalibrationMaterial& material, const SphereShot& shot) {
  double softest = INFINITY;
  for (const Hypothesis& hypothesis : job.hypotheses) {
    const Bounds mu = bounds_of(job, hypothesis, material.mu), alpha = bounds_of(job, hypothesis, material.alpha);
    for (const double m : {mu.low, mu.high})
      for (const double a : {alpha.low, alpha.high}) {
        const double mu_true = true_modulus(m, a, hypothesis.convention);
        if (!(mu_true > 0)) continue;
        const Bounds rate = bounds_of(job, hypothesis, material.rate_exponent);
        for (const double exponent : {rate.low, rate.high})
          softest = std::min(softest, mu_true * rate_factor({.rate_exponent = exponent,
                                                             .reference_rate = material.reference_rate,
                                                             .relaxation = most_relaxed(job, hypothesis, material)},
                                                            shot.speed / shot.radius));
      }
  }
  return softest;
}

}  // namespace

double width_needed(const CalibrationJob& job) {
  double widest = 0;
  for (const MeasuredShot& shot : job.shots) {
    if (shot.body) continue;
    for (std::size_t m = 0; m < job.materials.size(); ++m) {
      if (!meets(job, shot, static_cast<int>(m))) continue;
      const CalibrationMaterial& material = job.materials[m];
      const double pi4 = material.density * shot.speed * shot.speed / softest(job, material, shot);
      widest = std::max(widest, usual_width(pi4, shot.density / material.density));
    }
  }
  return widest;
}

void settle_width(CalibrationJob& job) {
  for (const int body : bodies_of(job)) {
    double radii = 0;
    for (const MeasuredShot& shot : job.shots)
      if (place_of_body(shot) == body) radii = std::max(radii, shot.layer_width / shot.radius);
    const bool chosen = radii == 0;
    if (body == 0) job.width_was_chosen = chosen;
    for (MeasuredShot& shot : job.shots)
      if (place_of_body(shot) == body && shot.layer_width == 0)
        shot.layer_width = (chosen ? farthest_wall : radii) * shot.radius;
  }
}

}  // namespace percal
