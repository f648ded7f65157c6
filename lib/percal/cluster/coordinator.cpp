#include "percal/cluster/coordinator.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

#include "percal/base/error.hpp"

namespace percal {
namespace {

constexpr double work_of_task = 60 * 80e6;  // element-steps: about a minute
constexpr int most_losses = 3;              // of one evaluation
constexpr std::chrono::milliseconds between_looks{500};
constexpr std::chrono::seconds between_questions{5};  // to Slurm

Claims::Claim claim_of(Claims& claims, const std::string& folder) {
  auto claim = claims.claim("coordinator");
  if (!claim) throw IoFailure(folder + ": another percal hands work over from this folder; name another one");
  return std::move(*claim);
}

}  // namespace

std::vector<std::vector<std::string>> in_tasks(const std::vector<Problem>& problems, const SlurmOptions& options) {
  std::vector<std::vector<std::string>> tasks;
  double work = INFINITY;
  for (const Problem& problem : problems) {
    const bool full = options.batch > 0 ? tasks.empty() || static_cast<int>(tasks.back().size()) >= options.batch
                                        : work + work_of(problem) > work_of_task;
    if (full) {
      tasks.emplace_back();
      work = 0;
    }
    tasks.back().push_back(evaluation_key(problem, options.level));
    work += work_of(problem);
  }
  return tasks;
}

Coordinator::Coordinator(SlurmOptions options, Store& store)
    : options_(std::move(options)),
      folder_(options_.folder),
      claims_(folder_.path() + "/coordinator"),
      here_(claim_of(claims_, folder_.path())),
      store_(store),
      most_tasks_(most_tasks_of_array()) {
  options_.folder = folder_.path();
}

// Into the store first, then gone from the folder: whoever is killed between the two finds it in both.
void Coordinator::take_in(Missing& missing, Progress* progress) {
  for (const KeyedEvaluation& result : folder_.results()) {
    store_.put(result.key, result.evaluation);
    folder_.remove_result(result.key);
    const auto found = missing.find(result.key);
    if (found == missing.end()) continue;
    if (progress) progress->add(1, found->second);
    missing.erase(found);
  }
}

std::set<std::string> Coordinator::at_work() const {
  std::set<std::string> keys;
  for (const auto& [array, task] : live_tasks(folder_.path()))
    for (std::string& key : folder_.list(array, task)) keys.insert(std::move(key));
  return keys;
}

void Coordinator::hand_over(const std::vector<Problem>& problems) {
  const auto tasks = in_tasks(problems, options_);
  for (std::size_t first = 0; first < tasks.size(); first += static_cast<std::size_t>(most_tasks_)) {
    const std::size_t count = std::min(tasks.size() - first, static_cast<std::size_t>(most_tasks_));
    const std::string array = fmt::format("{}-{}-{}", std::time(nullptr), getpid(), first);
    for (std::size_t k = 0; k < count; ++k) folder_.write_list(array, static_cast<int>(k), tasks[first + k]);
    submit(array_script(options_, array, static_cast<int>(count)));
  }
}

void Coordinator::make(const std::vector<Problem>& problems, Progress* progress) {
  Missing missing;
  for (const Problem& problem : problems) missing.emplace(evaluation_key(problem, options_.level), work_of(problem));
  const auto among_missing = [&](const std::set<std::string>& without) {
    std::vector<Problem> some;
    for (const Problem& problem : problems)
      if (const std::string key = evaluation_key(problem, options_.level);
          missing.contains(key) && !without.contains(key))
        some.push_back(problem);
    return some;
  };
  take_in(missing, progress);
  if (missing.empty()) return;
  const std::set<std::string> begun = at_work();
  take_in(missing, progress);  // what was finished since
  if (const auto idle = among_missing(begun); !idle.empty()) hand_over(idle);
  auto asked = std::chrono::steady_clock::now();
  while (!missing.empty()) {
    std::this_thread::sleep_for(between_looks);
    take_in(missing, progress);
    if (missing.empty() || std::chrono::steady_clock::now() < asked + between_questions) continue;
    // What no task is at was lost, unless its file came between the question and now.
    const std::set<std::string> busy = at_work();
    take_in(missing, progress);
    const auto lost = among_missing(busy);
    for (const Problem& problem : lost)
      if (++losses_[evaluation_key(problem, options_.level)] > most_losses)
        throw IoFailure(
            fmt::format("{} evaluations were handed over {} times and never came back; what the tasks said is in {}",
                        lost.size(), most_losses + 1, folder_.log_folder()));
    if (!lost.empty()) hand_over(lost);
    asked = std::chrono::steady_clock::now();
  }
}

}  // namespace percal
