// Ladders made by hand: depths with a known limit, order and noise.
#pragma once
#include <cmath>

#include "percal/study/page/error_vs_time.hpp"

namespace percal::study_test {

inline Rung rung_at(double mesh, double depth, double spread, int replicates = 5) {
  Rung rung;
  rung.elements_per_radius = mesh;
  rung.time_step_factor = 0.8;
  rung.replicates = replicates;
  rung.elements = std::lround(112 * mesh * mesh);
  rung.steps = 800.0 * mesh;
  rung.cpu_seconds = 1e-3 * mesh * mesh * mesh;
  auto& p = rung.penetration;
  p.outcome = Outcome::stopped;
  p.outcomes.assign(replicates, Outcome::stopped);
  p.depth = depth;
  p.spread = spread;
  p.standard_error = spread / std::sqrt(replicates);
  return rung;
}

// 27 (1 + a h^p) on 5 to 28 elements per radius, a run scattering by `noise` of it; the means are exact.
inline Ladder ladder_of(double a, double p, double noise) {
  Ladder ladder;
  ladder.options.time_step_factor = 0.8;
  for (const double mesh : ladder.options.meshes) {
    const double depth = 27 * (1 + a * std::pow(mesh, -p));
    ladder.meshes.push_back(rung_at(mesh, depth, noise * depth));
  }
  ladder.half_steps = {ladder.meshes[1], ladder.meshes[3]};
  for (Rung& half : ladder.half_steps) half.time_step_factor = 0.4;
  ladder.double_precision = ladder.meshes[1];
  ladder.double_precision.arithmetic = Arithmetic::double_precision;
  return ladder;
}

// The same with a spread that is `noise` on 10 elements per radius and goes as their size.
inline Ladder eroding_ladder_of(double a, double p, double noise) {
  Ladder ladder = ladder_of(a, p, noise);
  for (Rung& rung : ladder.meshes) {
    *rung.penetration.spread *= 10 / rung.elements_per_radius;
    *rung.penetration.standard_error *= 10 / rung.elements_per_radius;
  }
  return ladder;
}

// Of a scene on 10 elements per radius whose erosion is local.
inline Ladder local_ladder_of(double a, double p, double noise) {
  Ladder ladder = eroding_ladder_of(a, p, noise);
  ladder.refinement = Refinement::no_limit;
  ladder.scene_mesh = 10;
  return ladder;
}

inline void pass_through(Rung& rung) {
  auto& p = rung.penetration;
  p.outcome = Outcome::passed_through;
  p.outcomes.assign(rung.replicates, Outcome::passed_through);
  p.depth = p.spread = p.standard_error = std::nullopt;
  p.at_least = 75;
}

// As percal study --error-vs-time would write it.
inline page::Json result_of(const Ladder& ladder) {
  Scene scene;
  scene.source = "/a/gold.toml";
  scene.particle.name = "gold";
  scene.target.name = "skin";
  const ErrorVsTime study = error_vs_time(ladder);
  std::vector<AdvisedSetting> advice;
  for (const double target : advised_errors) advice.push_back(advise(ladder, study, target));
  return error_vs_time_to_json(scene, ladder, study, advice, {.runs = 42, .reused = 3, .cpu_seconds = 1.5});
}

}  // namespace percal::study_test
