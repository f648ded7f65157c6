#pragma once
#include "percal/estimate/least_squares.hpp"

namespace percal {

// Whether two minima are one: the same point, or points of one ridge, between which the objective rises by less than `barrier`.
inline constexpr double barrier = 0.1;  // of -2 ln likelihood: nothing that data could show
bool connected(const CalibrationProblem& problem, const Minimum& from, const Minimum& to);

}  // namespace percal
