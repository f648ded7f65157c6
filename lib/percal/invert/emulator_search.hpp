// The hyperparameters of the emulator: those of the greatest likelihood, held near the plausible where few runs say little.
//                                                                                              docs/theory/emulator.md
#pragma once
#include <vector>

#include "percal/invert/depth_covariance.hpp"
#include "percal/invert/emulator.hpp"

namespace percal {

// Runs as the Gaussian process sees them: values ln depth less their mean.
struct TrainingData {
  InputScale scale;
  MeshPoints points;
  Eigen::VectorXd values;
  double mean = 0;
  double plane_deviation = 0;  // prior standard deviation of the plane's constant and slopes

  explicit TrainingData(const std::vector<TrainingRun>& runs);
};

// Indices, in order, of at most `most` runs for the search: the fine ones (those not on the coarsest mesh) as far as half of
// the places go, and the others evenly spaced as they stand.
std::vector<int> runs_for_search(const std::vector<TrainingRun>& runs, int most);

EmulatorSettings find_settings(const std::vector<TrainingRun>& runs, const EmulatorOptions& options);

}  // namespace percal
