// Where the table stands in a CSV file: its separator, its header, a row of units, and the lines before it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/text/csv.hpp"

namespace percal {

struct CsvLine {
  int number;  // 1-based
  std::string text;
};

// The cells of a line, trimmed; a quote within a quoted cell is doubled. nullopt where a quoted cell is not closed.
std::optional<std::vector<std::string>> split_cells(const std::string& line, char separator);

struct CsvLayout {
  char separator = ',';
  std::vector<int> before;  // lines: titles of a testing machine
  CsvLine header;
  std::optional<CsvLine> units;  // a second header row that holds units
  std::vector<CsvRow> rows;
};

// The first line is the header where the lines below have its number of cells. Where they have not, or where a line of text follows, the
// table is what most lines look like: numbers in the same columns; the header is the line of text above the first of them.
// `text` is UTF-8. Throws BadInput: no lines.
CsvLayout find_layout(const std::string& text, const std::string& file);

// The text of a file in UTF-8 without its byte-order mark; UTF-16 with a mark is converted. Throws BadInput for spreadsheets (.xlsx, .xls,
// .ods), which says what to save, for other binary files, and for broken UTF-16.
std::string as_utf8(std::string text, const std::string& file);

}  // namespace percal
