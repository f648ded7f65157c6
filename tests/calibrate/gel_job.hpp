// A small job whose depths follow a smooth law that a test knows, and an emulator that has learnt it.
#pragma once
#include <cmath>

#include "percal/calibrate/job_fit.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/math/draws.hpp"

namespace percal::test {

// ln(depth/radius): softer, faster, heavier goes deeper; harder to erode goes less deep.
inline double smooth_law(const SphereInputs& at) {
  return 2 + 0.35 * at.log_pi4 - 0.5 * at.log_pi5 - 0.05 * at.alpha - 0.5 * std::log(at.erosion_strain) +
         0.02 * at.log_pi4 * at.alpha - 0.3 * at.log_erosion_length;
}

// With `length` over lengths from 0.1 radii to 1, with four elements in each.
inline Emulator emulator_of_the_smooth_law(int runs = 150, double noise = 0.002, bool length = false) {
  const auto points = sobol_points(runs, sphere_inputs, 1);
  Draws draws(1);
  std::vector<TrainingRun> training;
  for (int k = 0; k < runs; ++k) {
    const auto u = points.row(k);
    const SphereInputs at{std::log(3.0) + u[0] * std::log(60.0),
                          std::log(1 / 17.0) + u[1] * std::log(15.0),
                          4 + 8 * u[2],
                          0.3 + 1.2 * u[3],
                          std::log(50.0) + u[4] * std::log(3.0),
                          std::log(50.0) + u[5] * std::log(40.0),
                          length ? std::log(0.1) + u[6] * std::log(10.0) : 0};
    training.push_back({at, length ? 0.25 : 0.1, smooth_law(at) + noise * draws.normal()});
  }
  return Emulator(training, EmulatorOptions{});
}

inline CalibrationJob gel_job(int speeds = 8) {
  CalibrationJob job;
  job.file = job.text = "gel";
  job.parameters = {
      {ParameterKind::modulus, {.name = "mu", .unit = "Pa", .low = 50e3, .high = 900e3}},
      {ParameterKind::exponent, {.name = "alpha", .unit = "", .low = 4, .high = 12, .logarithmic = false}},
      {ParameterKind::erosion_strain, {.name = "erosion_strain", .unit = "", .low = 0.3, .high = 1.5}}};
  job.materials = {{.name = "gel",
                    .density = 1010,
                    .mu = SharedParameter{0},
                    .alpha = SharedParameter{1},
                    .erosion_strain = SharedParameter{2},
                    .rate_factor = {},
                    .curve_modulus = {}}};
  job.targets = {{.name = "gel"}};
  job.groups = {{"shots", true, 0}};
  job.sets = {{"balls", false}};
  for (int k = 0; k < speeds; ++k) {
    MeasuredShot shot;
    shot.label = "shot " + std::to_string(k);
    shot.radius = 1.59e-3;
    shot.density = k % 2 == 0 ? 7800 : 4540;
    shot.speed = 45 + 8 * k;
    shot.layer_depth = 0.12;
    shot.layer_width = 5 * shot.radius;
    shot.row = {{"material", k % 2 == 0 ? "steel" : "titanium"}};
    job.shots.push_back(shot);
  }
  job.hypotheses = {{.name = "free", .held = {}}};
  return job;
}

// The same judged over a length, on balls of two sizes.
inline CalibrationJob gel_job_with_length(int speeds = 8) {
  CalibrationJob job = gel_job(speeds);
  job.parameters.push_back(
      {ParameterKind::erosion_length, {.name = "length", .unit = "m", .low = 0.2e-3, .high = 0.7e-3}});
  job.materials[0].erosion_length = SharedParameter{3};
  job.training.coarse = job.training.fine = job.training.verify = 4;
  for (int k = 0; k < speeds; k += 3) {
    job.shots[k].radius = 0.8e-3;
    job.shots[k].layer_width = 5 * job.shots[k].radius;
  }
  return job;
}

// Depths that the law gives at these natural values, times exp(scatter z).
inline void measure(CalibrationJob& job, const std::vector<double>& natural, double scatter, unsigned seed) {
  Draws draws(seed);
  for (auto& shot : job.shots) {
    const auto at = shot_inputs(shot, target_at(job, job.hypotheses[0], job.targets[shot.target], natural)).at;
    shot.depth = shot.radius * std::exp(smooth_law(at) + scatter * draws.normal());
  }
}

}  // namespace percal::test
