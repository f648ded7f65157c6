// The result of `percal calibrate`: its result.json, and the page that says what is in it.
#pragma once
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

struct CalibrationJob;
struct CalibrationResult;

// Units in the key names, intervals as {low, high, low_open, high_open}; every key is there, null where there is nothing, and no
// number is infinite or NaN.                                                                    docs/formats/calibrate.md
page::Json calibration_to_json(const CalibrationJob& job, const CalibrationResult& result);

page::Page calibrate_page(const page::Json& result);

}  // namespace percal
