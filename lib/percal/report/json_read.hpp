// Numbers, texts and lists out of a result.json. What is not there, or is of another kind, is an empty value: a page shows what a
// result has. For the .cpp files of this folder.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace percal::report_parts {

using Json = nlohmann::json;

// The value under a key; null where there is none.
const Json& at(const Json& object, const std::string& key);

// The elements of an array under a key; an empty array where there is none.
const Json& list(const Json& object, const std::string& key);

std::optional<double> number(const Json& value);
std::optional<double> number(const Json& object, const std::string& key);
double number_or(const Json& object, const std::string& key, double otherwise);
std::string text(const Json& object, const std::string& key);  // empty where there is none
bool yes(const Json& object, const std::string& key);          // true and there

// The numbers of an array, NaN for an element that is none.
std::vector<double> numbers(const Json& array);
std::vector<std::string> texts(const Json& array);

}  // namespace percal::report_parts
