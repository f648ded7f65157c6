// The matrix of extreme impacts as JSON, CSV and a page: docs/formats/study.md.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "percal/study/extremes.hpp"

namespace percal {

// {cells: [...], outcomes: {...}, summary: {...}}
nlohmann::json extremes_to_json(const std::vector<CellResult>& results);

// A line a cell.
std::string extremes_csv(const std::vector<CellResult>& results);

// A table for each group in Markdown and what they come to, without a title.
std::string extremes_markdown(const std::vector<CellResult>& results);

}  // namespace percal
