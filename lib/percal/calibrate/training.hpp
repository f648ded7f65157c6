// The runs behind one emulator: a space-filling design first, then runs where they make the answer surer. docs/theory/emulator.md
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "percal/calibrate/calibration.hpp"

namespace percal {

// The name of the store's note of which runs of other jobs a job has learnt from. Each solver version and instruction level sees runs
// of its own, whose keys begin with `key_prefix`, and keeps a note of its own.
std::string foreign_note(const CalibrationJob& job, const std::string& key_prefix);

// One design for all hypotheses. Runs of the atlas that are like the data are its beginning, where there are such. Runs of other jobs that the store has for the job's setting of the solver are taken in
// once, when the job first starts, and written down: whoever goes on with the job later starts from the same ones.
class Training {
 public:
  Training(const CalibrationJob& job, Store* store, Campaign& campaign, const CalibrationLimits& limits);

  // Sobol points over the parameters' box and the job's shots; once there is an emulator, those alone whose depth is anywhere near
  // the measured one.
  void fill_space();

  // One more batch. `targets`: depths that have to be known; weight: 1/(variance of their data).
  struct Target {
    SphereInputs at;
    double weight = 1;
  };
  // One run to choose from, at a target's own inputs, on the coarse or the fine mesh.
  struct Candidate {
    Problem coarse, fine;
  };
  void add_round(const std::vector<Target>& targets, const std::vector<Candidate>& candidates);

  // Runs that were made elsewhere: learnt from like the others.
  void add_runs(const std::vector<Problem>& problems, const std::vector<std::optional<Evaluation>>& evaluations);

  bool full() const { return design_runs_ >= job_.training.most; }
  // The budget's share for runs is over, or the next run would not be done by then.
  bool out_of_time() const { return out_of_time_ || limits_.spent(share_for_training); }
  const Emulator& emulator() const { return *emulator_; }
  bool has_emulator() const { return emulator_.has_value(); }
  EmulatorReport& report() { return report_; }
  // The counts in words where more runs failed than the job tolerates: a numerical outcome.
  std::optional<std::string> failures() const;

 private:
  std::string setting() const;  // of the job's problems, any of them
  void take_runs_of_atlas();
  void take_foreign_runs();
  void run(const std::vector<Problem>& problems);
  void count(const std::vector<Problem>& problems, const std::vector<std::optional<Evaluation>>& evaluations);
  void learn();
  std::vector<double> numbers_at(const Eigen::RowVectorXd& shares) const;
  std::vector<Problem> space_filling_batch(int count);

  const CalibrationJob& job_;
  const Hypothesis& hypothesis_;  // any: convention and held numbers do not matter here
  Store* store_;
  Campaign& campaign_;
  const CalibrationLimits& limits_;
  std::vector<TrainingRun> runs_;
  std::vector<std::string> taken_;  // keys, so that no run counts twice
  std::optional<Emulator> emulator_;
  EmulatorReport report_;
  double least_learnt_;  // ln reach in radii: runs short of it are no rows
  int design_runs_ = 0, next_point_ = 0, searched_at_ = 0;
  bool out_of_time_ = false;
  double cpu_seconds_ = 0;
};

}  // namespace percal
