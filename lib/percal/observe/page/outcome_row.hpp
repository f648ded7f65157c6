// What an impact says as one row of a table of many: the numbers and words of its own result (impact_json.hpp), flat.
#pragma once
#include <vector>

#include "percal/observe/page/impact_json.hpp"
#include "percal/page/result_csv.hpp"

namespace percal {

// Keys of a row that are read elsewhere.
namespace outcome_key {
inline constexpr const char *outcome = "outcome", *depth = "depth_m", *depth_error = "depth_error_m",
                            *at_least = "depth_at_least_m", *speed_left = "speed_left_m_s", *notes = "notes",
                            *cpu_seconds = "cpu_s";
}

// The keys of outcome_columns(); null is what there is none of.
page::Json outcome_row(const ImpactFindings& findings);

// Those of a CSV file, in order.
std::vector<page::ResultColumn> outcome_columns();

}  // namespace percal
