// Intervals and rate factors as they stand in result.json.                                      docs/formats/fit.md
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "percal/fit/rate_factor.hpp"
#include "percal/fit/uncertainty.hpp"

namespace percal {

// Units in the key names; no number is infinite or NaN, what does not exist is null.
nlohmann::json to_json(const Uncertainty& uncertainty);
nlohmann::json to_json(const RateFactor& rate);

}  // namespace percal
