// The options of every command, for CLI11. Each function adds one command and says what runs it; it is run after the whole command
// line has been read.
#include "options.hpp"

#include <fmt/format.h>

#include "percal/scene/scene.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {

// CLI::Range lets nan pass, which is neither below nor above.
CLI::Validator between(double low, double high) {
  return CLI::Validator(
      [=](const std::string& text) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return good ? std::string() : fmt::format("Value {} not in range [{} - {}]", text, low, high);
      },
      fmt::format("FLOAT in [{} - {}]", low, high));
}

void add_runs(CLI::App& command, Common& common) {
  command.add_option("--store", common.store, "evaluation store (default: percal.store in the user's cache folder)");
  command.add_option("--threads", common.threads, "evaluations side by side (default: one for each core)")
      ->check(CLI::Range(0, 4096));
}

void add_common(CLI::App& command, Common& common, bool runs_impacts, const std::string& out) {
  command.add_option("--out", common.out, out);
  if (runs_impacts) add_runs(command, common);
  command.add_flag("--json", common.json, "print the result as JSON on standard output");
  command.add_flag("--details", common.details, "print all of the result, not the answer alone");
  command.add_flag("--check", common.check, "read and validate, run nothing");
  command.add_flag("--quiet", common.quiet, "print nothing but errors");
}

namespace {

void add_sphere(CLI::App& command, SphereWords& words) {
  auto* radius = command.add_option("--radius", words.radius, "of the sphere, as \"1.59 mm\"");
  command.add_option("--diameter", words.diameter, "in its place, as 4.5mm")->excludes(radius);
  auto* density = command.add_option("--particle-density", words.density, "of the sphere, as \"7800 kg/m3\"");
  command.add_option("--particle-mass", words.mass, "in its place, as 0.36g")->excludes(density);
}

void add_impact(CLI::App& app, ImpactArguments& impact, Common& common, std::vector<Command>& commands) {
  auto* command =
      app.add_subcommand("impact", "a sphere into a layer -> depth with its scatter, energy ledger, what was left out");
  command->add_option("scene", impact.scene, "TOML scene")->required();
  command->add_option("--elements-per-radius", impact.elements_per_radius, "mesh, a real number (default: the scene's)")
      ->check(between(1, 1000));
  command
      ->add_option("--replicates", impact.replicates,
                   fmt::format("runs on meshes of different phase (default: the scene's, {})", usual_replicates))
      ->check(CLI::Range(1, 1000));
  command->add_option("--arithmetic", impact.arithmetic, "single or double")
      ->check(CLI::IsMember({"single", "double"}));
  command->add_option("--history", impact.history, "write the penetration history to this CSV file");
  command->add_option(
      "--fields", impact.fields,
      "write fields of the middle run for ParaView, as every=0.5us, every=10um (of depth), every=2% (of the "
      "target's depth) or every=200 (steps), to fields/ in the folder for results");
  command->add_option("--picture", impact.picture, "draw the middle run's last state to this PNG, SVG or PDF file");
  command
      ->add_option(
          "--accuracy", impact.accuracy,
          "error of the depth, as 2%: mesh and replicates as the scene's study advises, which is run first where "
          "the store keeps none")
      ->excludes("--elements-per-radius")
      ->excludes("--replicates")
      ->excludes("--arithmetic");
  command->add_flag("--measure-errors", impact.measure_errors,
                    "measure what half the time step, 1.5 times the width and twice K do to the depth (three times the "
                    "runs more), instead of expecting it by rule");
  command
      ->add_flag("--extrapolate", impact.extrapolate,
                 "the depth at h = 0 from this mesh and one twice as fine, where erosion is judged over a length")
      ->excludes("--accuracy");
  command->footer(
      "Examples: percal impact bb.toml\n"
      "          percal impact data/guha2009/gold.toml --elements-per-radius 10 --json");
  add_common(*command, common, true);
  commands.push_back({command, [&] { return run_impact(impact, common); }, true});
}

void add_identify(CLI::App& app, IdentifyArguments& identify, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "identify", "the whole chain: gelatin shots -> ridge -> similarity -> skin -> predictions -> cards");
  command->add_option("job", identify.job, "TOML job")->required();
  command->footer("Example: percal identify data/guha2009/skin.toml");
  add_common(*command, common, true);
  add_cluster(*command, common.cluster);
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
  add_cluster(*command, common.cluster);
  command->get_option("--budget")->excludes("--slurm");  // the wall time of a queue is anybody's guess
  commands.push_back({command, [&] { return run_calibrate(calibrate, common); }, true});
}

