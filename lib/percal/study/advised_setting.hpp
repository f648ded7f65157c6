// The cheapest mesh and number of replicates for an error that is asked for.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "percal/study/error_vs_time.hpp"

namespace percal {

inline constexpr std::array<double, 3> advised_errors{0.05, 0.02, 0.01};
inline constexpr int most_advised_replicates = 100;
inline constexpr int finest_advised_mesh = 1000;

// In single precision, with the ladder's time step. Errors are shares of the depth; the error is the root of the sum of the
// squares of its two parts.
struct AdvisedSetting {
  double target = 0;
  bool is_found = false;
  std::string why_not;             // where none was found
  bool cost_is_estimated = false;  // no mesh of the ladder reaches it: mesh, error and cost are extrapolated
  double elements_per_radius = 0;
  int replicates = 0;
  double discretisation_error = 0, noise_error = 0, error = 0;
  double cpu_seconds = 0;                                   // of all replicates
  std::optional<double> cpu_seconds_low, cpu_seconds_high;  // 95 of 100 cases; not there: unbounded
};

AdvisedSetting advise(const Ladder& ladder, const ErrorVsTime& study, double target);

}  // namespace percal
