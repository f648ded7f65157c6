// The answer to a request: shots, a curve over speed, the number that gives a depth; checked by runs where that is wanted.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/campaign/campaign.hpp"
#include "percal/page/result.hpp"
#include "percal/predict/request.hpp"

namespace percal {

// Runs of the shot at the best point of the sample, on the mesh that the prediction is of.
struct CheckedByRuns {
  int runs = 0;
  Outcome outcome = Outcome::stopped;  // the first that is not `stopped`
  MeanOfRuns depth;  // m; of a model that knows what passes, their reach. Nothing where a run has none
  // (ln mean depth of the runs - ln predicted) over the emulator's standard deviation and the runs' standard error.
  std::optional<double> standardised;
};

struct ShotPrediction {
  NamedShot shot;
  DepthPrediction depth;
  std::vector<double> elsewhere;  // m: under the other hypotheses, in their order
  std::optional<CheckedByRuns> checked;
};

struct Prediction {
  PredictRequest request;
  std::string material, hypothesis;   // names
  bool passage = false;               // of the model
  std::vector<RunNumber> beside;      // the numbers that it knows beside the depth
  std::vector<ShotPrediction> shots;  // none where a range of speeds was asked for, or the number was not found
  std::vector<double> speeds;         // m/s, of the curve; empty of several shots
  std::vector<DepthPrediction> curve;
  std::optional<SolvedShot> solved;
  std::vector<FiredShot>
      fired;  // into the same material by spheres of this size and density: to be drawn beside the curve
  std::vector<std::string> findings;
  page::Cost cost;
};

Prediction predict(const ShotModel& model, const PredictRequest& request);

// Runs every shot of the prediction.
void check_by_runs(Prediction& prediction, const ShotModel& model, Campaign& campaign);

}  // namespace percal
