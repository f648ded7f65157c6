// One hypothesis of a job, from the emulator's fit to all that is said about it.
#pragma once
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/job_fit.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Fit, intervals, predictions, cross-validations, error budgets, advice; no runs are made. What takes long is left out, and said to
// be, where the budget is spent.
HypothesisResult read_out(const CalibrationJob& job, int hypothesis, const JobModel& model,
                          const JobModel& without_mesh, const JobFit& fit, const CalibrationLimits& limits);

// The fitted shots at the best point, on the verifying mesh.
std::vector<Problem> fresh_problems(const CalibrationJob& job, int hypothesis, const JobModel& model,
                                    const JobFit& fit);

// These runs, with their replicates, beside the emulator.
std::vector<FreshRun> fresh_runs(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit,
                                 const Emulator& emulator, Campaign& campaign);

// Root mean square of the standardised differences: 1 where the emulator's stated error is right. 0 without a run that stopped.
double spread(const std::vector<FreshRun>& runs);

// Above it the emulator's stated error is taken to be too small; some 25 runs scatter about 1 by 0.14.
inline constexpr double trusted_spread = 1.3;

// Error of the emulator and of the data at the fitted shots, as relative standard deviations, means over the shots.
struct ErrorSizes {
  double emulator = 0, data = 0;
};
ErrorSizes error_sizes(const CalibrationJob& job, const JobModel& model, const JobFit& fit);

}  // namespace percal
