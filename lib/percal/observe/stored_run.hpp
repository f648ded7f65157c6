// A run as the store keeps it: everything but the history, as JSON of dimensionless numbers.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "percal/observe/penetration.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// The payload of a stored evaluation, doubles to the last bit. Stores of earlier versions have this format.
std::string to_payload(const Evaluation& evaluation);
// Throws std::invalid_argument where the text is not such a payload (a store of another version).
Evaluation from_payload(const std::string& payload);

// Whether a stored run of this problem is one of an earlier version, or of somebody who asked for less: it is to be run again.
bool lacks_something(const ImpactResult& result, const Problem& problem);

// {term: share, ..., "sum"}
nlohmann::json energy_to_json(const EnergyLedger& energy);

}  // namespace percal
