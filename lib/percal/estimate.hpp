// estimate: parameters from data of any kind.
//
// Weighted least squares with priors, bounds and a scatter that the data tell; every distinct minimum; profile
// intervals, bootstrap, ridges, and what the data cannot tell. The model is a function.
//
//     const auto minima = percal::find_minima(problem, {});
//     const auto intervals = percal::profile_intervals(problem, minima.front(), 0.95, {});
//
// See docs/theory/calibration.md.
#pragma once
#include "percal/estimate/intervals.hpp"
#include "percal/estimate/least_squares.hpp"
