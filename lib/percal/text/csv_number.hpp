// A number as it stands in a cell.
#pragma once
#include <optional>
#include <string>

namespace percal {

struct ParsedNumber {
  std::optional<double> value;  // finite
  std::string fault;            // why there is none: "'1.2.3'; accepted: a number"
};

// "1.5", "+3e-2", "-.5"; with a decimal comma "1,5" and no point. A minus sign may be the typographic one. No blanks
// inside, no thousands separators, no inf or nan, nothing that a double cannot hold.
ParsedNumber parse_number(const std::string& cell, bool decimal_comma);

}  // namespace percal
