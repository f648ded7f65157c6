// A calibration from the job to the result: an emulator trained, every hypothesis fitted, checked by fresh runs and compared.
#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "percal/calibrate/result.hpp"
#include "percal/campaign/campaign.hpp"

namespace percal {

// Shares of a budget, in the order of what comes: by when training, what is read out of its fits, and fresh runs are over. The rest is
// for the result's files.
inline constexpr double share_for_training = 0.55, share_for_reading = 0.75, share_for_fresh_runs = 0.97;

// How long a calibration may go on.
struct CalibrationLimits {
  std::optional<double> budget_seconds;  // wall time from `start`
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  // When a share of the budget is over; never without a budget.
  Campaign::Deadline deadline(double share) const {
    if (!budget_seconds) return std::nullopt;
    const std::chrono::duration<double> time(share * *budget_seconds);
    return start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(time);
  }
  bool spent(double share) const { return budget_seconds && std::chrono::steady_clock::now() >= deadline(share); }
};

// Announces what it does in sentences. A budget that runs out ends the training and the checks early, which the result says. With
// more failed runs than the job tolerates the result has no hypotheses and says why.
CalibrationResult calibrate(const CalibrationJob& job, Store& store, Campaign& campaign,
                            const CalibrationLimits& limits, const std::function<void(const std::string&)>& announce);

}  // namespace percal
