// A fit as it stands in result.json.                                                            docs/formats/fit.md
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "percal/fit/fit_ogden.hpp"

namespace percal {

// Minima best first with units in the key names, points, sources and findings. What does not exist is null; no number
// is infinite or NaN.
nlohmann::json to_json(const OgdenFit& fit, const CurveData& data);

// Files and columns alone, before anything is fitted.
nlohmann::json to_json(const CurveData& data);

}  // namespace percal
