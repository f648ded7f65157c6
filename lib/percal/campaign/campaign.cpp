#include "percal/campaign/campaign.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "percal/base/error.hpp"
#include "percal/base/memory.hpp"
#include "percal/base/threads.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/observe/stored_run.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/solid/march/march.hpp"

namespace percal {
namespace {

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Below this many elements a second thread inside a run costs more than it gives.
constexpr double worth_a_thread = 40'000;

ImpactResult in_memory(const Problem& problem, const std::function<ImpactResult()>& run) {
  try {
    return run();
  } catch (const std::bad_alloc&) {
    const RunSize size = size_of(problem);
    throw NoMemory(fmt::format("a run of {:.0f} elements", size.elements), size.bytes);
  }
}

Evaluation run(const Problem& problem, int spare_threads, FrameObserver* observer) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu = thread_cpu_seconds();
  const int threads = std::clamp(static_cast<int>(size_of(problem).elements / worth_a_thread), 1, spare_threads);
  Evaluation evaluation{.result = in_memory(problem,
                                            [&] {
                                              const bool solid = problem.geometry == Geometry::block;
                                              if (observer)
                                                return solid ? run_solid(problem, *observer, threads)
                                                             : run_impact(problem, *observer, threads);
                                              return solid ? run_solid(problem, threads) : run_impact(problem, threads);
                                            }),
                        .instruction_level = instruction_level()};
  evaluation.cpu_seconds = thread_cpu_seconds() - cpu + evaluation.result.helper_cpu_seconds;
  evaluation.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return evaluation;
}

// Ends a run from within where the campaign is asked to stop; looks on for another observer, which may be null.
class StopWatch : public FrameObserver {
 public:
  StopWatch(const std::function<bool()>& wanted, FrameObserver* other) : wanted_(wanted), other_(other) {}
  bool is_due(const Moment& now) override {
    if (wanted_()) throw Interrupted();
    return other_ && other_->is_due(now);
  }
  void see(const Frame& frame) override {
    if (other_) other_->see(frame);
  }

 private:
  const std::function<bool()>& wanted_;
  FrameObserver* const other_;
};

}  // namespace

// A store of another program's making: to be told, not to be run over.
Evaluation Campaign::read(const StoredEvaluation& stored) const {
  try {
    return from_payload(stored.payload);
  } catch (const std::invalid_argument& error) {
    throw IoFailure(fmt::format("{}: {}; remove the file or name another store", store_->path(), error.what()));
  }
}

double work_of(const Problem& problem) {
  const RunSize size = size_of(problem);
  return size.elements * size.steps;
}

StoredEvaluation as_stored(const Evaluation& evaluation) {
  return {word(evaluation.result.outcome), to_payload(evaluation), evaluation.cpu_seconds};
}

struct Campaign::Books {
  std::mutex mutex;
  CampaignCost cost;
  std::set<std::string> made_elsewhere;  // keys that were not counted yet
  double work = 0, wall_seconds = 0;     // of the runs done here

  void add(const Problem& problem, const Evaluation& evaluation) {
    const std::lock_guard lock(mutex);
    ++cost.runs;
    cost.cpu_seconds += evaluation.cpu_seconds;
    work += work_of(problem);
    wall_seconds += evaluation.wall_seconds;
  }
  void add_found(const std::string& key, double cpu_seconds) {
    const std::lock_guard lock(mutex);
    if (made_elsewhere.erase(key) == 0) {
      ++cost.reused;
      return;
    }
    ++cost.runs;
    cost.cpu_seconds += cpu_seconds;
  }
  double expected_seconds(const Problem& problem) {
    const std::lock_guard lock(mutex);
    return work > 0 ? wall_seconds / work * work_of(problem) : 0;
  }
};

// A problem with its key. One with an observer or a history is never taken from the store.
struct Campaign::Task {
  const Problem& problem;
  FrameObserver* observer;  // may be null
  std::string key;
  bool is_shared = false;  // by the store
};

Campaign::Task Campaign::task_of(const Problem& problem, FrameObserver* observer) const {
  return {problem, observer, evaluation_key(problem, instruction_level()),
          store_ && !observer && problem.history_samples == 0};
}

