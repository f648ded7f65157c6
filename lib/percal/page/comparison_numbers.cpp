// The numbers of a result, each with its path and its error.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/page/comparison_of.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page {
namespace {

// What is compared elsewhere, or says nothing beside another result.
const std::set<std::string> not_compared{
    "input", "data", "calibration", "model", "shot_model", "cost", "schema", "seed", "cards", "tables", "cpu_s",
    "wall_s", "reused", "trials", "scores", "shot", "iterations", "evaluations", "likelihood_evaluations", "curve",
    // of a list's elements: what they are called by, and what was put in
    "radius_m", "speed_m_s", "particle_density_kg_m3", "target_density_kg_m3", "measured_m", "measured_at_least_m",
    "thesis_fe_m", "reference_m", "elements_per_radius", "table_mu_as_given_Pa"};

std::string without_unit(const std::string& key) {
  const UnitSuffix* suffix = unit_suffix(key);
  return suffix ? key.substr(0, key.size() - std::string(suffix->ending).size()) : key;
}

std::string unit_of(const std::string& key) {
  const UnitSuffix* suffix = unit_suffix(key);
  return suffix ? suffix->ending : "";
}

bool is_error(const std::string& key) {
  const std::string name = without_unit(key);
  return name.ends_with("_error") || name.ends_with("_spread") || name.ends_with("_sd") ||
         name == "standard_deviation" || key.find("interval") != std::string::npos;
}

// Half of an interval of about 95 % is two standard errors.
std::optional<double> error_of_interval(const Json& interval) {
  const auto low = number(maybe(interval, "low")), high = number(maybe(interval, "high"));
  return low && high && *high > *low ? std::optional((*high - *low) / 4) : std::nullopt;
}

// The error that stands beside a number: KEY_error, KEY_standard_error, KEY_spread, its interval, a relative error.
std::optional<double> error_beside(const Json& object, const std::string& key) {
  const std::string name = without_unit(key), unit = unit_of(key);
  for (const char* ending : {"_standard_error", "_error", "_spread", "_sd"})
    if (const auto error = number(maybe(object, name + ending + unit))) return error;
  if (name == "value")
    if (const auto error = error_of_interval(maybe(object, "interval" + unit))) return error;
  if (name == "value")
    if (const auto error = error_of_interval(object)) return error;
  const auto solver = number(maybe(object, "relative_error_solver")),
             data = number(maybe(object, "relative_error_data"));
  if (name.starts_with("mu_") && (solver || data))
    return std::abs(*number(maybe(object, key))) * std::hypot(solver.value_or(0), data.value_or(0));
  return std::nullopt;
}

// What an element of a list is called.
std::string name_in_list(const Json& element, std::size_t place) {
  std::string name;
  for (const char* key :
       {"name", "label", "system", "material", "quantity", "setting", "particle", "measurement", "what"})
    if (const std::string word = text(maybe(element, key)); !word.empty()) {
      name = word;
      break;
    }
  const bool nameless = name.empty();
  for (const char* key : {"target_density_kg_m3", "radius_m", "speed_m_s", "erosion_strain", "elements_per_radius"}) {
    const bool of_nameless = key == std::string("erosion_strain") || key == std::string("elements_per_radius");
    if (const auto value = number(maybe(element, key)); value && (nameless || !of_nameless))
      name += fmt::format("{}{}", name.empty() ? "" : ", ",
                          of_nameless ? path_words(key) + " " + shown(value) : value_of(key, value));
  }
  std::replace(name.begin(), name.end(), '/', '|');
  return name.empty() ? fmt::format("{}", place + 1) : name;
}

void collect(const Json& value, const std::string& path, std::vector<FoundNumber>& found) {
  if (value.is_object())
    for (const auto& [key, inner] : value.items()) {
      if (not_compared.contains(key)) continue;
      const std::string here = path.empty() ? key : path + "/" + key;
      if (inner.is_structured())
        collect(inner, here, found);
      else if (inner.is_number() && !is_error(key))
        found.push_back({here, inner.get<double>(), error_beside(value, key)});
    }
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i].is_object()) collect(value[i], path + "/" + name_in_list(value[i], i), found);
}

bool starts(const std::string& path, const char* word) { return path.starts_with(word); }
bool has(const std::string& path, const char* word) { return path.find(word) != std::string::npos; }

}  // namespace

std::vector<FoundNumber> numbers_of(const Json& result) {
  std::vector<FoundNumber> found;
  Json own = result;
  if (own.is_object() && (text(maybe(own, "command")) == "identify")) own.erase("steps");  // its tables
  collect(own, "", found);
  return found;
}

bool is_main(const std::string& command, const std::string& path) {
  if (command == "identify")
    return starts(path, "skin/") || path == "alpha/value" || starts(path, "model_check/depth") ||
           (starts(path, "ridge/") && has(path, "/mu_")) || starts(path, "prediction_means/") ||
           starts(path, "similarity/");
  if (command == "calibrate")
    return has(path, "/mu_true/value") || has(path, "/youngs_quasi_static_true/value") ||
           has(path, "/fresh_mean_deviation") ||
           (has(path, "/parameters/") && has(path, "/value") && !has(path, "/minima/") && !has(path, "/minimum/")) ||
           has(path, "/prediction/mean_deviation") || (has(path, "/sets/") && path.ends_with("/mean_deviation"));
  if (command == "fit") return starts(path, "minima/") || has(path, "/parameters/");
  return std::count(path.begin(), path.end(), '/') <= 1;
}

std::string path_words(const std::string& path) {
  std::string words;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    std::string token = path.substr(begin, end - begin);
    if (end == path.size()) token = without_unit(token);
    std::replace(token.begin(), token.end(), '_', ' ');
    std::replace(token.begin(), token.end(), '|', '/');
    words += (words.empty() ? "" : ": ") + token;
    begin = end + 1;
  }
  return words;
}

std::string value_of(const std::string& path, std::optional<double> value) {
  const std::string key = path.substr(path.rfind('/') + 1);
  for (const char* share : {"deviation", "mismatch", "relative_error", "numerical_loss", "closure", "mesh_error"})
    if (has(key, share)) return percent(value, 2);
  return quantity(value, dimension_of_key(key));
}

}  // namespace percal::page
