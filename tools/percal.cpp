// The program: reads the command line, runs one command, turns the failures into exit codes. The commands are in files of their own.
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "colour.hpp"
#include "describe.hpp"
#include "options.hpp"
#include "percal/base/progress.hpp"
#include "percal/base/version.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {

std::string out_folder(const std::string& first_input, const Common& common) {
  if (common.out == "none") return "";
  const std::string folder =
      common.out.empty() ? std::filesystem::path(first_input).stem().string() + ".out" : common.out;
  ensure_writable_folder(folder);
  return folder;
}

namespace {

// Ends at once, by calls that a signal handler may make. Evaluations are in the store as soon as they are finished, and files
// that are being written hold the signal back (text/file.cpp), so nothing half-written stays behind.
void end_interrupted(int) {
  constexpr char message[] =
      "\npercal: interrupted; what is finished is in the store, and the same command goes on from there\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof message - 1);
  _exit(static_cast<int>(Exit::interrupted));
}

void resume_after_interruption() {
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    action.sa_handler = end_interrupted;
    sigfillset(&action.sa_mask);
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);  // ignored by the caller (nohup): stays so
  }
}

// What is still in the buffer may be more than the disk holds.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw IoFailure(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

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

// Where a command is unknown CLI11 says only that one is missing.
void refuse_unknown_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  if (!chosen.empty()) return refuse_unknown_command(*chosen.front());
  const auto words = app.remaining();
  std::vector<std::string> commands;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(command->get_name());
  if (commands.empty() || words.empty() || words.front().starts_with("-")) return;
  const auto near = nearest_word(words.front(), commands);
  throw BadInput(Place{.file = "", .line = 0, .key = "command"},
                 in_quotes(words.front()) + (near ? " (did you mean " + *near + "?)" : ""), listed(commands));
}

// What the command line says, of all commands.
struct Arguments {
  Common common;
  FitArguments fit;
  ScaleArguments scale;
  ImpactArguments impact;
  StudyArguments study;
  IdentifyArguments identify;
  CalibrateArguments calibrate;
  CardArguments card;
  StoreArguments store;
  ReportArguments report;
  NewArguments start;
  KeysArguments keys;
  CompletionArguments completion;
  ManArguments man;
};

std::vector<Command> add_commands(CLI::App& app, Arguments& a) {
  std::vector<Command> commands;
  add_fit(app, a.fit, a.common, commands);
  add_scale(app, a.scale, a.common, commands);
  add_impact(app, a.impact, a.common, commands);
  add_study(app, a.study, a.common, commands);
  add_identify(app, a.identify, a.common, commands);
  add_calibrate(app, a.calibrate, a.common, commands);
  add_card(app, a.card, a.common, commands);
  add_store(app, a.store, a.common, commands);
  add_report(app, a.report, a.common, commands);
  add_new(app, a.start, a.common, commands);
  add_keys(app, a.keys, a.common, commands);
  add_completion(app, a.completion, commands);
  add_man(app, a.man, commands);
  name_values(app);
  return commands;
}

Exit run(int argc, char** argv) {
  CLI::App app(
      "percal identifies the material parameters of soft solids from stress-stretch curves and penetration depths.",
      "percal");
  app.set_version_flag("--version", "percal " + version());
  app.require_subcommand(1);
  Arguments arguments;
  const std::vector<Command> commands = add_commands(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
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
    if (command.runs_impacts) resume_after_interruption();
    return command.run();
  }
  throw std::logic_error("a command that nothing runs");
}

void say(const std::string& message) {
  std::fprintf(stderr, "%s %s\n", red("percal:", stderr).c_str(), message.c_str());
}

}  // namespace
}  // namespace percal::tools

int main(int argc, char** argv) {
  using percal::Exit;
  using percal::tools::say;
  std::signal(SIGXFSZ, SIG_IGN);  // a file over its size limit is a failure to write, told as one
  try {
    const Exit exit = percal::tools::run(argc, argv);
    percal::tools::flush_output();
    return static_cast<int>(exit);
  } catch (const percal::BadInput& error) {
    say(error.what());
    return static_cast<int>(Exit::bad_input);
  } catch (const percal::IoFailure& error) {
    say(error.what());
    return static_cast<int>(Exit::io_failure);
  } catch (const std::system_error& error) {  // fmt::print on a full disk
    say(std::string("standard output: ") + error.what());
    return static_cast<int>(Exit::io_failure);
  } catch (const std::exception& error) {
    say(std::string("internal error: ") + error.what());
    return 70;
  }
}
