// percal study --extremes: the matrix, its table; CSV and JSON in a folder, and a page, where they are asked for.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "pages.hpp"
#include "percal/base/progress.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/study/extremes_json.hpp"
#include "percal/text/file.hpp"
#include "studies.hpp"

namespace percal::tools {
namespace {

using Json = nlohmann::json;

std::string number(double x, int digits) { return std::isfinite(x) ? fmt::format("{:.{}g}", x, digits) : "-"; }

void print(const std::vector<CellResult>& results, const CampaignCost& cost, double wall_seconds) {
  std::vector<std::vector<std::string>> rows{
      {"group", "cell", "tip/radius", "energy", "smallest J", "smallest step", "Mach", "steps", "CPU s", "outcome"}};
  for (const auto& result : results) {
    std::vector<std::string> row{result.cell.group, result.cell.what};
    if (result.run) {
      const auto& evaluation = result.run->evaluation;
      const auto& r = evaluation.result;
      for (const auto& [value, digits] : {std::pair{r.depth, 4},
                                          {r.energy.closure(), 2},
                                          {r.smallest_jacobian, 2},
                                          {r.smallest_step, 2},
                                          {result.run->reduction.mach, 2}})
        row.push_back(number(value, digits));
      row.push_back(fmt::format("{}", r.steps));
      row.push_back(fmt::format("{:.2f}", evaluation.cpu_seconds));
    } else {
      row.insert(row.end(), 7, "-");
    }
    row.push_back(result.outcome() + (result.reason.empty() ? "" : ": " + result.reason));
    rows.push_back(row);
  }
  fmt::print("{}", aligned(rows));
  for (const auto& result : results)
    for (const auto& trouble : result.troubles)
      fmt::print("  trouble: {}, {}: {}\n", result.cell.group, result.cell.what, trouble);
  fmt::print("  {} cells, {} runs, {} from the store, {:.1f} s of processor time, {:.1f} s in all, {}\n",
             results.size(), cost.runs, cost.reused, cost.cpu_seconds, wall_seconds, instruction_level());
}

constexpr const char* about =
    "Every cell is one run around a gold sphere into skin (radius 1 um, 651 m/s, true mu 63.75 MPa, alpha 8.5, K/mu "
    "50, "
    "erosion strain 0.7) on 7 elements per radius in a layer of 40 radii, for 200 radii of time at most, with the one "
    "thing changed that its name says. The energy closure is the sum of the ledger less 1; the smallest step is over "
    "the "
    "first one. A cell is refused where the scene reader does so.";

}  // namespace

Exit study_extremes(const StudyArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  const auto cells = extreme_cells();
  if (common.check) {
    if (common.json)
      fmt::print("{}\n", Json{{"command", "study"}, {"cells", cells.size()}, {"valid", true}}.dump());
    else if (!common.quiet)
      fmt::print("{} cells\n", cells.size());
    return Exit::done;
  }
  if (!common.out.empty()) ensure_writable_folder(common.out);
  Store store(common.store.empty() ? default_store_path() : common.store);
  Campaign campaign(&store, common.threads);
  const auto results = [&] {
    Progress progress("study", static_cast<long>(cells.size()));
    return run_extremes(cells, instruction_level(),
                        [&](const std::vector<Problem>& problems) { return campaign.evaluate(problems, &progress); });
  }();
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Json json = extremes_to_json(results);
  json.update(study_header("extremes", campaign.cost(), wall));
  const std::string result = json_text(json);
  if (!common.out.empty()) {
    write_file(common.out + "/result.json", result);
    write_file(common.out + "/extremes.csv", extremes_csv(results));
  }
  if (!arguments.markdown.empty())
    write_file(arguments.markdown,
               study_page("Stiff and extreme impacts", "percal study --extremes", about, extremes_markdown(results)));
  if (common.json)
    fmt::print("{}", result);
  else if (!common.quiet)
    print(results, campaign.cost(), wall);
  return has_troubles(results) ? Exit::check_failed : Exit::done;
}

}  // namespace percal::tools
