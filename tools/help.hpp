// The help of a command as it fits into a terminal.
#pragma once
#include <string>

namespace percal::tools {

// The help with its lines folded at words to so many columns (0: as it is), descriptions below each other. Examples stay whole: they
// are there to be copied.
std::string fitted_help(const std::string& help, int columns);

}  // namespace percal::tools