void add_predict(CLI::App& app, PredictArguments& predict, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "predict",
      "a shot that was not fired, from a finished calibration -> its depth with intervals, depth over speed");
  PredictWords& words = predict.words;
  command->add_option("result", predict.result, "result.json of percal calibrate, or its folder")->required();
  command->add_option("--material", words.material,
                      "of the calibration, or one of its targets (default: the one that was shot into)");
  command->add_option("--hypothesis", words.hypothesis, "name or number (default: the first)");
  command->add_option("--body", words.body,
                      "\"sphere\", or the name of another body that was shot (default: what the fitted shots were)");
  command->add_option("--speed", words.speed, "as \"83 m/s\", or a range as 50..250m/s");
  add_sphere(*command, words.sphere);
  command->add_option("--layer-depth", words.layer_depth, "the target's depth, as 200mm");
  command->add_option("--speed-error", words.speed_error, "standard deviation of the speeds, as 1%");
  command->add_option("--shots", words.shots,
                      "CSV of many shots: speed, radius or diameter, particle_density or particle_mass, layer_depth, "
                      "label; what has no column is as the options say");
  auto* depth = command->add_option("--depth", words.depth, "look for the speed that gives this depth, as 85mm");
  command->add_option("--solve-for", words.solve_for,
                      "speed, diameter or density: what --depth or --v50 looks for (default: speed)");
  command->add_flag("--v50", words.v50, "look for the speed at which half of the shots pass the layer")
      ->excludes(depth);
  command->add_option("--level", words.level, "confidence level of the intervals (default: the calibration's)")
      ->check(between(0.5, 0.9999));
  command->add_flag("--verify", predict.verify, "run the solver at every shot, with its replicates");
  command->footer(
      "What is left out is what the fitted shots have in common.\n"
      "Examples: percal predict joint.out --speed 83m/s\n"
      "          percal predict joint.out --speed 50..120m/s --out joint_speeds\n"
      "          percal predict joint.out --depth \"30 mm\"");
  add_common(*command, common, true, "folder for results (default: no files)");
  commands.push_back({command, [&] { return run_predict(predict, common); }, true});
}

