#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "percal/base/version.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "studies.hpp"

namespace percal::tools {
namespace {

using Json = nlohmann::json;

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

}  // namespace

Json study_header(const std::string& study, const CampaignCost& cost, double wall_seconds) {
  return {{"schema", result_schema},   {"percal", version()},   {"command", "study"},        {"study", study},
          {"runs", cost.runs},         {"reused", cost.reused}, {"cpu_s", cost.cpu_seconds}, {"wall_s", wall_seconds},
          {"isa", instruction_level()}};
}

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string study_page(const std::string& title, const std::string& command, const std::string& about,
                       const std::string& body) {
  return fmt::format(
      "# {}\n\nWritten by `{}` (percal {}, {}, {}). Times are processor seconds of one thread on a machine that others "
      "use too: compare them with each other.\n{}\n\n{}",
      title, command, version(), instruction_level(), processor(), about, body);
}

}  // namespace percal::tools
