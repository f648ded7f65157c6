// Columns of a CSV table by name, as numbers in SI, and rows by condition.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "percal/text/csv.hpp"
#include "percal/text/csv_faults.hpp"
#include "percal/text/csv_header.hpp"
#include "percal/text/csv_number.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string headers(const CsvTable& table) {
  std::string text;
  for (const auto& column : table.columns)
    if (!column.header.empty()) text += (text.empty() ? "" : ", ") + column.header;
  return text;
}

std::string dimension_words(const Dimension& wanted) {
  return wanted == dimension::none ? "a dimensionless column" : units_of(wanted);
}

// The unit of a column whose numbers it changes, empty where they are SI as they stand. Throws BadInput where the
// header's unit is missing, unknown or of another dimension.
std::string unit_of(const CsvTable& table, const CsvColumn& column, const Dimension& wanted,
                    const std::string& default_unit) {
  const Place place{table.file, table.header_line, column.header};
  const std::string& unit = column.unit.empty() ? default_unit : column.unit;
  if (unit.empty()) {
    if (wanted == dimension::none) return "";
    throw BadInput(
        place, "a column without a unit",
        fmt::format("the unit in the header, \"{0}_UNIT\" or \"{0} [UNIT]\" with {1}", column.name, units_of(wanted)));
  }
  try {
    const Quantity one = column_unit(unit);
    if (one.dimension == wanted) return one.value == 1 ? "" : unit;
  } catch (const std::invalid_argument& error) {
    throw BadInput(place, error.what(), dimension_words(wanted));
  }
  throw BadInput(place, "the unit " + unit, dimension_words(wanted));
}

// Rounded once, as the same quantity in a TOML file is, so that both have the same bits. nullopt where it is not
// finite.
std::optional<double> in_si(double number, const std::string& unit) {
  if (unit.empty()) return number;
  try {
    const double value = parse_quantity(fmt::format("{} {}", number, unit)).value;
    if (std::isfinite(value)) return value;
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

std::vector<std::optional<double>> read_numbers(const CsvTable& table, int index, const Dimension& wanted,
                                                const std::string& default_unit, bool may_be_empty) {
  const CsvColumn& column = table.columns.at(index);
  const std::string unit = unit_of(table, column, wanted, default_unit);
  LineFaults faults(table.file);
  std::vector<std::optional<double>> values;
  values.reserve(table.rows.size());
  for (const auto& row : table.rows) {
    const std::string& cell = row.cells.at(index);
    values.emplace_back();
    if (cell.empty() && may_be_empty) continue;
    const ParsedNumber number = parse_number(cell, table.dialect.decimal_comma);
    if (!number.value) {
      faults.add(row.line, column.header + ": found " + number.fault);
      continue;
    }
    values.back() = in_si(*number.value, unit);
    if (!values.back())
      faults.add(row.line,
                 column.header + ": found " + in_quotes(cell) + "; accepted: a number that is finite in SI units");
  }
  faults.throw_if_any();
  return values;
}

bool same_value(const std::string& cell, const std::string& value, bool decimal_comma) {
  if (cell == value) return true;
  const auto a = parse_number(cell, decimal_comma);
  auto b = parse_number(value, false);
  if (!b.value) b = parse_number(value, decimal_comma);
  return a.value && b.value && *a.value == *b.value;
}

std::string trim(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// The different cells of a column in their order, at most 20 of them.
std::string values_there_are(const CsvTable& table, int column) {
  std::vector<std::string> seen;
  for (const auto& row : table.rows) {
    const std::string cell = in_quotes(row.cells[column]);
    if (std::find(seen.begin(), seen.end(), cell) != seen.end()) continue;
    seen.push_back(seen.size() < 20 ? cell : "...");
    if (seen.size() > 20) break;
  }
  std::string text;
  for (const auto& cell : seen) text += (text.empty() ? "" : ", ") + cell;
  return text;
}

}  // namespace

std::optional<int> CsvTable::find(const std::string& wanted) const {
  const std::string word = lower(wanted);
  if (word.empty()) return std::nullopt;
  std::vector<int> by_header, by_name;
  for (int i = 0; i < static_cast<int>(columns.size()); ++i) {
    if (columns[i].header == wanted) return i;
    if (lower(columns[i].header) == word) by_header.push_back(i);
    if (lower(columns[i].name) == word) by_name.push_back(i);
  }
  const auto& found = by_header.empty() ? by_name : by_header;
  if (found.size() > 1)
    throw BadInput({file, header_line, wanted}, "a name of several columns",
                   "one of the headers as written: " + headers(*this));
  if (found.empty()) return std::nullopt;
  return found[0];
}

int CsvTable::column(const std::string& wanted) const {
  if (const auto index = find(wanted)) return *index;
  throw BadInput({file, header_line, ""}, "no column " + in_quotes(wanted), headers(*this));
}

std::vector<double> CsvTable::numbers(int index, const Dimension& wanted, const std::string& default_unit) const {
  const auto cells = read_numbers(*this, index, wanted, default_unit, false);
  std::vector<double> values;
  values.reserve(cells.size());
  for (const auto& cell : cells) values.push_back(*cell);
  return values;
}

std::vector<double> CsvTable::numbers(const std::string& name, const Dimension& wanted,
                                      const std::string& default_unit) const {
  return numbers(column(name), wanted, default_unit);
}

std::vector<std::optional<double>> CsvTable::optional_numbers(const std::string& name, const Dimension& wanted) const {
  return read_numbers(*this, column(name), wanted, "", true);
}

std::vector<std::string> CsvTable::texts(const std::string& name) const {
  const int index = column(name);
  std::vector<std::string> cells;
  cells.reserve(rows.size());
  for (const auto& row : rows) cells.push_back(row.cells.at(index));
  return cells;
}

CsvTable CsvTable::where(const std::vector<std::string>& conditions) const {
  CsvTable kept = *this;
  for (const auto& condition : conditions) {
    const auto equals = condition.find('=');
    if (equals == std::string::npos || trim(condition.substr(0, equals)).empty())
      throw BadInput({file, 0, ""}, "the condition " + in_quotes(condition), "COLUMN=VALUE");
    const int index = column(trim(condition.substr(0, equals)));
    const std::string value = trim(condition.substr(equals + 1));
    std::vector<CsvRow> matching;
    for (const auto& row : kept.rows)
      if (same_value(row.cells[index], value, dialect.decimal_comma)) matching.push_back(row);
    if (matching.empty())
      throw BadInput({file, 0, columns[index].header}, "no row with " + in_quotes(value),
                     values_there_are(kept, index));
    kept.rows = std::move(matching);
  }
  return kept;
}

}  // namespace percal
