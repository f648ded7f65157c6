#include "percal/calibrate/fresh_runs.hpp"

#include <algorithm>
#include <cmath>

#include "percal/calibrate/shot_problem.hpp"
#include "percal/math/statistics.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

// A fitted shot at the best point of a hypothesis: what its runs are to be compared with.
struct Expected {
  int shot = 0;
  Problem problem;
  double log_depth = 0, variance = 0;  // emulated, on the verifying mesh
};

std::vector<Expected> expected(const CalibrationJob& job, const FittedHypotheses& fitted, std::size_t k) {
  const JobModel& model = fitted.models[k];
  const JobFit& fit = fitted.fits[k];
  const Hypothesis& hypothesis = job.hypotheses[k];
  const std::vector<MeasuredShot> shots = shots_of(job, fit.shots);
  const auto natural = natural_values(job, hypothesis, model.of_job, fit.at);
  const ModelAnswer emulated = model.log_depths(fit.at, shots, Want::values_and_covariance);
  std::vector<Expected> all;
  for (std::size_t s = 0; s < shots.size(); ++s) {
    const auto i = static_cast<Eigen::Index>(s);
    const MaterialAt material = material_at(job, hypothesis, shots[s].material, natural);
    all.push_back({fit.shots[s],
                   shot_problem(job, shots[s], material, mesh_of(shots[s], material, job.training.verify)),
                   emulated.value[i], emulated.covariance(i, i)});
  }
  return all;
}

double noise_of(const CalibrationJob& job, const Emulator& emulator) { return emulator.noise(1 / job.training.verify); }

double standardised(double log_depth, const Expected& shot, double noise, std::size_t runs) {
  return (log_depth - shot.log_depth) / std::sqrt(shot.variance + noise * noise / static_cast<double>(runs));
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

std::optional<FreshRun> summary(const CalibrationJob& job, const Expected& shot, double noise,
                                const std::vector<std::optional<Evaluation>>& runs) {
  FreshRun fresh{.shot = shot.shot,
                 .elements_per_radius = shot.problem.elements_per_radius,
                 .depth = {},
                 .outcome = word(Outcome::stopped),
                 .emulated = std::exp(shot.log_depth)};
  if (has_erosion_length(job)) fresh.elements_in_length = job.training.verify;
  std::vector<double> depths;
  for (const auto& run : runs) {
    if (!run) continue;
    ++fresh.runs;
    if (run->result.outcome == Outcome::stopped)
      depths.push_back(run->result.depth * job.shots[shot.shot].radius);
    else
      fresh.outcome = word(run->result.outcome);
  }
  if (fresh.runs == 0) return std::nullopt;
  if (static_cast<int>(depths.size()) == fresh.runs) {
    fresh.depth = mean(depths);
    fresh.standardised = standardised(std::log(*fresh.depth), shot, noise, depths.size());
  }
  return fresh;
}

}  // namespace

std::vector<Problem> single_fresh_problems(const CalibrationJob& job, const FittedHypotheses& fitted) {
  std::vector<Problem> problems;
  for (std::size_t k = 0; k < fitted.fits.size(); ++k)
    for (Expected& shot : expected(job, fitted, k)) {
      const double mesh = shot.problem.elements_per_radius;
      shot.problem.elements_per_radius = drawn_mesh(mesh, job.training.seed, static_cast<int>(problems.size()));
      problems.push_back(std::move(shot.problem));
    }
  return problems;
}

double spread_of_single_runs(const CalibrationJob& job, const FittedHypotheses& fitted, const Emulator& emulator,
                             const std::vector<std::optional<Evaluation>>& runs) {
  const double noise = noise_of(job, emulator);
  double worst = 0;
  std::size_t i = 0;
  for (std::size_t k = 0; k < fitted.fits.size(); ++k) {
    std::vector<double> off;
    for (const Expected& shot : expected(job, fitted, k))
      if (const auto& run = runs[i++]; run && run->result.outcome == Outcome::stopped)
        off.push_back(standardised(std::log(run->result.depth * job.shots[shot.shot].radius), shot, noise, 1));
    worst = std::max(worst, root_mean_square(off));
  }
  return worst;
}

std::vector<std::vector<FreshRun>> fresh_runs(const CalibrationJob& job, const FittedHypotheses& fitted,
                                              const Emulator& emulator, Campaign& campaign,
                                              const Campaign::Deadline& deadline) {
  const auto replicates = static_cast<std::size_t>(job.training.verify_replicates);
  std::vector<std::vector<Expected>> shots;
  std::vector<std::vector<Problem>> walks;  // of every shot of every hypothesis
  for (std::size_t k = 0; k < fitted.fits.size(); ++k) {
    shots.push_back(expected(job, fitted, k));
    for (const Expected& shot : shots.back())
      walks.push_back(replicates_of(shot.problem, job.training.verify_replicates));
  }
  std::vector<Problem> problems;  // round by round; neighbours begin at different phases
  for (std::size_t r = 0; r < replicates; ++r)
    for (std::size_t w = 0; w < walks.size(); ++w) problems.push_back(walks[w][(r + w) % replicates]);
  Progress progress("fresh runs at the best points", static_cast<long>(problems.size()), deadline);
  const auto runs = campaign.evaluate_by(deadline, problems, &progress);

  const double noise = noise_of(job, emulator);
  std::vector<std::vector<FreshRun>> fresh(shots.size());
  std::size_t place = 0;  // among the walks
  for (std::size_t k = 0; k < shots.size(); ++k)
    for (const Expected& shot : shots[k]) {
      std::vector<std::optional<Evaluation>> of_shot;
      for (std::size_t i = place; i < runs.size(); i += walks.size()) of_shot.push_back(runs[i]);
      if (auto found = summary(job, shot, noise, of_shot)) fresh[k].push_back(std::move(*found));
      ++place;
    }
  return fresh;
}

double spread(const std::vector<FreshRun>& runs) {
  std::vector<double> off;
  for (const FreshRun& run : runs)
    if (run.depth) off.push_back(run.standardised);
  return root_mean_square(off);
}

}  // namespace percal
