#include "percal/page/table.hpp"

#include <algorithm>

#include "percal/page/numbers.hpp"

namespace percal::page {
namespace {

// Begins as a number does, and is short.
bool is_number(const std::string& cell) {
  const std::size_t first = cell.find_first_not_of("+-<>~ ");
  return first != std::string::npos && cell[first] >= '0' && cell[first] <= '9' && cell.size() <= 34;
}

}  // namespace

bool has_header(const Table& table) {
  const auto& cells = table.rows.front();
  return !std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); });
}

bool is_column_of_numbers(const Table& table, std::size_t column) {
  constexpr std::size_t short_text = 16;
  if (column == 0 || !has_header(table)) return false;
  int of_numbers = 0, of_words = 0;
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    if (column >= table.rows[r].size()) continue;
    const std::string& cell = table.rows[r][column];
    if (cell.empty() || cell == absent) continue;
    if (!is_number(cell) && cell.size() > short_text) return false;
    ++(is_number(cell) ? of_numbers : of_words);
  }
  return of_numbers > of_words;
}

std::size_t columns_of(const Table& table) {
  std::size_t columns = 0;
  for (const auto& row : table.rows) columns = std::max(columns, row.size());
  return columns;
}

}  // namespace percal::page
