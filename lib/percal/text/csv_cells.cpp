#include "percal/text/csv_cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
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

// Dimensionless units that quantities do not know. Their numbers stay as they stand; `of_strain` is what 1 of them means as a strain.
struct PlainUnit {
  const char* word;
  std::optional<double> of_strain;
};
constexpr double percent = 0.01, permille = 1e-3, micro = 1e-6;
constexpr PlainUnit plain_units[] = {
    {"%", percent},
    {"pct", percent},
    {"percent", percent},
    {"perc", percent},
    {"per cent", percent},
    {"percentage", percent},
    {"prozent", percent},
    {"permille", permille},
    {"per mille", permille},
    {"\xE2\x80\xB0", permille},  // the sign of permille
    {"microstrain", micro},
    {"ustrain", micro},
    {"\xC2\xB5\xCE\xB5", micro},  // mu and epsilon, mu as the sign and as the letter
    {"\xCE\xBC\xCE\xB5", micro},
    {"--", 1},
    {"dimensionless", 1},
    {"unitless", 1},
    {"wtpct", {}},
    {"wt%", {}},
    {"wt %", {}},
    {"wt_pct", {}},
    {"wt_percent", {}},
    {"vol%", {}},
    {"volpct", {}},
    {"deg", {}},
    {"\xC2\xB0", {}},
};

const PlainUnit* plain_unit(const std::string& unit) {
  const std::string word = lower_case(unit);
  const auto* found = std::find_if(std::begin(plain_units), std::end(plain_units),
                                   [&](const auto& known) { return word == known.word; });
  return found == std::end(plain_units) ? nullptr : found;
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
    if (!plain_unit(unit)) unit = quotient(tail);
    if (is_unit(unit)) found = {header, header.substr(0, underscore), unit};
  }
  return found;
}

// "Strain %", "Strain/%", "Stress, kPa", "stress in MPa": a unit behind the last stroke, comma or blank. A single letter or digit
// behind a blank is a label.
CsvColumn split_words(const std::string& header) {
  for (const std::string separator : {" in ", ",", "/", " "}) {
    const auto at = header.find(separator, 1);
    const auto last = separator == "/" ? at : header.rfind(separator);  // "velocity/m/s": the first stroke
    if (last == std::string::npos || last == 0) continue;
    const std::string name = trimmed(header.substr(0, last)), unit = trimmed(header.substr(last + separator.size()));
    const bool label = separator == " " && unit.size() < 2 && unit != "%";
    if (!name.empty() && !label && unit != "1" && is_unit(unit)) return {header, name, unit};
  }
  return {header, header, ""};
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

std::optional<double> size_of_strain(const std::string& unit) {
  if (const auto* plain = plain_unit(unit)) return plain->of_strain;
  return is_unit(unit) && column_unit(unit).dimension == dimension::none ? std::optional(1.0) : std::nullopt;
}

std::vector<std::string> strain_units() {
  std::vector<std::string> words;
  for (const auto& unit : plain_units)
    if (unit.of_strain) words.push_back(unit.word);
  return words;
}

Quantity column_unit(const std::string& unit) {
  if (plain_unit(unit)) return {1, dimension::none};
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
  const CsvColumn with_suffix = split_suffix(header);
  return with_suffix.unit.empty() ? split_words(header) : with_suffix;
}

bool is_unit_word(const std::string& text) { return is_unit(text); }

std::string bare_unit(const std::string& cell) {
  const bool framed =
      cell.size() > 2 && ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'));
  return framed ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

void LineFaults::add(int line, const std::string& what) { faults_.push_back({line, what}); }

std::string LineFaults::message() const {
  auto sorted = faults_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) { return a.line < b.line; });
  std::vector<std::string> told;
  std::map<std::string, std::vector<int>> lines_of;
  std::vector<int> rest;
  for (const auto& [line, what] : sorted) {
    const bool known = lines_of.contains(what);
    if (!known && told.size() >= told_in_full) {
      rest.push_back(line);
      continue;
    }
    if (!known) told.push_back(what);
    lines_of[what].push_back(line);
  }
  std::string text;
  for (const auto& what : told) {
    const auto& lines = lines_of[what];
    text += fmt::format("{}{}:{}: {}", text.empty() ? "" : "\n", file_, lines[0], what);
    if (lines.size() > 1) text += " (also lines " + ranges({lines.begin() + 1, lines.end()}) + ")";
  }
  if (!rest.empty()) text += fmt::format("\n{}: also lines {}", file_, ranges(rest));
  return text;
}

void LineFaults::throw_if_any() const {
  if (!faults_.empty()) throw BadInput(message());
}

}  // namespace percal
