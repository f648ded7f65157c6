// One width in radii for every sphere of a job: the widest that its shots need.     docs/formats/identify.md
#pragma once
#include "percal/identify/job.hpp"

namespace percal {

// Radii: what usual_width() asks of any of the job's shots, at the softest material that the job knows for it: of the tissue, where
// the search begins or a known pair; of a formulation, its own; of a prediction, the pair given. What the chain finds may be
// softer: the reduction of each impact says so.
double widest_needed(const IdentifyJob& job);

}  // namespace percal
