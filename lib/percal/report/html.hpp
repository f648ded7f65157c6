// A page as one self-contained HTML file: style and figures are inside it, nothing is fetched, there is no script,
// and the page's own security policy forbids both.
#pragma once
#include <map>
#include <string>

#include "percal/report/page.hpp"

namespace percal {

// Drawn figures by their names, as inline SVG. A figure without one shows its points as a table and says why.
using DrawnFigures = std::map<std::string, std::string>;

// Draws every figure of the page, side by side; those that gnuplot cannot draw are missing.
DrawnFigures draw_figures(const Page& page);

std::string html(const Page& page, const DrawnFigures& figures);

}  // namespace percal
