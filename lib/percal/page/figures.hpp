// The figures of a page, drawn by gnuplot where it is there.
#pragma once
#include <map>
#include <string>

#include "percal/page/page.hpp"

namespace percal::page {

// Drawn figures by their names, as inline SVG for wide and for narrow screens. A figure without one shows its points as a table
// and says why.
using DrawnFigures = std::map<std::string, std::string>;

// Draws every figure of the page, side by side; those that gnuplot cannot draw are missing.
DrawnFigures draw_figures(const Page& page);

// NAME.csv, NAME.svg and, where asked for, NAME.png of every figure, in a folder. Whether all were drawn; the CSV files have the
// points in any case. Throws IoFailure.
enum class Pictures { svg, svg_and_png };
bool write_figures(const Page& page, const std::string& folder, Pictures pictures);

}  // namespace percal::page
