// report: results as a page.
//
// One self-contained HTML page of one result, or of two side by side.
#pragma once
#include "percal/report/html.hpp"
#include "percal/report/page.hpp"
