// How large the runs of a job are.
#pragma once
#include "percal/identify/job.hpp"
#include "percal/impact/target/size.hpp"

namespace percal {

// The run with the most elements, every target as stiff as where the search for the tissue's modulus begins. Throws BadInput where
// one is too large (refuse_what_is_too_large).
RunSize largest_run(const IdentifyJob& job);

}  // namespace percal
