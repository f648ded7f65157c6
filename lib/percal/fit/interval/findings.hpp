// What a reader must know beside the numbers of a fit, a sentence each.
#pragma once
#include <string>
#include <vector>

#include "percal/fit/interval/uncertainty.hpp"

namespace percal {

// Of the fit: the sign of alpha and how well the other sign fits, a bound, a parameter that the points do not determine, a term
// that vanishes.
std::vector<std::string> findings(const CurveFit& fit);

// Of its intervals: which parameter the points do not determine and over which range they reach; errors that the residuals contradict;
// residuals that are no noise.
std::vector<std::string> uncertainty_findings(const Uncertainty& uncertainty, const CurveData& data,
                                              const CurveProblem& problem, const CurveFit& fit);

// Residuals that are no noise, by the correlation of neighbours among so many points; empty where they may be.        (33)
std::string systematic_misfit(const std::optional<double>& neighbour_correlation, std::size_t points);

// "The stretch range 0.95 to 1.05", "The shear range 0 to 0.4", or both.
std::string range_of(const CurveData& data);

// Why a parameter cannot be known from points over this range: its interval reaches an end of the search, or is too
// wide. Empty where it can.
std::string undetermined(const ParameterUncertainty& parameter, const std::string& range, double level);

}  // namespace percal
