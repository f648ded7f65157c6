// The cheapest mesh and number of replicates for an error that is asked for. Where depths have no limit in the element's size the
// scene's own mesh stays, and the error is the noise alone.
#pragma once
#include <array>
#include <limits>
#include <optional>
#include <string>

#include "percal/study/error_vs_time.hpp"

namespace percal {

inline constexpr std::array<double, 3> advised_errors{0.05, 0.02, 0.01};
inline constexpr int most_advised_replicates = 100;
inline constexpr double farthest_advised_mesh = 1.5;  // of the ladder's finest: a fit is not trusted further

// In single precision, with the ladder's time step. Errors are shares of the depth; the error is the root of the sum of the
// squares of its two parts.
struct AdvisedSetting {
  double target = 0;
  bool is_found = false;
  std::string why_not;             // where none was found
  bool cost_is_estimated = false;  // the mesh is none of the ladder's: cost and, beyond it, error are estimates
  double elements_per_radius = 0;
  int replicates = 0;
  std::optional<double> discretisation_error;  // not there without a limit
  double noise_error = 0, error = 0;
  double cpu_seconds = 0;                                   // of all replicates; 0 where nobody has measured it
  std::optional<double> cpu_seconds_low, cpu_seconds_high;  // 95 of 100 cases; not there: unbounded
};

AdvisedSetting advise(const Ladder& ladder, const ErrorVsTime& study, double target);

// Of a scene without a limit, one run of which is known to scatter by `noise` on its own mesh: no ladder is needed. `known`: standard
// deviation of what is known of the depth before, and is joined with the runs.
AdvisedSetting advise(double elements_per_radius, double noise, double target,
                      double known = std::numeric_limits<double>::infinity());

}  // namespace percal
