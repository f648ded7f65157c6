#include "percal/text/json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "percal/base/error.hpp"

namespace percal {
namespace {

using nlohmann::json;

// Where the text goes deeper than it may; its length where it does not.
std::size_t too_deep(const std::string& text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (in_string && letter == '\\') {
      ++i;
    } else if (letter == '"') {
      in_string = !in_string;
    } else if (!in_string && (letter == '{' || letter == '[')) {
      if (++depth > deepest_json) return i;
    } else if (!in_string && (letter == '}' || letter == ']')) {
      --depth;
    }
  }
  return text.size();
}

// What stands between the first two single quotes of a message: the number that is out of range.
std::string quoted_in(const std::string& message) {
  const std::size_t start = message.find('\'') + 1, end = message.find('\'', start);
  return end == std::string::npos ? message : message.substr(start, end - start);
}

}  // namespace

json parse_json(const std::string& text, const std::string& file, const std::string& wanted) {
  const auto line_at = [&](std::size_t byte) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return Place{file, 1 + static_cast<int>(std::count(text.begin(), end, '\n')), ""};
  };
  if (text.size() > largest_json)
    throw BadInput(Place{file, 0, ""}, fmt::format("{} MiB", text.size() >> 20),
                   fmt::format("{} of at most {} MiB", wanted, largest_json >> 20));
  if (const std::size_t deep = too_deep(text); deep < text.size())
    throw BadInput(line_at(deep), "JSON nested too deeply",
                   fmt::format("{} of at most {} levels", wanted, deepest_json));
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    throw BadInput(line_at(error.byte), "text that is not JSON", wanted);
  } catch (const json::out_of_range& error) {
    const std::string number = quoted_in(error.what());
    throw BadInput(line_at(text.find(number)), number, "numbers that a double holds, to 1.8e308");
  }
}

}  // namespace percal
