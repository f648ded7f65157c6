// percal invert: one depth to one modulus or erosion strain, and the ridge that it leaves.
#include <chrono>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "pages.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/one_depth/page/page.hpp"

namespace percal::tools {

Exit run_invert(const InvertArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  const InvertRequest request = understood(arguments.words);
  if (common.check)
    return say_valid("a shot that can be inverted", {{"command", "invert"}}, common, first_run(request));
  const std::string folder = common.out.empty() ? "" : out_folder("", common);
  Store store(store_file(common));
  Campaign campaign(&store, common.threads);
  OneDepth found = find_at_depth(request, campaign);
  found.cost = cost_since(start, campaign);
  const page::Json json = one_depth_to_json(found);
  deliver(json, folder, common);
  write_page_figures(invert_page(json), folder, common);
  return found.own().found() ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
