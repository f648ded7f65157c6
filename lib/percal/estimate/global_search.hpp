// Where in the box the minima may be.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "percal/estimate/frozen_fit.hpp"

namespace percal {

// Starts for the local search, best first: points of a search over the whole box that have no better point near them. One or
// more. The search is NLopt's DIRECT_L, which draws no random numbers.                docs/theory/calibration.md (9)
std::vector<Eigen::VectorXd> promising_points(Evaluator& evaluator, const SearchOptions& options);

}  // namespace percal
