#include "percal/text/csv_header.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <vector>

namespace percal {
namespace {

// Dimensionless units that quantities do not know, taken as they stand.
constexpr std::array taken_as_they_stand = {"%",      "pct",        "percent", "wtpct",  "wt%", "wt %",
                                            "wt_pct", "wt_percent", "vol%",    "volpct", "deg", "\xC2\xB0"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string trim(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool stands_as_it_is(const std::string& unit) {
  const std::string word = lower(unit);
  return std::any_of(taken_as_they_stand.begin(), taken_as_they_stand.end(),
                     [&](const char* known) { return word == known; });
}

bool is_unit(const std::string& text) {
  if (text.empty()) return false;
  try {
    column_unit(text);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// "kg", "m3" -> "kg/m3". Empty where a part cannot be a unit: parts start with a letter, and "min" is a minimum.
std::string quotient(const std::vector<std::string>& parts) {
  std::string text;
  for (const auto& part : parts) {
    const unsigned char first = part.empty() ? '\0' : part[0];
    if ((!std::isalpha(first) && first < 0x80) || part == "min") return "";
    text += (text.empty() ? "" : "/") + part;
  }
  return text;
}

// The unit behind the last underscores, longest first.
CsvColumn split_suffix(const std::string& header) {
  std::vector<std::string> tail;
  std::size_t end = header.size();
  CsvColumn found{header, header, ""};
  for (int parts = 1; parts <= 3; ++parts) {
    const auto underscore = header.rfind('_', end == 0 ? 0 : end - 1);
    if (underscore == std::string::npos || underscore == 0 || end == 0) break;
    tail.insert(tail.begin(), header.substr(underscore + 1, end - underscore - 1));
    end = underscore;
    std::string unit = header.substr(underscore + 1);
    if (!stands_as_it_is(unit)) unit = quotient(tail);
    if (is_unit(unit)) found = {header, header.substr(0, underscore), unit};
  }
  return found;
}

}  // namespace

bool is_percent(const std::string& unit) {
  const std::string word = lower(unit);
  return word == "%" || word == "pct" || word == "percent";
}

Quantity column_unit(const std::string& unit) {
  if (stands_as_it_is(unit)) return {1, dimension::none};
  return parse_unit(unit);
}

CsvColumn split_header(const std::string& header) {
  if (header.size() > 2 && (header.back() == ']' || header.back() == ')')) {
    const bool bracket = header.back() == ']';
    const auto open = header.rfind(bracket ? '[' : '(');
    if (open != std::string::npos && open > 0) {
      const std::string name = trim(header.substr(0, open));
      const std::string unit = trim(header.substr(open + 1, header.size() - open - 2));
      if (!name.empty() && (bracket || is_unit(unit))) return {header, name, unit};
    }
  }
  return split_suffix(header);
}

}  // namespace percal
