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

// The fitted shots of all hypotheses at their best points on the verifying mesh: to check the emulator by, and to learn from where it
// does not hold. One run of a shot has a phase of the mesh that the job's seed draws, several walk over it.
struct FreshRuns {
  struct Made {
    std::vector<Problem> problems;
    std::vector<std::optional<Evaluation>> evaluations;  // none where a run would not be done by the deadline
  };
  std::map<int, Made> of_body;            // by place_of_body()
  std::vector<std::vector<FreshRun>> of;  // each hypothesis: its shots in order, without those that got no run

  bool complete() const;
  double worst_spread() const;  // under the hypothesis where spread() is largest
};

// Before the deadline every shot gets its first run before any gets a second.
FreshRuns fresh_runs(const CalibrationJob& job, const FittedHypotheses& fitted, const Emulators& emulators,
                     Campaign& campaign, const Campaign::Deadline& deadline);

// The root mean square of (ln depth - ln emulated) over the emulator's stated error, noise included: 1 where that error is right. 0
// without a run that stopped.
double spread(const std::vector<FreshRun>& runs);

// Above it the emulator's stated error is taken to be too small; some 25 runs scatter about 1 by 0.14.
inline constexpr double trusted_spread = 1.3;

}  // namespace percal
