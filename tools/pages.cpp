#include "pages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "colour.hpp"
#include "percal/base/error.hpp"
#include "percal/base/printable.hpp"
#include "percal/base/version.hpp"
#include "percal/page/figures.hpp"
#include "percal/scene/document_kind.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"
#include "percal/text/json.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {

using page::Json;

void refuse_document(const std::string& file, const std::string& accepted) {
  if (!file.ends_with(".toml")) return;
  if (const auto kind = document_in_words(read_file(file))) throw BadInput({file, 0, ""}, *kind, accepted);
}

NamedResult read_json_result(const std::string& path) {
  const std::string file = result_file(path);
  refuse_document(file, "the result.json of a command of percal");
  Json json = parse_json(read_file(file), file, "the result.json of a command of percal");
  check_result(json, file);
  return {file, std::move(json)};
}

page::ReadResult read_result(const std::string& path) {
  NamedResult read = read_json_result(path);
  page::Page page = page_of_result(read.json, read.file);
  return {std::move(read.file), std::move(read.json), std::move(page)};
}

void deliver(const Json& result, const std::string& folder, const Common& common) {
  const std::string json = page::written(result);
  const std::string file = folder + "/result.json";
  if (!folder.empty()) write_file(file, json);
  if (common.json) fmt::print("{}", json);
  if (!common.talks()) return;
  const auto style = terminal_style(common.details ? page::Detail::more : page::Detail::answer);
  fmt::print("{}", page::as_text(page_of_result(result, "this result"), style));
  if (!folder.empty())
    print(fmt::format("{}: the whole result{}\n", file, common.details ? "" : "; see --details, percal report"));
}

void write_page_figures(const page::Page& page, const std::string& folder, const Common& common) {
  if (!folder.empty() && !page::write_figures(page, folder, page::Pictures::svg) && common.talks())
    fmt::print("figures were not drawn, since gnuplot is not there or failed; the CSV files have their points\n");
}

void write_scene(const Scene& scene, const std::string& comment, const std::string& name, const std::string& folder) {
  if (folder.empty()) return;
  const std::string scenes = folder + "/scenes";
  ensure_writable_folder(scenes);
  write_file(scenes + "/" + name + ".toml", scene_to_toml(scene, comment));
}

Exit say_valid(const std::string& words, Json answer, const Common& common, const std::optional<RunSize>& largest) {
  answer["valid"] = true;
  if (largest)
    answer["largest_run"] = {{"elements", largest->elements},
                             {"columns", largest->columns},
                             {"rows", largest->rows},
                             {"bytes", largest->bytes},
                             {"steps_up_to", std::ceil(largest->steps)}};
  if (common.json) fmt::print("{}\n", answer.dump());
  if (common.talks()) print(words + "\n");
  return Exit::done;
}

page::TextStyle terminal_style(page::Detail detail) {
  return {.columns = terminal_columns(STDOUT_FILENO), .colour = has_colour(stdout), .detail = detail};
}

}  // namespace percal::tools
