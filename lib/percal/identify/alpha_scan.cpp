#include "percal/identify/alpha_scan.hpp"

#include <algorithm>
#include <cmath>

#include "percal/atlas/expected.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/math/statistics.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

constexpr char label[] = "alpha scan";

struct Score {
  double alpha, mean, error;
};

Score score_at(double alpha, const std::vector<Line>& lines) {
  std::vector<double> deviations;
  for (const Line& line : lines) deviations.push_back(std::abs(std::exp(line.at(alpha)) - 1));
  const double n = static_cast<double>(deviations.size());
  return {alpha, mean(deviations), deviations.size() > 1 ? sample_deviation(deviations) / std::sqrt(n) : 0};
}

// m; none where the particle passed through.
using Depths = std::vector<std::optional<double>>;

Depths mean_depths(Campaign& campaign, const std::vector<Scene>& scenes, int replicates) {
  Depths depths;
  for (const Shooting& shot : shoot(campaign, scenes, replicates, label)) depths.push_back(shot.penetration.depth);
  return depths;
}

// One run each, in phases of the mesh that follow no trend over the scenes.
Depths single_depths(Campaign& campaign, const std::vector<Scene>& scenes) {
  std::vector<Reduction> reductions;
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    constexpr std::size_t stride = 3;
    reductions.push_back(reduce(scenes[i]));
    problems.push_back(replicates_of(reductions.back().problem, usual_replicates)[stride * i % usual_replicates]);
    refuse_what_is_too_large(problems.back(), scenes[i].source);
  }
  Progress progress(label, static_cast<long>(problems.size()));
  const auto runs = campaign.evaluate(problems, &progress);
  Depths depths;
  for (std::size_t i = 0; i < runs.size(); ++i)
    depths.push_back(summarise({runs[i]}, problems[i], reductions[i].scales).depth);
  return depths;
}

// Each pair's depths are smoothed over the candidates: where the atlas knows how much one run scatters, and the smoothed depth would be known well
// enough by one run a candidate, there is no need of more. A job that wants more than the usual ones gets them.
bool mean_of_each_is_needed(const AlphaScan& scan, const std::vector<Scene>& scenes) {
  if (scan.replicates > usual_replicates) return true;
  constexpr double well_enough = 0.015;  // of the depth: what pairs of one depth differ by is several times that
  const auto expected = expected_depth(reduce(scenes[scenes.size() / 2]).problem);
  return !expected || expected->noise > well_enough * std::sqrt(static_cast<double>(scan.candidates.size()));
}

}  // namespace

AlphaFinding choose_alpha(const std::vector<AlphaTrial>& trials, int pairs) {
  double low = 1e300, high = -1e300;
  std::vector<Line> lines;
  for (int pair = 0; pair < pairs; ++pair) {
    std::vector<double> x, y;
    for (const AlphaTrial& trial : trials)
      if (trial.pair == pair) {
        low = std::min(low, trial.alpha);
        high = std::max(high, trial.alpha);
        if (trial.usable) {
          x.push_back(trial.alpha);
          y.push_back(trial.log_misfit);
        }
      }
    if (x.size() >= 2) lines.push_back(linear_trend(x, y));
  }
  if (lines.empty())
    throw BadInput("alpha: no pair of the target gave a depth at two candidates; the scan cannot decide");
  std::vector<Score> scores;
  for (int k = 0; low + k * alpha_step <= high + 1e-9; ++k) scores.push_back(score_at(low + k * alpha_step, lines));
  const Score best =
      *std::min_element(scores.begin(), scores.end(), [](const Score& a, const Score& b) { return a.mean < b.mean; });
  AlphaFinding finding{.alpha = best.alpha,
                       .best = best.alpha,
                       .best_score = best.mean,
                       .score_error = best.error,
                       .score = best.mean,
                       .lowest = best.alpha,
                       .highest = best.alpha,
                       .at_edge = best.alpha == scores.front().alpha || best.alpha == scores.back().alpha,
                       .trials = trials};
  for (const Score& score : scores) {
    finding.scores.push_back({score.alpha, score.mean});
    if (score.mean > best.mean + best.error) continue;
    finding.lowest = std::min(finding.lowest, score.alpha);
    finding.highest = std::max(finding.highest, score.alpha);
  }
  // The mildest hardening: for negative alphas that is the one nearest to 0 too.
  finding.alpha = std::abs(finding.lowest) < std::abs(finding.highest) ? finding.lowest : finding.highest;
  finding.score = score_at(finding.alpha, lines).mean;
  finding.alpha = std::round(finding.alpha / alpha_step) * alpha_step;
  return finding;
}

std::vector<AlphaTrial> run_alpha_trials(Campaign& campaign, const IdentifyJob& job, const AlphaScan& scan) {
  std::vector<AlphaTrial> trials;
  std::vector<Scene> scenes;
  for (const double alpha : scan.candidates)
    for (std::size_t pair = 0; pair < scan.target.size(); ++pair) {
      trials.push_back({.alpha = alpha, .pair = static_cast<int>(pair)});
      const TargetMaterial target{job.tissue.density, scan.target[pair].mu, alpha, scan.target[pair].erosion_strain};
      scenes.push_back(impact_scene(job, job.calibration, target, job.volumetric, scan.elements_per_radius));
    }
  const auto depths = mean_of_each_is_needed(scan, scenes) ? mean_depths(campaign, scenes, scan.replicates)
                                                           : single_depths(campaign, scenes);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].usable = depths[i].has_value();
    if (trials[i].usable) trials[i].log_misfit = std::log(*depths[i] / job.penetration);
  }
  return trials;
}

}  // namespace percal
