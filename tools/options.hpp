// The options of every command. CLI11 is seen by options*.cpp and command_line.cpp alone.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "commands.hpp"
#include "describe.hpp"

namespace percal::tools {

// What the command line says, of all commands.
struct Arguments {
  Common common;
  FitArguments fit;
  ScaleArguments scale;
  ImpactArguments impact;
  PredictArguments predict;
  PowderArguments dose, design;
  InvertArguments invert;
  StudyArguments study;
  CampaignArguments campaign;
  AtlasArguments atlas;
  WorkArguments work;
  IdentifyArguments identify;
  CalibrateArguments calibrate;
  CardArguments card;
  StoreArguments store;
  ReportArguments report;
  NewArguments start;
  KeysArguments keys;
  CompletionArguments completion;
  ManArguments man;
  std::vector<std::string> help;  // words of a command
};

struct Command {
  CLI::App* app;
  std::function<Exit()> run;
  bool runs_impacts = false;  // may be interrupted and resumed
};

// A number of the range.
CLI::Validator between(double low, double high);

// --out, --json, --check, --quiet, and for commands that run impacts --store and --threads.
void add_common(CLI::App& command, Common& common, bool runs_impacts,
                const std::string& out =
                    "folder for results (default: NAME.out in the working folder, NAME that of "
                    "the input; none: no files)");

// Those of it on runs: --store and --threads.
void add_runs(CLI::App& command, Common& common);

// Of commands whose batches of runs a cluster may make.
void add_cluster(CLI::App& command, Common::Cluster& cluster);

void add_campaign(CLI::App& app, CampaignArguments& campaign, Common& common, std::vector<Command>& commands);
void add_atlas(CLI::App& app, AtlasArguments& atlas, Common& common, std::vector<Command>& commands);
void add_work(CLI::App& app, WorkArguments& work, std::vector<Command>& commands);
void add_fit(CLI::App& app, FitArguments& fit, Common& common, std::vector<Command>& commands);

void add_dose(CLI::App& app, PowderArguments& dose, Common& common, std::vector<Command>& commands);
void add_design(CLI::App& app, PowderArguments& design, Common& common, std::vector<Command>& commands);

// Those of `percal card`.
void add_card(CLI::App& app, CardArguments& card, Common& common, std::vector<Command>& commands);

// Adds them all; what is said goes into the arguments, which must live as long as the commands.
std::vector<Command> add_commands(CLI::App& app, Arguments& a);

DescribedCommand described(const CLI::App& app);

// Prints the help of the command that the words name, that of the program where there are none. Throws BadInput for other words.
Exit print_help(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace percal::tools
