// Options of the commands that run no impact: fit, scale, card, report, new.
#include "options.hpp"

namespace percal::tools {

void add_fit(CLI::App& app, FitArguments& fit, Common& common, std::vector<Command>& commands) {
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
  commands.push_back({command, [&] { return run_fit(fit, common); }});
}

void add_scale(CLI::App& app, ScaleArguments& scale, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("scale", "pi groups of two systems, what must hold for similarity, mapped values");
  command->add_option("job", scale.job, "TOML job")->required();
  command->add_option("--write-scene", scale.write_scene, "write the similar scene to this file");
  command->footer("Example: percal scale data/guha2009/similar.toml");
  add_common(*command, common, false);
  commands.push_back({command, [&] { return run_scale(scale, common); }});
}

namespace {

void add_card_write(CLI::App& card_command, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = card_command.add_subcommand("write", "write the card of a result");
  command->add_option("result", card.result, "result.json of identify")->required();
  command
      ->add_option("--solver", card.solver, "lsdyna, abaqus, calculix, openradioss, febio, ansys, or csv for a table")
      ->required()
      ->check(CLI::IsMember({"lsdyna", "abaqus", "calculix", "openradioss", "febio", "ansys", "csv"}));
  command->add_option("--units", card.units, "unit system of the card: si, mm-t-s-MPa, mm-ms-kg-GPa, um-us-ng-MPa");
  command->add_option("--file", card.file, "file to write (default: standard output)");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer("Example: percal card write skin.out/result.json --solver lsdyna --units mm-ms-kg-GPa");
  commands.push_back({command, [&] { return run_card_write(card, common); }});
}

void add_card_read(CLI::App& card_command, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = card_command.add_subcommand("read", "the material that a card means, in percal's convention");
  command->add_option("card", card.card, "a card of one of the six programs")->required();
  command->add_flag("--json", common.json, "print the card object of a result file");
  command->footer("Example: percal card read skin.k");
  commands.push_back({command, [&] { return run_card_read(card, common); }});
}

void add_card_check(CLI::App& card_command, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = card_command.add_subcommand("check", "the stress-stretch curve that a card means");
  command->add_option("card", card.card, "a card of one of the six programs")->required();
  command->footer("Example: percal card check skin.k");
  commands.push_back({command, [&] { return run_card_check(card, common); }});
}

}  // namespace

void add_card(CLI::App& app, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("card", "material cards for finite-element programs");
  command->require_subcommand(1);
  add_card_write(*command, card, common, commands);
  add_card_read(*command, card, common, commands);
  add_card_check(*command, card, common, commands);
}

void add_report(CLI::App& app, ReportArguments& report, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("report", "a result as one HTML page; two results side by side");
  command->add_option("results", report.results, "result.json of a command, or two of the same command")
      ->required()
      ->expected(1, 2);
  command->add_option("-o,--file", report.file, "page to write (default: report.html beside the result)");
  command->add_option("--plots", report.plots, "folder for every figure as SVG, PNG and CSV (default: none)");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer("Example: percal report skin.out/result.json -o skin.html");
  commands.push_back({command, [&] { return run_report(report, common); }});
}

void add_new(CLI::App& app, NewArguments& start, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("new", "a commented template of a scene or a job");
  command->add_option("kind", start.kind, "scene, scale, identify, calibrate; job is calibrate")
      ->required()
      ->check(CLI::IsMember({"scene", "scale", "identify", "calibrate", "job"}));
  command->add_option("-o,--file", start.file, "file to write (default: standard output)");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer("Example: percal new scene -o my.toml");
  commands.push_back({command, [&] { return run_new(start, common); }});
}

}  // namespace percal::tools
