// page: a result as a page.
//
// Each command's page is made from its result.json; it is written as text, as one self-contained HTML file, or as Markdown.
#pragma once
#include "percal/page/figures.hpp"
#include "percal/page/html.hpp"
#include "percal/page/markdown.hpp"
#include "percal/page/numbers.hpp"
#include "percal/page/page.hpp"
#include "percal/page/text.hpp"
