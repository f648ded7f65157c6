// How large the runs of a job are, and whether they can be made at all.
#pragma once
#include "percal/calibrate/job.hpp"
#include "percal/impact/target/size.hpp"

namespace percal {

// The run with the most elements, on the verifying mesh, at the middle of the parameters' bounds; an erosion length is at its
// shortest there. Throws BadInput where one is too large (refuse_what_is_too_large), and where a length makes meshes too coarse to be
// run: fewer than three elements in it, or fewer than one in a radius. The message counts the shots of which that is so.
RunSize largest_run(const CalibrationJob& job);

}  // namespace percal
