// What stands in the cells of a CSV file: headers with their units, numbers; and its bad lines, named together in one message.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/text/csv.hpp"
#include "percal/units/quantity.hpp"

namespace percal {

struct ParsedNumber {
  std::optional<double> value;  // finite
  std::string fault;            // why there is none: "'1.2.3'; accepted: a number"
};

// "1.5", "+3e-2", "-.5"; with a decimal comma "1,5" and no point. A minus sign may be the typographic one. No blanks
// inside, no thousands separators, no inf or nan, nothing that a double cannot hold.
ParsedNumber parse_number(const std::string& cell, bool decimal_comma);

// Name and unit of a header: "stress [kPa]", "stress (kPa)", "stress_kPa", "stress/kPa", "stress, kPa" and "stress in kPa" are stress in kPa, "density_kg_m3" is
// density in kg/m3: of several trailing parts the first multiplies and the others divide. What stands in brackets is
// always taken as the unit; in parentheses and after '_' only where it is a known unit, so "stretch_x" has none.
CsvColumn split_header(const std::string& header);

// The SI value and dimension of 1 unit. Percent, weight percent and degrees are dimensionless and count as 1.
// Throws std::invalid_argument that names the unknown unit.
Quantity column_unit(const std::string& unit);

// What 1 of a unit means as a strain: 0.01 for percent, 1e-6 for microstrain, 1 for "-" and "mm/mm" (and for "um/m", whose numbers
// column_unit converts already). nullopt for what measures no strain: degrees, weight percent, kPa, unknown words.
std::optional<double> size_of_strain(const std::string& unit);

// The words besides "-" and quotients such as "mm/mm" that size_of_strain knows.
std::vector<std::string> strain_units();

// Whether the text is a unit that percal knows.
bool is_unit_word(const std::string& text);

// Without its brackets: "[kPa]" and "(kPa)" are kPa.
std::string bare_unit(const std::string& cell);

// Collects faults line by line; throw_if_any() makes one BadInput of them. Equal faults are one line, the first
// 50 different ones are told in full, of the rest
// only the line numbers.
class LineFaults {
 public:
  explicit LineFaults(std::string file) : file_(std::move(file)) {}
  void add(int line, const std::string& what);
  bool empty() const { return faults_.empty(); }
  std::string message() const;
  void throw_if_any() const;

 private:
  struct Fault {
    int line;
    std::string what;
  };
  std::string file_;
  std::vector<Fault> faults_;
};

}  // namespace percal
