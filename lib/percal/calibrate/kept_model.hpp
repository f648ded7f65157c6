// What a calibration keeps for shots that were not fired.                                       docs/theory/prediction.md
#pragma once
#include "percal/calibrate/job_fit.hpp"

namespace percal {

// The job's materials at the best point of a fit and at a sample of the points that the data do not rule out. The scatter is that of the
// material's fitted shots; where those are of several groups, or there are none, the largest.
ShotHypothesis for_shots(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit);

// Nothing where nothing was shot or fitted. Moves `for_shots` of the result's hypotheses.
std::optional<ShotModel> kept_model(const CalibrationJob& job, const Emulators& emulators, CalibrationResult& result);

}  // namespace percal
