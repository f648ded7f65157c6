// What percal fit prints.
#pragma once
#include <string>
#include <vector>

#include "percal/fit/compare_models.hpp"
#include "percal/fit/uncertainty.hpp"
#include "percal/material/stability.hpp"

namespace percal::tools {

std::string sources_as_text(const CurveData& data);
std::string fit_as_text(const CurveFit& fit, const CurveData& data, const StretchRange& stretches);
std::string uncertainty_as_text(const Uncertainty& uncertainty, const CurveFit& fit);
std::string comparison_as_text(const std::vector<ComparedModel>& models, const StretchRange& stretches);

}  // namespace percal::tools
