// The command line, for the program: CLI11 stays behind it.
#pragma once
#include "percal/base/error.hpp"

namespace percal::tools {

// Reads it and runs the one command that it names, after `before_impacts` where that command runs impacts. Throws BadInput for what
// is no command, no option or no value of one.
Exit run_command_line(int argc, char** argv, void (*before_impacts)());

}  // namespace percal::tools
