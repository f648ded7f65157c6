// One width in radii for all shots of a job, for one emulator answers for all.
#pragma once
#include "percal/calibrate/job.hpp"

namespace percal {

// Radii: the widest that usual_width() asks of any shot at the softest that any hypothesis' bounds let its material be.
double width_needed(const CalibrationJob& job);

}  // namespace percal
