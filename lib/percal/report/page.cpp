#include "percal/report/page.hpp"

#include <algorithm>
#include <array>

#include "percal/base/error.hpp"
#include "percal/base/version.hpp"
#include "percal/report/study_page_parts.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

using report_parts::Json;

struct PageOfCommand {
  const char* command;
  Page (*page)(const Json&);
};
constexpr std::array<PageOfCommand, 6> pages{{{"fit", fit_page},
                                              {"scale", scale_page},
                                              {"impact", impact_page},
                                              {"study", study_page},
                                              {"identify", identify_page},
                                              {"calibrate", calibrate_page}}};

std::vector<std::string> commands() {
  std::vector<std::string> names;
  for (const PageOfCommand& one : pages) names.emplace_back(one.command);
  return names;
}

std::string shown(const Json& value) {
  if (value.is_null()) return "nothing";
  return value.is_string() ? in_quotes(value.get<std::string>()) : value.dump().substr(0, 60);
}

}  // namespace

Page page_of_result(const Json& result, const std::string& file) {
  if (!result.is_object())
    throw BadInput({file, 0, ""}, "JSON that is no object", "the result.json of a command of percal");
  const Json &command = report_parts::at(result, "command"), &schema = report_parts::at(result, "schema");
  if (schema != result_schema)
    throw BadInput({file, 0, "schema"}, shown(schema),
                   std::to_string(result_schema) + ", in the result.json of a command of percal");
  const Json& study = report_parts::at(result, "study");
  const auto& studies = report_parts::studies;
  if (command == "study" && std::find(studies.begin(), studies.end(), study) == studies.end())
    throw BadInput({file, 0, "study"}, shown(study), listed(studies));
  for (const PageOfCommand& one : pages) {
    if (command != one.command) continue;
    Page page = one.page(result);
    if (page.title.empty()) page.title = std::string("Result of percal ") + one.command;
    return page;
  }
  throw BadInput({file, 0, "command"}, shown(command), "a result of " + listed(commands()));
}

}  // namespace percal
