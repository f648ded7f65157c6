#include "percal/campaign/run_cost.hpp"

#include "percal/math/instruction_level.hpp"

namespace percal {

page::Cost cost_since(std::chrono::steady_clock::time_point start, const Campaign& campaign) {
  const CampaignCost cost = campaign.cost();
  return {.runs = cost.runs,
          .reused = cost.reused,
          .cpu_seconds = cost.cpu_seconds,
          .wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          .instruction_level = instruction_level()};
}

}  // namespace percal
