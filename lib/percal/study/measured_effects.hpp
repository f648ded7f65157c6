// What half the time step, a farther wall and twice K do to a scene's depth: run, not ruled.
// docs/theory/errors.md, The error of one depth
#pragma once
#include <array>
#include <vector>

#include "percal/campaign/campaign.hpp"
#include "percal/observe/depth_error.hpp"

namespace percal {

// What is measured, each by a better setting of its own.
inline constexpr std::array measured_sources{DepthErrorSource::wall, DepthErrorSource::time_step,
                                             DepthErrorSource::bulk};

// The problem with the one setting better: the same meshes at the same speeds. All layers' K; graded columns grow as they did.
Problem with_better(DepthErrorSource source, const Problem& problem);

// How many runs measured_effects() makes, for a progress bar.
long effect_runs(int replicates);

// Of two or more replicates of the reduced scene, all stopped; more are run through the campaign. A source is left out where a run
// of its pairs did not stop.
std::vector<MeasuredEffect> measured_effects(const Reduction& reduction, const std::vector<Evaluation>& replicates,
                                             Campaign& campaign, Progress* progress);

}  // namespace percal
