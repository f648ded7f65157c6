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

bool FreshRuns::complete() const {
  return std::ranges::all_of(of_body, [](const auto& body) {
    return std::ranges::all_of(body.second.evaluations, [](const auto& evaluation) { return evaluation.has_value(); });
  });
}

double FreshRuns::worst_spread() const {
  double worst = 0;
  for (const auto& of_hypothesis : of) worst = std::max(worst, spread(of_hypothesis));
  return worst;
}

FreshRuns fresh_runs(const CalibrationJob& job, const FittedHypotheses& fitted, const Emulators& emulators,
                     Campaign& campaign, const Campaign::Deadline& deadline) {
  const int replicates = job.training.verify_replicates;
  std::vector<std::vector<Expected>> shots;
  std::vector<std::vector<Problem>> walks;  // of every shot of every hypothesis
  for (std::size_t k = 0; k < fitted.fits.size(); ++k) {
    shots.push_back(expected(job, fitted, k));
    for (const Expected& shot : shots.back()) {
      walks.push_back(replicates_of(shot.problem, replicates));
      if (replicates == 1)
        walks.back()[0].elements_per_radius =
            drawn_mesh(shot.problem.elements_per_radius, job.training.seed, static_cast<int>(walks.size()) - 1);
    }
  }
  std::vector<Problem> problems;  // round by round; neighbours begin at different phases
  const auto rounds = static_cast<std::size_t>(replicates);
  for (std::size_t r = 0; r < rounds; ++r)
    for (std::size_t w = 0; w < walks.size(); ++w) problems.push_back(walks[w][(r + w) % rounds]);
  Progress progress("fresh runs at the best points", static_cast<long>(problems.size()), deadline);
  const auto evaluations = campaign.evaluate_by(deadline, problems, &progress);

  FreshRuns runs;
  runs.of.resize(shots.size());
  std::size_t place = 0;  // among the walks
  for (std::size_t k = 0; k < shots.size(); ++k)
    for (const Expected& shot : shots[k]) {
      FreshRuns::Made& made = runs.of_body[place_of_body(job.shots[shot.shot])];
      std::vector<std::optional<Evaluation>> of_shot;
      for (std::size_t i = place; i < evaluations.size(); i += walks.size()) {
        made.problems.push_back(problems[i]);
        made.evaluations.push_back(evaluations[i]);
        of_shot.push_back(evaluations[i]);
      }
      if (auto found = summary(job, shot, emulators, of_shot)) runs.of[k].push_back(std::move(*found));
      ++place;
    }
  return runs;
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
