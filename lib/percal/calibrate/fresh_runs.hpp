// Runs at the best points of the hypotheses, on a finer mesh than the emulator learnt from: no answer is taken from it alone.
#pragma once
#include <map>
#include <optional>
#include <vector>

#include "percal/calibrate/job_fit.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// What an emulator's fit of each hypothesis of a job is: entry k of both belongs to hypothesis k.
struct FittedHypotheses {
  std::vector<JobModel> models;
  std::vector<JobFit> fits;
};

// The fitted shots of all hypotheses at their best points on the verifying mesh, one run each at a phase drawn by the job's seed: to
// check the emulator by, and to learn from. No evaluation where a run would not be done by the deadline.
struct SingleFreshRuns {
  struct Made {
    std::vector<Problem> problems;
    std::vector<std::optional<Evaluation>> evaluations;
  };
  std::map<int, Made> of_body;
  double worst_spread = 0;  // under the hypothesis where spread() is largest
};
SingleFreshRuns single_fresh_runs(const CalibrationJob& job, const FittedHypotheses& fitted, const Emulators& emulators,
                                  Campaign& campaign, const Campaign::Deadline& deadline);

// The same shots with their replicates over the mesh phase: [hypothesis][fitted shot]. Before the deadline every shot gets its first
// replicate before any gets a second; shots that got none are left out.
std::vector<std::vector<FreshRun>> fresh_runs(const CalibrationJob& job, const FittedHypotheses& fitted,
                                              const Emulators& emulators, Campaign& campaign,
                                              const Campaign::Deadline& deadline);

// The root mean square of (ln depth - ln emulated) over the emulator's stated error, noise included: 1 where that error is right. 0
// without a run that stopped.
double spread(const std::vector<FreshRun>& runs);

// Above it the emulator's stated error is taken to be too small; some 25 runs scatter about 1 by 0.14.
inline constexpr double trusted_spread = 1.3;

}  // namespace percal
