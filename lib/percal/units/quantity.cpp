#include "percal/units/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "percal/units/words.hpp"

namespace percal {
namespace {

// A unit is mantissa * 10^ten in SI. The power of ten is kept apart so that it can be joined to the number's own
// exponent before the one rounding from decimal to binary.
struct Scale {
  Dimension dimension;
  double mantissa = 1;
  int ten = 0;
};

struct Unit {
  const char* symbol;
  Scale scale;
};

using dimension::force;
constexpr Dimension energy{.mass = 1, .length = 2, .time = -2};
constexpr double pound = 0.45359237;                         // kg
constexpr double pound_per_square_inch = 6894.757293168361;  // Pa: a pound * 9.80665 m/s2 / (0.0254 m)^2

// clang-format off
constexpr std::array units{
    Unit{"kg", {dimension::mass, 1, 0}},      Unit{"g", {dimension::mass, 1, -3}},
    Unit{"mg", {dimension::mass, 1, -6}},     Unit{"ug", {dimension::mass, 1, -9}},
    Unit{"ng", {dimension::mass, 1, -12}},    Unit{"pg", {dimension::mass, 1, -15}},
    Unit{"t", {dimension::mass, 1, 3}},       Unit{"m", {dimension::length, 1, 0}},
    Unit{"dm", {dimension::length, 1, -1}},   Unit{"cm", {dimension::length, 1, -2}},
    Unit{"mm", {dimension::length, 1, -3}},   Unit{"um", {dimension::length, 1, -6}},
    Unit{"nm", {dimension::length, 1, -9}},   Unit{"km", {dimension::length, 1, 3}},
    Unit{"in", {dimension::length, 254, -4}}, Unit{"inch", {dimension::length, 254, -4}},
    Unit{"mil", {dimension::length, 254, -7}}, Unit{"ft", {dimension::length, 3048, -4}},
    Unit{"yd", {dimension::length, 9144, -4}}, Unit{"fps", {dimension::speed, 3048, -4}},
    Unit{"mph", {dimension::speed, 44704, -5}}, Unit{"lb", {dimension::mass, pound, 0}},
    Unit{"oz", {dimension::mass, pound / 16, 0}}, Unit{"gr", {dimension::mass, 6479891, -11}},
    Unit{"grain", {dimension::mass, 6479891, -11}},
    Unit{"s", {dimension::time, 1, 0}},       Unit{"ms", {dimension::time, 1, -3}},
    Unit{"us", {dimension::time, 1, -6}},     Unit{"ns", {dimension::time, 1, -9}},
    Unit{"min", {dimension::time, 60, 0}},    Unit{"h", {dimension::time, 3600, 0}},
    Unit{"Pa", {dimension::pressure, 1, 0}},  Unit{"hPa", {dimension::pressure, 1, 2}},
    Unit{"kPa", {dimension::pressure, 1, 3}}, Unit{"MPa", {dimension::pressure, 1, 6}},
    Unit{"GPa", {dimension::pressure, 1, 9}}, Unit{"bar", {dimension::pressure, 1, 5}},
    Unit{"psi", {dimension::pressure, pound_per_square_inch, 0}},
    Unit{"ksi", {dimension::pressure, pound_per_square_inch, 3}},
    Unit{"N", {force, 1, 0}},                 Unit{"kN", {force, 1, 3}},
    Unit{"mN", {force, 1, -3}},               Unit{"uN", {force, 1, -6}},
    Unit{"gf", {force, 980665, -8}},          Unit{"kgf", {force, 980665, -5}},
    Unit{"lbf", {force, 4.4482216152605, 0}},
    Unit{"J", {energy, 1, 0}},                Unit{"kJ", {energy, 1, 3}},
    Unit{"mJ", {energy, 1, -3}},              Unit{"uJ", {energy, 1, -6}},
};
// clang-format on

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

std::string known_units() {
  std::vector<std::string> symbols;
  for (const auto& unit : units) symbols.emplace_back(unit.symbol);
  return listed(symbols) + ", joined as in kg/m3 or m/s";
}

Scale find_unit(std::string_view symbol) {
  for (const auto& unit : units) {
    if (symbol == unit.symbol) return unit.scale;
  }
  if (symbol.ends_with('%')) refuse(in_quotes(symbol) + " is not a unit here: write a fraction such as 0.1");
  for (const auto& unit : units) {
    if (lower_case(symbol) == lower_case(unit.symbol)) {
      refuse(fmt::format("unknown unit {} (did you mean {}? capital and small letters differ)", in_quotes(symbol),
                         unit.symbol));
    }
  }
  refuse("unknown unit " + in_quotes(symbol) + "; known: " + known_units());
}

Scale power(const Scale& base, int exponent) {
  const auto& [dimension, mantissa, ten] = base;
  return {{dimension.mass * exponent, dimension.length * exponent, dimension.time * exponent},
          std::pow(mantissa, exponent),
          ten * exponent};
}

Scale product(const Scale& a, const Scale& b) {
  const Dimension dimension{a.dimension.mass + b.dimension.mass, a.dimension.length + b.dimension.length,
                            a.dimension.time + b.dimension.time};
  return {dimension, a.mantissa * b.mantissa, a.ten + b.ten};
}

// Greek letters, raised digits and the raised dot as they are typed in ASCII.
std::string in_ascii(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, char>, 15> spellings{{{"\u00b5", 'u'},
                                                                                {"\u03bc", 'u'},
                                                                                {"\u00b7", '*'},
                                                                                {"\u207b", '-'},
                                                                                {"\u2070", '0'},
                                                                                {"\u00b9", '1'},
                                                                                {"\u00b2", '2'},
                                                                                {"\u00b3", '3'},
                                                                                {"\u2074", '4'},
                                                                                {"\u2075", '5'},
                                                                                {"\u2076", '6'},
                                                                                {"\u2077", '7'},
                                                                                {"\u2078", '8'},
                                                                                {"\u2079", '9'},
                                                                                {"\u00a0", ' '}}};
  std::string result;
  while (!text.empty()) {
    std::size_t taken = 1;
    char c = text.front();
    for (const auto& [spelling, ascii] : spellings) {
      if (text.starts_with(spelling)) {
        c = ascii;
        taken = spelling.size();
      }
    }
    result += c;
    text.remove_prefix(taken);
  }
  return result;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t'; }

std::string_view stripped(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

// product := factor { ('*' | ' ' | '/') factor }
// factor := (symbol | '(' product ')') [['^'] integer] | '1' before '/'
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : text_(text) {}

  Scale parse() {
    const Scale scale = parse_product();
    if (at_ < text_.size()) refuse("unit " + in_quotes(text_) + ": unexpected " + in_quotes(text_.substr(at_)));
    return scale;
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) { return peek() == c && at_ < text_.size() ? (++at_, true) : false; }
  void skip_spaces() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  Scale parse_product() {
    Scale scale = parse_first();
    for (bool divided = false;;) {
      skip_spaces();
      if (at_ == text_.size() || peek() == ')') return scale;
      const bool divide = take('/');
      if (!divide && divided) {
        refuse("unit " + in_quotes(text_) +
               " may be read in two ways; put what is below the line in brackets, as in kg/(m s)");
      }
      if (!divide) take('*');
      skip_spaces();
      scale = bounded(product(scale, power(parse_factor(), divide ? -1 : 1)));
      divided = divided || divide;
    }
  }

  Scale parse_first() {
    skip_spaces();
    if (peek() != '1') return parse_factor();
    ++at_;
    skip_spaces();
    if (peek() != '/') refuse("unit " + in_quotes(text_) + ": a number is no unit");
    return {};
  }

  Scale parse_factor() {
    if (take('(')) {
      const Scale inner = parse_product();
      if (!take(')')) refuse("unit " + in_quotes(text_) + ": a bracket is not closed");
      return with_power(inner);
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::string_view(" \t*/^()+-0123456789").find(text_[at_]) == std::string_view::npos)
      ++at_;
    if (at_ == begin) {
      refuse(at_ < text_.size() ? "unit " + in_quotes(text_) + ": unexpected " + in_quotes(text_.substr(at_))
                                : "unit " + in_quotes(text_) + " is not complete");
    }
    return with_power(find_unit(text_.substr(begin, at_ - begin)));
  }

  Scale with_power(const Scale& base) {
    const bool marked = take('^');
    const std::size_t begin = at_;
    const bool negative = take('-');
    if (!negative) take('+');
    const char* first = text_.data() + at_;
    int exponent = 0;
    const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), exponent);
    if (end == first || !is_digit(*first)) {
      if (marked || begin != at_) refuse("unit " + in_quotes(text_) + ": a power is a whole number, as in m^3 or s^-1");
      return base;
    }
    if (error != std::errc{} || exponent < 1 || exponent > 9) {
      refuse("unit " + in_quotes(text_) + ": a power is between 1 and 9, or -9 and -1");
    }
    at_ += static_cast<std::size_t>(end - first);
    return bounded(power(base, negative ? -exponent : exponent));
  }

