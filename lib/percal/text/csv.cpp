#include "percal/text/csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "percal/text/csv_cells.hpp"
#include "percal/text/csv_layout.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

bool looks_like_decimal_comma(const std::string& cell) {
  return cell.find('.') == std::string::npos && cell.find(',') != std::string::npos &&
         parse_number(cell, true).value.has_value();
}

std::vector<CsvColumn> read_header(const CsvLine& line, char separator, const std::string& file) {
  auto cells = split_cells(line.text, separator);
  if (!cells) throw BadInput({file, line.number, ""}, "a quoted cell that is not closed", "column names");
  while (!cells->empty() && cells->back().empty()) cells->pop_back();
  if (std::all_of(cells->begin(), cells->end(),
                  [](const auto& cell) { return parse_number(cell, false).value || parse_number(cell, true).value; }))
    throw BadInput({file, line.number, ""}, "numbers in the first line", "a header with the names of the columns");
  std::vector<CsvColumn> columns;
  for (const auto& cell : *cells) {
    const bool twice = std::any_of(columns.begin(), columns.end(), [&](const auto& c) { return c.header == cell; });
    if (twice && !cell.empty())
      throw BadInput({file, line.number, ""}, "the column " + in_quotes(cell) + " twice", "one column of a name");
    columns.push_back(split_header(cell));
  }
  return columns;
}

// The units of a second header row, for the columns whose headers name none.
void read_units(const CsvLine& line, char separator, CsvTable& table) {
  const auto cells = split_cells(line.text, separator).value_or(std::vector<std::string>{});
  for (std::size_t i = 0; i < table.columns.size() && i < cells.size(); ++i) {
    CsvColumn& column = table.columns[i];
    const std::string unit = bare_unit(cells[i]);
    if (unit.empty() || unit == column.unit) continue;
    if (!column.unit.empty())
      throw BadInput({table.file, line.number, column.header}, "the unit " + in_quotes(unit),
                     "none, or " + column.unit + " as in the header above");
    column.unit = unit;
  }
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
    const std::string cell = table.cell(row, index);
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

// As the command line writes it or as the file does.
ParsedNumber number_of_condition(const std::string& value, bool decimal_comma) {
  const auto plain = parse_number(value, false);
  return plain.value ? plain : parse_number(value, decimal_comma);
}

bool same_value(const std::string& cell, const std::string& value, bool decimal_comma) {
  if (cell == value) return true;
  const auto a = parse_number(cell, decimal_comma), b = number_of_condition(value, decimal_comma);
  return a.value && b.value && *a.value == *b.value;
}

struct Condition {
  std::string column, sign, value;  // sign: =, !=, <, <=, > or >=
};

// The first sign divides.
Condition condition_of(const std::string& text, const std::string& file) {
  const auto at = text.find_first_of("=<>!");
  Condition condition;
  if (at != std::string::npos) {
    const std::size_t length = at + 1 < text.size() && text[at] != '=' && text[at + 1] == '=' ? 2 : 1;
    condition = {trimmed(text.substr(0, at)), text.substr(at, length), trimmed(text.substr(at + length))};
  }
  if (condition.column.empty() || condition.sign == "!")
    throw BadInput({file, 0, ""}, "the condition " + in_quotes(text),
                   "COLUMN=VALUE, COLUMN!=VALUE, or COLUMN<NUMBER with <, <=, > or >=");
  return condition;
}

// `fault` gets what a comparison cannot use.
template <class Fault>
bool is_met(const Condition& condition, const std::string& cell, bool decimal_comma, const Fault& fault) {
  const auto& [column, sign, value] = condition;
  if (sign == "=" || sign == "!=") return same_value(cell, value, decimal_comma) == (sign == "=");
  const auto limit = number_of_condition(value, decimal_comma), number = parse_number(cell, decimal_comma);
  if (!number.value) return fault(number.fault + ", which " + sign + " compares with no number"), false;
  if (sign == "<") return *number.value < *limit.value;
  if (sign == "<=") return *number.value <= *limit.value;
  if (sign == ">") return *number.value > *limit.value;
  return *number.value >= *limit.value;
}

// The different cells of a column in their order, at most 20 of them.
std::string values_there_are(const CsvTable& table, int column) {
  std::vector<std::string> seen;
  for (const auto& row : table.rows) {
    const std::string cell = in_quotes(table.cell(row, column));
    if (std::find(seen.begin(), seen.end(), cell) != seen.end()) continue;
    seen.push_back(seen.size() < 20 ? cell : "...");
    if (seen.size() > 20) break;
  }
  std::string text;
  for (const auto& cell : seen) text += (text.empty() ? "" : ", ") + cell;
  return text;
}

}  // namespace

