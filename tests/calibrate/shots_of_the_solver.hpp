// Jobs that are made up: shots that the solver makes on a coarse mesh, what a result keeps of a fit, and how often a fit's intervals hold the truth.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "calibrate/gel_job.hpp"
#include "percal/calibrate/kept_model.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/estimate/intervals.hpp"
#include "support/temporary_folder.hpp"

namespace percal::test {

inline const std::vector<double> true_gel{200e3, 8, 0.8};

// A campaign with a store of its own.
struct OwnCampaign {
  TemporaryFolder folder;
  Store store{folder.path("percal.store")};
  Campaign campaign{&store, 0};
};

// Few runs on three elements per radius, as solved_numbers has it, and no bootstrap.
inline void train_coarsely(CalibrationJob& job) {
  job.training = {.coarse = 3, .fine = 3, .verify = 3, .initial = 60, .batch = 30, .most = 240};
  job.bootstrap = 0;
}

// Six steel balls into gel of known alpha and erosion strain, this number seen of each; the numbers are to be made.
inline CalibrationJob steel_balls_told_by(RunNumber number, const std::string& group) {
  CalibrationJob job = gel_job(6);
  job.groups = {{group, true, 0}};
  job.hypotheses[0].held = {{1, true_gel[1]}, {2, true_gel[2]}};
  train_coarsely(job);
  for (MeasuredShot& shot : job.shots) {
    shot.density = 7800;
    shot.speed += 25;
    shot.number = number;
  }
  return job;
}

// m: the shot's number in each of 20 runs over the mesh's phase that tells it, at these natural values.
inline std::vector<double> solved_numbers(const CalibrationJob& job, const MeasuredShot& shot,
                                          const std::vector<double>& natural, Campaign& campaign) {
  const Problem problem = shot_problem(job, shot, material_at(job, job.hypotheses[0], 0, natural), 3);
  const RunNumberKind& kind = kind_of(shot.number);
  std::vector<double> numbers;
  const auto runs = campaign.replicate({problem}, 20, nullptr);
  for (const Evaluation& one : runs[0]) {
    const double over = kind.over_depth ? one.result.depth : 1;
    if (shot.number == RunNumber::depth)
      numbers.push_back(over * shot.radius);
    else if (const auto log_number = kind.log_of(one.result))
      numbers.push_back(over * std::exp(*log_number) * shot.radius);
  }
  return numbers;
}

inline bool holds(const ShotDepth& interval, const MeasuredShot& shot) {
  return interval.low <= shot.depth && shot.depth <= interval.high;
}

// Shots of 45 to 133 m/s, with a second group of scatter.
inline CalibrationJob gel_job_at_speeds(int shots, const std::string& second_group, double element) {
  CalibrationJob job = gel_job(shots);
  for (int k = 0; k < shots; ++k) job.shots[k].speed = 45 + 88.0 * k / (shots - 1);
  job.groups.push_back({second_group, true, 0});
  job.training.verify = 1 / element;
  return job;
}

// What a result keeps of the fit, written and read again.
struct KeptAndRead {
  page::Json json;
  ShotModel read;
};
inline KeptAndRead kept_and_read(const CalibrationJob& job, const Emulators& emulators, const JobModel& model,
                               const JobFit& fit) {
  CalibrationResult result;
  result.hypotheses.resize(1);
  result.hypotheses[0].for_shots = for_shots(job, 0, model, fit);
  const auto kept = kept_model(job, emulators, result);
  const page::Json json{{"command", "calibrate"}, {"shot_model", shot_model_to_json(*kept)}};
  const ShotModel read = shot_model_of(page::Json::parse(json.dump()), "result.json");
  EXPECT_EQ(shot_model_to_json(read), shot_model_to_json(*kept));
  return {json, read};
}

struct HeldTruths {
  int moduli = 0, shots = 0, of_shots = 0;
};

// Of 95 % intervals, 100 of moduli.
inline void expect_about_95_of_100(const HeldTruths& held) {
  testing::Test::RecordProperty("held", held.moduli);
  testing::Test::RecordProperty("within", held.shots);
  EXPECT_GE(held.moduli, 89);
  EXPECT_LE(held.moduli, 99);
  EXPECT_GE(held.shots, 0.89 * held.of_shots);
}

// Of 100 moduli about the true gel's: those in their interval, and of `predicted` shots, which no fit sees, those in theirs. A job is made
// from the truth and a seed.
template <class Make>
HeldTruths held_of_100_moduli(const Emulators& emulators, double element, const std::vector<int>& predicted,
                              const Make& make) {
  HeldTruths held;
  for (int t = 0; t < 100; ++t) {
    std::vector<double> natural = true_gel;
    natural[0] *= std::exp(0.5 * (t / 50.0 - 1));
    CalibrationJob job = make(natural, 100 + static_cast<unsigned>(t));
    job.hypotheses[0].held = {{1, true_gel[1]}, {2, true_gel[2]}};
    for (const int k : predicted) job.shots[k].used = false;
    const JobModel model = finite_element_model(job, job.hypotheses[0], emulators, element);
    const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
    const auto intervals = region_intervals(fit.problem, fit.minima, 0.95, quick_search());
    if (!intervals.empty())
      held.moduli += intervals[0].interval.low <= natural[0] && natural[0] <= intervals[0].interval.high;
    for (const ShotDepth& depth : shot_depths(job, model, fit, predicted)) {
      held.shots += holds(depth, job.shots[depth.shot]);
      ++held.of_shots;
    }
  }
  return held;
}

}  // namespace percal::test
