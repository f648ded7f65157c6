// The kinds of study, each in a file of its own.
#pragma once
#include "commands.hpp"

namespace percal::tools {

Exit study_error_vs_time(const StudyArguments&, const Common&);  // study_error_vs_time.cpp

}  // namespace percal::tools
