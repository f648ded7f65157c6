#include "percal/text/range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string_view>

namespace percal {

std::string with_article(const std::string& noun) {
  const bool vowel = !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

Range positive(const std::string& what) {
  return {.low = 0, .high = std::numeric_limits<double>::infinity(), .low_open = true, .words = "a positive " + what};
}

Range not_negative(const std::string& what) {
  return {.low = 0, .high = std::numeric_limits<double>::infinity(), .words = with_article(what) + " not below zero"};
}

Range any_number() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {.low = -infinity, .high = infinity, .words = "a finite number"};
}

std::string words_of(const Range& range) {
  if (!range.words.empty()) return range.words;
  const bool has_low = std::isfinite(range.low), has_high = std::isfinite(range.high);
  std::string text = "a number";
  if (has_low) text += fmt::format(" {} {}", range.low_open ? "above" : "from", range.low);
  if (has_low && has_high) text += " and";
  if (has_high) text += fmt::format(" {} {}", range.high_open ? "below" : "up to", range.high);
  return text;
}

bool contains(const Range& range, double value) {
  return std::isfinite(value) && (range.low_open ? value > range.low : value >= range.low) &&
         (range.high_open ? value < range.high : value <= range.high);
}

std::string words_of(const Range& range, const Dimension& dimension) {
  if (dimension == dimension::none) return words_of(range);
  const std::string units = units_of(dimension);
  return fmt::format("{} with its unit, such as \"5 {}\" ({})", words_of(range), units.substr(0, units.find(',')),
                     units);
}

}  // namespace percal
