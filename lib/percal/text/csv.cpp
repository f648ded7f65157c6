#include "percal/text/csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "percal/text/csv_cells.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

struct Line {
  int number;  // 1-based
  std::string text;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

// The lines that carry something: no comments, none of blanks and separators alone. Lines end with LF, CRLF or CR.
std::vector<Line> content_lines(const std::string& text) {
  std::vector<Line> lines;
  int number = 1;
  for (std::size_t start = 0; start <= text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
    const std::string line = text.substr(start, end - start);
    const std::string content = trimmed(line);
    if (content.find_first_not_of(",;\t ") != std::string::npos && content[0] != '#') lines.push_back({number, line});
    start = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

// How often `separator` stands outside quotes and brackets.
int count_separators(const std::string& header, char separator) {
  int count = 0, depth = 0;
  bool quoted = false;
  for (char c : header) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
    if (c == separator && depth <= 0) ++count;
  }
  return count;
}

char find_separator(const std::string& header) {
  for (char separator : {'\t', ';'})
    if (count_separators(header, separator) > 0) return separator;
  return ',';
}

// The cells of a line, trimmed; a quote within a quoted cell is doubled. nullopt where a quoted cell is not closed.
std::optional<std::vector<std::string>> split_cells(const std::string& line, char separator) {
  const auto blank = [&](char c) { return is_blank(c) && c != separator; };
  std::vector<std::string> cells;
  std::size_t i = 0;
  for (;;) {
    while (i < line.size() && blank(line[i])) ++i;
    std::string cell;
    if (i < line.size() && line[i] == '"') {
      bool closed = false;
      for (++i; i < line.size(); ++i) {
        if (line[i] != '"') {
          cell += line[i];
        } else if (i + 1 < line.size() && line[i + 1] == '"') {
          cell += line[i++];
        } else {
          closed = true;
          ++i;
          break;
        }
      }
      while (i < line.size() && blank(line[i])) ++i;
      if (!closed || (i < line.size() && line[i] != separator)) return std::nullopt;
    } else {
      const std::size_t end = std::min(line.find(separator, i), line.size());
      cell = line.substr(i, end - i);
      i = end;
    }
    cells.push_back(trimmed(cell));
    if (i >= line.size()) return cells;
    ++i;  // the separator
  }
}

bool looks_like_decimal_comma(const std::string& cell) {
  return cell.find('.') == std::string::npos && cell.find(',') != std::string::npos &&
         parse_number(cell, true).value.has_value();
}

std::vector<CsvColumn> read_header(const Line& line, char separator, const std::string& file) {
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

CsvTable parse_csv(const std::string& given, const std::string& name) {
  if (given.find('\0') != std::string::npos)
    throw BadInput({name, 0, ""}, "NUL bytes (a binary file, or text in UTF-16)", "text in UTF-8");
  const bool marked = given.compare(0, 3, "\xEF\xBB\xBF") == 0;
  const auto lines = content_lines(marked ? given.substr(3) : given);
  if (lines.empty()) throw BadInput({name, 0, ""}, "no header and no rows", "a header line and at least one row");

  CsvTable table;
  table.file = name;
  table.header_line = lines[0].number;
  table.dialect.separator = find_separator(lines[0].text);
  table.columns = read_header(lines[0], table.dialect.separator, name);

  LineFaults faults(name);
  const std::size_t width = table.columns.size();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    auto cells = split_cells(lines[i].text, table.dialect.separator);
    if (!cells) {
      faults.add(lines[i].number,
                 "found a quoted cell that is not closed; accepted: \"...\" within one line, a quote inside doubled");
      continue;
    }
    if (std::all_of(cells->begin(), cells->end(), [](const auto& cell) { return cell.empty(); })) continue;
    while (cells->size() > width && cells->back().empty()) cells->pop_back();
    if (cells->size() != width)
      faults.add(lines[i].number, fmt::format("found {} cell{}; accepted: {}, one for each column of the header",
                                              cells->size(), cells->size() == 1 ? "" : "s", width));
    table.rows.push_back({lines[i].number, std::move(*cells)});
  }
  faults.throw_if_any();
  if (table.rows.empty())
    throw BadInput({name, table.header_line, ""}, "a header without rows", "at least one row of numbers");
  if (table.dialect.separator != ',')
    table.dialect.decimal_comma = std::any_of(table.rows.begin(), table.rows.end(), [](const CsvRow& row) {
      return std::any_of(row.cells.begin(), row.cells.end(), looks_like_decimal_comma);
    });
  return table;
}

CsvTable read_csv(const std::string& path) { return parse_csv(read_file(path), path); }

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
  std::vector<std::string> cells;
  cells.reserve(rows.size());
  for (const auto& row : rows) cells.push_back(row.cells.at(index));
  return cells;
}

CsvTable CsvTable::where(const std::vector<std::string>& conditions) const {
  CsvTable kept = *this;
  for (const auto& condition : conditions) {
    const auto equals = condition.find('=');
    if (equals == std::string::npos || trimmed(condition.substr(0, equals)).empty())
      throw BadInput({file, 0, ""}, "the condition " + in_quotes(condition), "COLUMN=VALUE");
    const int index = column(trimmed(condition.substr(0, equals)));
    const std::string value = trimmed(condition.substr(equals + 1));
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
