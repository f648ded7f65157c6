// percal study SCENE --omissions: the audit, its table and conclusions; CSV and JSON in the folder of results.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "pages.hpp"
#include "percal/base/progress.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/omissions_json.hpp"
#include "percal/text/file.hpp"
#include "percal/units/quantity.hpp"
#include "studies.hpp"

namespace percal::tools {
namespace {

using Json = nlohmann::json;

std::vector<std::string> row_of(const std::string& name, const std::string& verdict, const Rung& rung, double cost) {
  const auto& p = rung.penetration;
  const auto length = [](const std::optional<double>& x) {
    return x ? format_quantity(*x, dimension::length) : std::string("-");
  };
  return {name,
          p.depth ? length(p.depth) : word(p.outcome),
          length(p.spread),
          fmt::format("{:.2f}", cost),
          fmt::format("{:.0f}", rung.steps),
          fmt::format("{:.3g}", rung.cpu_seconds),
          verdict};
}

void print(const Scene& scene, const Omissions& audit, const CampaignCost& cost, double wall_seconds) {
  fmt::print("{} into {}: what was left out, and why\n", scene.particle.name, scene.target.name);
  for (const auto& [left_out, audited_by, why_not] : audit.left_out)
    fmt::print("  {}: {}{}\n", left_out.what, left_out.why,
               audited_by.empty() ? " (not audited: " + why_not + ")" : "");
  fmt::print("Each switched back on, or changed; {} replicates\n", audit.baseline.replicates);
  std::vector<std::vector<std::string>> rows{
      {"what", "depth", "spread", "time ratio", "steps", "CPU s a run", "verdict"}};
  rows.push_back(row_of("the scene as it is", "", audit.baseline, 1));
  for (const auto& one : audit.omissions)
    rows.push_back(row_of(one.variant.name + (one.variant.is_illustration ? " (illustration)" : ""), one.verdict,
                          one.rung, one.change.cost_ratio));
  fmt::print("{}", aligned(rows));
  for (const auto& one : audit.skipped) fmt::print("  not run: {}: {}\n", one.name, one.why);
  for (const auto& line : audit.conclusions) fmt::print("  {}\n", line);
  fmt::print(
      "  a run scatters by {:.2g} % of the depth; {} runs, {} from the store, {:.1f} s of processor time, {:.1f} s "
      "in all, {}\n",
      100 * audit.spread_of_a_run, cost.runs, cost.reused, cost.cpu_seconds, wall_seconds, instruction_level());
}

std::string page_of(const Scene& scene, const Omissions& audit) {
  const std::string name = std::filesystem::path(scene.source).filename().string();
  return study_page(
      fmt::format("What the omissions of {} are worth", name),
      fmt::format("percal study {} --omissions --replicates {}", name, audit.baseline.replicates),
      fmt::format(
          "{} into {}, {} elements per radius, {} replicates each; depths are means, changes are against the "
          "scene as it is, with the standard error of the difference of two means. A run scatters by {:.2g} % of "
          "the depth. A change below two standard errors is called none, one below three possible: among so many "
          "comparisons chance makes one or two of those.",
          scene.particle.name, scene.target.name, audit.baseline.elements_per_radius, audit.baseline.replicates,
          100 * audit.spread_of_a_run),
      omissions_markdown(audit));
}

}  // namespace

Exit study_omissions(const StudyArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = read_scene(arguments.scene);
  const int replicates = arguments.replicates.value_or(audit_replicates);
  if (common.check) {
    const auto plan = plan_omissions(scene, reduce(scene), std::nullopt);
    if (common.json)
      fmt::print("{}\n", Json{{"command", "study"}, {"scene", arguments.scene}, {"valid", true}}.dump());
    else if (!common.quiet)
      fmt::print("{}: a scene that can be studied, {} runs\n", arguments.scene,
                 replicates * (1 + plan.variants.size()));
    return Exit::done;
  }
  const std::string folder = out_folder(arguments.scene, common);
  ensure_writable_folder(folder);
  Store store(common.store.empty() ? default_store_path() : common.store);
  Campaign campaign(&store, common.threads);
  const Omissions audit = [&] {
    Progress progress("study", 0);
    return audit_omissions(scene, replicates, [&](const std::vector<Problem>& problems, int runs) {
      progress.expect(static_cast<long>(problems.size()) * runs);
      return campaign.replicate(problems, runs, &progress);
    });
  }();
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Json json = omissions_to_json(audit);
  json.update(study_header("omissions", campaign.cost(), wall));
  json.update({{"input", {{"scene", scene.source}, {"toml", scene_to_toml(scene, "")}}}, {"replicates", replicates}});
  const std::string result = json_text(json);
  write_file(folder + "/result.json", result);
  write_file(folder + "/omissions.csv", omissions_csv(audit));
  if (!arguments.markdown.empty()) write_file(arguments.markdown, page_of(scene, audit));
  if (common.json) {
    fmt::print("{}", result);
  } else if (!common.quiet) {
    print(scene, audit, campaign.cost(), wall);
    fmt::print("  results: {}\n", folder);
  }
  return audit.baseline.penetration.depth ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
