// What a calibration of a gel keeps whose depths follow a smooth law that a test knows.
#pragma once
#include "calibrate/gel_job.hpp"
#include "percal/predict/predictor.hpp"

namespace percal::test {

inline constexpr LayerMaterial true_gel{.density = 1010, .mu_true = 200e3, .alpha = 8, .erosion_strain = 0.8};

inline std::vector<FiredShot> steel_balls() {
  std::vector<FiredShot> shots;
  for (const double speed : {60.0, 80.0, 100.0}) {
    FiredShot shot{};
    shot.radius = 1.59e-3;
    shot.density = 7800;
    shot.speed = speed;
    shot.layer_depth = 0.12;
    shot.layer_width = 8e-3;
    shot.depth = 0.04;
    shot.label = "steel " + words_of(shot);
    shots.push_back(shot);
  }
  return shots;
}

// Three steel spheres of one size. The sample is the truth, and points to both sides of it in the modulus.
inline ShotModel smooth_model(double scatter = 0.05, double freedom = 6) {
  const Emulator emulator = emulator_of_the_smooth_law();
  ShotModel model{.elements = 10,
                  .shots = steel_balls(),
                  .runs = emulator.runs(),
                  .settings = emulator.settings(),
                  .hypotheses = {}};
  MaterialSample gel{.name = "gel", .points = {true_gel}, .scatter = scatter, .freedom = freedom};
  for (const double factor : {0.9, 1.1}) {
    LayerMaterial point = true_gel;
    point.mu_true *= factor;
    gel.points.push_back(point);
  }
  model.hypotheses = {{.name = "as given", .mesh_error = -0.02, .materials = {gel}}};
  return model;
}

inline double true_depth(const SphereShot& shot) {
  return shot.radius * std::exp(smooth_law(shot_inputs(shot, true_gel).at));
}

}  // namespace percal::test
