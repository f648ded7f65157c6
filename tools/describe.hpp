// The command line as plain data, for completion scripts, manual pages and suggestions.
#pragma once
#include <string>
#include <vector>

namespace percal::tools {

struct DescribedOption {
  std::vector<std::string> names;    // "--out", "-o"; empty of an argument without one
  std::string argument;              // "scene": what an argument is called
  std::string value;                 // "FILE", "FOLDER", "TEXT", "INT"; empty of a flag
  std::vector<std::string> choices;  // the words that it takes; empty where it takes others
  std::string help;
  bool required = false;
  bool several = false;  // may be given several times, or takes several values
};

struct DescribedCommand {
  std::vector<std::string> words;  // "percal", "card", "write"
  std::string help, footer;
  std::vector<DescribedOption> options;  // in the order of the help; arguments among them
  std::vector<DescribedCommand> commands;
};

// The command and all below it, parents first.
std::vector<const DescribedCommand*> with_all_below(const DescribedCommand& command);

// Scripts for the shells.
std::string bash_completion(const DescribedCommand& program);
std::string zsh_completion(const DescribedCommand& program);

// A manual page in man(7) macros. `kin` are the names of other pages to see.
std::string manual_page(const DescribedCommand& command, const DescribedCommand& program);

// "percal-card-write", the name of a command's page.
std::string page_name(const DescribedCommand& command);

}  // namespace percal::tools
