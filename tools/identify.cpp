// percal identify: the whole chain, each step as a table when it is done; the result and the cards in one folder.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cluster.hpp"
#include "commands.hpp"
#include "pages.hpp"
#include "percal/base/progress.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/card/solver.hpp"
#include "percal/identify/page/identification_json.hpp"
#include "percal/identify/run_sizes.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

void print_step(const page::Table& step) {
  fmt::print("{}\n", page::as_text(step, terminal_style(page::Detail::answer)));
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
  const RunSize largest = largest_run(job);  // throws where it cannot be run
  if (common.check)
    return say_valid(fmt::format("{}: a job that can be run; the largest run has {}", arguments.job, in_words(largest)),
                     {{"command", "identify"}, {"job", arguments.job}}, common, largest);
  const std::string folder = out_folder(arguments.job, common);
  Runs runs(common, arguments.job);
  Campaign& campaign = runs.campaign;
  const bool as_they_come = common.talks() && !common.details;  // the details have them all
  const Identification found = identify(job, campaign, [&](const ComparedNumbers& step) {
    if (as_they_come) print_step(comparison_table(comparison_to_json(job, step)));
  });
  const page::Json result = identification_to_json(job, found, cost_since(start, campaign));
  deliver(result, folder, common);
  if (found.card && !folder.empty()) write_cards(*found.card, folder);
  if (found.complete()) {
    write_scene(identified_scene(job, found), "The calibration shot of " + job.title + ", on the mesh of the ridge.",
                "calibration", folder);
    write_scene(found.model_check->scene, "The model system of " + job.title + ", as it was checked.", "model", folder);
  }
  return found.complete() ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
