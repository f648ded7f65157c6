// Dehn's closed form fitted to a job's shots by the same machinery: what the finite elements have to be better than.
#pragma once
#include "percal/calibrate/job_fit.hpp"

namespace percal {

DehnResult fit_dehn(const CalibrationJob& job);

}  // namespace percal
