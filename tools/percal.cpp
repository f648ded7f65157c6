// The program: reads the command line, runs one command, turns the failures into exit codes. The commands are in files of their own.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "commands.hpp"
#include "percal/base/progress.hpp"
#include "percal/base/version.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {

std::string out_folder(const std::string& job, const Common& common) {
  if (!common.out.empty()) return common.out;
  std::filesystem::path path(job);
  return path.replace_extension(".out").string();
}

namespace {

void add_common(CLI::App& command, Common& common, bool runs_impacts) {
  command.add_option("--out", common.out, "folder for results (default: NAME.out beside the job)");
  if (runs_impacts) {
    command.add_option("--store", common.store, "evaluation store (default: percal.store in the user's cache folder)");
    command.add_option("--threads", common.threads, "evaluations side by side (default: one for each core)")
        ->check(CLI::Range(0, 4096));
  }
  command.add_flag("--json", common.json, "print the result as JSON on standard output");
  command.add_flag("--check", common.check, "read and validate, run nothing");
  command.add_flag("--quiet", common.quiet, "print nothing but errors");
}

CLI::App* add_fit(CLI::App& app, FitArguments& fit, Common& common) {
  auto* command =
      app.add_subcommand("fit", "stress-stretch CSV files -> moduli and exponents, every minimum, models compared");
  command->add_option("files", fit.files, "CSV files")->required();
  command->add_option("--mode", fit.mode,
                      "deformation where the file has no mode column: uniaxial, equibiaxial, planar, shear");
  command->add_option("--model", fit.model, "ogden (one term), ogden2, ogden3, neo-hooke or mooney-rivlin")
      ->check(CLI::IsMember({"ogden", "ogden2", "ogden3", "neo-hooke", "mooney-rivlin"}));
  command->add_flag("--compare", fit.compare,
                    "all models side by side: AICc, R^2 of each test, prediction of tests left out, stability");
  command
      ->add_option("--residual", fit.residual,
                   "relative (Guha 2009, Eq. 3-4), absolute, or error (over the points' standard errors)")
      ->check(CLI::IsMember({"relative", "absolute", "error"}));
  command->add_option("--weights", fit.weights,
                      "points: each counts the same; tests: each test does; NAME=NUMBER,...: tests by their shares");
  command->add_option("--loss", fit.loss, "squares, or a robust loss: huber, cauchy")
      ->check(CLI::IsMember({"squares", "huber", "cauchy"}));
  command->add_flag("--unconstrained", fit.unconstrained, "single moduli of a sum may be negative");
  command->add_option("--stable", fit.stable, "stretches LOW:HIGH over which stability is looked at");
  command->add_option("--x", fit.x, "column of stretch, strain or shear");
  command->add_option("--y", fit.y, "column of stress");
  command->add_option("--error", fit.error, "column of the stress's standard error");
  command->add_option("--where", fit.where, "keep the rows with COLUMN=VALUE (may be given several times)")
      ->allow_extra_args(false);
  command->add_flag("--intervals,!--no-intervals", fit.intervals,
                    "profile-likelihood intervals of every parameter (default: yes)");
  command->add_option("--level", fit.level, "confidence level of the intervals (default: 0.95)")
      ->check(CLI::Range(0.5, 0.9999));
  command->add_option("--bootstrap", fit.bootstrap, "replicates of each kind of bootstrap (default: none)")
      ->check(CLI::Range(0, 1000000));
  auto* rate_factor = command->add_flag("--rate-factor", fit.rate_factor,
                                        "one factor between two curves of one solid: files LOW_RATE HIGH_RATE");
  command->add_option("--rate-column", fit.rate_column, "with --rate-factor and one file: the column of the rate")
      ->needs(rate_factor);
  for (const char* other :
       {"--model", "--compare", "--weights", "--loss", "--unconstrained", "--stable", "--bootstrap"})
    rate_factor->excludes(other);
  command->footer(
      "Examples: percal fit data/public/treloar1944_rubber_primary.csv --where mode=UT --residual absolute\n"
      "          percal fit data/public/treloar1944_rubber_primary.csv --compare --weights tests\n"
      "          percal fit --rate-factor data/synthetic/gelatin_12wt_quasistatic.csv "
      "data/synthetic/gelatin_12wt_highrate.csv");
  add_common(*command, common, false);
  command->get_option("--out")->description("folder for result.json (default: nothing is written)");
  return command;
}

CLI::App* add_scale(CLI::App& app, ScaleArguments& scale, Common& common) {
  auto* command = app.add_subcommand("scale", "pi groups of two systems, what must hold for similarity, mapped values");
  command->add_option("job", scale.job, "TOML job")->required();
  command->add_option("--write-scene", scale.write_scene, "write the similar scene to this file");
  command->footer("Example: percal scale data/guha2009/similar.toml");
  add_common(*command, common, false);
  return command;
}

CLI::App* add_impact(CLI::App& app, ImpactArguments& impact, Common& common) {
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
  return command;
}

CLI::App* add_identify(CLI::App& app, IdentifyArguments& identify, Common& common) {
  auto* command = app.add_subcommand(
      "identify", "the whole chain: gelatin shots -> ridge -> similarity -> skin -> predictions -> cards");
  command->add_option("job", identify.job, "TOML job")->required();
  command->footer("Example: percal identify data/guha2009/skin.toml");
  add_common(*command, common, true);
  return command;
}

CLI::App* add_calibrate(CLI::App& app, CalibrateArguments& calibrate, Common& common) {
  auto* command = app.add_subcommand(
      "calibrate",
      "curves and depths of shots together -> free parameters with intervals, ridges, predictions, advice");
  command->add_option("job", calibrate.job, "TOML job")->required();
  command->add_option("--budget", calibrate.budget, "wall time to keep to, as 60s or 5min: the best answer within it");
  command->add_flag("--details", calibrate.details, "print every shot and every fresh run");
  command->footer("Example: percal calibrate data/synthetic/joint.toml --budget 60s");
  add_common(*command, common, true);
  return command;
}

CLI::App* add_study(CLI::App& app, StudyArguments& study, Common& common) {
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
  command->add_option("--markdown", study.markdown, "write tables and conclusions to this page; not of --error-vs-time")
      ->excludes(errors);
  extremes->excludes(scene)->excludes(meshes)->excludes(replicates);
  command->footer(
      "Examples: percal study data/guha2009/gold.toml --error-vs-time --meshes 5,7,10,14 --replicates 3\n"
      "          percal study data/guha2009/gold.toml --omissions\n"
      "          percal study --extremes --markdown extremes.md");
  add_common(*command, common, true);
  return command;
}

CLI::App* add_card(CLI::App& app, CardArguments& card, Common& common) {
  auto* command = app.add_subcommand("card", "material cards for finite-element programs");
  command->require_subcommand(1);
  auto* write = command->add_subcommand("write", "write the card of a result");
  write->add_option("result", card.result, "result.json of identify")->required();
  write->add_option("--solver", card.solver, "lsdyna, abaqus or calculix")
      ->required()
      ->check(CLI::IsMember({"lsdyna", "abaqus", "calculix"}));
  write->add_option("--units", card.units, "unit system of the card: si, mm-t-s-MPa, mm-ms-kg-GPa, um-us-ng-MPa");
  write->add_option("--file", card.file, "file to write (default: standard output)");
  write->footer("Example: percal card write skin.out/result.json --solver lsdyna --units mm-ms-kg-GPa");
  write->add_flag("--quiet", common.quiet, "print nothing but errors");
  return command;
}

// Ends at once, by calls that a signal handler may make. Evaluations are in the store as soon as they are finished, and files
// that are being written hold the signal back (text/file.cpp), so nothing half-written stays behind.
void end_interrupted(int) {
  constexpr char message[] =
      "\npercal: interrupted; what is finished is in the store, and the same command goes on from there\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof message - 1);
  _exit(static_cast<int>(Exit::interrupted));
}

void resume_after_interruption() {
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    action.sa_handler = end_interrupted;
    sigfillset(&action.sa_mask);
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);  // ignored by the caller (nohup): stays so
  }
}

