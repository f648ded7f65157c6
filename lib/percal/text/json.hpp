// JSON from files that anybody may have written: the one reader of results.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace percal {

// Results are some megabytes and ten levels deep; beyond these limits a file is none.
inline constexpr std::size_t largest_json = 64 << 20;  // bytes
inline constexpr int deepest_json = 64;                // objects and arrays inside each other

// Throws BadInput with the line: text that is not JSON, beyond the limits, or with a number beyond a double's range. `wanted` says what
// is accepted: "a result.json of percal".
nlohmann::json parse_json(const std::string& text, const std::string& file, const std::string& wanted);

}  // namespace percal
