#include "pages.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "colour.hpp"
#include "percal/base/error.hpp"
#include "percal/base/version.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/fit/page/page.hpp"
#include "percal/identify/page/page.hpp"
#include "percal/observe/page/page.hpp"
#include "percal/scaling/page/page.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/page/page.hpp"
#include "percal/text/file.hpp"
#include "percal/text/json.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

using page::Json;

struct PageOfCommand {
  const char* command;
  page::Page (*page)(const Json&);
};
constexpr std::array<PageOfCommand, 6> pages{{{"fit", fit_page},
                                              {"scale", scale_page},
                                              {"impact", impact_page},
                                              {"study", study_page},
                                              {"identify", identify_page},
                                              {"calibrate", calibrate_page}}};

std::string shown(const Json& value) {
  if (value.is_null()) return "nothing";
  return value.is_string() ? in_quotes(value.get<std::string>()) : value.dump().substr(0, 60);
}

}  // namespace

page::Page page_of_result(const Json& result, const std::string& file) {
  if (!result.is_object())
    throw BadInput({file, 0, ""}, "JSON that is no object", "the result.json of a command of percal");
  const Json &command = page::maybe(result, "command"), &schema = page::maybe(result, "schema");
  if (schema != result_schema)
    throw BadInput({file, 0, "schema"}, shown(schema),
                   std::to_string(result_schema) +
                       ", as results of this percal have it: run the command again (finished runs are in the store)");
  std::vector<std::string> commands;
  for (const PageOfCommand& one : pages) {
    commands.emplace_back(one.command);
    if (command != one.command) continue;
    try {
      page::Page page = one.page(result);
      if (page.title.empty()) page.title = std::string("Result of percal ") + one.command;
      return page;
    } catch (const page::MissingKey& missing) {
      throw BadInput({file, 0, missing.key}, "nothing",
                     "a value, as every result of percal " + commands.back() + " has it");
    } catch (const Json::exception& error) {
      throw BadInput({file, 0, ""}, error.what(),
                     "values of the kinds that a result of percal " + commands.back() + " has");
    }
  }
  throw BadInput({file, 0, "command"}, shown(command), "a result of " + listed(commands));
}

page::ReadResult read_result(const std::string& path) {
  std::error_code none;
  const std::string file = std::filesystem::is_directory(path, none) ? path + "/result.json" : path;
  refuse_document(file, "the result.json of a command of percal");
  page::ReadResult result{file, parse_json(read_file(file), file, "the result.json of a command of percal"), {}};
  result.page = page_of_result(result.json, file);
  return result;
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
  return {.columns = terminal_columns(), .colour = has_colour(stdout), .detail = detail};
}

}  // namespace percal::tools
