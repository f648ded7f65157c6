// The options of percal campaign, percal atlas and percal work, and those that have runs made by a cluster.
#include "options.hpp"

namespace percal::tools {

void add_cluster(CLI::App& command, Common::Cluster& cluster) {
  auto* slurm =
      command.add_flag("--slurm", cluster.wanted, "have the runs made by Slurm, from a folder that all nodes see");
  command.add_option("--partition", cluster.partition, "of the cluster (default: its own)")->needs(slurm);
  command
      .add_option("--time", cluster.time, "limit of a task, as Slurm has it: 30, 2:00:00 (default: the partition's)")
      ->needs(slurm);
  command.add_option("--batch", cluster.batch, "runs a task (default: about a minute's work)")
      ->check(CLI::Range(1, 1000000))
      ->needs(slurm);
  command.add_option("--at-once", cluster.at_once, "tasks that may run at once (default: as many as the cluster lets)")
      ->check(CLI::Range(1, 1000000))
      ->needs(slurm);
  command
      .add_option("--slurm-folder", cluster.folder,
                  "for lists and results of tasks (default: NAME.slurm in the working folder)")
      ->needs(slurm);
}

void add_campaign(CLI::App& app, CampaignArguments& campaign, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "campaign", "sweeps over any key of a scene or any dimensionless group -> a table of outcomes, a figure");
  command->add_option("plan", campaign.plan, "TOML plan")->required();
  command->add_flag("--estimate", campaign.estimate,
                    "say how many runs it takes, how long and how much memory, from some short runs; do no others");
  command->footer(
      "Killed and started again it goes on where it was; started twice, both processes share the runs.\n"
      "Examples: percal campaign data/guha2009/gold_sweep.toml --estimate\n"
      "          percal campaign data/guha2009/gold_sweep.toml");
  add_common(*command, common, true);
  add_cluster(*command, common.cluster);
  command->add_flag("--dry-run", common.cluster.dry_run, "print the script of the array, hand nothing over")
      ->needs("--slurm");
  commands.push_back({command, [&] { return run_campaign(campaign, common); }, true});
}

void add_atlas(CLI::App& app, AtlasArguments& atlas, Common& common, std::vector<Command>& commands) {
  auto* command =
      app.add_subcommand("atlas", "runs of spheres over the box that users live in, which calibrations begin with");
  command->require_subcommand(1);
  const auto runs = [&](CLI::App* one) {
    add_runs(*one, common);
    one->add_flag("--quiet", common.quiet, "print nothing but errors");
  };
  auto* check = command->add_subcommand("check", "fresh runs between its runs: whether it holds, and how well");
  check->add_option("--points", atlas.points, "fresh runs (default: 20)")->check(CLI::Range(5, 10000));
  check->add_flag("--json", common.json, "print the result as JSON on standard output");
  runs(check);
  check->footer("Example: percal atlas check");
  commands.push_back({check, [&] { return run_atlas_check(atlas, common); }, true});
  auto* write =
      command->add_subcommand("write", "the runs of a plan as the file of an atlas; those that a store lacks are made");
  write->add_option("plan", atlas.plan, "TOML plan of percal campaign: spheres into one layer, one run a point")
      ->required();
  write->add_option("-o,--file", atlas.file, "atlas to write")->required();
  runs(write);
  write->footer("Example: percal atlas write data/atlas/spheres.toml -o spheres.csv");
  commands.push_back({write, [&] { return run_atlas_write(atlas, common); }, true});
}

void add_work(CLI::App& app, WorkArguments& work, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("work", "what a task of a cluster does: the runs of its list, a file each");
  command->add_option("list", work.list, "written by a command with --slurm")->required();
  command->footer("Example: percal work skin.slurm/todo/1764500000-1-0/7");
  commands.push_back({command, [&] { return run_work(work); }, true});
}

}  // namespace percal::tools
