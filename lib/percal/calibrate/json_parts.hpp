// Pieces that several parts of a calibration's JSON are made of. For the .cpp files of this folder.
#pragma once
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "percal/calibrate/result.hpp"

namespace percal::calibration_json {

using Json = nlohmann::json;

inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
inline Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

// "value" with the parameter's unit behind it: "value_Pa".
inline std::string with_unit(const std::string& key, const FreeParameter& parameter) {
  return parameter.unit.empty() ? key : key + "_" + parameter.unit;
}

Json numbers(const std::vector<double>& values);
Json interval_to_json(const Interval& interval);
Json estimate_to_json(const Estimate& estimate, const std::string& unit);  // {"value_UNIT", "interval_UNIT"}
Json deviation_to_json(const Deviation& deviation);
Json shot_depths_to_json(const CalibrationJob& job, const std::vector<ShotDepth>& depths);
Json cross_validations_to_json(const CalibrationJob& job, const std::vector<CrossValidationResult>& all);

// One entry for each parameter at the best minimum: value, intervals, whether it is known.
Json parameters_to_json(const std::vector<FreeParameter>& parameters, const Minimum& best,
                        const std::vector<ProfileInterval>& intervals, const std::optional<Bootstrap>& bootstrap);
Json minimum_to_json(const CalibrationJob& job, const std::vector<FreeParameter>& parameters, const Minimum& minimum);

Json job_to_json(const CalibrationJob& job);                                             // job_json.cpp
Json hypothesis_to_json(const CalibrationJob& job, const HypothesisResult& hypothesis);  // hypothesis_json.cpp
Json dehn_to_json(const CalibrationJob& job, const DehnResult& dehn);                    // hypothesis_json.cpp
Json emulator_to_json(const CalibrationJob& job, const EmulatorReport& emulator);        // result_json.cpp

}  // namespace percal::calibration_json
