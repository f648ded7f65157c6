// The options of every command, for CLI11. Each function adds one command and says what runs it; it is run after the whole
// command line has been read. CLI11 is seen by percal.cpp and options_*.cpp alone.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "commands.hpp"

namespace percal::tools {

struct Command {
  CLI::App* app;
  std::function<Exit()> run;
  bool runs_impacts = false;  // may be interrupted and resumed
};

// What the values of options are called in help and completion: FILE, FOLDER and so on; for all commands at once.
void name_values(CLI::App& app);

// --out, --json, --check, --quiet, and for commands that run impacts --store and --threads.
void add_common(CLI::App& command, Common& common, bool runs_impacts);

void add_fit(CLI::App& app, FitArguments& fit, Common& common, std::vector<Command>& commands);
void add_scale(CLI::App& app, ScaleArguments& scale, Common& common, std::vector<Command>& commands);
void add_card(CLI::App& app, CardArguments& card, Common& common, std::vector<Command>& commands);
void add_impact(CLI::App& app, ImpactArguments& impact, Common& common, std::vector<Command>& commands);
void add_study(CLI::App& app, StudyArguments& study, Common& common, std::vector<Command>& commands);
void add_identify(CLI::App& app, IdentifyArguments& identify, Common& common, std::vector<Command>& commands);
void add_calibrate(CLI::App& app, CalibrateArguments& calibrate, Common& common, std::vector<Command>& commands);
void add_store(CLI::App& app, StoreArguments& store, Common& common, std::vector<Command>& commands);
void add_report(CLI::App& app, ReportArguments& report, Common& common, std::vector<Command>& commands);
void add_new(CLI::App& app, NewArguments& start, Common& common, std::vector<Command>& commands);
void add_keys(CLI::App& app, KeysArguments& keys, Common& common, std::vector<Command>& commands);
void add_completion(CLI::App& app, CompletionArguments& completion, std::vector<Command>& commands);
void add_man(CLI::App& app, ManArguments& man, std::vector<Command>& commands);

}  // namespace percal::tools
