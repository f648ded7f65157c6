#include "percal/text/key_form.hpp"

#include <fmt/format.h>

#include "percal/units/words.hpp"

namespace percal {
namespace {

std::string general_words(const Range& range) { return range.in_general.empty() ? words_of(range) : range.in_general; }
std::string kind_of(const Dimension& dimension) { return dimension == dimension::none ? "number" : name_of(dimension); }

}  // namespace

std::string accepted_integer(int low, int high) { return fmt::format("a whole number from {} to {}", low, high); }

std::string accepted_words(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + in_quotes(word);
  return text;
}

KeyForm quantity_form(const Dimension& dimension, const Range& range) {
  return {kind_of(dimension), general_words(range), ""};
}

KeyForm quantity_array_form(const Dimension& dimension, const Range& range) {
  return {"array: " + kind_of(dimension), "each element " + general_words(range), ""};
}

KeyForm quantity_pairs_form(const Dimension& dimension, const Range& range) {
  return {"array of pairs: " + kind_of(dimension), "each number " + general_words(range), ""};
}

KeyForm integer_form(int low, int high) { return {"whole number", accepted_integer(low, high), ""}; }

KeyForm word_form(const std::vector<std::string>& words) { return {"word", accepted_words(words), ""}; }

KeyForm with_default(KeyForm form, std::string fallback) {
  form.fallback = std::move(fallback);
  return form;
}

std::string written(double value, const Dimension& dimension) {
  if (dimension == dimension::none) return fmt::format("{}", value);
  const std::string units = units_of(dimension);
  return in_quotes(value == 0 ? "0 " + units.substr(0, units.find(',')) : format_quantity(value, dimension));
}

}  // namespace percal
