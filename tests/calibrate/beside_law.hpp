// A number beside the depth that follows a smooth law which a test knows, and the emulators that have learnt both.
#pragma once
#include "calibrate/gel_job.hpp"

namespace percal::test {

// ln of the final depth over the deepest.
inline double final_law(const SphereInputs& at) {
  return -0.45 + 0.06 * at.log_pi4 - 0.05 * at.log_pi5 - 0.1 * std::log(at.erosion_strain);
}

// ln of the depth at half the speed over the deepest, and of the largest channel radius over the sphere's.
inline double half_speed_law(const SphereInputs& at) { return -0.4 + 0.01 * at.log_pi4; }
inline double channel_law(const SphereInputs& at) { return 0.05 + 0.14 * at.log_pi4 - 0.05 * at.log_pi5; }

template <class Law>
Emulators with_number(Emulators emulators, RunNumber number, const Law& law, double noise) {
  std::vector<TrainingRun> runs = emulators.depth().runs();
  Draws draws(2);
  for (TrainingRun& run : runs) run.log_depth = law(run.at) + noise * draws.normal();
  emulators.of.emplace(EmulatorOf{0, number}, Emulator(runs, EmulatorOptions{}));
  return emulators;
}

inline SphereInputs inputs_at(const CalibrationJob& job, const MeasuredShot& shot, const std::vector<double>& natural) {
  return shot_inputs(shot, target_at(job, job.hypotheses[0], job.targets[shot.target], natural)).at;
}

}  // namespace percal::test
