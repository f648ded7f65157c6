// Plots by gnuplot, where it is there.
#pragma once
#include <optional>
#include <string>

#include "percal/plot/chart.hpp"

namespace percal {

// What gnuplot prints for a script of any length; nothing where it is not there or fails.
std::optional<std::string> gnuplot(const std::string& script);

// The plot as SVG whose text and axes are in the colour of the surrounding text (currentColor), so that it is readable on a
// dark page too; and as PNG, on white. Nothing where gnuplot is not there or fails.
std::optional<std::string> draw_svg(const Plot& plot);
std::optional<std::string> draw_png(const Plot& plot);

}  // namespace percal
