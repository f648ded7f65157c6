// The runs of a plan, and what came of them.
#pragma once
#include <string>
#include <vector>

#include "percal/base/progress.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/sweep/scene_at.hpp"

namespace percal {

// Of each point, the problems of its replicates.
std::vector<std::vector<Problem>> problems_of(const std::vector<SweepPoint>& points);

// Of these the distinct ones that a store (which may be null) does not have.
std::vector<std::vector<Problem>> problems_to_run(const std::vector<std::vector<Problem>>& of_points,
                                                  const Store* store);

// Runs of each point, in the order of its replicates. `progress` is told of every run, and says the time left by their work.
std::vector<std::vector<Evaluation>> run_points(const std::vector<SweepPoint>& points, Campaign& campaign,
                                                const Store* store, Progress& progress);

// What a run is found by in the store, as a digest: SHA-256 of its key. Of a point it is that of the middle replicate.
std::string store_digest(const SweepPoint& point);

}  // namespace percal
