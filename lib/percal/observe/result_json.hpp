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

// Time, tip, speed and force in SI and the energies' shares as CSV with units in the header.
std::string history_csv(const std::vector<HistoryPoint>& history, const Scales& scales);
// The same columns: {"time_s": [...], "tip_m", "speed_m_s", "force_N", "energy": {term: [...], "sum": [...]}}.
nlohmann::json history_to_json(const std::vector<HistoryPoint>& history, const Scales& scales);

}  // namespace percal
