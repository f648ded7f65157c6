#include "percal/text/csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "percal/text/csv_faults.hpp"
#include "percal/text/csv_header.hpp"
#include "percal/text/csv_number.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

struct Line {
  int number;  // 1-based
  std::string text;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string trim(const std::string& text) {
  std::size_t first = 0, last = text.size();
  while (first < last && is_blank(text[first])) ++first;
  while (last > first && is_blank(text[last - 1])) --last;
  return text.substr(first, last - first);
}

// The lines that carry something: no comments, none of blanks and separators alone. Lines end with LF, CRLF or CR.
std::vector<Line> content_lines(const std::string& text) {
  std::vector<Line> lines;
  int number = 1;
  for (std::size_t start = 0; start <= text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
    const std::string line = text.substr(start, end - start);
    const std::string content = trim(line);
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
    cells.push_back(trim(cell));
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

}  // namespace percal
