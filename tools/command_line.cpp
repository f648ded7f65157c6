// The command line as it is read, refused and described.
#include "command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

#include "colour.hpp"
#include "help.hpp"
#include "options.hpp"
#include "percal/base/printable.hpp"
#include "percal/base/progress.hpp"
#include "percal/base/version.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

// The words between the braces of "TEXT:{a,b,c}".
std::vector<std::string> choices_in(const std::string& type) {
  const auto open = type.find('{'), close = type.rfind('}');
  std::vector<std::string> choices;
  if (open == std::string::npos || close == std::string::npos) return choices;
  std::istringstream words(type.substr(open + 1, close - open - 1));
  for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
  return choices;
}

// The type without what a check adds to it: "TEXT:{a,b}", "INT:INT in [1 - 9]"; a name of our own may have a colon.
std::string name_of_value(const std::string& type) {
  if (const auto choices = type.find('{'); choices != std::string::npos)
    return type.substr(0, choices > 0 && type[choices - 1] == ':' ? choices - 1 : choices);
  return type.find(" in [") != std::string::npos ? type.substr(0, type.find(':')) : type;
}

DescribedOption described_option(const CLI::Option& option) {
  DescribedOption result;
  for (const auto& name : option.get_lnames()) result.names.push_back("--" + name);
  for (const auto& name : option.get_snames()) result.names.push_back("-" + name);
  if (option.get_positional()) result.argument = option.get_name(true);
  const std::string type = option.get_type_name();
  if (option.get_expected_max() != 0 && option.get_type_size_max() != 0) {
    result.value = name_of_value(type);
    if (result.value.empty()) result.value = "TEXT";
  }
  result.choices = choices_in(type);
  result.help = option.get_description();
  result.required = option.get_required();
  result.several = option.get_expected_max() > 1;
  return result;
}

void add_options(const CLI::App& app, std::vector<DescribedOption>& options) {
  for (const CLI::Option* option : app.get_options()) options.push_back(described_option(*option));
  for (const CLI::App* group : app.get_subcommands({}))
    if (group->get_name().empty()) add_options(*group, options);
}

DescribedCommand described_below(const CLI::App& app, std::vector<std::string> words) {
  words.push_back(app.get_name());
  DescribedCommand command{words, app.get_description(), app.get_footer(), {}, {}};
  add_options(app, command.options);
  for (const CLI::App* below : app.get_subcommands({}))
    if (!below->get_name().empty()) command.commands.push_back(described_below(*below, words));
  return command;
}

}  // namespace

DescribedCommand described(const CLI::App& app) { return described_below(app, {}); }

namespace {

const CLI::App& deepest_chosen(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : deepest_chosen(*chosen.front());
}

// "card write " of what was chosen.
std::string words_below(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? "" : chosen.front()->get_name() + " " + words_below(*chosen.front());
}

// CLI11 says of an unknown option only that it was not expected, or that something else is missing.
void refuse_unknown_option(const CLI::App& app) {
  const CLI::App& command = deepest_chosen(app);
  std::vector<std::string> known;
  for (const DescribedOption& option : described(command).options)
    known.insert(known.end(), option.names.begin(), option.names.end());
  for (const std::string& word : command.remaining()) {
    if (word.size() < 2 || word[0] != '-' || (word[1] != '-' && !std::isalpha(static_cast<unsigned char>(word[1]))))
      continue;
    const std::string name = word.substr(0, word.find('='));
    const auto near = nearest_word(name, known);
    throw BadInput(Place{.file = "", .line = 0, .key = name},
                   "an unknown option" + (near ? " (did you mean " + *near + "?)" : ""), listed(known));
  }
}

// What a command's commands are called.
std::vector<std::string> names_below(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_name().empty()) names.push_back(command->get_name());
  return names;
}

[[noreturn]] void refuse_command(const std::string& word, const std::vector<std::string>& commands) {
  const auto near = nearest_word(word, commands);
  throw BadInput(Place{.file = "", .line = 0, .key = "command"},
                 in_quotes(word) + (near ? " (did you mean " + *near + "?)" : ""), listed(commands));
}

// Where a command is unknown CLI11 says only that one is missing.
void refuse_unknown_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  if (!chosen.empty()) return refuse_unknown_command(*chosen.front());
  const auto words = app.remaining();
  const auto commands = names_below(app);
  if (commands.empty() || words.empty() || words.front().starts_with("-")) return;
  refuse_command(words.front(), commands);
}

}  // namespace

Exit print_help(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* command = &program;
  std::string before;
  for (const std::string& word : words) {
    const auto names = names_below(*command);
    if (std::find(names.begin(), names.end(), word) == names.end()) refuse_command(word, names);
    before += (before.empty() ? "" : " ") + command->get_name();
    command = command->get_subcommand(word);
  }
  // An App's own help is that of the command which the command line chose, here this one.
  const auto formatter = command->get_formatter();
  const std::string name = before.empty() ? command->get_name() : before + " " + command->get_name();
  fmt::print("{}", fitted_help(formatter->make_help(command, name, CLI::AppFormatMode::Normal),
                               terminal_columns(STDOUT_FILENO)));
  return Exit::done;
}

Exit run_command_line(int argc, char** argv, void (*before_impacts)()) {
  CLI::App app(
      "percal identifies the material parameters of soft solids from stress-stretch curves and penetration depths.",
      "percal");
  app.set_version_flag("--version", "percal " + version());
  app.footer("Example: percal new scene -o bb.toml && percal impact bb.toml && percal report bb.out --open");
  app.require_subcommand(1);
  Arguments arguments;
  const std::vector<Command> commands = add_commands(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", fitted_help(app.help(), terminal_columns(STDOUT_FILENO)));
    return Exit::done;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --version
      app.exit(error);
      return Exit::done;
    }
    refuse_unknown_command(app);
    refuse_unknown_option(app);
    throw BadInput(std::string(error.what()) + "; see percal " + words_below(app) + "--help");
  }
  Progress::enable(!arguments.common.quiet);
  for (const Command& command : commands) {
    if (!*command.app) continue;
    if (command.runs_impacts) before_impacts();
    return command.run();
  }
  throw std::logic_error("a command that nothing runs");
}

}  // namespace percal::tools
