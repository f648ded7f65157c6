#include "page_of_result.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/base/version.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/fit/page/page.hpp"
#include "percal/identify/page/page.hpp"
#include "percal/observe/page/page.hpp"
#include "percal/one_depth/page/page.hpp"
#include "percal/page/result.hpp"
#include "percal/powder/page/page.hpp"
#include "percal/predict/page/page.hpp"
#include "percal/scaling/page/page.hpp"
#include "percal/study/page/page.hpp"
#include "percal/sweep/page/page.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

using page::Json;

struct PageOfCommand {
  const char* command;
  page::Page (*page)(const Json&);
};
constexpr std::array<PageOfCommand, 11> pages{{{"fit", fit_page},
                                               {"scale", scale_page},
                                               {"impact", impact_page},
                                               {"study", study_page},
                                               {"campaign", sweep_page},
                                               {"identify", identify_page},
                                               {"calibrate", calibrate_page},
                                               {"predict", predict_page},
                                               {"dose", dose_page},
                                               {"design", design_page},
                                               {"invert", invert_page}}};

std::string shown(const Json& value) {
  if (value.is_null()) return "nothing";
  return value.is_string() ? in_quotes(value.get<std::string>()) : value.dump().substr(0, 60);
}

}  // namespace

std::string result_file(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_directory(path, none) ? path + "/result.json" : path;
}

void check_result(const Json& result, const std::string& file) {
  if (!result.is_object())
    throw BadInput({file, 0, ""}, "JSON that is no object", "the result.json of a command of percal");
  if (const Json& schema = page::maybe(result, "schema"); schema != result_schema)
    throw BadInput({file, 0, "schema"}, shown(schema),
                   std::to_string(result_schema) +
                       ", as results of this percal have it: run the command again (finished runs are in the store)");
}

page::Page page_of_result(const Json& result, const std::string& file) {
  check_result(result, file);
  const Json& command = page::maybe(result, "command");
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

}  // namespace percal::tools
