// A calibration from the job to the result: emulators trained, every hypothesis fitted, checked by fresh runs and compared.
#pragma once
#include <functional>
#include <string>

#include "percal/calibrate/limits.hpp"
#include "percal/calibrate/result.hpp"
#include "percal/campaign/campaign.hpp"

namespace percal {

// Announces what it does in sentences. A budget that runs out ends the training and the checks early, which the result says. With
// more failed runs than the job tolerates the result has no hypotheses and says why.
CalibrationResult calibrate(const CalibrationJob& job, Store& store, Campaign& campaign,
                            const CalibrationLimits& limits, const std::function<void(const std::string&)>& announce);

}  // namespace percal
