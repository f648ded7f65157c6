// The options of percal fit: see options.cpp.
#include "options.hpp"

namespace percal::tools {

void add_fit(CLI::App& app, FitArguments& fit, Common& common, std::vector<Command>& commands) {
  auto* command =
      app.add_subcommand("fit", "stress-stretch CSV files -> moduli and exponents, every minimum, models compared");
  command->add_option("files", fit.files, "CSV files; uniaxial=FILE, planar=FILE, ... say the deformation of each");
  command
      ->add_option(
          "--mode", fit.mode,
          "deformation where the file has no mode column, or one of other words: uniaxial, equibiaxial, planar, shear, "
          "...; WORD=FILE of one file (may be given several times)")
      ->allow_extra_args(false);
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
  command
      ->add_option("--where", fit.where,
                   "keep the rows with COLUMN=VALUE, or with !=, <, <=, >, >= such as \"stretch<3\" (may be given "
                   "several times)")
      ->allow_extra_args(false);
  command->add_option("--gauge-length", fit.gauge_length,
                      "x is a displacement, over this length (the height in simple shear), as \"10 mm\"");
  command->add_option("--area", fit.area, "y is a force, over this cross-section before the test, as \"78.5 mm2\"");
  command->add_option("--specimen-diameter", fit.specimen_diameter, "in its place, of a round specimen");
  command->add_option("--width", fit.width, "in its place, with --thickness");
  command->add_option("--thickness", fit.thickness, "in its place, with --width");
  command->add_option("--branch", fit.branch,
                      "of cycles: loading, unloading, or the number of one branch, 1 the first");
  command->add_option("--until", fit.until, "peak: each curve up to its largest stress")
      ->check(CLI::IsMember({"peak"}));
  command->add_option("--without", fit.without, "holds: no rows in which the stress relaxes at a held stretch")
      ->check(CLI::IsMember({"holds"}));
  auto* relaxation = command->add_option("--relaxation", fit.relaxation,
                                         "terms of a Prony series, fitted to the whole stress history: 1, 2, 3 or auto "
                                         "(as many as AICc wants)");
  command->add_option("--time", fit.time, "with --relaxation: the column of time (default: found by its name)")
      ->needs(relaxation);
  command
      ->add_option(
          "--rate", fit.rate,
          "with --relaxation and no column of time: the rate of stretch, as \"0.05 1/s\", or of displacement, as "
          "\"5 mm/min\"; RATE=FILE of one file (may be given several times)")
      ->allow_extra_args(false)
      ->needs(relaxation);
  for (const char* other : {"--branch", "--until", "--without", "--loss", "--unconstrained", "--compare"})
    relaxation->excludes(other);
  command->add_flag("--intervals,!--no-intervals", fit.intervals,
                    "profile-likelihood intervals of every parameter (default: yes)");
  command->add_option("--level", fit.level, "confidence level of the intervals (default: 0.95)")
      ->check(between(0.5, 0.9999));
  command->add_option("--bootstrap", fit.bootstrap, "replicates of each kind of bootstrap (default: none)")
      ->check(CLI::Range(0, 1000000));
  auto* rate_factor = command->add_flag("--rate-factor", fit.rate_factor,
                                        "one factor between two curves of one solid: files LOW_RATE HIGH_RATE");
  command->add_option("--rate-column", fit.rate_column, "with --rate-factor and one file: the column of the rate")
      ->needs(rate_factor);
  for (const char* other :
       {"--model", "--compare", "--weights", "--loss", "--unconstrained", "--stable", "--bootstrap", "--relaxation"})
    rate_factor->excludes(other);
  relaxation->excludes("--bootstrap");
  command->footer(
      "Examples: percal fit data/public/treloar1944_rubber_primary.csv --where mode=UT --residual absolute\n"
      "          percal fit data/public/treloar1944_rubber_primary.csv --compare --weights tests\n"
      "          percal fit machine.csv --mode compression --gauge-length 10mm --specimen-diameter 12mm\n"
      "          percal fit uniaxial=tension.csv planar=shear.csv --where \"stretch<3\"\n"
      "          percal fit data/public/vanloocke2008_muscle_rates.csv --mode compression --where set=rate --where "
      "direction=fibre --relaxation auto\n"
      "          percal fit --rate-factor data/synthetic/gelatin_12wt_quasistatic.csv "
      "data/synthetic/gelatin_12wt_highrate.csv");
  add_common(*command, common, false);
  commands.push_back({command, [&] { return run_fit(fit, common); }});
}

}  // namespace percal::tools
