// How long a calibration may go on.
#pragma once
#include <chrono>
#include <optional>

namespace percal {

struct CalibrationLimits {
  std::optional<double> budget_seconds;  // wall time from `start`
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  // A share of the budget is over; never without a budget.
  bool spent(double share = 1) const {
    if (!budget_seconds) return false;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() >= share * *budget_seconds;
  }
};

}  // namespace percal
