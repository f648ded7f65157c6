// The bootstrap over points: as many as there are, drawn with return, fitted anew.
#pragma once
#include "percal/estimate/intervals.hpp"

namespace percal {

// Percentile intervals at a level from `replicates` fits that start from the minimum. Assumes nothing of the points' errors but that
// the points are independent. The same seed gives the same numbers. The groups must have been estimated or the errors
// known, as the problem says. Draws with fewer than `parameters` + 1 different points count as failed.
Bootstrap bootstrap_over_points(const CalibrationProblem& problem, const Minimum& minimum, int replicates, double level,
                                unsigned seed, const SearchOptions& options);

// The problem whose data are those at `rows`, in that order, any of them more than once. It refers to `problem`.
CalibrationProblem drawn(const CalibrationProblem& problem, const std::vector<int>& rows);

}  // namespace percal
