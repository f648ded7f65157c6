// What a reader of the number must know.  For the .cpp files of this folder.
#pragma once
#include "percal/one_depth/one_depth.hpp"

namespace percal {

void add_findings(OneDepth& found);

}  // namespace percal