void add_invert(CLI::App& app, InvertArguments& invert, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "invert",
      "one depth -> the modulus that gives it, or the erosion strain, with its interval, and the ridge of pairs");
  InvertWords& words = invert.words;
  command->add_option("--depth", words.depth, "measured, as 85mm");
  command->add_option("--depth-error", words.depth_error, "its standard deviation, as 5mm or 5%");
  command
      ->add_option("--scene", words.scene,
                   "TOML scene of any shot, in place of what is said below of sphere, speed and layer")
      ->type_name("FILE");
  add_sphere(*command, words.sphere);
  command->add_option("--speed", words.speed, "as \"180 m/s\"");
  command->add_option("--speed-error", words.speed_error, "its standard deviation, as 2%");
  command->add_option("--density", words.density, "of the layer, as \"1030 kg/m3\"");
  command->add_option("--alpha", words.alpha, "the layer's Ogden exponent");
  command->add_option("--erosion-strain", words.erosion_strain, "engineering; the modulus is then looked for");
  command->add_option("--mu", words.mu, "true modulus, as 346kPa; the erosion strain is then looked for");
  command->add_option("--erosion-length", words.erosion_length, "over which erosion is judged (default: each element)");
  command->add_option("--layer-depth", words.layer_depth, "the layer's depth, as 150mm");
  command->add_option("--layer-width", words.layer_width, "from its middle to the wall (default: as in a scene)");
  command->add_option("--elements-per-radius", words.elements_per_radius,
                      "mesh, a real number (default: 10, with an erosion length three elements in it or more)");
  command->add_option("--level", words.level, "confidence level of the intervals (default: 0.95)")
      ->check(between(0.5, 0.9999));
  command->footer(
      "One of --mu and --erosion-strain; without the lengths, widths and errors that have a default everything is "
      "needed.\n"
      "Example: percal invert --depth 85mm --depth-error 5mm --diameter 4.5mm --particle-density \"7800 kg/m3\" "
      "--speed 179.8m/s --density \"1030 kg/m3\" --alpha 8.65 --erosion-strain 1 --layer-depth 150mm\n"
      "         percal invert --depth 3.44cm --scene data/guha2009/rhombus_block.toml --mu 837kPa");
  add_common(*command, common, true, "folder for results (default: no files)");
  commands.push_back({command, [&] { return run_invert(invert, common); }, true});
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
  auto* meshes = command
                     ->add_option("--meshes", study.meshes,
                                  "elements per radius, four or more (default: 5,7,10,14,20,28; with an erosion length "
                                  "from three elements in it)")
                     ->delimiter(',')
                     ->check(between(1, 1000))
                     ->needs(errors);
  auto* replicates = command
                         ->add_option("--replicates", study.replicates,
                                      fmt::format("runs of each setting (default: {})", usual_replicates))
                         ->check(CLI::Range(3, 1000));
  command->add_option("--markdown", study.markdown, "write the whole page as Markdown to this file");
  extremes->excludes(scene)->excludes(meshes)->excludes(replicates);
  command->footer(
      "Examples: percal study data/guha2009/gold.toml --error-vs-time --meshes 5,7,10,14 --replicates 3\n"
      "          percal study data/guha2009/gold.toml --omissions\n"
      "          percal study --extremes --markdown extremes.md");
  add_common(*command, common, true);
  add_cluster(*command, common.cluster);
  commands.push_back({command, [&] { return run_study(study, common); }, true});
}

void add_scale(CLI::App& app, ScaleArguments& scale, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("scale", "pi groups of two systems, what must hold for similarity, mapped values");
  command->add_option("job", scale.job, "TOML job")->required();
  command->add_option("--write-scene", scale.write_scene, "write the similar scene to this file");
  command->footer("Example: percal scale data/guha2009/similar.toml");
  add_common(*command, common, false);
  commands.push_back({command, [&] { return run_scale(scale, common); }});
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
  command->add_option("results", report.results, "result.json of a command or its folder, or two of the same command")
      ->required()
      ->expected(1, 2);
  command->add_option("-o,--file", report.file,
                      "page to write (default: report.html or explore.html beside the result)");
  command->add_flag("--explore", report.explore,
                    "of a calibration: a page to play with, sliders for shot and material, depth, ridge and dose");
  command->add_option("--plots", report.plots, "folder for every figure as SVG, PNG and CSV (default: none)");
  command->add_flag("--open", report.open, "show the page in the browser, by xdg-open");
  command->add_flag("--check", common.check, "read the results, write nothing");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer("Example: percal report bb.out --open");
  commands.push_back({command, [&] { return run_report(report, common); }});
}

void add_new(CLI::App& app, NewArguments& start, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("new", "a commented template of a scene, a job or a table of a curve");
  command->add_option("kind", start.kind, "a kind of file, or the command that reads it")
      ->required()
      ->check(CLI::IsMember(
          {"scene", "scale", "identify", "calibrate", "campaign", "dose", "design", "fit", "impact", "study", "job"}));
  command->add_flag("--all", start.all, "every key, not those alone that one needs");
  command
      ->add_option("-o,--file", start.file,
                   "file to write, never over another; example tables go beside it (default: standard output)")
      ->type_name("FILE");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer("Example: percal new scene -o bb.toml && percal impact bb.toml");
  commands.push_back({command, [&] { return run_new(start, common); }});
}