  // Refuses what would overflow. A step multiplies by at most 9, so that int cannot overflow before this looks.
  Scale bounded(const Scale& scale) const {
    const auto& [dimension, mantissa, ten] = scale;
    const int largest = std::max({std::abs(dimension.mass), std::abs(dimension.length), std::abs(dimension.time)});
    if (largest > 60 || std::abs(ten) > 300 || !std::isnormal(mantissa)) {
      refuse("unit " + in_quotes(text_) + ": the powers are too large");
    }
    return scale;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

constexpr std::size_t longest_text = 200;

// The decimal number `digits` (with or without an exponent of its own) times 10^ten, rounded once. NaN where out of
// range.
double shifted(std::string_view digits, int ten) {
  const std::size_t mark = digits.find_first_of("eE");
  int exponent = 0;
  if (mark != std::string_view::npos) {
    std::string_view own = digits.substr(mark + 1);
    if (own.starts_with('+')) own.remove_prefix(1);
    const auto [end, error] = std::from_chars(own.data(), own.data() + own.size(), exponent);
    if (error != std::errc{} || std::abs(exponent) > 10000) return NAN;
  }
  const std::string text = fmt::format("{}e{}", digits.substr(0, mark), exponent + ten);
  double value = NAN;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? value : NAN;
}

}  // namespace

Quantity parse_unit(std::string_view unit) {
  if (unit.size() > longest_text) refuse("unit " + in_quotes(unit) + " is too long");
  const std::string ascii = in_ascii(stripped(unit));
  const std::string_view text = stripped(ascii);
  if (text.empty() || text == "-" || text == "1") return {1, dimension::none};
  const Scale scale = UnitParser(text).parse();
  const double value = scale.mantissa * shifted("1", scale.ten);
  if (!std::isnormal(value)) refuse("unit " + in_quotes(unit) + " is out of range");
  return {value, scale.dimension};
}

Quantity parse_quantity(std::string_view written) {
  if (written.size() > longest_text) refuse(in_quotes(written) + " is too long for a number with a unit");
  std::string_view text = stripped(written);
  if (text.empty()) refuse("an empty text is no number");
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  const char* begin = text.data();
  const std::string_view magnitude = text.substr(text.front() == '-' ? 1 : 0);
  double number = NAN;
  const auto [end, error] = std::from_chars(begin, begin + text.size(), number);
  if (magnitude.empty() || !(is_digit(magnitude.front()) || magnitude.front() == '.') ||
      error == std::errc::invalid_argument) {
    refuse(in_quotes(written) + " does not begin with a finite number");
  }
  const auto used = static_cast<std::size_t>(end - begin);
  const std::string_view rest = stripped(text.substr(used));
  if (rest.starts_with(',')) refuse(in_quotes(written) + ": write the decimal mark as a point");
  if (error != std::errc{}) refuse(in_quotes(written) + " is out of the range of numbers");

  const std::string unit = in_ascii(rest);
  const Scale scale = unit.empty() ? Scale{} : UnitParser(unit).parse();
  const double decimal = number == 0 || scale.ten == 0 ? number : shifted(text.substr(0, used), scale.ten);
  const double value = decimal * scale.mantissa;
  if (!std::isfinite(value) || (value == 0 && number != 0))
    refuse(in_quotes(written) + " is out of the range of numbers");
  return {value, scale.dimension};
}

}  // namespace percal
