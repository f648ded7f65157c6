#include "percal/page/result_csv.hpp"

#include <fmt/ranges.h>

#include <sstream>

#include "percal/plot/quoted.hpp"

namespace percal::page {
namespace {

std::string cell_of(const Json& row, const ResultColumn& column) {
  const Json* value = &row;
  std::istringstream path(column.path);
  for (std::string key; std::getline(path, key, '/');) value = &at(*value, key);
  if (value->is_number_float()) return fmt::format("{:.9g}", value->get<double>());
  if (value->is_string())
    return column.form == ResultColumn::free_text ? csv_quoted(value->get<std::string>()) : value->get<std::string>();
  return value->is_null() ? "" : value->dump();
}

}  // namespace

std::string as_csv(const std::vector<ResultColumn>& columns, const std::vector<Json>& rows) {
  std::vector<std::string> cells;
  for (const ResultColumn& column : columns) cells.push_back(column.name);
  std::string csv = fmt::format("{}\n", fmt::join(cells, ","));
  for (const Json& row : rows) {
    cells.clear();
    for (const ResultColumn& column : columns) cells.push_back(cell_of(row, column));
    csv += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return csv;
}

}  // namespace percal::page
