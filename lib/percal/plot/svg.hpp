// What gnuplot prints as SVG, made fit for a page.
#pragma once
#include <string>

namespace percal {

// Without prolog and white parts, black in the colour of the surrounding text, in the page's font, and with `prefix` before
// every id, so that several fit on one page.
std::string tidy_svg(const std::string& svg, const std::string& prefix);

// As part of an HTML page: without the namespaces that HTML knows, read out as `alt`.
std::string inline_svg(const std::string& svg, const std::string& alt);

}  // namespace percal
