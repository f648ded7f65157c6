#include "percal/text/toml_depth.hpp"

#include <algorithm>

#include "percal/base/error.hpp"

namespace percal {
namespace {

constexpr int most_dots = 100;  // in one line, decimal points not counted

bool is_digit(char c) { return (c >= '0' && c <= '9') || c == '_'; }

// A dot with digits on both sides, none of which belongs to another dot: 0.25, but not the keys 1.2.3.
bool is_decimal_point(std::string_view line, std::size_t dot) {
  std::size_t before = dot, after = dot + 1;
  while (before > 0 && is_digit(line[before - 1])) --before;
  while (after < line.size() && is_digit(line[after])) ++after;
  const bool has_digits = before < dot && after > dot + 1;
  const bool alone = (before == 0 || line[before - 1] != '.') && (after == line.size() || line[after] != '.');
  return has_digits && alone;
}

}  // namespace

void refuse_deep_keys(std::string_view text, const std::string& file) {
  int number = 1;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    int dots = 0;
    for (std::size_t at = line.find('.'); at != line.npos; at = line.find('.', at + 1))
      dots += !is_decimal_point(line, at);
    if (dots > most_dots)
      throw BadInput({file, number, ""}, "a line with more than 100 dots", "keys nested a few levels deep");
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    ++number;
  }
}

}  // namespace percal
