// result.json of a calibration.   docs/formats/calibrate.md
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "percal/calibrate/result.hpp"

namespace percal {

// Units in the key names, intervals as {low, high, low_open, high_open}; what does not exist is null, and no number is
// infinite or NaN.
nlohmann::json calibration_to_json(const CalibrationJob& job, const CalibrationResult& result);

}  // namespace percal
