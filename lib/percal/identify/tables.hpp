// The published tables that the job lets us recompute.
#pragma once
#include "percal/identify/identification.hpp"

namespace percal {

std::vector<ComparisonTable> published_tables(const IdentifyJob& job, const Identification& found);

}  // namespace percal
