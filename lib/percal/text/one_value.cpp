#include "percal/text/one_value.hpp"

#include <stdexcept>

#include "percal/base/error.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// What `accepted` says, in the form that the value is written in.
[[noreturn]] void refuse(const std::string& text, const std::string& why, const std::string& name,
                         const std::string& accepted) {
  throw BadInput(Place{.file = "", .line = 0, .key = name}, in_quotes(text) + (why.empty() ? "" : ": " + why),
                 accepted);
}

Quantity parsed(const std::string& part, const std::string& text, const std::string& name,
                const std::string& accepted) {
  try {
    return parse_quantity(part);
  } catch (const std::invalid_argument& error) {
    refuse(text, error.what(), name, accepted);
  }
}

// What stands behind the number: " m/s" of "250 m/s".
std::string unit_behind(const std::string& text) {
  for (std::size_t length = text.size(); length > 0; --length) try {
      if (parse_quantity(text.substr(0, length)).dimension == dimension::none) return text.substr(length);
    } catch (const std::invalid_argument&) {
    }
  return "";
}

}  // namespace

double one_quantity(const std::string& text, const std::string& name, const Dimension& dimension,
                    const Range& accepted) {
  const std::string words = words_of(accepted, dimension);
  const Quantity quantity = parsed(text, text, name, words);
  if (quantity.dimension != dimension || !contains(accepted, quantity.value)) refuse(text, "", name, words);
  return quantity.value;
}

std::optional<double> optional_quantity(const std::string& text, const std::string& name, const Dimension& dimension,
                                        const Range& accepted) {
  if (text.empty()) return std::nullopt;
  return one_quantity(text, name, dimension, accepted);
}

double one_share(const std::string& text, const std::string& name, const Range& accepted) {
  const std::string words = words_of(accepted), number = trimmed(text);
  const bool is_percent = number.ends_with('%');
  const Quantity share = parsed(is_percent ? trimmed(number.substr(0, number.size() - 1)) : number, text, name, words);
  const double value = is_percent ? share.value / 100 : share.value;
  if (share.dimension != dimension::none || !contains(accepted, value)) refuse(text, "", name, words);
  return value;
}

QuantityRange quantity_range(const std::string& text, const std::string& name, const Dimension& dimension,
                             const Range& accepted) {
  const auto dots = text.find("..");
  if (dots == std::string::npos) {
    const double value = one_quantity(text, name, dimension, accepted);
    return {value, value};
  }
  const std::string words = "LOW..HIGH, each " + words_of(accepted, dimension), high = trimmed(text.substr(dots + 2));
  std::string low = trimmed(text.substr(0, dots));
  if (parsed(low, text, name, words).dimension == dimension::none) low += unit_behind(high);
  const Quantity ends[] = {parsed(low, text, name, words), parsed(high, text, name, words)};
  for (const Quantity& end : ends)
    if (end.dimension != dimension || !contains(accepted, end.value)) refuse(text, "", name, words);
  if (!(ends[0].value < ends[1].value)) refuse(text, "", name, words + ", low before high");
  return {ends[0].value, ends[1].value};
}

}  // namespace percal
