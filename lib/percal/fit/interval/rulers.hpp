// Which points a fit hangs on that misses its curve.
#pragma once
#include <string>
#include <vector>

#include "percal/fit/search/fit_curves.hpp"

namespace percal {

inline constexpr double poor_fit = 0.5;  // R^2 below which a fit misses its curve

// A sentence where R^2 of the best minimum is below poor_fit: which few points rule the sum of squares, and what absolute residuals give.
std::vector<std::string> rulers(const CurveData& data, const CurveFit& fit);

}  // namespace percal
