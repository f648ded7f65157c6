// A calibration from the job to the result: an emulator trained, every hypothesis fitted, checked by fresh runs and compared.
#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "percal/calibrate/result.hpp"
#include "percal/campaign/campaign.hpp"

namespace percal {

// How long a calibration may go on.
struct CalibrationLimits {
  std::optional<double> budget_seconds;  // wall time from `start`
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  // A share of the budget is over; never without a budget.
  bool spent(double share = 1) const {
    if (!budget_seconds) return false;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() >= share * *budget_seconds;
  }
};

// Announces what it does in sentences. A budget that runs out ends the training and the checks early, which the result says. With
// more failed runs than the job tolerates the result has no hypotheses and says why.
CalibrationResult calibrate(const CalibrationJob& job, Store& store, Campaign& campaign,
                            const CalibrationLimits& limits, const std::function<void(const std::string&)>& announce);

}  // namespace percal
