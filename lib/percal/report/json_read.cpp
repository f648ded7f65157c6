#include "percal/report/json_read.hpp"

#include <limits>

namespace percal::report_parts {

const Json& at(const Json& object, const std::string& key) {
  static const Json nothing = nullptr;
  if (!object.is_object()) return nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

const Json& list(const Json& object, const std::string& key) {
  static const Json nothing = Json::array();
  const Json& value = at(object, key);
  return value.is_array() ? value : nothing;
}

std::optional<double> number(const Json& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}
std::optional<double> number(const Json& object, const std::string& key) { return number(at(object, key)); }
double number_or(const Json& object, const std::string& key, double otherwise) {
  return number(object, key).value_or(otherwise);
}

std::string text(const Json& object, const std::string& key) {
  const Json& value = at(object, key);
  return value.is_string() ? value.get<std::string>() : "";
}

bool yes(const Json& object, const std::string& key) {
  const Json& value = at(object, key);
  return value.is_boolean() && value.get<bool>();
}

std::vector<double> numbers(const Json& array) {
  std::vector<double> all;
  if (array.is_array())
    for (const Json& value : array) all.push_back(number(value).value_or(std::numeric_limits<double>::quiet_NaN()));
  return all;
}

std::vector<std::string> texts(const Json& array) {
  std::vector<std::string> all;
  if (array.is_array())
    for (const Json& value : array)
      if (value.is_string()) all.push_back(value.get<std::string>());
  return all;
}

}  // namespace percal::report_parts
