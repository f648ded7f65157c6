// The page of `percal study`: which of its kinds.
#include "percal/study/page/page.hpp"

#include <filesystem>

#include "percal/observe/page/scene_words.hpp"
#include "percal/study/page/parts.hpp"

namespace percal {

namespace page {

std::string scene_words(const Json& result) {
  const Json& input = at(result, "input");
  const std::string pair = scene_title(text(input, "toml"));
  const std::string file = std::filesystem::path(text(input, "scene")).filename().string();
  return pair.empty() ? file : pair + " (" + file + ")";
}

}  // namespace page

page::Page study_page(const page::Json& result) {
  using namespace page;
  const std::string study = text(result, "study");
  if (study == "error vs time") return error_vs_time_page(result);
  return study == "omissions" ? omissions_page(result) : extremes_page(result);
}

}  // namespace percal
