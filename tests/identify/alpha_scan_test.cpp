// The choice of alpha, on trials made up here.
#include "percal/identify/alpha_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace percal {
namespace {

constexpr double slope = -0.08;  // of ln depth against alpha: about what an impact has

// Pairs whose ln depth meets the target at `alpha` plus their own offsets.
std::vector<AlphaTrial> trials_of(double alpha, const std::vector<double>& offsets,
                                  const std::vector<double>& candidates) {
  std::vector<AlphaTrial> trials;
  for (const double candidate : candidates)
    for (std::size_t pair = 0; pair < offsets.size(); ++pair)
      trials.push_back({.alpha = candidate,
                        .pair = static_cast<int>(pair),
                        .log_misfit = slope * (candidate - alpha) + offsets[pair],
                        .usable = true});
  return trials;
}

const std::vector<double> scan{8, 8.2, 8.4, 8.6, 8.8, 9, 9.2};

TEST(ChooseAlpha, RecoversTheAlphaThatTheTrialsWereMadeWith) {
  const auto finding = choose_alpha(trials_of(8.55, {0, 0, 0, 0}, scan), 4);
  EXPECT_NEAR(finding.best, 8.55, 1e-9) << "on the grid of alpha_step, between two candidates";
  EXPECT_NEAR(finding.alpha, 8.55, 1e-9);
  EXPECT_NEAR(finding.best_score, 0, 1e-12);
  EXPECT_FALSE(finding.at_edge);
}

TEST(ChooseAlpha, FindsItThroughTheNoiseOfTheSolver) {
  std::mt19937 random(20090101);
  std::normal_distribution<double> noise(0, 0.02);
  auto trials = trials_of(8.6, {0, 0, 0, 0, 0, 0}, scan);
  for (auto& trial : trials) trial.log_misfit += noise(random);
  const auto finding = choose_alpha(trials, 6);
  EXPECT_NEAR(finding.best, 8.6, 0.15) << "0.02/(0.08 sqrt(42)) is 0.04: four standard errors";
}

TEST(ChooseAlpha, TakesTheMildestAlphaWithinOneStandardErrorOfTheBest) {
  const std::vector<double> offsets{-0.05, 0.07, 0.01, -0.02};
  const auto finding = choose_alpha(trials_of(8.6, offsets, scan), 4);
  const auto score = [&](double alpha) {
    double mean = 0;
    for (const double offset : offsets) mean += std::abs(std::exp(slope * (alpha - 8.6) + offset) - 1) / 4;
    return mean;
  };
  double best = 8;
  for (int k = 0; k <= 24; ++k)
    if (score(8 + 0.05 * k) < score(best)) best = 8 + 0.05 * k;
  double squares = 0;
  for (const double offset : offsets)
    squares += std::pow(std::abs(std::exp(slope * (best - 8.6) + offset) - 1) - score(best), 2);
  const double error = std::sqrt(squares / 3 / 4);
  double mildest = best;
  for (int k = 24; k >= 0; --k)
    if (score(8 + 0.05 * k) <= score(best) + error) mildest = 8 + 0.05 * k;
  ASSERT_LT(mildest, best) << "offsets for which the rule makes a difference";
  EXPECT_NEAR(finding.best, best, 1e-9);
  EXPECT_NEAR(finding.score_error, error, 1e-12);
  EXPECT_NEAR(finding.alpha, mildest, 1e-9);
  EXPECT_NEAR(finding.lowest, mildest, 1e-9);
  EXPECT_GT(finding.highest, finding.best);
  EXPECT_NEAR(finding.score, score(mildest), 1e-12);
  EXPECT_LE(finding.score, finding.best_score + finding.score_error);
}

TEST(ChooseAlpha, SaysWhenTheBestIsAtTheEdgeOfTheScan) {
  EXPECT_TRUE(choose_alpha(trials_of(10.5, {0, 0, 0}, scan), 3).at_edge);
  EXPECT_TRUE(choose_alpha(trials_of(6.0, {0, 0, 0}, scan), 3).at_edge);
  EXPECT_FALSE(choose_alpha(trials_of(8.5, {0, 0, 0}, scan), 3).at_edge);
}

TEST(ChooseAlpha, LeavesOutTrialsWithoutADepth) {
  auto trials = trials_of(8.45, {0, 0, 0}, scan);
  for (auto& trial : trials)
    if (trial.pair == 1 && trial.alpha > 8.7) {
      trial.usable = false;
      trial.log_misfit = 50;
    }
  EXPECT_NEAR(choose_alpha(trials, 3).best, 8.45, 1e-9);
}

TEST(ChooseAlpha, LeavesOutPairsWithFewerThanTwoDepths) {
  auto trials = trials_of(8.45, {0, 0, 3}, scan);
  for (auto& trial : trials)
    if (trial.pair == 2 && trial.alpha > 8.1) trial.usable = false;
  EXPECT_NEAR(choose_alpha(trials, 3).best, 8.45, 1e-9);
}

TEST(ChooseAlpha, RefusesToChooseWithoutAnyDepth) {
  auto trials = trials_of(8.45, {0, 0}, scan);
  for (auto& trial : trials) trial.usable = false;
  EXPECT_THROW(choose_alpha(trials, 2), BadInput);
}

TEST(ChooseAlpha, OfNegativeExponentsTheMildestIsTheOneNearestToZero) {
  std::vector<double> negative;
  for (const double alpha : scan) negative.push_back(-alpha);
  std::sort(negative.begin(), negative.end());
  const auto finding = choose_alpha(trials_of(-8.6, {-0.05, 0.07, 0.01, -0.02}, negative), 4);
  EXPECT_LT(finding.alpha, 0);
  EXPECT_GT(finding.alpha, finding.best);
  EXPECT_NEAR(finding.alpha, finding.highest, 1e-9);
  EXPECT_NEAR(choose_alpha(trials_of(-8.45, {0, 0}, negative), 2).alpha, -8.45, 1e-9);
}

}  // namespace
}  // namespace percal
