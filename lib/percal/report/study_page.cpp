// The page of `percal study`: which of its kinds.
#include <filesystem>

#include "percal/report/scene_words.hpp"
#include "percal/report/study_page_parts.hpp"

namespace percal {

namespace report_parts {

std::string scene_words(const Json& result) {
  const Json& input = at(result, "input");
  const std::string pair = scene_title(text(input, "toml"));
  const std::string file = std::filesystem::path(text(input, "scene")).filename().string();
  return pair.empty() ? file : pair + " (" + file + ")";
}

}  // namespace report_parts

Page study_page(const report_parts::Json& result) {
  using namespace report_parts;
  const std::string study = text(result, "study");
  if (study == "error vs time") return error_vs_time_page(result);
  return study == "omissions" ? omissions_page(result) : extremes_page(result);
}

}  // namespace percal
