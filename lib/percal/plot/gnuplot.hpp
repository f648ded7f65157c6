// Plots by gnuplot, where it is there.
#pragma once
#include <optional>
#include <string>

#include "percal/plot/chart.hpp"

namespace percal {

// What gnuplot prints for a script of any length; nothing where it is not there or fails.
std::optional<std::string> gnuplot(const std::string& script);

// The plot as SVG whose text and axes are in the colour of the surrounding text (currentColor), so that it is readable on a
// dark page too; and as PNG, on white. Nothing where gnuplot is not there or fails, and for a plot without a point.
std::optional<std::string> draw_svg(const Plot& plot);
std::optional<std::string> draw_png(const Plot& plot);

// As SVG in a size of one's own, in pixels; `prefix` is put before the ids within it.
struct Canvas {
  int width, height, font_size;
};
inline constexpr Canvas wide_canvas{720, 440, 14}, narrow_canvas{360, 340, 12};
std::optional<std::string> draw_svg(const Plot& plot, const Canvas& canvas, const std::string& prefix);

}  // namespace percal
