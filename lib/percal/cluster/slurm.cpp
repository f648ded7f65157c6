#include "percal/cluster/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "percal/base/child_process.hpp"
#include "percal/base/error.hpp"
#include "percal/text/sha256.hpp"

namespace percal {
namespace {

// Prints in these columns, a line a task of an array.
constexpr char task_format[] = "%j %K";

// For a shell, whatever is in it.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return "'" + inside + "'";
}

std::string said_by(const std::vector<std::string>& words, const std::string& input) {
  const auto [ended_well, text] = answer_of(words, input, Complaints::in_answer);
  if (!ended_well)
    throw IoFailure(
        fmt::format("{}: {}", words.front(), text.empty() ? "cannot be started, or does not answer" : text));
  return text;
}

}  // namespace

std::string job_prefix(const std::string& folder) { return "percal-" + sha256(folder).substr(0, 12) + "-"; }

std::string array_script(const SlurmOptions& options, const std::string& array, int tasks) {
  std::string text = "#!/bin/sh\n";
  const auto say = [&](const std::string& option) { text += "#SBATCH " + option + "\n"; };
  say("--job-name=" + job_prefix(options.folder) + array);
  say(fmt::format("--array=0-{}{}", tasks - 1, options.at_once > 0 ? fmt::format("%{}", options.at_once) : ""));
  say("--ntasks=1");
  say("--cpus-per-task=1");
  say("--requeue");
  if (!options.partition.empty()) say("--partition=" + options.partition);
  if (!options.time.empty()) say("--time=" + options.time);
  say("--output=\"" + options.folder + "/log/%x_%a.txt\"");
  text += fmt::format("export PERCAL_ISA={}\n", options.level);
  text += fmt::format("exec {} work {}/\"$SLURM_ARRAY_TASK_ID\"\n", quoted(options.program),
                      quoted(options.folder + "/todo/" + array));
  return text;
}

void submit(const std::string& script) { said_by({"sbatch", "--parsable"}, script); }

std::set<SlurmTask> tasks_in(const std::string& printed, const std::string& prefix) {
  std::set<SlurmTask> tasks;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name;
    int task = 0;
    if (words >> name >> task && name.starts_with(prefix)) tasks.emplace(name.substr(prefix.size()), task);
  }
  return tasks;
}

std::set<SlurmTask> live_tasks(const std::string& folder) {
  return tasks_in(said_by({"squeue", "--me", "--array", "--noheader", "--format", task_format}, ""),
                  job_prefix(folder));
}

int most_tasks_of_array() {
  constexpr int usual = 1000;
  constexpr char name[] = "MaxArraySize";
  const std::string text = said_by({"scontrol", "show", "config"}, "");
  const auto line = text.find(name);
  const auto equals = line == std::string::npos ? line : text.find('=', line);
  if (equals == std::string::npos) return usual;
  return std::max(1, std::atoi(text.c_str() + equals + 1) - 1);  // the largest number of a task is one less
}

}  // namespace percal
