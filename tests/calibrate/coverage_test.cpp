// Do the stated 95 % intervals hold? Depths are made by the solver at known parameters, as means over the mesh's phase with known scatter
// added, and calibrated through an emulator that has never seen those runs.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "calibrate/gel_job.hpp"
#include "percal/calibrate/hypothesis_fit.hpp"
#include "percal/calibrate/job_fit.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/calibrate/training.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/math/distributions.hpp"
#include "percal/math/draws.hpp"
#include "percal/problem/replicates.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

constexpr int mesh = 6;           // elements per radius: of the emulator and of the truth
constexpr double scatter = 0.05;  // of ln depth, of the data made here
constexpr int truths = 10, replicates = 10;
constexpr int phases = 5;  // behind each true depth

CalibrationJob steel_into_gel() {
  CalibrationJob job = test::gel_job(0);
  job.file = job.text = "steel_into_gel";
  const std::array<std::array<double, 2>, 3> box{{{80e3, 800e3}, {5, 11}, {0.4, 1.2}}};
  for (std::size_t k = 0; k < box.size(); ++k) {
    job.parameters[k].free.low = box[k][0];
    job.parameters[k].free.high = box[k][1];
  }
  for (const double diameter : {3.18e-3, 2.39e-3})
    for (const double speed : {50.0, 65.0, 80.0, 95.0, 110.0}) {
      MeasuredShot shot;
      shot.label = "shot";
      shot.radius = diameter / 2;
      shot.density = 7800;
      shot.speed = speed;
      shot.layer_depth = 120 * shot.radius;
      shot.layer_width = 5 * shot.radius;
      shot.depth = 25 * shot.radius;  // about: the design is filled around it
      job.shots.push_back(shot);
    }
  job.training = {.coarse = mesh, .fine = mesh, .verify = mesh, .initial = 200, .batch = 40, .most = 320, .seed = 1};
  return job;
}

// Points inside of the box whose shots all stop in the layer.
std::vector<std::vector<double>> true_points(const CalibrationJob& job, const Emulator& emulator) {
  const auto points = sobol_points(200, 3, 1);
  std::vector<std::vector<double>> found;
  for (int k = 0; k < points.rows() && static_cast<int>(found.size()) < truths; ++k) {
    std::vector<double> natural;
    for (int j = 0; j < 3; ++j) {
      const FreeParameter& p = job.parameters[static_cast<std::size_t>(j)].free;
      const double low = p.searched(p.low), high = p.searched(p.high);
      natural.push_back(p.natural(low + (high - low) * (0.2 + 0.6 * points(k, j))));
    }
    bool inside = true;
    for (const auto& shot : job.shots) {
      const auto at = shot_inputs(shot, material_at(job, job.hypotheses[0], 0, natural)).at;
      const double depth = std::exp(emulator.depth({at}, 1.0 / mesh, false).log_depth[0]);
      inside = inside && depth > 8 && depth < 60;
    }
    if (inside) found.push_back(natural);
  }
  return found;
}

// Log depths of all shots by the solver; nothing where one does not stop.
std::vector<double> solved(const CalibrationJob& job, Campaign& campaign, const std::vector<double>& natural) {
  std::vector<double> log_depths;
  for (const auto& shot : job.shots) {
    const Problem problem = shot_problem(job, shot, material_at(job, job.hypotheses[0], 0, natural), mesh);
    double sum = 0;
    for (const auto& run : campaign.evaluate(replicates_of(problem, phases), nullptr)) {
      if (run.result.outcome != Outcome::stopped) return {};
      sum += std::log(run.result.depth * shot.radius);
    }
    log_depths.push_back(sum / phases);
  }
  return log_depths;
}

