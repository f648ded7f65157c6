// Two meshes to h = 0, where erosion has a length.     docs/theory/errors.md, The error of one depth
#pragma once
#include "percal/campaign/campaign.hpp"
#include "percal/observe/depth_error.hpp"

namespace percal {

// Elements per radius of the second mesh over the first one's.
inline constexpr double finer_mesh = 2;

// Throws BadInput where the scene has no erosion length, with fewer than two replicates, and where the finer mesh is too large.
void need_a_limit(const Scene& scene);

// d0 = (4 d(2 n) - d(n))/3 of two phase means that all stopped.
Extrapolation extrapolate(const Penetration& coarse, const Penetration& fine, double elements_per_radius);

// Runs the finer mesh beside the scene's own replicates. Nothing where a run of either did not stop.
std::optional<Extrapolation> extrapolated(const Scene& scene, const Penetration& coarse, Campaign& campaign,
                                          Progress* progress);

}  // namespace percal
