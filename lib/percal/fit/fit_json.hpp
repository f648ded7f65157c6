// A fit as it stands in result.json.                                                            docs/formats/fit.md
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "percal/fit/compare_models.hpp"
#include "percal/material/stability.hpp"

namespace percal {

// Minima best first with units in the key names, points, tests, sources, stability of the best and findings. What does
// not exist is null; no number is infinite or NaN.
nlohmann::json to_json(const CurveFit& fit, const CurveData& data, const StretchRange& stretches);

// Files and columns alone, before anything is fitted.
nlohmann::json to_json(const CurveData& data);

// A list of the models in their order.
nlohmann::json to_json(const std::vector<ComparedModel>& models, const StretchRange& stretches);

}  // namespace percal