// What came of asking for an evaluation once: it is there, another thread or process is at it, or there is no time for it.
struct Campaign::Attempt {
  enum { done, busy, too_late } end = done;
  std::optional<Evaluation> evaluation = {};
};

Campaign::Campaign(Store* store, int threads)
    : store_(store), threads_(threads > 0 ? threads : threads_of_this_machine()), books_(std::make_shared<Books>()) {}

// `knows_less`: the store has it, but of somebody who asked for less.
std::optional<Campaign::Attempt> Campaign::stored(const Task& task, bool& knows_less) {
  const auto found = store_->find(task.key);
  if (!found) return std::nullopt;
  Evaluation evaluation = read(*found);
  knows_less = lacks_something(evaluation.result, task.problem);
  if (knows_less) return std::nullopt;
  books_->add_found(task.key, evaluation.cpu_seconds);
  return Attempt{.evaluation = std::move(evaluation)};
}

Campaign::Attempt Campaign::run_unless_too_late(const Task& task, int threads, const Deadline& deadline,
                                                bool stored_knows_less) {
  if (deadline) {
    const std::chrono::duration<double> left = *deadline - std::chrono::steady_clock::now();
    if (left.count() < books_->expected_seconds(task.problem)) return {.end = Attempt::too_late};
  }
  StopWatch watch(stop_wanted_, task.observer);
  Evaluation evaluation = run(task.problem, threads, stop_wanted_ ? &watch : task.observer);
  if (store_) {
    const StoredEvaluation row = as_stored(evaluation);
    stored_knows_less ? store_->replace(task.key, row) : store_->put(task.key, row);
  }
  books_->add(task.problem, evaluation);
  return {.evaluation = std::move(evaluation)};
}

Campaign::Attempt Campaign::attempt(const Task& task, int threads, const Deadline& deadline) {
  if (stop_wanted_ && stop_wanted_()) throw Interrupted();
  bool knows_less = false;
  if (!task.is_shared) return run_unless_too_late(task, threads, deadline, knows_less);
  if (auto found = stored(task, knows_less)) return std::move(*found);
  const auto claim = store_->claim(task.key);
  if (!claim) {
    const bool too_late = deadline && std::chrono::steady_clock::now() >= *deadline;
    return {.end = too_late ? Attempt::too_late : Attempt::busy};
  }
  if (auto found = stored(task, knows_less)) return std::move(*found);  // finished since
  return run_unless_too_late(task, threads, deadline, knows_less);
}

namespace {

constexpr std::size_t worth_the_way = 4;                   // runs
constexpr std::chrono::milliseconds between_attempts{20};  // at what others are at

// Problems that are the same are evaluated once; those that ask for more than their key says, apart from those that do not.
struct Distinct {
  std::vector<std::size_t> stands_for;  // of each problem, the first that is the same
  std::vector<std::size_t> first;       // those, in order
};

template <class Tasks>
Distinct distinct_among(const Tasks& tasks) {
  Distinct distinct;
  std::map<std::string, std::size_t> first_with_key;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    std::string key = tasks[i].key;
    if (tasks[i].problem.history_samples > 0) key += " history";
    if (tasks[i].problem.channel) key += " channel";
    if (tasks[i].problem.half_speed_depth) key += " half speed";
    const auto [place, is_new] = first_with_key.try_emplace(key, i);
    distinct.stands_for.push_back(place->second);
    if (is_new) distinct.first.push_back(i);
  }
  return distinct;
}

// The longest first: what is left for the end is short, and the threads end together.
void put_longest_first(std::vector<std::size_t>& order, const std::vector<Problem>& problems) {
  std::vector<double> work;
  for (const Problem& problem : problems) work.push_back(work_of(problem));
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
}

}  // namespace

Evaluation Campaign::evaluate(const Problem& problem) {
  const Task task = task_of(problem, nullptr);
  for (;;) {
    if (const Attempt found = attempt(task, 1, {}); found.evaluation) return *found.evaluation;
    std::this_thread::sleep_for(between_attempts);
  }
}

