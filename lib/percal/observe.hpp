// observe: what runs mean.
//
// The replicates of one impact as one penetration in SI, with warnings; what else a field measures of it; the history as CSV; runs as the store keeps them; fields
// for ParaView and a picture of the last state.
//
//     const percal::Penetration found = percal::summarise(runs, reduction.problem, reduction.scales);
//     if (found.depth) std::cout << *found.depth << " m\n";
//
// See docs/formats/impact.md and docs/formats/fields.md.
#pragma once
#include "percal/observe/field_measures.hpp"
#include "percal/observe/fields.hpp"
#include "percal/observe/history.hpp"
#include "percal/observe/penetration.hpp"
#include "percal/observe/picture.hpp"
#include "percal/observe/stored_run.hpp"
