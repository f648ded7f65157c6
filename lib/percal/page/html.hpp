// A page as one self-contained HTML file: style and figures are inside it, nothing is fetched, there is no script,
// and the page's own security policy forbids both.
#pragma once
#include <string>

#include "percal/page/figures.hpp"

namespace percal::page {

std::string html(const Page& page, const DrawnFigures& figures);

}  // namespace percal::page
