#include "percal/card/card_text.hpp"

#include <fmt/core.h>

#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "percal/base/error.hpp"

namespace percal {
namespace {

constexpr std::size_t comment_columns = 80;  // LS-DYNA's line; Abaqus and CalculiX take more

// "6.3750e+07" -> "6.375e7", "15" -> "15.": no zeros that say nothing, and a point, so that nobody reads an integer.
std::string squeezed(const std::string& text) {
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') == std::string::npos) mantissa += '.';
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (e == std::string::npos) return mantissa;
  std::size_t digits = e + 1;
  std::string sign;
  if (text[digits] == '+' || text[digits] == '-') {
    if (text[digits] == '-') sign = "-";
    ++digits;
  }
  while (digits + 1 < text.size() && text[digits] == '0') ++digits;
  return mantissa + "e" + sign + text.substr(digits);
}

std::string without_leading_zero(std::string text) {
  const std::size_t start = text.starts_with('-') ? 1 : 0;
  if (text.compare(start, 2, "0.") == 0 && text.size() > start + 2) text.erase(start, 1);
  return text;
}

// The best field so far: nearest first, then the one that reads best (short, and two columns' worth of dislike for
// exponents and for a missing zero).
struct Best {
  double value;
  std::size_t width;
  std::string text;
  double error = std::numeric_limits<double>::infinity();
  std::size_t awkwardness = 0;

  void offer(const std::string& candidate, std::size_t dislike) {
    if (candidate.size() > width) return;
    const double candidate_error = std::abs(*field_number(candidate) - value);
    const std::size_t candidate_awkwardness = candidate.size() + dislike;
    if (candidate_error < error || (candidate_error == error && candidate_awkwardness < awkwardness)) {
      text = candidate;
      error = candidate_error;
      awkwardness = candidate_awkwardness;
    }
  }
};

}  // namespace

std::string number_field(double value, int width) {
  assert(width >= 9);
  if (!std::isfinite(value)) throw BadInput(Place{}, fmt::format("{}", value), "a finite number");
  if (value == 0) return "0.";
  value = *field_number(fmt::format("{:.14e}", value));
  Best best{.value = value, .width = static_cast<std::size_t>(width), .text = ""};
  for (int digits = 0; digits <= width; ++digits) {
    const std::string fixed = squeezed(fmt::format("{:.{}f}", value, digits));
    best.offer(fixed, 0);
    best.offer(without_leading_zero(fixed), 2);
    best.offer(squeezed(fmt::format("{:.{}e}", value, digits)), 2);
  }
  return best.text;
}

std::string fixed_line(const std::vector<std::string>& fields, int width) {
  std::string line;
  for (const std::string& field : fields) {
    assert(field.size() <= static_cast<std::size_t>(width));
    line += fmt::format("{:>{}}", field, width);
  }
  return line + "\n";
}

std::optional<double> field_number(const std::string& field) {
  std::size_t first = field.find_first_not_of(" \t\r");
  if (first == std::string::npos) return 0.0;
  const std::size_t last = field.find_last_not_of(" \t\r");
  if (field[first] == '+') ++first;
  double value = 0;
  const char* end = field.data() + last + 1;
  const auto [stop, fault] = std::from_chars(field.data() + first, end, value);
  if (fault != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string comment_lines(const std::string& prefix, const std::string& text) {
  const std::string indented = prefix + "  ";
  std::string lines;
  std::string line = prefix;
  bool empty = true;  // whether `line` has a word yet
  const auto flush = [&] {
    lines += line + "\n";
    line = indented;
    empty = true;
  };
  const auto add = [&](std::string word) {
    if (!empty && line.size() + 1 + word.size() > comment_columns) flush();
    while (line.size() + 1 + word.size() > comment_columns) {  // a word longer than a line
      const std::size_t room = comment_columns - line.size() - 1;
      line += ' ';
      line += word.substr(0, room);
      word.erase(0, room);
      flush();
    }
    if (word.empty()) return;
    line += ' ';
    line += word;
    empty = false;
  };
  std::string word;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte <= ' ' || byte == 127) {
      if (!word.empty()) add(word);
      word.clear();
    } else if (byte < 128) {
      word += letter;
    } else if ((byte & 0xC0) != 0x80) {  // the first byte of a character in UTF-8; the others follow it silently
      word += '?';
    }
  }
  if (!word.empty()) add(word);
  if (!empty || lines.empty()) lines += line + "\n";
  return lines;
}

std::string comment_lines(const std::string& prefix, const std::vector<std::string>& texts) {
  std::string lines;
  for (const std::string& text : texts) lines += comment_lines(prefix, text);
  return lines;
}

std::string ascii_name(const std::string& name, const std::string& others, std::size_t most_characters) {
  std::string fit;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    if ((byte & 0xC0) == 0x80) continue;  // the rest of a character in UTF-8
    fit += byte < 128 && (std::isalnum(byte) || others.find(letter) != std::string::npos) ? letter : '_';
  }
  const auto start = fit.find_first_not_of(' ');
  if (start == std::string::npos) return "Ogden";
  fit = fit.substr(start, most_characters);
  return fit.substr(0, fit.find_last_not_of(' ') + 1);
}

}  // namespace percal