void add_keys(CLI::App& app, KeysArguments& keys, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("keys", "every key of a kind of file: what it may be, its default, what it means");
  auto* kind = command->add_option("kind", keys.kind, "a kind of file, or the command that reads it")
                   ->check(CLI::IsMember({"scene", "scale", "identify", "calibrate", "campaign", "dose", "design",
                                          "impact", "study", "job"}));
  auto* json = command->add_flag("--json", common.json, "print them as JSON");
  command->add_flag("--markdown", keys.markdown, "all kinds, as a page")->excludes(kind)->excludes(json);
  command->footer("Example: percal keys scene");
  commands.push_back({command, [&keys, &common] { return run_keys(keys, common); }});
}

void add_completion(CLI::App& app, CompletionArguments& completion, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("completion", "a script that completes percal's command line in a shell");
  command->add_option("shell", completion.shell, "bash or zsh")->required()->check(CLI::IsMember({"bash", "zsh"}));
  command->footer("Example: source <(percal completion bash)");
  commands.push_back({command, [&app, &completion] { return run_completion(completion, described(app)); }});
}

void add_man(CLI::App& app, ManArguments& man, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("man", "a manual page, for man -l");
  command->add_option("words", man.words, "a command, as: card write (default: percal itself)");
  command->add_option("--all", man.folder, "write all pages to this folder")->type_name("FOLDER");
  command->footer("Example: percal man impact | man -l -");
  commands.push_back({command, [&app, &man] { return run_man(man, described(app)); }});
}

void add_help(CLI::App& app, std::vector<std::string>& words, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("help", "the help of a command, as its --help");
  command->add_option("words", words, "a command, as: card write (default: percal itself)");
  command->footer("Example: percal help impact");
  commands.push_back({command, [&app, &words] { return print_help(app, words); }});
}

// What the values of options are called in help and completion: FILE, FOLDER and so on; for all commands at once.
void name_values(CLI::App& app) {
  static const std::vector<std::pair<std::vector<std::string>, std::string>> names{
      {{"--out", "--plots", "--slurm-folder"}, "FOLDER"},
      {{"--store", "--file", "--history", "--markdown", "--write-scene", "--picture", "--csv"}, "FILE"},
      {{"files", "scene", "job", "plan", "list", "result", "results", "card", "sources"}, "FILE"},
      {{"--shots"}, "FILE.csv"},
      {{"--x", "--y", "--error", "--rate-column"}, "COLUMN"},
      {{"--where"}, "COLUMN=VALUE"},
      {{"--stable"}, "LOW:HIGH"},
      {{"--gauge-length", "--specimen-diameter", "--width", "--thickness"}, "LENGTH"},
      {{"--area"}, "AREA"},
      {{"--branch"}, "BRANCH"},
      {{"--accuracy"}, "PERCENT"},
      {{"--budget"}, "TIME"}};
  for (CLI::App* command : app.get_subcommands({})) name_values(*command);
  for (const auto& [options, value] : names)
    for (const std::string& name : options) {
      CLI::Option* option = app.get_option_no_throw(name);
      if (option && option->get_type_size_max() > 0 && option->get_expected_max() > 0) option->type_name(value);
    }
}

}  // namespace

std::vector<Command> add_commands(CLI::App& app, Arguments& a) {
  std::vector<Command> commands;
  add_fit(app, a.fit, a.common, commands);
  add_scale(app, a.scale, a.common, commands);
  add_impact(app, a.impact, a.common, commands);
  add_study(app, a.study, a.common, commands);
  add_campaign(app, a.campaign, a.common, commands);
  add_atlas(app, a.atlas, a.common, commands);
  add_identify(app, a.identify, a.common, commands);
  add_calibrate(app, a.calibrate, a.common, commands);
  add_predict(app, a.predict, a.common, commands);
  add_dose(app, a.dose, a.common, commands);
  add_design(app, a.design, a.common, commands);
  add_invert(app, a.invert, a.common, commands);
  add_card(app, a.card, a.common, commands);
  add_store(app, a.store, a.common, commands);
  add_work(app, a.work, commands);
  add_report(app, a.report, a.common, commands);
  add_new(app, a.start, a.common, commands);
  add_keys(app, a.keys, a.common, commands);
  add_completion(app, a.completion, commands);
  add_man(app, a.man, commands);
  add_help(app, a.help, commands);
  name_values(app);
  return commands;
}

}  // namespace percal::tools