CsvTable parse_csv(std::string given, const std::string& name) {
  CsvTable table;
  table.file = name;
  table.text = std::make_shared<const std::string>(as_utf8(std::move(given), name));
  CsvLayout layout = find_layout(*table.text, name);
  table.header_line = layout.header.number;
  table.dialect.separator = layout.separator;
  table.passed_over = layout.before;
  table.columns = read_header(layout.header, layout.separator, name);
  if (layout.units) read_units(*layout.units, layout.separator, table);

  LineFaults faults(name);
  const std::size_t width = table.columns.size();
  const bool may_have_commas = layout.separator != ',';
  table.rows = std::move(layout.rows);
  std::erase_if(table.rows, [&](const CsvRow& row) {
    auto cells = split_cells(table.text->substr(row.begin, row.length), layout.separator);
    if (!cells) {
      faults.add(row.line,
                 "found a quoted cell that is not closed; accepted: \"...\" within one line, a quote inside doubled");
      return true;
    }
    if (std::all_of(cells->begin(), cells->end(), [](const auto& cell) { return cell.empty(); })) return true;
    while (cells->size() > width && cells->back().empty()) cells->pop_back();
    if (cells->size() != width)
      faults.add(row.line, fmt::format("found {} cell{}; accepted: {}, one for each column of the header in line {}",
                                       cells->size(), cells->size() == 1 ? "" : "s", width, table.header_line));
    if (may_have_commas && !table.dialect.decimal_comma)
      table.dialect.decimal_comma = std::any_of(cells->begin(), cells->end(), looks_like_decimal_comma);
    return false;
  });
  faults.throw_if_any();
  if (table.rows.empty())
    throw BadInput({name, table.header_line, ""}, "a header without rows", "at least one row of numbers");
  return table;
}

CsvTable read_csv(const std::string& path) {
  std::error_code none;
  const auto size = std::filesystem::file_size(path, none);
  if (!none && size > largest_csv)
    throw BadInput({path, 0, ""}, fmt::format("a file of {:.0f} MiB", static_cast<double>(size) / (1 << 20)),
                   fmt::format("at most {} MiB: leave out rows or columns", largest_csv >> 20));
  return parse_csv(read_file(path), path);
}

std::vector<std::string> CsvTable::cells(const CsvRow& row) const {
  auto all = split_cells(text->substr(row.begin, row.length), dialect.separator).value_or(std::vector<std::string>{});
  all.resize(columns.size());
  return all;
}

std::string CsvTable::cell(const CsvRow& row, int column) const {
  return cells(row).at(static_cast<std::size_t>(column));
}

std::optional<int> CsvTable::find(const std::string& wanted) const {
  const std::string word = lower_case(wanted);
  if (word.empty()) return std::nullopt;
  std::vector<int> by_header, by_name;
  for (int i = 0; i < static_cast<int>(columns.size()); ++i) {
    if (columns[i].header == wanted) return i;
    if (lower_case(columns[i].header) == word) by_header.push_back(i);
    if (lower_case(columns[i].name) == word) by_name.push_back(i);
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
  std::vector<std::string> all;
  all.reserve(rows.size());
  for (const auto& row : rows) all.push_back(cell(row, index));
  return all;
}

CsvTable CsvTable::where(const std::vector<std::string>& conditions) const {
  CsvTable kept = *this;
  for (const auto& text_of_condition : conditions) {
    const Condition condition = condition_of(text_of_condition, file);
    const int index = column(condition.column);
    if (condition.sign.find_first_of("<>") == 0 && !number_of_condition(condition.value, dialect.decimal_comma).value)
      throw BadInput({file, 0, ""}, "the condition " + in_quotes(text_of_condition),
                     "a number behind " + condition.sign);
    LineFaults faults(file);
    std::vector<CsvRow> matching;
    for (const auto& row : kept.rows) {
      const std::string found = cell(row, index);
      if (is_met(condition, found, dialect.decimal_comma,
                 [&](const std::string& what) { faults.add(row.line, columns[index].header + ": found " + what); }))
        matching.push_back(row);
    }
    faults.throw_if_any();
    if (matching.empty())
      throw BadInput({file, 0, columns[index].header},
                     "no row with " + (condition.sign == "=" ? "" : condition.sign + " ") + in_quotes(condition.value),
                     values_there_are(kept, index));
    kept.rows = std::move(matching);
  }
  return kept;
}

}  // namespace percal
