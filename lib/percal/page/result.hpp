// Numbers, texts and lists out of a result.json. A key that a result ought to have and lacks is a MissingKey, so that nothing is
// taken for "no" that was never said; null is an absent value, and whatever is looked up in it is absent too.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "percal/units/quantity.hpp"

namespace percal::page {

using Json = nlohmann::json;

// What every result begins with: schema, percal's version, the command, and what it was given: {"job" or "scene": file, "toml": its
// text}, or the arguments.
Json result_head(const std::string& command, const Json& input);

// What a result cost, under `cost`. Runs: of the solver, done here and taken from the store.
struct Cost {
  std::optional<long> runs = {}, reused = {};
  double cpu_seconds = 0, wall_seconds = 0;
  std::optional<double> budget_seconds = {};
  std::string instruction_level = "";  // empty: no runs
  std::string advice = "";             // what more time would buy
};
Json cost_to_json(const Cost& cost);

// A number as JSON, which has no NaN: null.
Json finite(double value);
Json finite(const std::optional<double>& value);

// As a file: indented, bytes that are no UTF-8 replaced.
std::string written(const Json& result);

// A result of another version, or cut by hand. Whoever read the file says its name.
struct MissingKey : std::runtime_error {
  explicit MissingKey(const std::string& key) : std::runtime_error("a result without the key " + key), key(key) {}
  std::string key;
};

// The value under a key; null in null. Throws MissingKey.
const Json& at(const Json& object, const std::string& key);

// The value under a key that only some results have; null where there is none.
const Json& maybe(const Json& object, const std::string& key);

// As at(): the elements of an array, none of null; a finite number; a text, empty of null; true and nothing else.
const Json& list(const Json& object, const std::string& key);
std::optional<double> number(const Json& object, const std::string& key);
double number_or(const Json& object, const std::string& key, double otherwise);
std::string text(const Json& object, const std::string& key);
bool yes(const Json& object, const std::string& key);

std::optional<double> number(const Json& value);
std::string text(const Json& value);
std::vector<double> numbers(const Json& array);  // NaN for an element that is none
std::vector<std::string> texts(const Json& array);

// The value under KEY, or under KEY with a unit behind it: "value_Pa".
const Json& with_unit(const Json& object, const std::string& key);

// That number in words, with its unit: "1.2 MPa", "0.58"; "-" of null.
std::string value_words(const Json& object, const std::string& key, int digits = 3);

// "1.2 MPa to 3.4 MPa" of an interval {low, high, low_open, high_open}, by itself or under KEY or KEY with a unit; an end that a bound
// of the search cut off is said to be: "below 1.2 MPa to above 3.4 MPa".
std::string interval_words(const Json& interval, const Dimension& dimension, int digits = 3);
std::string interval_words(const Json& object, const std::string& key, int digits = 3);

// "1.2 MPa to 3.4 MPa or 5 MPa to 6 MPa" of the pieces [[low, high], ...], by themselves or under a key as above.
std::string region_words(const Json& region, const Dimension& dimension, int digits = 3);
std::string region_words(const Json& object, const std::string& key, int digits = 3);

// "95 %": the level of confidence under `level`.
std::string level_words(const Json& object);

}  // namespace percal::page