std::vector<Evaluation> Campaign::evaluate(const std::vector<Problem>& problems, Progress* progress,
                                           const Watch& watch) {
  std::vector<Evaluation> all;
  for (auto& evaluation : evaluate(problems, progress, watch, {})) all.push_back(std::move(*evaluation));
  return all;
}

std::vector<std::optional<Evaluation>> Campaign::evaluate_by(const Deadline& deadline,
                                                             const std::vector<Problem>& problems, Progress* progress) {
  return evaluate(problems, progress, {}, deadline);
}

// Those of `left` that the store lacks, where there are enough of them to be worth the way. Their keys; `progress` knows of them.
std::set<std::string> Campaign::make_elsewhere(const std::vector<Task>& tasks, const std::vector<std::size_t>& left,
                                               Progress* progress) {
  if (!elsewhere_) return {};
  std::vector<Problem> missing;
  std::set<std::string> keys;
  for (const std::size_t k : left) {
    if (!tasks[k].is_shared || store_->find(tasks[k].key)) continue;
    missing.push_back(tasks[k].problem);
    keys.insert(tasks[k].key);
  }
  if (missing.size() < worth_the_way) return {};
  elsewhere_->make(missing, progress);
  const std::lock_guard lock(books_->mutex);
  books_->made_elsewhere.insert(keys.begin(), keys.end());
  return keys;
}

std::vector<std::optional<Evaluation>> Campaign::evaluate(const std::vector<Problem>& problems, Progress* progress,
                                                          const Watch& watch, const Deadline& deadline) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < problems.size(); ++i)
    tasks.push_back(task_of(problems[i], i == watch.problem ? watch.observer : nullptr));
  const Distinct distinct = distinct_among(tasks);
  std::vector<std::size_t> left = distinct.first;
  if (!deadline) put_longest_first(left, problems);
  std::vector<std::optional<Evaluation>> results(problems.size());
  const std::set<std::string> told = make_elsewhere(tasks, left, progress);
  const int threads_each = std::max(1, threads_ / std::max(1, static_cast<int>(left.size())));
  MemoryRoom room(memory_.value_or(available_memory()));
  // What others are at is left to them, and asked for again when all the rest is done.
  for (std::vector<std::size_t> busy; !left.empty(); left = std::exchange(busy, {})) {
    std::mutex mutex;
    side_by_side(static_cast<int>(left.size()), [&](int k) {
      const Task& task = tasks[left[k]];
      const MemoryRoom::Place place(room, size_of(task.problem).bytes);
      Attempt found = attempt(task, threads_each, deadline);
      if (found.end == Attempt::busy) {
        const std::lock_guard lock(mutex);
        busy.push_back(left[k]);
        return;
      }
      const bool ran_here = found.evaluation && !found.evaluation->reused;
      results[left[k]] = std::move(found.evaluation);
      if (progress && !told.contains(task.key)) progress->add(1, ran_here ? work_of(task.problem) : 0);
    });
    if (busy.size() == left.size()) std::this_thread::sleep_for(between_attempts);
  }
  for (std::size_t i = 0; i < problems.size(); ++i)
    if (const std::size_t same = distinct.stands_for[i]; same != i) {
      results[i] = results[same];
      if (progress) progress->add();
    }
  return results;
}

std::vector<std::vector<Evaluation>> Campaign::replicate(const std::vector<Problem>& problems, int replicates,
                                                         Progress* progress) {
  std::vector<Problem> all;
  for (const Problem& problem : problems)
    for (Problem& one : replicates_of(problem, replicates)) all.push_back(std::move(one));
  const auto flat = evaluate(all, progress);
  std::vector<std::vector<Evaluation>> grouped(problems.size());
  for (std::size_t i = 0; i < flat.size(); ++i) grouped[i / replicates].push_back(flat[i]);
  return grouped;
}

void Campaign::side_by_side(int count, const std::function<void(int)>& work) const {
  percal::side_by_side(threads_, count, work);
}

CampaignCost Campaign::cost() const {
  const std::lock_guard lock(books_->mutex);
  return books_->cost;
}

}  // namespace percal
