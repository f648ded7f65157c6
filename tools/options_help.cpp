// Options of the commands that describe percal itself: new, keys, completion, man.
#include "describe.hpp"
#include "options.hpp"

namespace percal::tools {

void name_values(CLI::App& app) {
  static const std::vector<std::pair<std::vector<std::string>, std::string>> names{
      {{"--out", "--plots"}, "FOLDER"},
      {{"--store", "--file", "--history", "--markdown", "--write-scene", "--picture", "--csv"}, "FILE"},
      {{"files", "scene", "job", "result", "results", "card", "sources"}, "FILE"},
      {{"--x", "--y", "--error", "--rate-column"}, "COLUMN"},
      {{"--where"}, "COLUMN=VALUE"},
      {{"--stable"}, "LOW:HIGH"},
      {{"--accuracy"}, "PERCENT"},
      {{"--budget"}, "TIME"}};
  for (CLI::App* command : app.get_subcommands({})) name_values(*command);
  for (const auto& [options, value] : names)
    for (const std::string& name : options) {
      CLI::Option* option = app.get_option_no_throw(name);
      if (option && option->get_type_size_max() > 0 && option->get_expected_max() > 0) option->type_name(value);
    }
}

void add_new(CLI::App& app, NewArguments& start, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("new", "a commented template of a scene, a job or a table of a curve");
  command->add_option("kind", start.kind, "scene, scale, identify, calibrate (job is the same), fit")
      ->required()
      ->check(CLI::IsMember({"scene", "scale", "identify", "calibrate", "job", "fit"}));
  command
      ->add_option("-o,--file", start.file,
                   "file to write, never over another; example tables go beside it (default: standard output)")
      ->type_name("FILE");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer("Example: percal new scene -o my.toml && percal impact my.toml --check");
  commands.push_back({command, [&] { return run_new(start, common); }});
}

void add_keys(CLI::App& app, KeysArguments& keys, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("keys", "every key of a kind of file: what it may be, its default, what it means");
  auto* kind = command->add_option("kind", keys.kind, "scene, scale, identify, calibrate (job is the same)")
                   ->check(CLI::IsMember({"scene", "scale", "identify", "calibrate", "job"}));
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

}  // namespace percal::tools
