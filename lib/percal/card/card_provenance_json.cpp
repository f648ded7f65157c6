#include "percal/card/card_provenance_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace percal {
namespace {

using nlohmann::json;

std::string dumped(const json& value) { return value.dump(-1, ' ', true, json::error_handler_t::replace); }

Place below(const Place& place, const std::string& key) {
  return {place.file, place.line, place.key.empty() ? key : place.key + "." + key};
}

json end_to_json(const std::optional<double>& end) { return end ? json(*end) : json(nullptr); }

std::optional<double> end_of(const json& interval, const std::string& key, const Place& place) {
  if (!interval.contains(key) || interval[key].is_null()) return std::nullopt;
  if (!interval[key].is_number()) throw BadInput(below(place, key), dumped(interval[key]), "a number or null");
  return interval[key].get<double>();
}

CardIntervals intervals_of(const json& given, const Place& place) {
  if (!given.is_object())
    throw BadInput(place, dumped(given), "an object with level and an interval of each parameter");
  if (!given.contains("level") || !given["level"].is_number())
    throw BadInput(below(place, "level"), given.contains("level") ? dumped(given["level"]) : "nothing",
                   "a number between 0 and 1");
  CardIntervals intervals{given["level"].get<double>(), {}};
  for (const auto& [parameter, interval] : given.items()) {
    if (parameter == "level") continue;
    const Place of_parameter = below(place, parameter);
    if (!interval.is_object()) throw BadInput(of_parameter, dumped(interval), "an object with low and high");
    intervals.of.push_back({parameter, end_of(interval, "low", of_parameter), end_of(interval, "high", of_parameter)});
  }
  return intervals;
}

CardData data_of(const json& given, const Place& place) {
  const bool good = given.is_object() && given.contains("file") && given["file"].is_string() &&
                    given.contains("sha256") && given["sha256"].is_string();
  if (!good) throw BadInput(place, dumped(given), "objects with file and sha256");
  CardData data{given["file"].get<std::string>(), given["sha256"].get<std::string>()};
  const bool hexadecimal = std::all_of(data.sha256.begin(), data.sha256.end(), [](char digit) {
    return (digit >= '0' && digit <= '9') || (digit >= 'a' && digit <= 'f');
  });
  if (data.sha256.size() != 64 || !hexadecimal)
    throw BadInput(below(place, "sha256"), "\"" + data.sha256 + "\"", "64 hexadecimal digits");
  return data;
}

}  // namespace

void add_provenance(const CardMaterial& material, json& card) {
  if (material.intervals) {
    json intervals = {{"level", material.intervals->level}};
    for (const CardInterval& one : material.intervals->of)
      intervals[one.parameter] = {{"low", end_to_json(one.low)}, {"high", end_to_json(one.high)}};
    card["intervals"] = intervals;
  }
  if (!material.fit_error.empty()) card["fit_error"] = material.fit_error;
  if (!material.data.empty()) {
    card["data"] = json::array();
    for (const CardData& data : material.data) card["data"].push_back({{"file", data.file}, {"sha256", data.sha256}});
  }
}

void read_provenance(const json& card, const Place& place, CardMaterial& material) {
  const auto given = [&](const std::string& key) { return card.contains(key) && !card[key].is_null(); };
  if (given("intervals")) material.intervals = intervals_of(card["intervals"], below(place, "intervals"));
  if (given("fit_error")) {
    if (!card["fit_error"].is_string())
      throw BadInput(below(place, "fit_error"), dumped(card["fit_error"]), "a sentence");
    material.fit_error = card["fit_error"].get<std::string>();
  }
  if (given("data")) {
    if (!card["data"].is_array()) throw BadInput(below(place, "data"), dumped(card["data"]), "an array of objects");
    for (const json& one : card["data"]) material.data.push_back(data_of(one, below(place, "data")));
  }
}

}  // namespace percal
