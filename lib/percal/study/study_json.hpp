// A study as JSON and as CSV: docs/formats/study.md.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "percal/study/advice.hpp"

namespace percal {

nlohmann::json error_vs_time_to_json(const Ladder& ladder, const ErrorVsTime& study,
                                     const std::vector<AdvisedSetting>& advice);
nlohmann::json advice_to_json(const AdvisedSetting& advice);
nlohmann::json rung_to_json(const Rung& rung);  // without errors

// One line a rung: the meshes, the half steps, the one in double precision.
std::string error_vs_time_csv(const Ladder& ladder, const ErrorVsTime& study);

}  // namespace percal
