#include "percal/text/csv_number.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "percal/units/words.hpp"

namespace percal {
namespace {
constexpr const char* typographic_minus = "\xE2\x88\x92";
}

ParsedNumber parse_number(const std::string& cell, bool decimal_comma) {
  if (cell.empty()) return {std::nullopt, "an empty cell; accepted: a number"};
  std::string text = cell;
  if (text.compare(0, 3, typographic_minus) == 0) text.replace(0, 3, "-");
  const bool point = text.find('.') != std::string::npos, comma = text.find(',') != std::string::npos;
  if (decimal_comma && point)
    return {std::nullopt, in_quotes(cell) + " in a file with decimal commas; accepted: a number such as 1,5"};
  if (!decimal_comma && comma) return {std::nullopt, in_quotes(cell) + "; accepted: a number such as 1.5"};
  if (decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
  if (text[0] == '+' && text.size() > 1 && text[1] != '-') text.erase(0, 1);

  const auto digit_or_point = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) || c == '.'; };
  const std::size_t first = text.size() > 1 && text[0] == '-' ? 1 : 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range)
    return {std::nullopt, in_quotes(cell) + "; accepted: a number between 1e-300 and 1e300 in size"};
  if (text.empty() || !digit_or_point(text[first]) || error != std::errc{} || end != text.data() + text.size() ||
      !std::isfinite(value))
    return {std::nullopt, in_quotes(cell) + "; accepted: a number"};
  return {value, ""};
}

}  // namespace percal