// What is still in the buffer may be more than the disk holds.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw IoFailure(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

// Where a command is unknown CLI11 says only that one is missing.
void refuse_unknown_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  if (!chosen.empty()) return refuse_unknown_command(*chosen.front());
  const auto words = app.remaining();
  std::vector<std::string> commands;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(command->get_name());
  if (commands.empty() || words.empty() || words.front().starts_with("-")) return;
  const auto near = nearest_word(words.front(), commands);
  throw BadInput(Place{.file = "", .line = 0, .key = "command"},
                 in_quotes(words.front()) + (near ? " (did you mean " + *near + "?)" : ""), listed(commands));
}

Exit run(int argc, char** argv) {
  CLI::App app(
      "percal identifies the material parameters of soft solids from stress-stretch curves and penetration depths.",
      "percal");
  app.set_version_flag("--version", "percal " + version());
  app.require_subcommand(1);
  Common common;
  FitArguments fit;
  ScaleArguments scale;
  ImpactArguments impact;
  IdentifyArguments identify;
  CalibrateArguments calibrate;
  StudyArguments study;
  CardArguments card;
  auto* fit_command = add_fit(app, fit, common);
  auto* scale_command = add_scale(app, scale, common);
  auto* impact_command = add_impact(app, impact, common);
  auto* identify_command = add_identify(app, identify, common);
  auto* calibrate_command = add_calibrate(app, calibrate, common);
  auto* study_command = add_study(app, study, common);
  add_card(app, card, common);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) refuse_unknown_command(app);
    return app.exit(error) == 0 ? Exit::done : Exit::bad_input;
  }
  Progress::enable(!common.quiet);
  if (*fit_command) return run_fit(fit, common);
  if (*scale_command) return run_scale(scale, common);
  if (*impact_command || *identify_command || *calibrate_command || *study_command) resume_after_interruption();
  if (*impact_command) return run_impact(impact, common);
  if (*identify_command) return run_identify(identify, common);
  if (*calibrate_command) return run_calibrate(calibrate, common);
  if (*study_command) return run_study(study, common);
  return run_card_write(card, common);
}

}  // namespace
}  // namespace percal::tools

int main(int argc, char** argv) {
  using percal::Exit;
  std::signal(SIGXFSZ, SIG_IGN);  // a file over its size limit is a failure to write, told as one
  try {
    const Exit exit = percal::tools::run(argc, argv);
    percal::tools::flush_output();
    return static_cast<int>(exit);
  } catch (const percal::BadInput& error) {
    std::fprintf(stderr, "percal: %s\n", error.what());
    return static_cast<int>(Exit::bad_input);
  } catch (const percal::IoFailure& error) {
    std::fprintf(stderr, "percal: %s\n", error.what());
    return static_cast<int>(Exit::io_failure);
  } catch (const std::system_error& error) {  // fmt::print on a full disk
    std::fprintf(stderr, "percal: standard output: %s\n", error.what());
    return static_cast<int>(Exit::io_failure);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "percal: internal error: %s\n", error.what());
    return 70;
  }
}
