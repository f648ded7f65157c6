// What a task of a cluster does: the evaluations of its list, one after the other, a file each.
#pragma once
#include <string>

namespace percal {

struct WorkDone {
  int done = 0, found = 0;  // evaluated now; there already
};

// Of a list in a WorkFolder. Throws BadInput where a line is no evaluation of this version of percal at this instruction level, IoFailure where
// a result cannot be written.
WorkDone work_through(const std::string& list_file);

}  // namespace percal
