// Which measurement would help most: shots at speeds and into materials of the job that could be made, and curves.
#pragma once
#include "percal/calibrate/error_budget.hpp"

namespace percal {

// The best few for each quantity, best first; what each would do to the quantity's interval, linearised.
std::vector<Advice> advise(const CalibrationJob& job, const JobModel& model, const JobFit& fit,
                           const std::vector<LogQuantity>& quantities);

}  // namespace percal
