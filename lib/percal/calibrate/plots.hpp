// Plots of a calibration: scripts for gnuplot, and the points as CSV.
#pragma once
#include <string>
#include <vector>

#include "percal/calibrate/result.hpp"
#include "percal/plot/chart.hpp"

namespace percal {

// "ridge_PARAMETER" for each modulus that has a ridge, its level sets in all hypotheses with the best points and the
// published ones; "depths_N", depths measured against model's, for each hypothesis (from 1); "error_vs_time", the
// emulators' error round by round.
std::vector<Plot> calibration_plots(const CalibrationJob& job, const CalibrationResult& result);

}  // namespace percal
