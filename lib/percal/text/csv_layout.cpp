#include "percal/text/csv_layout.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "percal/base/error.hpp"
#include "percal/text/csv_cells.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

// The lines that carry something: no comments, none of blanks and separators alone. Lines end with LF, CRLF or CR.
std::vector<CsvRow> content_lines(const std::string& text) {
  std::vector<CsvRow> lines;
  lines.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
  int number = 1;
  for (std::size_t start = 0; start <= text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
    const std::string content = trimmed(text.substr(start, end - start));
    if (content.find_first_not_of(",;\t ") != std::string::npos && content[0] != '#')
      lines.push_back({number, static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(end - start)});
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

// The separator that Excel's first line names: "sep=;".
std::optional<char> named_separator(const std::string& line) {
  std::string text = line;
  text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
  if (text.size() < 5 || lower_case(text.substr(0, 4)) != "sep=") return std::nullopt;
  return text[4];
}

constexpr std::size_t surveyed = 1000;  // lines; a table shows its shape within them

// What a line looks like: 'n' for a cell with a number, 't' for text, '-' for none. Empty cells at its end do not count. Empty where a quoted
// cell is not closed.
std::string shape_of(const std::string& line, char separator) {
  const auto cells = split_cells(line, separator);
  std::string shape;
  for (const auto& cell : cells.value_or(std::vector<std::string>{}))
    shape += cell.empty() ? '-' : parse_number(cell, false).value || parse_number(cell, true).value ? 'n' : 't';
  while (!shape.empty() && shape.back() == '-') shape.pop_back();
  return shape;
}

bool has_number(const std::string& shape) { return shape.find('n') != std::string::npos; }

// Whether half of the cells or more are units.
bool is_units_row(const std::string& line, char separator) {
  int units = 0, others = 0;
  for (const auto& cell : split_cells(line, separator).value_or(std::vector<std::string>{}))
    if (!cell.empty()) ++(is_unit_word(bare_unit(cell)) ? units : others);
  return units > 0 && units >= others;
}

bool names_a_unit(const std::string& line, char separator) {
  const auto cells = split_cells(line, separator).value_or(std::vector<std::string>{});
  return std::any_of(cells.begin(), cells.end(), [](const auto& cell) { return !split_header(cell).unit.empty(); });
}

// A table found by its rows: the line of its header and of its units, and its first row.
struct FoundTable {
  std::size_t header, first_row;
  std::optional<std::size_t> units;
};

// nullopt where no shape with a number is that of a third of the lines or more, or no line of text stands above.
std::optional<FoundTable> find_table(const std::vector<CsvLine>& lines, char separator) {
  std::vector<std::string> shapes;
  std::map<std::string, std::size_t> count;
  const std::size_t seen = std::min(lines.size(), surveyed);
  for (std::size_t i = 0; i < seen; ++i) {
    shapes.push_back(shape_of(lines[i].text, separator));
    if (has_number(shapes.back()) && shapes.back().size() > 1) ++count[shapes.back()];
  }
  const auto most =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == count.end() || 3 * most->second < seen) return std::nullopt;
  const std::size_t width = most->first.size();
  auto row = static_cast<std::size_t>(std::find(shapes.begin(), shapes.end(), most->first) - shapes.begin());
  while (row > 0 && shapes[row - 1].size() == width && has_number(shapes[row - 1])) --row;
  const auto is_text = [&](std::size_t i) {
    return !has_number(shapes[i]) && !shapes[i].empty() && split_cells(lines[i].text, separator)->size() >= width;
  };
  if (row == 0) return std::nullopt;
  std::size_t last = row - 1;
  if (!is_text(last)) return std::nullopt;
  if (last > 0 && is_text(last - 1) && is_units_row(lines[last].text, separator) &&
      !names_a_unit(lines[last].text, separator))
    return FoundTable{last - 1, row, last};
  // Of several lines of text the first that names a unit; a line of text below it is a row of the table.
  std::size_t first = last;
  while (first > 0 && is_text(first - 1) && shapes[first - 1].size() == width) --first;
  for (std::size_t i = first; i <= last; ++i)
    if (names_a_unit(lines[i].text, separator)) return FoundTable{i, i + 1, {}};
  return FoundTable{first, first + 1, {}};
}

// Whether the line has as many cells as most below it.
bool heads_most(const std::vector<CsvLine>& lines, char separator) {
  const std::size_t width = shape_of(lines[0].text, separator).size();
  std::size_t same = 0;
  const std::size_t seen = std::min(lines.size(), surveyed);
  for (std::size_t i = 1; i < seen; ++i) same += shape_of(lines[i].text, separator).size() == width;
  return 2 * same >= seen - 1;
}

}  // namespace

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

CsvLayout find_layout(const std::string& text, const std::string& file) {
  std::vector<CsvRow> all = content_lines(text);
  std::vector<CsvLine> lines;  // the first of them
  for (std::size_t i = 0; i < std::min(all.size(), surveyed + 1); ++i)
    lines.push_back({all[i].line, text.substr(all[i].begin, all[i].length)});
  if (lines.empty()) throw BadInput({file, 0, ""}, "no header and no rows", "a header line and at least one row");
  CsvLayout layout;
  const auto named = named_separator(lines[0].text);
  if (named) lines.erase(lines.begin()), all.erase(all.begin());
  if (lines.empty()) throw BadInput({file, 1, ""}, "no header and no rows", "a header line and at least one row");
  layout.separator = named.value_or(find_separator(lines[0].text));
  FoundTable table{0, 1, {}};
  if (const auto found = find_table(lines, layout.separator)) {
    table = *found;
  } else if (!named && !heads_most(lines, layout.separator)) {
    for (const char separator : {'\t', ';', ','})
      if (const auto other = find_table(lines, separator)) {
        layout.separator = separator;
        table = *other;
        break;
      }
  }
  for (std::size_t i = 0; i < table.header; ++i) layout.before.push_back(lines[i].number);
  layout.header = lines[table.header];
  if (table.units) layout.units = lines[*table.units];
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(table.first_row));
  layout.rows = std::move(all);
  return layout;
}

}  // namespace percal
