// Options of the commands that run no impact: fit, scale, card, store, report, new.
#include "options.hpp"
#include "percal/card/solver.hpp"
#include "percal/units/words.hpp"

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
  command->add_option("result", card.result, "result.json of identify, calibrate or fit, or of card read --json")
      ->required();
  auto targets = solver_words();
  auto* solver = command->add_option("--solver", card.solver, listed(targets) + ", or csv for a table")->required();
  targets.push_back("csv");
  solver->check(CLI::IsMember(targets));
  command->add_option("--units", card.units, "unit system of the card: si, mm-t-s-MPa, mm-ms-kg-GPa, um-us-ng-MPa");
  command->add_option("--file", card.file, "file to write (default: standard output)");
  command->add_option("--card,--name", card.name, "which of several cards; the name of a single one");
  command->add_option("--density", card.density, "density, such as \"1010 kg/m3\"; a fit does not know it");
  auto* ratio = command->add_option("--bulk-to-shear", card.bulk_to_shear, "K/mu; a fit does not know it");
  command->add_option("--nu", card.nu, "Poisson's ratio instead")->excludes(ratio);
  command->add_option("--mode", card.mode, "with csv: uniaxial (default), equibiaxial, planar or shear");
  command->add_option("--range", card.range, "with csv: stretches LOW:HIGH (default: 0.5:2)");
  command->add_option("--points", card.points, "with csv: rows (default: 31)");
  auto* deck = command->add_option("--deck", card.deck, "the card in a single-element test ready to run: uniaxial")
                   ->check(CLI::IsMember({"uniaxial"}));
  command->add_option("--stretch", card.stretch, "with --deck: stretch at the end (default: 2)")->needs(deck);
  command->add_option("--increments", card.increments, "with --deck: equal steps to it (default: 20)")->needs(deck);
  command->add_flag("--check", common.check, "read and convert, write nothing");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer(
      "Examples: percal card write skin.out/result.json --solver lsdyna --units mm-ms-kg-GPa\n"
      "          percal card write gel.out/result.json --solver febio --density \"1010 kg/m3\" --nu 0.495\n"
      "          percal card write skin.out/result.json --solver calculix --units mm-t-s-MPa --deck uniaxial "
      "--file skin.inp");
  commands.push_back({command, [&] { return run_card_write(card, common); }});
}

void add_card_source(CLI::App& command, CardArguments& card) {
  command.add_option("card", card.card, "a card of one of the programs, or a result of percal")->required();
  command.add_option("--solver", card.solver, "the program (default: found by its keywords)")
      ->check(CLI::IsMember(solver_words()));
  command.add_option("--units", card.units, "units of its numbers (default: as the comment of a percal card says)");
  command.add_option("--name", card.name, "which of several materials");
}

void add_card_read(CLI::App& card_command, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = card_command.add_subcommand("read", "the material that a card means, in percal's convention");
  add_card_source(*command, card);
  command->add_flag("--json", common.json, "print the card object, which card write takes");
  command->footer("Example: percal card read skin.k");
  commands.push_back({command, [&] { return run_card_read(card, common); }});
}

void add_card_check(CLI::App& card_command, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = card_command.add_subcommand("check", "the stress-stretch curve that a card means");
  add_card_source(*command, card);
  command->add_option("--mode", card.mode, "uniaxial (default), equibiaxial, planar or shear");
  command->add_option("--stretch", card.range, "stretches LOW:HIGH (default: 0.5:2; in shear 0:1)");
  command->add_option("--points", card.points, "points of the curve (default: 31)");
  command->add_option("--csv", card.csv, "write the curve to this file, for percal fit and for tables");
  command->add_flag("--json", common.json, "print the card object and the curve");
  command->footer("Example: percal card check skin.k --mode equibiaxial --stretch 0.8:1.5");
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

void add_store(CLI::App& app, StoreArguments& store, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("store", "the store of finished evaluations");
  command->require_subcommand(1);
  auto* merge = command->add_subcommand("merge", "take the evaluations of other stores into one");
  merge->add_option("sources", store.sources, "stores to read; they stay as they are")->required();
  merge->add_option("--store", common.store, "store to write (default: percal.store in the user's cache folder)");
  merge->add_flag("--quiet", common.quiet, "print nothing but errors");
  merge->footer("Example: percal store merge task*.store --store all.store");
  commands.push_back({merge, [&] { return run_store_merge(store, common); }});
}

void add_report(CLI::App& app, ReportArguments& report, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("report", "a result as one HTML page; two results side by side");
  command->add_option("results", report.results, "result.json of a command, or two of the same command")
      ->required()
      ->expected(1, 2);
  command->add_option("-o,--file", report.file, "page to write (default: report.html beside the result)");
  command->add_option("--plots", report.plots, "folder for every figure as SVG, PNG and CSV (default: none)");
  command->add_flag("--check", common.check, "read the results, write nothing");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer("Example: percal report skin.out/result.json -o skin.html");
  commands.push_back({command, [&] { return run_report(report, common); }});
}

}  // namespace percal::tools
