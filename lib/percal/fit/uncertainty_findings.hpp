// What the intervals of a fit mean, in sentences.
#pragma once
#include <string>
#include <vector>

#include "percal/fit/uncertainty.hpp"

namespace percal {

// Which parameter the points do not determine and over which range they reach; errors that the residuals contradict;
// residuals that are no noise.
std::vector<std::string> uncertainty_findings(const Uncertainty& uncertainty, const CurveData& data,
                                              const CurveProblem& problem, const CurveFit& fit);

// "The stretch range 0.95 to 1.05", "The shear range 0 to 0.4", or both.
std::string range_of(const CurveData& data);

// Why a parameter cannot be known from points over this range: its interval reaches an end of the search, or is too
// wide. Empty where it can.
std::string undetermined(const ParameterUncertainty& parameter, const std::string& range, double level);

}  // namespace percal
