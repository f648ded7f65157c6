// CSV as people have it: comments (#), a header whose columns may carry units, CRLF, a byte-order mark, commas,
// semicolons (with decimal commas) or tabs, quoted cells, trailing separators.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/units/quantity.hpp"

namespace percal {

// Where a row stands in the text. Its cells are cut out when they are asked for, so that a table takes less than five bytes for each of
// its file.
struct CsvRow {
  int line;  // 1-based line in the file
  std::uint32_t begin, length;
};

inline constexpr std::size_t largest_csv = std::size_t{64} << 20;  // bytes

struct CsvColumn {
  std::string header;  // as written: "stress_kPa", "stress [kPa]"
  std::string name;    // without the unit: "stress"
  std::string unit;    // "kPa", empty where the header names none
};

// How numbers and columns are separated; found from the header and the first rows.
struct CsvDialect {
  char separator = ',';
  bool decimal_comma = false;
};

class CsvTable {
 public:
  std::string file;
  CsvDialect dialect;
  int header_line = 0;           // 1-based
  std::vector<int> passed_over;  // lines of text before the table
  std::vector<CsvColumn> columns;
  std::vector<CsvRow> rows;
  std::shared_ptr<const std::string> text;  // of the file, in UTF-8

  // One cell of a row for each column, trimmed; one of them.
  std::vector<std::string> cells(const CsvRow& row) const;
  std::string cell(const CsvRow& row, int column) const;

  // Index of a column by its full header or its name without unit (case-insensitive). nullopt where there is none.
  // Throws BadInput where the name alone means several columns (stress_kPa beside stress_MPa).
  std::optional<int> find(const std::string& column) const;
  // As find, but throws BadInput that lists the columns there are.
  int column(const std::string& column) const;

  // All cells of a column as finite SI numbers with the given dimension. The unit comes from the header; a column
  // without a unit is refused unless the dimension is none or `default_unit` names one. Percentages and degrees are
  // dimensionless and stay as they stand. Every bad line is named in one BadInput.
  std::vector<double> numbers(int column, const Dimension&, const std::string& default_unit = "") const;
  std::vector<double> numbers(const std::string& column, const Dimension&, const std::string& default_unit = "") const;
  // As above with empty cells allowed.
  std::vector<std::optional<double>> optional_numbers(const std::string& column, const Dimension&) const;
  std::vector<std::string> texts(const std::string& column) const;

  // Only the rows that meet every condition: COLUMN=VALUE (text compared exactly, or as numbers where both are), COLUMN!=VALUE, or with <,
  // <=, >, >= and a number, all as the file has them. Throws BadInput that lists the values there are when a condition leaves no row.
  CsvTable where(const std::vector<std::string>& conditions) const;
};

// Throws BadInput: missing file, one above largest_csv, no header, no rows, rows with too many or too few cells (each bad line named).
CsvTable read_csv(const std::string& path);
CsvTable parse_csv(std::string text, const std::string& name);

}  // namespace percal
