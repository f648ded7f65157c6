#include "percal/campaign/campaign.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <new>
#include <stdexcept>

#include "percal/base/error.hpp"
#include "percal/base/threads.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/observe/stored_run.hpp"
#include "percal/problem/replicates.hpp"

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
  Evaluation evaluation{
      .result = in_memory(
          problem, [&] { return observer ? run_impact(problem, *observer, threads) : run_impact(problem, threads); }),
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

namespace {

// What a run is expected to cost in proportion to.
double expected_work(const Problem& problem) {
  const RunSize size = size_of(problem);
  return size.elements * size.steps;
}

}  // namespace

struct Campaign::Books {
  std::mutex mutex;
  CampaignCost cost;
  double work = 0, wall_seconds = 0;  // of the runs done here

  void add(const Problem& problem, const Evaluation& evaluation) {
    const std::lock_guard lock(mutex);
    ++cost.runs;
    cost.cpu_seconds += evaluation.cpu_seconds;
    work += expected_work(problem);
    wall_seconds += evaluation.wall_seconds;
  }
  double expected_seconds(const Problem& problem) {
    const std::lock_guard lock(mutex);
    return work > 0 ? wall_seconds / work * expected_work(problem) : 0;
  }
};

Campaign::Campaign(Store* store, int threads)
    : store_(store), threads_(threads > 0 ? threads : threads_of_this_machine()), books_(std::make_shared<Books>()) {}

Evaluation Campaign::evaluate(const Problem& problem) { return *evaluate(problem, 1, nullptr, {}); }

std::optional<Evaluation> Campaign::evaluate(const Problem& problem, int threads, FrameObserver* observer,
                                             const Deadline& deadline) {
  if (stop_wanted_ && stop_wanted_()) throw Interrupted();
  const std::string key = evaluation_key(problem, instruction_level());
  bool knows_less = false;  // what the store has
  if (store_ && !observer && problem.history_samples == 0) {
    if (const auto stored = store_->find(key)) {
      Evaluation evaluation = read(*stored);
      knows_less = lacks_something(evaluation.result, problem);
      if (!knows_less) {
        const std::lock_guard lock(books_->mutex);
        ++books_->cost.reused;
        return evaluation;
      }
    }
  }
  if (deadline) {
    const std::chrono::duration<double> left = *deadline - std::chrono::steady_clock::now();
    if (left.count() < books_->expected_seconds(problem)) return std::nullopt;
  }
  StopWatch watch(stop_wanted_, observer);
  Evaluation evaluation = run(problem, threads, stop_wanted_ ? &watch : observer);
  if (store_) {
    const StoredEvaluation row{word(evaluation.result.outcome), to_payload(evaluation), evaluation.cpu_seconds};
    knows_less ? store_->replace(key, row) : store_->put(key, row);
  }
  books_->add(problem, evaluation);
  return evaluation;
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

std::vector<std::optional<Evaluation>> Campaign::evaluate(const std::vector<Problem>& problems, Progress* progress,
                                                          const Watch& watch, const Deadline& deadline) {
  // Problems that are the same are evaluated once; those with a history or a channel apart from those without.
  std::map<std::string, std::size_t> first_with_key;
  std::vector<std::size_t> stands_for(problems.size()), distinct;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    std::string key = evaluation_key(problems[i], instruction_level());
    if (problems[i].history_samples > 0) key += " history";
    if (problems[i].channel) key += " channel";
    const auto [place, is_new] = first_with_key.try_emplace(key, i);
    stands_for[i] = place->second;
    if (is_new) distinct.push_back(i);
  }
  std::vector<std::optional<Evaluation>> results(problems.size());
  const int threads_each = std::max(1, threads_ / std::max(1, static_cast<int>(distinct.size())));
  side_by_side(static_cast<int>(distinct.size()), [&](int k) {
    results[distinct[k]] = evaluate(problems[distinct[k]], threads_each,
                                    distinct[k] == watch.problem ? watch.observer : nullptr, deadline);
    if (progress) progress->add();
  });
  for (std::size_t i = 0; i < problems.size(); ++i)
    if (stands_for[i] != i) {
      results[i] = results[stands_for[i]];
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