class SlowCoverage : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder;
    store_ = new Store(folder_->path("coverage.store"));
    campaign_ = new Campaign(store_, 0);
    job_ = new CalibrationJob(steel_into_gel());
    Training training(*job_, store_, *campaign_, limits_);
    training.fill_space();
    emulator_ = new Emulator(training.emulator());
    for (const auto& natural : true_points(*job_, *emulator_)) {
      auto depths = solved(*job_, *campaign_, natural);
      if (!depths.empty()) truths_.push_back({natural, depths});
    }
  }
  static void TearDownTestSuite() {
    delete emulator_;
    delete job_;
    delete campaign_;
    delete store_;
    delete folder_;
  }

  struct Truth {
    std::vector<double> natural, log_depths;
  };
  // Counts the replicates in which `covered` says that the truth lies in the stated interval.
  struct Count {
    int covered = 0, of = 0;
  };
  template <class Covered>
  Count count(const std::vector<int>& held, Covered covered) const {
    Count result;
    for (std::size_t t = 0; t < truths_.size(); ++t)
      for (int r = 0; r < replicates; ++r) {
        Draws draws(1000 * t + static_cast<unsigned>(r) + 7);
        CalibrationJob job = *job_;
        for (std::size_t i = 0; i < job.shots.size(); ++i)
          job.shots[i].depth = std::exp(truths_[t].log_depths[i] + scatter * draws.normal());
        for (int p : held) job.hypotheses[0].held[p] = truths_[t].natural[static_cast<std::size_t>(p)];
        const JobModel model = finite_element_model(job, job.hypotheses[0], *emulator_, 1.0 / mesh);
        const JobFit fit = fit_job(job, model, used_shots(job), quick_search());
        Eigen::VectorXd truth(static_cast<Eigen::Index>(fit.of_model.size()));
        for (std::size_t k = 0; k < fit.of_model.size(); ++k) {
          const int parameter = model.of_job[fit.of_model[k]];
          truth[static_cast<Eigen::Index>(k)] =
              job.parameters[parameter].free.searched(truths_[t].natural[static_cast<std::size_t>(parameter)]);
        }
        result.covered += covered(fit, truth, truths_[t]);
        ++result.of;
      }
    return result;
  }

  static inline test::TemporaryFolder* folder_;
  static inline Store* store_;
  static inline Campaign* campaign_;
  static inline CalibrationJob* job_;
  static inline Emulator* emulator_;
  static inline CalibrationLimits limits_;
  static inline std::vector<Truth> truths_;
};

TEST_F(SlowCoverage, TheTruthsAreEnough) { EXPECT_GE(truths_.size() * replicates, 90u); }

// 89 to 99 of 100: what a binomial with 95 % does in 98 cases of 100.
TEST_F(SlowCoverage, AModulusThatDepthsDetermineIsWithinItsInterval) {
  const auto [covered, of] = count({1, 2}, [&](const JobFit& fit, const Eigen::VectorXd& truth, const Truth&) {
    const auto interval = profile_intervals(fit.problem, fit.best(), 0.95, quick_search())[0].interval;
    const double mu = fit.problem.parameters[0].natural(truth[0]);
    return interval.low <= mu && mu <= interval.high;
  });
  RecordProperty("covered", covered);
  EXPECT_GE(covered, 0.89 * of) << "of " << of;
  EXPECT_LE(covered, 0.995 * of) << "of " << of;
}

// Modulus and erosion strain move along a curved ridge; what the depths do determine is how deep the shots go in the mean.
TEST_F(SlowCoverage, OnTheRidgeTheDepthThatTheShotsDetermineIsWithinItsInterval) {
  const auto [covered, of] = count({1}, [&](const JobFit& fit, const Eigen::VectorXd&, const Truth& truth) {
    const ModelAnswer answer = fit.problem.model(fit.best().searched, Want::values_and_covariance);
    const auto n = answer.value.size();
    const Eigen::VectorXd mean = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
    const Eigen::VectorXd gradient = answer.jacobian.transpose() * mean;
    const double noise = emulator_->noise(1.0 / mesh);
    const double variance = gradient.dot(fit.best().covariance * gradient) + mean.dot(answer.covariance * mean) +
                            noise * noise / static_cast<double>(n * phases);  // the truth is of that many noisy runs
    const double freedom = effective_degrees_of_freedom(fit.problem, fit.best(), gradient);
    const double off = answer.value.mean() - Eigen::Map<const Eigen::VectorXd>(truth.log_depths.data(), n).mean();
    return std::abs(off) <= student_quantile(0.975, freedom) * std::sqrt(variance);
  });
  RecordProperty("covered", covered);
  EXPECT_GE(covered, 0.89 * of) << "of " << of;
  EXPECT_LE(covered, 0.995 * of) << "of " << of;
}

}  // namespace
}  // namespace percal
