// How large the runs of a job are.
#pragma once
#include "percal/calibrate/job.hpp"
#include "percal/impact/target/size.hpp"

namespace percal {

// The run with the most elements, on the verifying mesh, at the middle of the parameters' bounds. Throws BadInput where one is too
// large (refuse_what_is_too_large).
RunSize largest_run(const CalibrationJob& job);

}  // namespace percal
