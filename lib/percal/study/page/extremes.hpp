// The matrix of extreme impacts as its result.json, its table as CSV, and its page.
#pragma once
#include "percal/study/extremes.hpp"
#include "percal/study/page/page.hpp"

namespace percal {

page::Json extremes_to_json(const std::vector<CellResult>& results, const page::Cost& cost);

// A line a cell.
std::string extremes_csv(const page::Json& result);

page::Page extremes_page(const page::Json& result);

}  // namespace percal
