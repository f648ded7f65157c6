// alpha from known pairs of modulus and erosion strain, all of which should give one penetration.
#pragma once
#include <vector>

#include "percal/identify/impacts.hpp"

namespace percal {

// ln(depth/target) of one pair at one candidate; censored where the particle passed through.
struct AlphaTrial {
  double alpha = 0;
  int pair = 0;
  double log_misfit = 0;
  bool usable = true;
};

// Mean |depth/target - 1| over the pairs at one alpha, of the smoothed depths.
struct AlphaScore {
  double alpha = 0;
  double mean = 0;
};

struct AlphaFinding {
  double alpha = 0;                // the chosen one
  double best = 0;                 // where the score is least
  double best_score = 0;           // mean |depth/target - 1| over the pairs, of the smoothed depths
  double score_error = 0;          // standard error of that mean
  double score = 0;                // of the chosen alpha
  double lowest = 0, highest = 0;  // the alphas whose score is within one standard error of the best
  bool at_edge = false;            // the best alpha is the first or last candidate: the scan should go further
  std::vector<AlphaTrial> trials = {};
  std::vector<AlphaScore> scores = {};  // from the first candidate to the last
};

// Smooths each pair's ln depth by a line in alpha (the trials' noise is larger than the curvature over a scan), scores every
// alpha between the candidates in steps of alpha_step, and takes the least alpha whose score is within one standard error of
// the best: the mildest strain hardening that the target does not tell from the best. docs/decisions/0003-alpha-scan.md
AlphaFinding choose_alpha(const std::vector<AlphaTrial>& trials, int pairs);
inline constexpr double alpha_step = 0.05;

// The trials of a scan: every pair at every candidate.
std::vector<AlphaTrial> run_alpha_trials(Campaign& campaign, const IdentifyJob& job, const AlphaScan& scan);

}  // namespace percal
