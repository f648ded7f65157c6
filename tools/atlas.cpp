// percal atlas: the runs that calibrations begin with, written from a campaign and held against fresh ones.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "colour.hpp"
#include "commands.hpp"
#include "pages.hpp"
#include "percal/atlas/check.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/page/numbers.hpp"
#include "percal/page/text.hpp"
#include "percal/sweep/sweep_runs.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

struct Region {
  const char* name;
  double from, to;  // radii
};
constexpr Region regions[] = {
    {"to 3 radii", 0, 3}, {"3 to 10 radii", 3, 10}, {"10 radii and more", 10, INFINITY}, {"all", 0, INFINITY}};

AtlasAgreement agreement_in(const Region& region, const std::vector<CheckedPoint>& points) {
  std::vector<CheckedPoint> inside;
  for (const CheckedPoint& point : points)
    if (const double reach = std::exp(point.run.log_depth); reach >= region.from && reach < region.to)
      inside.push_back(point);
  return agreement(inside);
}

page::Table table_of(const std::vector<CheckedPoint>& points) {
  page::Table table{
      .caption = "Fresh runs against the atlas, by their reach",
      .rows = {{"", "runs", "half within", "r.m.s.", "in their 95 %"}},
      .notes = {"A fresh run is one run: its own scatter over the phase of the mesh is in the difference."}};
  for (const Region& region : regions) {
    const AtlasAgreement found = agreement_in(region, points);
    if (found.points == 0) continue;
    table.rows.push_back({region.name, std::to_string(found.points), page::rough_percent(found.median),
                          page::rough_percent(found.root_mean_square),
                          page::rough_percent(static_cast<double>(found.within95) / found.points)});
  }
  return table;
}

page::Json json_of(const std::vector<CheckedPoint>& points) {
  page::Json all = page::Json::array();
  for (const Region& region : regions) {
    const AtlasAgreement found = agreement_in(region, points);
    all.push_back({{"region", region.name},
                   {"runs", found.points},
                   {"median_error", found.median},
                   {"rms_error", found.root_mean_square},
                   {"standardised", found.standardised},
                   {"within95", found.within95}});
  }
  return all;
}

// Throws BadInput where the problems have several, or one is of anything but a sphere in one layer.
std::string one_setting(const std::vector<Problem>& problems, const std::string& plan) {
  const auto refuse = [&](const std::string& found) {
    throw BadInput({.file = plan, .line = 0, .key = ""}, found,
                   "rigid spheres in one layer that erodes by a strain, of one setting of the solver");
  };
  std::string setting;
  for (const Problem& problem : problems) {
    if (!is_for_an_emulator(problem) || !problem.below.empty()) refuse("a point that an atlas does not take");
    const std::string one = setting_of(problem);
    if (!setting.empty() && one != setting) refuse("points of several settings");
    setting = one;
  }
  return setting;
}

}  // namespace

Exit run_atlas_check(const AtlasArguments& arguments, const Common& common) {
  Store store(store_file(common));
  Campaign campaign(&store, common.threads);
  bool all_hold = true;
  page::Json results = page::Json::array();
  for (const Atlas& atlas : own_atlases()) {
    Progress progress("fresh runs", arguments.points);
    const auto points = check_atlas(atlas, arguments.points, campaign, progress);
    const bool good = holds(agreement(points));
    all_hold &= good;
    results.push_back(
        {{"atlas", atlas.name}, {"runs", atlas.runs.size()}, {"holds", good}, {"regions", json_of(points)}});
    if (!common.talks()) continue;
    print(fmt::format("{}: {} runs\n{}", atlas.name, atlas.runs.size(),
                      page::as_text(table_of(points), terminal_style(page::Detail::answer))));
    print(good ? "It holds: its errors are what it says.\n"
               : "It does not hold: more fresh runs lie outside its 95 % than chance would leave there.\n");
  }
  if (common.json) fmt::print("{}\n", page::Json{{"command", "atlas check"}, {"atlases", results}}.dump());
  return all_hold ? Exit::done : Exit::check_failed;
}

Exit run_atlas_write(const AtlasArguments& arguments, const Common& common) {
  const Plan plan = read_plan(arguments.plan);
  const auto points = points_to_run(plan);
  ensure_writable_file(arguments.file);
  std::vector<Problem> problems;
  for (const auto& replicates : problems_of(points))
    problems.insert(problems.end(), replicates.begin(), replicates.end());
  const std::string setting = one_setting(problems, arguments.plan);
  Store store(store_file(common));
  Campaign campaign(&store, common.threads);
  Progress progress("runs of the atlas", static_cast<long>(problems.size()));
  const auto evaluations = campaign.evaluate(problems, &progress);
  std::vector<TrainingRun> runs;
  for (std::size_t k = 0; k < problems.size(); ++k)
    if (const auto reach = reach_of(problems[k], evaluations[k].result))
      runs.push_back(training_run(problems[k], *reach));
  write_file(arguments.file, atlas_text(setting, runs));
  if (common.talks())
    print(fmt::format("{}: {} of {} runs have a reach and are in it\n", arguments.file, runs.size(), problems.size()));
  return Exit::done;
}

}  // namespace percal::tools
