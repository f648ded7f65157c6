// percal man: manual pages, made from the options themselves.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "commands.hpp"
#include "describe.hpp"
#include "percal/base/version.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

// Text that troff prints as it stands.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '~')
      result += "\\(ti";
    else if (c == '^')
      result += "\\(ha";
    else
      result += c;
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

std::string value_of(const DescribedOption& option) {
  return option.choices.empty() ? option.value : fmt::format("{}", fmt::join(option.choices, "|"));
}

std::string synopsis(const DescribedCommand& command) {
  std::string text = bold(fmt::format("{}", fmt::join(command.words, " ")));
  for (const DescribedOption& option : command.options) {
    if (option.argument.empty()) continue;
    const std::string shown = italic(option.argument) + (option.several ? " ..." : "");
    text += option.required ? fmt::format(" {}", shown) : fmt::format(" [{}]", shown);
  }
  for (const DescribedOption& option : command.options)
    if (option.required && option.argument.empty())
      text += fmt::format(" {} {}", bold(option.names.front()), italic(option.value));
  if (!command.commands.empty()) text += fmt::format(" {}", italic("command"));
  return fmt::format("{} [{}]\n", text, italic("options"));
}

std::string tagged(const std::string& tag, const std::string& text) {
  return ".TP\n" + tag + "\n" + (text.empty() ? "\\&" : plain(text)) + "\n";
}

std::string arguments(const DescribedCommand& command) {
  std::string text;
  for (const DescribedOption& option : command.options) {
    if (option.argument.empty()) continue;
    text += tagged(italic(option.argument), option.help);
  }
  return text.empty() ? "" : ".SH ARGUMENTS\n" + text;
}

std::string options(const DescribedCommand& command) {
  std::string text;
  for (const DescribedOption& option : command.options) {
    if (option.names.empty()) continue;
    std::string tag;
    for (const std::string& name : option.names) tag += (tag.empty() ? "" : ", ") + bold(name);
    if (!option.value.empty()) tag += fmt::format(" {}", italic(value_of(option)));
    text += tagged(tag, option.help);
  }
  return text.empty() ? "" : ".SH OPTIONS\n" + text;
}

std::string commands(const DescribedCommand& command) {
  std::string text;
  for (const DescribedCommand& below : command.commands) text += tagged(bold(page_name(below)) + "(1)", below.help);
  return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

// "Examples: a" and "          b" as lines of their own.
std::string examples(const DescribedCommand& command) {
  if (command.footer.empty()) return "";
  std::istringstream lines(command.footer);
  std::string text = ".SH EXAMPLES\n.nf\n";
  for (std::string line; std::getline(lines, line);) {
    for (const char* head : {"Examples:", "Example:"})
      if (line.starts_with(head)) line.erase(0, std::string(head).size());
    line.erase(0, line.find_first_not_of(' '));
    text += plain(line) + "\n";
  }
  return text + ".fi\n";
}

std::string exit_status() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : std::vector<std::pair<int, std::string>>{
           {0, "done; also where a particle goes through the layer"},
           {1, "done, but a check in the job failed"},
           {2, "bad input: the message names file, line and key, what was found and what is accepted"},
           {3, "the outcome that was asked for was not reached"},
           {4, "a file cannot be read or written, or memory is not to be had"},
           {130, "interrupted; the same command goes on from there"}})
    text += tagged(bold(std::to_string(code)), meaning);
  return text;
}

std::string environment() {
  return ".SH ENVIRONMENT\n" + tagged(bold("NO_COLOR"), "no colours where it is set to anything") +
         tagged(bold("XDG_CACHE_HOME"), "where the evaluation store is kept: percal/percal.store in it");
}

std::string see_also(const DescribedCommand& command, const DescribedCommand& program) {
  std::vector<std::string> pages;
  for (const auto* other : with_all_below(program))
    if (other->words != command.words) pages.push_back(bold(page_name(*other)) + "(1)");
  return fmt::format(".SH SEE ALSO\n{}\n", fmt::join(pages, ",\n"));
}

}  // namespace

std::string page_name(const DescribedCommand& command) { return fmt::format("{}", fmt::join(command.words, "-")); }

std::string manual_page(const DescribedCommand& command, const DescribedCommand& program) {
  std::string title = page_name(command);
  std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string text = fmt::format(".TH {} 1 \"\" \"percal {}\" \"percal\"\n", plain(title), version());
  text += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}", plain(page_name(command)), plain(command.help),
                      synopsis(command));
  text += arguments(command) + options(command) + commands(command) + examples(command) + exit_status();
  if (&command == &program) text += environment();
  return text + see_also(command, program);
}

Exit run_man(const ManArguments& arguments, const DescribedCommand& program) {
  const auto all = with_all_below(program);
  if (!arguments.folder.empty()) {
    for (const auto* command : all)
      write_file(arguments.folder + "/" + page_name(*command) + ".1", manual_page(*command, program));
    return Exit::done;
  }
  std::vector<std::string> wanted{program.words.front()}, names;
  wanted.insert(wanted.end(), arguments.words.begin(), arguments.words.end());
  for (const auto* command : all) {
    if (command->words == wanted) {
      fmt::print("{}", manual_page(*command, program));
      return Exit::done;
    }
    if (command->words.size() > 1)
      names.push_back(fmt::format("{}", fmt::join(command->words.begin() + 1, command->words.end(), " ")));
  }
  throw BadInput({"", 0, "command"}, in_quotes(fmt::format("{}", fmt::join(arguments.words, " "))), listed(names));
}

}  // namespace percal::tools
