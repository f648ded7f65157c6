// Two time steps against one: docs/decisions/0006-two-rates.md.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/math/statistics.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

TEST(Rates, TwoTakeFewerElementStepsForTheSameTime) {
  Problem p = setting_s(7);
  p.end_time = 5;
  p.rates = 1;
  const ImpactResult one = run_impact(p);
  p.rates = 2;
  const ImpactResult two = run_impact(p);
  EXPECT_LT(two.element_steps, 0.8 * one.element_steps);
  EXPECT_NEAR(two.depth, one.depth, 0.03 * one.depth);
}

TEST(Rates, ThereIsOneWhereNothingErodes) {
  Problem p = dent();
  p.rates = 1;
  const ImpactResult one = run_impact(p);
  p.rates = 2;
  same_bits(run_impact(p), one);
}

// An element too stiff for the long step takes the short one wherever it is; so the stiffest decides over the short step alone, and a
// long one is twice the step of a run at one rate.
TEST(Rates, StiffElementsFarFromTheParticleTakeTheShortStepToo) {
  Problem p = setting_s(7);
  p.rates = 1;
  const ImpactResult one = run_impact(p);
  p.rates = 2;
  const ImpactResult two = run_impact(p);
  EXPECT_LT(one.smallest_step, 0.4) << "there are stiff ones";
  EXPECT_LT(static_cast<double>(two.steps) / two.end_time, 0.57 * static_cast<double>(one.steps) / one.end_time);
}

TEST(Rates, DistortedElementsEndNoRunOfEither) {
  for (const int rates : {1, 2}) {
    Problem p = setting_s(5);
    p.alpha = -6;
    p.pi4 = 20;
    p.end_time = 10;
    p.erosion = StrainErosion{2};
    p.rates = rates;
    const ImpactResult result = run_impact(p);
    EXPECT_NE(result.outcome, Outcome::unstable) << result.reason;
    EXPECT_LT(result.smallest_step, 0.2) << "some are stiff";
    EXPECT_LT(std::abs(result.energy.closure()), 5e-3);
  }
}

struct RatesSample {
  std::vector<double> depths;
  double worst_closure = 0;
  double error() const { return sample_deviation(depths) / std::sqrt(static_cast<double>(depths.size())); }
};
RatesSample sample(Problem p, int rates, int replicates) {
  p.rates = rates;
  RatesSample result;
  for (int k = 0; k < replicates; ++k) {
    p.speed_factor = replicate_speed_factor(k);
    const ImpactResult run = run_impact(p);
    EXPECT_EQ(run.outcome, Outcome::stopped);
    result.depths.push_back(run.depth);
    result.worst_closure = std::max(result.worst_closure, std::abs(run.energy.closure()));
  }
  return result;
}

class SlowRates : public testing::TestWithParam<int> {};

TEST_P(SlowRates, GiveOneMeanDepthWithinTheScatter) {
  const int replicates = GetParam() < 10 ? 30 : 12;
  const Problem p = setting_s(GetParam());
  const RatesSample one = sample(p, 1, replicates), two = sample(p, 2, replicates);
  const double difference = mean(two.depths) - mean(one.depths), error = std::hypot(one.error(), two.error());
  std::printf("| %d | %d | %.2f ± %.2f | %.2f ± %.2f | %+.2f ± %.2f |\n", GetParam(), replicates, mean(one.depths),
              one.error(), mean(two.depths), two.error(), difference, error);
  EXPECT_LT(std::abs(difference), 3 * error);
  EXPECT_LT(error, 0.012 * mean(one.depths)) << "small enough to tell";
  EXPECT_LT(one.worst_closure, 5e-3);
  EXPECT_LT(two.worst_closure, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(SlowMeshes, SlowRates, testing::Values(7, 10));

}  // namespace
}  // namespace percal
