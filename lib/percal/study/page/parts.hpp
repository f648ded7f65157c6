// The pages of the three kinds of study. For the .cpp files of this folder.
#pragma once
#include "percal/page/sections.hpp"

namespace percal::page {

// The kinds, as results name them.
inline const std::vector<std::string> studies{"error vs time", "omissions", "extremes"};

Page error_vs_time_page(const Json& result);
Page omissions_page(const Json& result);
Page extremes_page(const Json& result);

// "gold into skin (gold.toml)".
std::string scene_words(const Json& result);

}  // namespace percal::page
