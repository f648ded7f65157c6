// The runs behind one emulator: a space-filling design first, then runs where they make the answer surer. docs/theory/emulator.md
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "percal/calibrate/calibration.hpp"

namespace percal {

// The name of the store's note of which runs of other jobs a job has learnt from. Each solver version and instruction level sees runs
// of its own, whose keys begin with `key_prefix`, and keeps a note of its own.
std::string foreign_note(const CalibrationJob& job, const std::string& key_prefix);

// One design for all hypotheses and each body that was shot, and one emulator for each number that its shots tell. Of spheres, runs of the atlas that are like the data are its beginning, where there are such. Runs of other jobs that the store has for the job's setting of the solver are taken in
// once, when the job first starts, and written down: whoever goes on with the job later starts from the same ones.
class Training {
 public:
  Training(const CalibrationJob& job, Store* store, Campaign& campaign, const CalibrationLimits& limits);

  // Of each body Sobol points over the parameters' box and its shots; once there is an emulator, those alone whose depth is anywhere near
  // the measured one. Then more of them for a number beside the depth that too few runs have told.
  void fill_space();

  // One more batch for a body. `targets`: depths of its that have to be known; weight: 1/(variance of their data).
  struct Target {
    SphereInputs at;
    double weight = 1;
    RunNumber number = RunNumber::depth;
  };
  // One run to choose from, at a target's own inputs, on the coarse or the fine mesh.
  struct Candidate {
    Problem coarse, fine;
    RunNumber number = RunNumber::depth;
  };
  void add_round(int body, const std::vector<Target>& targets, const std::vector<Candidate>& candidates);

  // Runs of a body that were made elsewhere: learnt from like the others.
  void add_runs(int body, const std::vector<Problem>& problems,
                const std::vector<std::optional<Evaluation>>& evaluations);

  bool full(int body) const { return designs_.at(body).runs >= counts_of(body).most; }
  int runs_of_design() const;  // of all bodies
  // The budget's share for runs is over, or the next run would not be done by then.
  bool out_of_time() const { return out_of_time_ || limits_.spent(share_for_training); }
  const Emulator& emulator() const { return *learnt_.at({}).emulator; }  // of spheres' depths
  Emulators emulators() const;
  // Of the depth of each body and every number that the job's shots tell.
  bool has_emulator() const;
  EmulatorReport& report() { return report_; }
  // Which body, or number beside the depth, too few runs told for an emulator, with their counts; empty where there is none.
  std::string untold() const;
  // The counts in words where more runs failed than the job tolerates: a numerical outcome.
  std::optional<std::string> failures() const;

 private:
  // What one emulator is learnt from.
  struct Learnt {
    std::vector<TrainingRun> runs = {};  // log_depth: of a number beside the depth, what is learnt of it
    int without = 0;                     // runs that were asked for a number beside the depth and do not tell it
    std::optional<Emulator> emulator = {};
    int searched_at = 0;
  };
  // Of one body.
  struct Design {
    int runs = 0, next_point = 0;
  };

  std::string setting() const;  // of the job's problems of spheres, any of them
  void take_runs_of_atlas();
  void take_foreign_runs();
  void fill_space(int body);
  void run(int body, const std::vector<Problem>& problems);
  void count(int body, const std::vector<Problem>& problems, const std::vector<std::optional<Evaluation>>& evaluations);
  void learn();
  void take_numbers(const Problem& problem, const ImpactResult& result);
  bool lacks(const Learnt& learnt) const;  // runs, and more of them may help
  RunCounts counts_of(int body) const;
  std::vector<int> shots_of_body(int body) const;
  std::vector<double> numbers_at(const Eigen::RowVectorXd& shares) const;
  bool is_near(const MeasuredShot& shot, const CoveredMaterial& material, const Problem& problem) const;
  std::vector<Problem> space_filling_batch(int body, int count, const std::vector<int>& shots);

  const CalibrationJob& job_;
  const Hypothesis& hypothesis_;  // any: convention and held numbers do not matter here
  Store* store_;
  Campaign& campaign_;
  const CalibrationLimits& limits_;
  std::map<EmulatorOf, Learnt> learnt_;
  std::map<int, Design> designs_;
  std::vector<std::string> taken_;  // keys, so that no run counts twice
  std::set<std::string> told_;      // keys of the runs that numbers beside the depth know
  EmulatorReport report_;
  double least_learnt_;  // ln reach in radii: runs of spheres short of it are no rows
  bool out_of_time_ = false;
  double cpu_seconds_ = 0;
};

}  // namespace percal
