// Slurm, as far as percal talks to it: arrays of tasks are handed over, and asked for.
#pragma once
#include <set>
#include <string>
#include <utility>

namespace percal {

struct SlurmOptions {
  std::string partition, time;  // as sbatch has them; empty: the cluster's own
  int batch = 0;                // evaluations a task; 0: about a minute's work
  int at_once = 0;              // tasks of an array that may run at once; 0: as many as the cluster lets
  std::string folder;           // that all nodes see
  std::string program;          // percal, as all nodes see it
  std::string level;            // the instruction level that all runs have
};

// What the tasks of a folder are called, so that a coordinator finds them again.
std::string job_prefix(const std::string& folder);

// The script of an array of `tasks` tasks.
std::string array_script(const SlurmOptions& options, const std::string& array, int tasks);

// Hands it over. Throws IoFailure with Slurm's own words.
void submit(const std::string& script);

// A task that waits or runs: the array's name and the task's number in it.
using SlurmTask = std::pair<std::string, int>;
// Those of this folder. Throws IoFailure with Slurm's own words.
std::set<SlurmTask> live_tasks(const std::string& folder);
// The same of what squeue prints.
std::set<SlurmTask> tasks_in(const std::string& printed, const std::string& prefix);

// The most tasks that an array may have here.
int most_tasks_of_array();

}  // namespace percal
