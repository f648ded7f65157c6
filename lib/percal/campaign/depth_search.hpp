// Searches for the number at which an impact is as deep as was measured, with runs as the answers.
#pragma once
#include <functional>
#include <vector>

#include "percal/campaign/campaign.hpp"
#include "percal/invert/modulus.hpp"

namespace percal {

// What the runs of one impact answer to a search, m.
DepthAnswer answer_of(const Penetration& found);

// One run an answer, each of the next phase of the mesh, so that a line through them is none of one phase. `worst_closure`: of the energy, kept
// by the caller as the campaign is.
DepthOfModulus one_run_an_answer(Campaign& campaign, std::function<Reduction(double log_value)> reduction,
                                 double& worst_closure);

// search(0) ... search(count - 1), side by side on the campaign's threads; their runs do not go side by side.
std::vector<Inversion> search_side_by_side(const Campaign& campaign, int count, const char* label,
                                           const std::function<Inversion(int)>& search);

}  // namespace percal
