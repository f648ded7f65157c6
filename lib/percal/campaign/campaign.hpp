// Many evaluations: what the store has is taken from there, the rest runs side by side, one run on each core, as many as fit into
// memory; where there are fewer runs than cores, large ones get several. The bits are the same. Processes that share a store share
// the work: what one is at, the others leave to it and take from the store (docs/decisions/0020-claims.md).
#pragma once
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "percal/base/progress.hpp"
#include "percal/impact/frame.hpp"
#include "percal/observe/penetration.hpp"
#include "percal/problem/problem.hpp"
#include "percal/store/store.hpp"

namespace percal {

struct CampaignCost {
  long runs = 0;           // done here
  long reused = 0;         // taken from the store
  double cpu_seconds = 0;  // of the runs done here
};

// An observer of one run of a batch, which is then never taken from the store; it is called from the thread that runs it.
struct Watch {
  FrameObserver* observer = nullptr;
  std::size_t problem = 0;
};

// As a store keeps it.
StoredEvaluation as_stored(const Evaluation& evaluation);

// Where runs of a batch are made before this process looks for them in its store: a cluster.
class Elsewhere {
 public:
  virtual ~Elsewhere() = default;
  // Problems that the store lacks, the longest first: it has them all when this returns. `progress` is told of each; it may be null.
  virtual void make(const std::vector<Problem>& problems, Progress* progress) = 0;
};

// Thrown by a campaign that was asked to stop. What was finished before is in the store.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

// What a run is expected to cost in proportion to: its elements times an upper bound of its steps (impact/target/size.hpp).
double work_of(const Problem& problem);

class Campaign {
 public:
  // A store that is null is not used. threads = 0: one for each core.
  Campaign(Store* store, int threads);

  // One problem, on the calling thread. Finished evaluations are in the store before this returns. A run with a history is
  // never taken from the store, which keeps none.
  Evaluation evaluate(const Problem& problem);

  // A batch, side by side, the longest first; results in the order of the problems, whatever finished first. `progress` may be null;
  // it is told the work_of() each run that is done here.
  std::vector<Evaluation> evaluate(const std::vector<Problem>& problems, Progress* progress, const Watch& watch = {});

  // The same, but a run is begun only where it is expected to be done by the deadline, from what the campaign's runs have cost so
  // far; the first runs of a campaign are begun at once. A result is empty where its run was not begun. Without a deadline, all are.
  using Deadline = std::optional<std::chrono::steady_clock::time_point>;
  std::vector<std::optional<Evaluation>> evaluate_by(const Deadline& deadline, const std::vector<Problem>& problems,
                                                     Progress* progress);

  // The replicates of each problem (problem/replicates.hpp): results[i] belongs to problems[i].
  std::vector<std::vector<Evaluation>> replicate(const std::vector<Problem>& problems, int replicates,
                                                 Progress* progress);

  // work(0) ... work(count - 1), each on one of the threads. The first exception ends the rest and is thrown here.
  void side_by_side(int count, const std::function<void(int)>& work) const;

  // Runs of a batch go side by side as long as they fit into so many bytes; left out, into what is available when it begins.
  void keep_within(double bytes) { memory_ = bytes; }

  // Batches of several runs are made there; what is asked for one by one is not. Kept by the caller.
  void have_made(Elsewhere& elsewhere) { elsewhere_ = &elsewhere; }

  // Asked before each run and at its every step, from several threads at once; where it answers yes, the run ends and Interrupted is
  // thrown.
  void stop_when(std::function<bool()> wanted) { stop_wanted_ = std::move(wanted); }

  CampaignCost cost() const;
  int threads() const { return threads_; }

 private:
  struct Task;
  struct Attempt;
  Task task_of(const Problem& problem, FrameObserver* observer) const;
  Attempt attempt(const Task& task, int threads, const Deadline& deadline);
  Attempt run_unless_too_late(const Task& task, int threads, const Deadline& deadline, bool stored_knows_less);
  std::optional<Attempt> stored(const Task& task, bool& knows_less);
  std::vector<std::optional<Evaluation>> evaluate(const std::vector<Problem>& problems, Progress* progress,
                                                  const Watch& watch, const Deadline& deadline);
  std::set<std::string> make_elsewhere(const std::vector<Task>& tasks, const std::vector<std::size_t>& left,
                                       Progress* progress);
  Evaluation read(const StoredEvaluation& stored) const;

  struct Books;
  Store* store_;
  int threads_;
  std::function<bool()> stop_wanted_;  // may be empty
  std::optional<double> memory_;       // bytes
  Elsewhere* elsewhere_ = nullptr;     // none: all runs are made here
  std::shared_ptr<Books> books_;
};

}  // namespace percal
