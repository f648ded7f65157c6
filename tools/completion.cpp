// percal completion: scripts for bash and zsh, made from the options themselves.
#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "describe.hpp"

namespace percal::tools {
namespace {

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

// For text between single quotes of a shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

// The arms of a case over "COMMAND WORD" that go down to a subcommand.
std::string descents(const DescribedCommand& program) {
  std::vector<std::string> patterns;
  for (const auto* command : with_all_below(program))
    if (command->words.size() > 1) patterns.push_back(quoted(joined(command->words)));
  return fmt::format("{}", fmt::join(patterns, " | "));
}

// What follows an option that takes a value: its choices, files, folders, or nothing that is known. `line` says how a shell
// offers each of them.
struct Offers {
  std::string (*choices)(const std::vector<std::string>&);
  std::string files, folders;
};

std::string offer(const DescribedOption& option, const Offers& offers) {
  if (!option.choices.empty()) return offers.choices(option.choices);
  if (option.value == "FILE") return offers.files;
  if (option.value == "FOLDER") return offers.folders;
  return ":";
}

std::string values(const DescribedCommand& program, const Offers& offers) {
  std::string text;
  for (const auto* command : with_all_below(program))
    for (const DescribedOption& option : command->options) {
      if (option.names.empty() || option.value.empty()) continue;
      std::vector<std::string> patterns;
      for (const auto& name : option.names) patterns.push_back(quoted(joined(command->words) + " " + name));
      text += fmt::format("    {}) {}; return ;;\n", fmt::join(patterns, " | "), offer(option, offers));
    }
  return text;
}

// What stands where no option does: subcommands, the choices of the arguments, or files.
std::string places(const DescribedCommand& program, const Offers& offers) {
  std::string text;
  for (const auto* command : with_all_below(program)) {
    std::vector<std::string> words;
    for (const auto& below : command->commands) words.push_back(below.words.back());
    bool takes_files = false;
    for (const DescribedOption& option : command->options) {
      if (option.argument.empty()) continue;
      words.insert(words.end(), option.choices.begin(), option.choices.end());
      takes_files |= option.value == "FILE";
    }
    const std::string what = !words.empty() ? offers.choices(words) : takes_files ? offers.files : ":";
    text += fmt::format("    {}) {} ;;\n", quoted(joined(command->words)), what);
  }
  return text;
}

std::vector<std::string> option_names(const DescribedCommand& command) {
  std::vector<std::string> names;
  for (const DescribedOption& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::string bash_words(const std::vector<std::string>& words) {
  return fmt::format("COMPREPLY=($(compgen -W {} -- \"$current\"))", quoted(joined(words)));
}

std::string zsh_words(const std::vector<std::string>& words) {
  std::vector<std::string> shown;
  for (const auto& word : words) shown.push_back(quoted(word));
  return fmt::format("compadd -- {}", fmt::join(shown, " "));
}

}  // namespace

std::string bash_completion(const DescribedCommand& program) {
  const Offers offers{bash_words, "_percal_paths -f", "_percal_paths -d"};
  std::string text =
      "# Completion of percal's command line in bash, written by `percal completion bash`.\n"
      "_percal_paths() {\n"
      "  compopt -o filenames 2>/dev/null\n"
      "  local IFS=$'\\n'\n"
      "  COMPREPLY=($(compgen \"$1\" -- \"$current\"))\n"
      "}\n\n"
      "_percal() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=percal i\n"
      "  COMPREPLY=()\n"
      "  if [[ $current == '=' ]]; then\n"  // --solver=f comes as three words
      "    current=\n"
      "  elif [[ $before == '=' ]]; then\n"
      "    before=${COMP_WORDS[COMP_CWORD-2]}\n"
      "  fi\n"
      "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
      "    case \"$command ${COMP_WORDS[i]}\" in\n";
  text += fmt::format("      {}) command=\"$command ${{COMP_WORDS[i]}}\" ;;\n", descents(program));
  text += "    esac\n  done\n  case \"$command $before\" in\n";
  text += values(program, offers);
  text += "  esac\n  if [[ $current == -* ]]; then\n    case \"$command\" in\n";
  for (const auto* command : with_all_below(program))
    text += fmt::format("      {}) {} ;;\n", quoted(joined(command->words)), bash_words(option_names(*command)));
  text += "    esac\n    return\n  fi\n  case \"$command\" in\n";
  text += places(program, offers);
  return text + "  esac\n}\n\ncomplete -F _percal percal\n";
}

std::string zsh_completion(const DescribedCommand& program) {
  const Offers offers{zsh_words, "_files", "_files -/"};
  std::string text =
      "#compdef percal\n"
      "# Completion of percal's command line in zsh, written by `percal completion zsh`.\n"
      "_percal() {\n"
      "  local before=${words[CURRENT-1]} command=percal i\n"
      "  local -a options\n"
      "  for ((i = 2; i < CURRENT; ++i)); do\n"
      "    case \"$command ${words[i]}\" in\n";
  text += fmt::format("      {}) command=\"$command ${{words[i]}}\" ;;\n", descents(program));
  text += "    esac\n  done\n  case \"$command $before\" in\n";
  text += values(program, offers);
  text += "  esac\n  if [[ $PREFIX == -* ]]; then\n    case \"$command\" in\n";
  for (const auto* command : with_all_below(program)) {
    text += fmt::format("      {})\n        options=(\n", quoted(joined(command->words)));
    for (const DescribedOption& option : command->options)
      for (const auto& name : option.names) {
        std::string help = option.help;
        for (auto at = help.find(':'); at != std::string::npos; at = help.find(':', at + 2)) help.insert(at, 1, '\\');
        text += fmt::format("          {}\n", quoted(name + ":" + help));
      }
    text += "        ) ;;\n";
  }
  text += "    esac\n    _describe -o option options\n    return\n  fi\n  case \"$command\" in\n";
  text += places(program, offers);
  return text +
         "  esac\n}\n\nif [[ $funcstack[1] == _percal ]]; then\n  _percal \"$@\"\nelse\n  compdef _percal percal\nfi\n";
}

Exit run_completion(const CompletionArguments& arguments, const DescribedCommand& program) {
  fmt::print("{}", arguments.shell == "bash" ? bash_completion(program) : zsh_completion(program));
  return Exit::done;
}

std::vector<const DescribedCommand*> with_all_below(const DescribedCommand& command) {
  std::vector<const DescribedCommand*> all{&command};
  for (const DescribedCommand& below : command.commands) {
    const auto more = with_all_below(below);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace percal::tools
