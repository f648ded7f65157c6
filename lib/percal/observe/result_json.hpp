// Runs as JSON: the store's payload, and parts of result files.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "percal/observe/penetration.hpp"

namespace percal {

// The payload of a stored evaluation: everything but the history, doubles to the last bit.
std::string to_payload(const Evaluation& evaluation);
// Throws std::invalid_argument where the text is not such a payload (a store of another version).
Evaluation from_payload(const std::string& payload);

nlohmann::json energy_to_json(const EnergyLedger& energy);

// t, tip, speed and force in SI as CSV with units in the header.
std::string history_csv(const std::vector<HistoryPoint>& history, const Scales& scales);

}  // namespace percal
