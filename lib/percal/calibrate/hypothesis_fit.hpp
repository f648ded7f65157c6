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
                          const JobModel& without_mesh, const JobFit& fit, const CalibrationLimits& limits,
                          int threads);

// Error of the emulator and of the data at the fitted shots, as relative standard deviations, means over the shots.
struct ErrorSizes {
  double emulator = 0, data = 0;
};
ErrorSizes error_sizes(const CalibrationJob& job, const JobModel& model, const JobFit& fit, int body);

}  // namespace percal
