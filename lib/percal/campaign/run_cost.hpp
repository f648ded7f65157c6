// What a campaign cost, as results say it.
#pragma once
#include <chrono>

#include "percal/campaign/campaign.hpp"
#include "percal/page/result.hpp"

namespace percal {

// Of the campaign's runs up to now; wall seconds are those since `start`.
page::Cost cost_since(std::chrono::steady_clock::time_point start, const Campaign& campaign);

}  // namespace percal
