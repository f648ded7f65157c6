// Options of the commands that run impacts: impact, study, identify, calibrate.
#include "options.hpp"

namespace percal::tools {

void add_common(CLI::App& command, Common& common, bool runs_impacts) {
  command.add_option(
      "--out", common.out,
      "folder for results (default: NAME.out in the working folder, NAME that of the input; none: no files)");
  if (runs_impacts) {
    command.add_option("--store", common.store, "evaluation store (default: percal.store in the user's cache folder)");
    command.add_option("--threads", common.threads, "evaluations side by side (default: one for each core)")
        ->check(CLI::Range(0, 4096));
  }
  command.add_flag("--json", common.json, "print the result as JSON on standard output");
  command.add_flag("--details", common.details, "print all of the result, not the answer alone");
  command.add_flag("--check", common.check, "read and validate, run nothing");
  command.add_flag("--quiet", common.quiet, "print nothing but errors");
}

void add_impact(CLI::App& app, ImpactArguments& impact, Common& common, std::vector<Command>& commands) {
  auto* command =
      app.add_subcommand("impact", "a sphere into a layer -> depth with its scatter, energy ledger, what was left out");
  command->add_option("scene", impact.scene, "TOML scene")->required();
  command->add_option("--elements-per-radius", impact.elements_per_radius, "mesh (default: the scene's)")
      ->check(CLI::Range(1, 1000));
  command->add_option("--replicates", impact.replicates, "runs at slightly different speeds (default: the scene's, 3)")
      ->check(CLI::Range(1, 1000));
  command->add_option("--arithmetic", impact.arithmetic, "single or double")
      ->check(CLI::IsMember({"single", "double"}));
  command->add_option("--history", impact.history, "write the penetration history to this CSV file");
  command->add_option(
      "--fields", impact.fields,
      "write fields of the first run for ParaView, as every=0.5us, every=10um (of depth), every=2% (of the "
      "target's depth) or every=200 (steps), to fields/ in the folder for results");
  command->add_option("--picture", impact.picture, "draw the first run's last state to this PNG, SVG or PDF file");
  command
      ->add_option(
          "--accuracy", impact.accuracy,
          "error of the depth, as 2%: mesh and replicates as the scene's study advises, which is run first where "
          "the store keeps none")
      ->excludes("--elements-per-radius")
      ->excludes("--replicates")
      ->excludes("--arithmetic");
  command->footer("Example: percal impact data/guha2009/gold.toml --elements-per-radius 10 --json");
  add_common(*command, common, true);
  commands.push_back({command, [&] { return run_impact(impact, common); }, true});
}

void add_identify(CLI::App& app, IdentifyArguments& identify, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "identify", "the whole chain: gelatin shots -> ridge -> similarity -> skin -> predictions -> cards");
  command->add_option("job", identify.job, "TOML job")->required();
  command->footer("Example: percal identify data/guha2009/skin.toml");
  add_common(*command, common, true);
  commands.push_back({command, [&] { return run_identify(identify, common); }, true});
}

void add_calibrate(CLI::App& app, CalibrateArguments& calibrate, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "calibrate",
      "curves and depths of shots together -> free parameters with intervals, ridges, predictions, advice");
  command->add_option("job", calibrate.job, "TOML job")->required();
  command->add_option("--budget", calibrate.budget, "wall time to keep to, as 60s or 5min: the best answer within it");
  command->footer("Example: percal calibrate data/synthetic/joint.toml --budget 60s");
  add_common(*command, common, true);
  commands.push_back({command, [&] { return run_calibrate(calibrate, common); }, true});
}

void add_study(CLI::App& app, StudyArguments& study, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "study", "what a scene's settings are worth: error against time, omissions; and a matrix of extreme impacts");
  auto* scene = command->add_option("scene", study.scene, "TOML scene");
  auto* which = command->add_option_group("what is studied");
  auto* errors = which->add_flag(
      "--error-vs-time", study.error_vs_time,
      "depth on a ladder of meshes, the error of each, its cost, and the cheapest setting for 5, 2 and 1 %");
  which->add_flag("--omissions", study.omissions,
                  "what the scene leaves out, each switched back on: its worth in depth and in time");
  auto* extremes = which->add_flag("--extremes", study.extremes,
                                   "a fixed matrix of stiff and extreme impacts and how each ends; takes no scene");
  which->require_option(1);
  auto* meshes =
      command->add_option("--meshes", study.meshes, "elements per radius, four or more (default: 5,7,10,14,20,28)")
          ->delimiter(',')
          ->check(CLI::Range(1, 1000))
          ->needs(errors);
  auto* replicates = command->add_option("--replicates", study.replicates, "runs of each setting (default: 5)")
                         ->check(CLI::Range(3, 1000));
  command->add_option("--markdown", study.markdown, "write the whole page as Markdown to this file");
  extremes->excludes(scene)->excludes(meshes)->excludes(replicates);
  command->footer(
      "Examples: percal study data/guha2009/gold.toml --error-vs-time --meshes 5,7,10,14 --replicates 3\n"
      "          percal study data/guha2009/gold.toml --omissions\n"
      "          percal study --extremes --markdown extremes.md");
  add_common(*command, common, true);
  commands.push_back({command, [&] { return run_study(study, common); }, true});
}

}  // namespace percal::tools
