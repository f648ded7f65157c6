// Depths of shots that were not fired, from what a calibration has kept: by the emulator, over the sample of its parameters.
//                                                                                               docs/theory/prediction.md
#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "percal/invert/depth_covariance.hpp"
#include "percal/predict/shot_model.hpp"

namespace percal {

// Where a number of a shot may be, m.
struct PredictedRange {
  Between mean;  // of the mean over many such shots: parameters and emulator
  Between shot;  // of one such shot: its scatter and its speed's error, too
  // Standard deviations of its logarithm by source.
  double by_parameters = 0, by_emulator = 0, by_scatter = 0, by_speed = 0;
};

// Another number of a shot, that runs tell beside its depth.
struct NumberPrediction : PredictedRange {
  double value = 0;  // m: at the best point of the sample
};

// The depth of a shot in a layer that it does not pass through; of a model that knows what passes, its reach (invert/reach.hpp).
struct DepthPrediction : PredictedRange {
  double depth = 0;                  // m: at the best point of the sample
  double passes = 0;                 // probability that one such shot goes as deep as the layer
  double speed_exponent = 0;         // d ln depth / d ln speed
  std::vector<std::string> outside;  // in which ways this goes beyond what the calibration has seen; empty: in none
  std::map<RunNumber, NumberPrediction> beside = {};  // of the numbers that the model knows
};

// Which of a shot's numbers is looked for.
enum class ShotNumber { speed, diameter, density };

// The number at which the depth is a given one.
struct SolvedShot {
  bool found = false;  // false: not within a factor of `solved_within` of where the search began
  SphereShot at;       // with the number that was found
  double value = 0;    // speed, diameter or density, SI
  Between mean;        // where the mean depth is the given one: parameters and emulator
  Between shot;        // where the depth of one shot may be: its scatter, too
  std::vector<std::string> outside;
};
inline constexpr double solved_within = 30;

class Predictor {
 public:
  // Of one material under one hypothesis (indices), with intervals at `level`. Keeps a pointer to the model.
  Predictor(const ShotModel& model, int hypothesis, int material, double level);

  // `speed_error`: relative standard deviation of every speed.
  std::vector<DepthPrediction> depths(std::span<const SphereShot> shots, double speed_error = 0) const;

  // The speed, diameter or density of a shot that is otherwise `like` this, for which the depth is `depth` (m).
  SolvedShot solve(ShotNumber wanted, const SphereShot& like, double depth, double speed_error = 0) const;

  // The same material under another hypothesis, by the same emulator; depths at its best point, m.
  Predictor under(int hypothesis) const;
  std::vector<double> best_depths(std::span<const SphereShot> shots) const;

  // ln depth in m: of each point of the sample (rows) for each shot; the emulator's standard deviations at the best point.
  Eigen::MatrixXd log_depths(std::span<const SphereShot> shots) const;
  Eigen::VectorXd emulator_errors(std::span<const SphereShot> shots) const;
  // By how much the shot lies beyond the emulator's runs at the best point, in half their range; 0: not at all.
  double beyond_runs(const SphereShot& shot) const;

  const MaterialSample& material() const { return model_->hypotheses[hypothesis_].materials[material_]; }

 private:
  Eigen::MatrixXd log_depths(std::span<const CoveredMaterial> points, std::span<const SphereShot> shots) const;
  NumberPrediction number(RunNumber number, const SphereShot& shot, double speed_error) const;
  std::vector<std::string> outside(const SphereShot& shot) const;

  const ShotModel* model_;
  Emulators emulators_;
  std::map<int, InputScale> scales_;  // of the runs of each body
  int hypothesis_, material_;
  double level_;
};

}  // namespace percal
