// campaign: many evaluations side by side.
//
// What the store has is taken from there, the rest is run, one run on each core. Can be asked to stop.
//
//     percal::Store store("percal.store");
//     percal::Campaign campaign(&store, 2);
//     const auto runs = campaign.replicate({reduction.problem}, 3, nullptr);
#pragma once
#include "percal/campaign/campaign.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/campaign/sphere_runs.hpp"
