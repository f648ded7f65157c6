// percal identify: the whole chain, each step as a table, the result and the cards in one folder.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "colour.hpp"
#include "commands.hpp"
#include "pages.hpp"
#include "percal/base/progress.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/card/solver.hpp"
#include "percal/identify/identification.hpp"
#include "percal/identify/result_json.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}g}", *value, digits) : "-";
}

void print(const ComparisonTable& table, const std::string& reference_name) {
  std::vector<std::vector<std::string>> rows{
      {"", "unit", table.beside.empty() ? reference_name : table.beside, "percal", "difference", "error", ""}};
  for (const ComparedNumber& row : table.rows) {
    const auto difference = row.difference();
    rows.push_back({row.what, row.unit.empty() ? "-" : row.unit, number(row.reference, row.digits),
                    number(row.ours, row.digits), difference ? fmt::format("{:+.2f} %", 100 * *difference) : "-",
                    row.error ? fmt::format("{:.2g}", *row.error) : "-", row.remark});
  }
  fmt::print("{}\n{}", table.name, aligned(rows));
  if (!table.note.empty()) fmt::print("  {}\n", table.note);
  fmt::print("\n");
  std::fflush(stdout);
}

void write_cards(const CardMaterial& card, const std::string& folder) {
  const UnitSystem lsdyna = unit_system("mm-ms-kg-GPa"), abaqus = unit_system("mm-t-s-MPa");
  write_file(folder + "/" + card.name + "_lsdyna.k", solver_named("lsdyna").card(card, lsdyna));
  write_file(folder + "/" + card.name + "_abaqus.inp", solver_named("abaqus").card(card, abaqus));
}

}  // namespace

Exit run_identify(const IdentifyArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  const IdentifyJob job = read_identify_job(arguments.job);
  if (common.check) {
    if (common.json)
      fmt::print("{}\n", nlohmann::json{{"command", "identify"}, {"job", arguments.job}, {"valid", true}}.dump());
    else if (!common.quiet)
      fmt::print("{}: a job that can be run\n", arguments.job);
    return Exit::done;
  }
  const std::string folder = out_folder(arguments.job, common);
  ensure_writable_folder(folder);
  Store store(common.store.empty() ? default_store_path() : common.store);
  Campaign campaign(&store, common.threads);
  const bool talk = !common.quiet && !common.json;
  if (talk) fmt::print("{}\n\n", job.title);
  const Identification found = identify(job, campaign, [&](const ComparisonTable& step) {
    if (talk) print(step, job.reference_name);
  });
  const CampaignCost cost = campaign.cost();
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto json =
      identification_to_json(job, found, {cost.runs, cost.reused, wall, cost.cpu_seconds, instruction_level()});
  const std::string result =
      json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";  // tables need not be UTF-8
  write_file(folder + "/result.json", result);
  if (found.card) write_cards(*found.card, folder);
  if (common.json) fmt::print("{}", result);
  if (talk) {
    for (const auto& finding : found.findings) fmt::print("{} {}\n", yellow("note:"), finding);
    fmt::print("\n{} runs, {} from the store, {:.1f} s of processor time, {:.1f} s in all on {} threads. Results: {}\n",
               cost.runs, cost.reused, cost.cpu_seconds, wall, campaign.threads(), folder);
  }
  return found.complete() ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
