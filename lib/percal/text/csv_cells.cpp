#include "percal/text/csv_cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "percal/base/error.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr std::size_t told_in_full = 50;
constexpr const char* typographic_minus = "\xE2\x88\x92";

// "60-75, 80" of ascending numbers.
std::string ranges(const std::vector<int>& lines) {
  std::string text;
  for (std::size_t first = 0; first < lines.size();) {
    std::size_t last = first;
    while (last + 1 < lines.size() && lines[last + 1] <= lines[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", lines[first]);
    if (lines[last] != lines[first]) text += fmt::format("-{}", lines[last]);
    first = last + 1;
  }
  return text;
}

// Dimensionless units that quantities do not know, taken as they stand.
constexpr std::array taken_as_they_stand = {"%",      "pct",        "percent", "wtpct",  "wt%", "wt %",
                                            "wt_pct", "wt_percent", "vol%",    "volpct", "deg", "\xC2\xB0"};

bool stands_as_it_is(const std::string& unit) {
  const std::string word = lower_case(unit);
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

bool is_percent(const std::string& unit) {
  const std::string word = lower_case(unit);
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
      const std::string name = trimmed(header.substr(0, open));
      const std::string unit = trimmed(header.substr(open + 1, header.size() - open - 2));
      if (!name.empty() && (bracket || is_unit(unit))) return {header, name, unit};
    }
  }
  return split_suffix(header);
}

void LineFaults::add(int line, const std::string& what) { faults_.push_back({line, what}); }

std::string LineFaults::message() const {
  auto sorted = faults_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) { return a.line < b.line; });
  std::string text;
  std::vector<int> rest;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i >= told_in_full) {
      rest.push_back(sorted[i].line);
      continue;
    }
    text += fmt::format("{}{}:{}: {}", text.empty() ? "" : "\n", file_, sorted[i].line, sorted[i].what);
  }
  if (!rest.empty()) text += fmt::format("\n{}: also lines {}", file_, ranges(rest));
  return text;
}

void LineFaults::throw_if_any() const {
  if (!faults_.empty()) throw BadInput(message());
}

}  // namespace percal
