#include "percal/page/result.hpp"

#include <cmath>
#include <limits>

#include "percal/base/version.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page {
namespace {

const Json nothing = nullptr;

// The unit in which an object has KEY: "_Pa", or none. Throws MissingKey.
std::string unit_beside(const Json& object, const std::string& key) {
  if (!object.is_object() || object.contains(key)) return "";
  for (const UnitSuffix& suffix : unit_suffixes)
    if (object.contains(key + suffix.ending)) return suffix.ending;
  throw MissingKey(key);
}

}  // namespace

Json result_head(const std::string& command, const Json& input) {
  return {{"schema", result_schema}, {"percal", version()}, {"command", command}, {"input", input}};
}

Json cost_to_json(const Cost& cost) {
  return {{"runs", cost.runs ? Json(*cost.runs) : nothing},
          {"reused", cost.reused ? Json(*cost.reused) : nothing},
          {"cpu_s", finite(cost.cpu_seconds)},
          {"wall_s", finite(cost.wall_seconds)},
          {"budget_s", finite(cost.budget_seconds)},
          {"isa", cost.instruction_level.empty() ? nothing : Json(cost.instruction_level)},
          {"advice", cost.advice.empty() ? nothing : Json(cost.advice)}};
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : nothing; }
Json finite(const std::optional<double>& value) { return value ? finite(*value) : nothing; }

std::string written(const Json& result) { return result.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

const Json& at(const Json& object, const std::string& key) {
  if (object.is_null()) return nothing;
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end()) throw MissingKey(key);
  return *found;
}

const Json& maybe(const Json& object, const std::string& key) {
  return object.is_object() && object.contains(key) ? object.at(key) : nothing;
}

const Json& list(const Json& object, const std::string& key) {
  static const Json empty = Json::array();
  const Json& value = at(object, key);
  return value.is_array() ? value : empty;
}

std::optional<double> number(const Json& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}
std::optional<double> number(const Json& object, const std::string& key) { return number(at(object, key)); }
double number_or(const Json& object, const std::string& key, double otherwise) {
  return number(object, key).value_or(otherwise);
}

std::string text(const Json& value) { return value.is_string() ? value.get<std::string>() : ""; }
std::string text(const Json& object, const std::string& key) { return text(at(object, key)); }

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

const Json& with_unit(const Json& object, const std::string& key) { return at(object, key + unit_beside(object, key)); }

std::string value_words(const Json& object, const std::string& key, int digits) {
  const std::string name = key + unit_beside(object, key);
  return quantity(number(object, name), dimension_of_key(name), digits);
}

std::string interval_words(const Json& interval, const Dimension& dimension, int digits) {
  const auto low = number(interval, "low"), high = number(interval, "high");
  if (!low || !high) return absent;
  if (*low == *high) return "held";
  const auto end = [&](const std::optional<double>& value) { return quantity(value, dimension, digits); };
  return (yes(interval, "low_open") ? "below " : "") + end(low) + " to " +
         (yes(interval, "high_open") ? "above " : "") + end(high);
}
std::string interval_words(const Json& object, const std::string& key, int digits) {
  const std::string name = key + unit_beside(object, key);
  return interval_words(at(object, name), dimension_of_key(name), digits);
}

std::string region_words(const Json& region, const Dimension& dimension, int digits) {
  std::string words;
  for (const Json& piece : region) {
    const auto ends = numbers(piece);
    if (ends.size() == 2)
      words += (words.empty() ? "" : " or ") + quantity(ends[0], dimension, digits) + " to " +
               quantity(ends[1], dimension, digits);
  }
  return words.empty() ? absent : words;
}
std::string region_words(const Json& object, const std::string& key, int digits) {
  const std::string name = key + unit_beside(object, key);
  return region_words(at(object, name), dimension_of_key(name), digits);
}

std::string level_words(const Json& object) { return shown(100 * number_or(object, "level", NAN), 3) + " %"; }

}  // namespace percal::page
