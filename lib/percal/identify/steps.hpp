// The tables that show each step of the chain: the reference's value, ours, the difference, the error that we know of.
#pragma once
#include "percal/identify/identification.hpp"

namespace percal {

ComparisonTable law_step(const IdentifyJob& job, const Identification& found);
ComparisonTable ridge_step(const IdentifyJob& job, const Identification& found);
ComparisonTable similarity_step(const IdentifyJob& job, const Identification& found);
ComparisonTable formulation_step(const IdentifyJob& job, const Identification& found);
ComparisonTable tissue_step(const IdentifyJob& job, const Identification& found);
ComparisonTable check_step(const IdentifyJob& job, const Identification& found);
ComparisonTable mesh_step(const IdentifyJob& job, const Identification& found);
ComparisonTable prediction_step(const IdentifyJob& job, const PredictionResult& result);

// What a reader must know before using the numbers, in sentences.
std::vector<std::string> findings(const IdentifyJob& job, const Identification& found);

}  // namespace percal
