#include "percal/calibrate/fresh_runs.hpp"

#include <algorithm>
#include <cmath>

#include "percal/calibrate/shot_problem.hpp"
#include "percal/campaign/sphere_runs.hpp"
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
    const CoveredMaterial material = target_at(job, hypothesis, job.targets[shots[s].target], natural);
    all.push_back({fit.shots[s],
                   shot_problem(job, shots[s], material, mesh_of(shots[s], material, job.training.verify)),
                   emulated.value[i], emulated.covariance(i, i)});
  }
  return all;
}

// What was measured of the shot, as a run has it; m.
std::optional<double> number_of_run(const MeasuredShot& shot, const Problem& problem, const ImpactResult& result) {
  const RunNumberKind& kind = kind_of(shot.number);
  const auto over = kind.over_depth ? reach_of(problem, result) : std::optional(1.0);
  if (shot.number == RunNumber::depth || !over) return over ? std::optional(*over * shot.radius) : over;
  const auto log_share = kind.log_of(result);
  return log_share ? std::optional(*over * std::exp(*log_share) * shot.radius) : std::nullopt;
}

// Why it has none.
std::string ending_of(const ImpactResult& result) {
  return result.outcome == Outcome::stopped && result.aftermath ? word(result.aftermath->ending) : word(result.outcome);
}

std::optional<FreshRun> summary(const CalibrationJob& job, const Expected& shot, const Emulators& emulators,
                                const std::vector<std::optional<Evaluation>>& runs) {
  FreshRun fresh{.shot = shot.shot,
                 .elements_per_radius = shot.problem.elements_per_radius,
                 .depth = {},
                 .outcome = word(Outcome::stopped),
                 .emulated = std::exp(shot.log_depth)};
  if (has_erosion_length(job)) fresh.elements_in_length = job.training.verify;
  const MeasuredShot& measured = job.shots[shot.shot];
  const double noise = emulators.noise(emulator_for(measured), 1 / job.training.verify);
  std::vector<double> depths;
  for (const auto& run : runs) {
    if (!run) continue;
    ++fresh.runs;
    const auto number = number_of_run(measured, shot.problem, run->result);
    if (number) depths.push_back(*number);
    if (!number || run->result.outcome != Outcome::stopped) fresh.outcome = ending_of(run->result);
  }
  if (fresh.runs == 0) return std::nullopt;
  if (static_cast<int>(depths.size()) == fresh.runs) {
    fresh.depth = mean(depths);
    fresh.standardised =
        (std::log(*fresh.depth) - shot.log_depth) / std::sqrt(shot.variance + noise * noise / fresh.runs);
  }
  return fresh;
}

}  // namespace

SingleFreshRuns single_fresh_runs(const CalibrationJob& job, const FittedHypotheses& fitted, const Emulators& emulators,
                                  Campaign& campaign, const Campaign::Deadline& deadline) {
  std::vector<Problem> problems;
  std::vector<std::vector<Expected>> shots;
  for (std::size_t k = 0; k < fitted.fits.size(); ++k) {
    shots.push_back(expected(job, fitted, k));
    for (const Expected& shot : shots.back()) {
      const double mesh = shot.problem.elements_per_radius;
      problems.push_back(shot.problem);
      problems.back().elements_per_radius = drawn_mesh(mesh, job.training.seed, static_cast<int>(problems.size()) - 1);
    }
  }
  Progress progress("runs at the best points", static_cast<long>(problems.size()), deadline);
  const auto evaluations = campaign.evaluate_by(deadline, problems, &progress);
  SingleFreshRuns runs;
  std::size_t i = 0;
  for (const auto& of_hypothesis : shots) {
    std::vector<FreshRun> fresh;
    for (const Expected& shot : of_hypothesis) {
      SingleFreshRuns::Made& made = runs.of_body[place_of_body(job.shots[shot.shot])];
      made.problems.push_back(problems[i]);
      made.evaluations.push_back(evaluations[i]);
      if (auto found = summary(job, shot, emulators, {evaluations[i]})) fresh.push_back(std::move(*found));
      ++i;
    }
    runs.worst_spread = std::max(runs.worst_spread, spread(fresh));
  }
  return runs;
}

std::vector<std::vector<FreshRun>> fresh_runs(const CalibrationJob& job, const FittedHypotheses& fitted,
                                              const Emulators& emulators, Campaign& campaign,
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

  std::vector<std::vector<FreshRun>> fresh(shots.size());
  std::size_t place = 0;  // among the walks
  for (std::size_t k = 0; k < shots.size(); ++k)
    for (const Expected& shot : shots[k]) {
      std::vector<std::optional<Evaluation>> of_shot;
      for (std::size_t i = place; i < runs.size(); i += walks.size()) of_shot.push_back(runs[i]);
      if (auto found = summary(job, shot, emulators, of_shot)) fresh[k].push_back(std::move(*found));
      ++place;
    }
  return fresh;
}

double spread(const std::vector<FreshRun>& runs) {
  double sum = 0;
  int count = 0;
  for (const FreshRun& run : runs) {
    if (!run.depth) continue;
    sum += run.standardised * run.standardised;
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

}  // namespace percal
