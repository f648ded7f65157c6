// What a page says of a scene, out of the TOML that its result keeps. For the .cpp files of this folder.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace percal::page {

// Keys and values of [section] of a scene written by percal, without quotes, quantities with the prefix that reads best:
// "1e-06 m" is "1 um".
std::vector<std::pair<std::string, std::string>> scene_values(const std::string& toml, const std::string& section);

// The value under one key, empty where there is none; as a number, where it is one without a unit.
std::string scene_value(const std::string& toml, const std::string& section, const std::string& key);
std::optional<double> scene_number(const std::string& toml, const std::string& section, const std::string& key);

// "gold into skin"; empty where the scene names neither.
std::string scene_title(const std::string& toml);

}  // namespace percal::page
