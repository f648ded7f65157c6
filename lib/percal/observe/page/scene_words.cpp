#include "percal/observe/page/scene_words.hpp"

#include <locale>
#include <sstream>
#include <stdexcept>

#include "percal/units/quantity.hpp"

namespace percal::page {
namespace {

// A quoted text may be a quantity.
std::string shown(const std::string& value) {
  if (value.size() < 2 || value.front() != '"' || value.back() != '"') return value;
  const std::string text = value.substr(1, value.size() - 2);
  try {
    const Quantity parsed = parse_quantity(text);
    return parsed.dimension == dimension::none ? text : format_quantity(parsed.value, parsed.dimension, 6);
  } catch (const std::invalid_argument&) {
    return text;
  }
}

}  // namespace

std::vector<std::pair<std::string, std::string>> scene_values(const std::string& toml, const std::string& section) {
  std::vector<std::pair<std::string, std::string>> values;
  std::istringstream lines(toml);
  bool inside = section.empty();
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("[")) inside = line == "[" + section + "]";
    const auto equals = line.find(" = ");
    if (inside && equals != std::string::npos && !line.starts_with("#"))
      values.emplace_back(line.substr(0, equals), shown(line.substr(equals + 3)));
  }
  return values;
}

std::string scene_value(const std::string& toml, const std::string& section, const std::string& key) {
  for (const auto& [name, value] : scene_values(toml, section))
    if (name == key) return value;
  return "";
}

std::optional<double> scene_number(const std::string& toml, const std::string& section, const std::string& key) {
  std::istringstream text(scene_value(toml, section, key));
  text.imbue(std::locale::classic());
  double number = 0;
  return text >> number && text.eof() ? std::optional(number) : std::nullopt;
}

std::string scene_title(const std::string& toml) {
  const std::string particle = scene_value(toml, "particle", "name"), target = scene_value(toml, "target", "name");
  return particle.empty() && target.empty() ? "" : particle + " into " + target;
}

}  // namespace percal::page
