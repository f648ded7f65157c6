// What further runs say of a depth's error, beyond the rules.     docs/theory/errors.md, The error of one depth
#pragma once
#include <vector>

#include "percal/campaign/campaign.hpp"
#include "percal/observe/depth_error.hpp"

namespace percal {

struct ErrorsAskedFor {
  bool measured = false;      // wall, time step and K, each by a better setting
  bool extrapolated = false;  // to no element size, by a finer mesh
};

// Throws BadInput, which names the option, where the scene cannot answer: one replicate, no erosion length, too fine a mesh.
void check_errors_asked_for(const ErrorsAskedFor& asked, const Scene& scene);

// Of the scene's finished replicates; nothing where they did not all stop. What could not be found is in its notes.
ErrorEvidence error_evidence(const ErrorsAskedFor& asked, const Scene& scene, const Reduction& reduction,
                             const std::vector<Evaluation>& replicates, const Penetration& penetration,
                             Campaign& campaign);

}  // namespace percal
