// percal campaign PLAN: sweeps over a scene; points.csv, result.json and the figures of its page in one folder.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "cluster.hpp"
#include "commands.hpp"
#include "pages.hpp"
#include "percal/base/progress.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/sweep/page/page.hpp"
#include "percal/sweep/sweep_runs.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

RunSize largest_of(const std::vector<SweepPoint>& points) {
  RunSize largest;
  for (const SweepPoint& point : points)
    if (const RunSize size = size_of(point.reduction.problem); size.elements > largest.elements) largest = size;
  return largest;
}

long runs_of(const std::vector<SweepPoint>& points) {
  long runs = 0;
  for (const SweepPoint& point : points) runs += point.scene.replicates;
  return runs;
}

Exit say_estimate(const std::string& plan, const std::vector<SweepPoint>& points, const Store& store,
                  const Common& common) {
  const auto to_run = problems_to_run(problems_of(points), &store);
  const CostEstimate estimate = estimate_cost(to_run, runs_of(points), Campaign(nullptr, common.threads).threads());
  if (common.json)
    fmt::print(
        "{}\n",
        page::Json{
            {"command", "campaign"}, {"job", plan}, {"points", points.size()}, {"estimate", estimate_to_json(estimate)}}
            .dump());
  if (common.talks()) print(fmt::format("{}: {} points, {}\n", plan, points.size(), in_words(estimate)));
  return Exit::done;
}

// Of the array that the points left to run are.
Exit say_script(const std::string& plan, const std::vector<SweepPoint>& points, const Common& common) {
  const Store store(store_file(common));
  std::vector<Problem> left;
  for (const auto& replicates : problems_to_run(problems_of(points), &store))
    left.insert(left.end(), replicates.begin(), replicates.end());
  return print_script(common, plan, left);
}

}  // namespace

Exit run_campaign(const CampaignArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  const Plan plan = read_plan(arguments.plan);
  const auto points = points_to_run(plan);  // throws where one cannot be run
  if (common.check)
    return say_valid(
        fmt::format("{}: a plan that can be run: {} points, {} runs, the largest of {}", arguments.plan, points.size(),
                    runs_of(points), in_words(largest_of(points))),
        {{"command", "campaign"}, {"job", arguments.plan}, {"points", points.size()}, {"runs", runs_of(points)}},
        common, largest_of(points));
  if (arguments.estimate) return say_estimate(arguments.plan, points, Store(store_file(common)), common);
  if (common.cluster.dry_run) return say_script(arguments.plan, points, common);
  const std::string folder = out_folder(arguments.plan, common);
  if (!folder.empty()) ensure_writable_file(folder + "/points.csv");
  Runs here_or_there(common, arguments.plan);
  Store& store = here_or_there.store;
  Campaign& campaign = here_or_there.campaign;
  SweepFindings found{.plan = plan, .points = points};
  {
    Progress progress("campaign", runs_of(points));
    found.runs = run_points(points, campaign, &store, progress);
  }
  found.cost = cost_since(start, campaign);
  const page::Json json = sweep_to_json(found);
  if (!folder.empty()) write_file(folder + "/points.csv", sweep_to_csv(json));
  deliver(json, folder, common);
  write_page_figures(sweep_page(json), folder, common);
  return all_points_ended_well(found) ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
