// Evaluations of a batch made on a cluster: handed over as arrays of tasks, taken in as their files come, handed over again where a task was
// lost. Everything that it knows is in the folder and in Slurm's queue: it may be stopped, killed and started again at will.
//                                                                                               docs/decisions/0022-slurm.md
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "percal/base/progress.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/cluster/slurm.hpp"
#include "percal/cluster/work_folder.hpp"
#include "percal/store/store.hpp"

namespace percal {

// Each task's problems, about a minute's work or `batch` of them, in the order given.
std::vector<std::vector<std::string>> in_tasks(const std::vector<Problem>& problems, const SlurmOptions& options);

class Coordinator : public Elsewhere {
 public:
  // Throws IoFailure where the folder cannot be written to, or another coordinator is at it.
  Coordinator(SlurmOptions options, Store& store);

  // Returns when all of them are in the store. Throws IoFailure where one was lost `most_losses` times, or Slurm refuses.
  void make(const std::vector<Problem>& problems, Progress* progress) override;

 private:
  using Missing = std::map<std::string, double>;  // keys, and the work of each
  void take_in(Missing& missing, Progress* progress);
  std::set<std::string> at_work() const;
  void hand_over(const std::vector<Problem>& problems);

  SlurmOptions options_;
  WorkFolder folder_;
  Claims claims_;
  Claims::Claim here_;
  Store& store_;
  int most_tasks_;
  std::map<std::string, int> losses_;
};

}  // namespace percal
