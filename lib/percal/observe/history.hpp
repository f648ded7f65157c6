// The penetration history of a run, in SI.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "percal/impact/result.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// time_s, tip_m, speed_m_s, the force on the whole particle (force_N; in plane strain force_N_per_m, of a metre of thickness), and
// the energies' shares, as CSV.
std::string history_csv(const std::vector<HistoryPoint>& history, const Problem& problem, const Scales& scales);
// The same columns: {"time_s": [...], "tip_m", "speed_m_s", "force_N" or "force_N_per_m", "energy": {term: [...], "sum": [...]}}.
nlohmann::json history_to_json(const std::vector<HistoryPoint>& history, const Problem& problem, const Scales& scales);

}  // namespace percal
