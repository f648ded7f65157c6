// Plots by gnuplot, where it is there.
#pragma once
#include <optional>
#include <string>

namespace percal::tools {

// What gnuplot prints for a script of up to 60,000 bytes; nothing where it is not there or fails.
std::optional<std::string> gnuplot(const std::string& script);

}  // namespace percal::tools
