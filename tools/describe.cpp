#include "describe.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

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

DescribedOption described(const CLI::Option& option) {
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
  for (const CLI::Option* option : app.get_options()) options.push_back(described(*option));
  for (const CLI::App* group : app.get_subcommands({}))
    if (group->get_name().empty()) add_options(*group, options);
}

DescribedCommand described(const CLI::App& app, std::vector<std::string> words) {
  words.push_back(app.get_name());
  DescribedCommand command{words, app.get_description(), app.get_footer(), {}, {}};
  add_options(app, command.options);
  for (const CLI::App* below : app.get_subcommands({}))
    if (!below->get_name().empty()) command.commands.push_back(described(*below, words));
  return command;
}

}  // namespace

DescribedCommand described(const CLI::App& app) { return described(app, {}); }

std::vector<const DescribedCommand*> with_all_below(const DescribedCommand& command) {
  std::vector<const DescribedCommand*> all{&command};
  for (const DescribedCommand& below : command.commands) {
    const auto more = with_all_below(below);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace percal::tools
