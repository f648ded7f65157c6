#include "percal/study/measured_effects.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "percal/problem/domain.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

// A light sphere that stops within some radii, on few elements.
Reduction shallow() {
  Reduction reduction;
  Problem& p = reduction.problem;
  p.pi4 = 10;
  p.density_ratio = 1.5;
  p.alpha = 5;
  p.erosion = StrainErosion{0.9};
  p.bulk_ratio = subsonic_bulk_ratio(p.pi4);
  p.depth = 12;
  p.elements_per_radius = 4;
  p.graded_columns = usual_graded_columns(p);
  reduction.scales.radius = 1e-3;
  return reduction;
}

TEST(MeasuredEffects, AreTheMeansOfPairsOnTheSameMeshes) {
  const Reduction reduction = shallow();
  Campaign campaign(nullptr, 1);
  const auto runs = campaign.evaluate(replicates_of(reduction.problem, 3), nullptr);
  const auto effects = measured_effects(reduction, runs, campaign, nullptr);
  ASSERT_EQ(effects.size(), 3u);
  EXPECT_EQ(campaign.cost().runs, 3 + effect_runs(3));
  for (const MeasuredEffect& effect : effects) {
    const auto better = campaign.evaluate(replicates_of(with_better(effect.source, reduction.problem), 3), nullptr);
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += 1e-3 * (better[k].result.depth - runs[k].result.depth);
    EXPECT_NEAR(effect.difference, sum / 3, 1e-12);
    EXPECT_NE(effect.difference, 0) << word(effect.source);
    EXPECT_EQ(effect.pairs, 3);
  }
}

TEST(MeasuredEffects, ABetterSettingIsOneAlone) {
  Problem problem = shallow().problem;
  problem.below.push_back({.depth = 1, .mu = 1, .alpha = 2, .bulk_ratio = 60});
  const Problem stiffer = with_better(DepthErrorSource::bulk, problem),
                farther = with_better(DepthErrorSource::wall, problem);
  EXPECT_EQ(stiffer.bulk_ratio, 2 * problem.bulk_ratio);
  EXPECT_EQ(stiffer.below[0].bulk_ratio, 120);
  EXPECT_EQ(stiffer.width, problem.width);
  EXPECT_EQ(farther.width, 1.5 * problem.width);
  EXPECT_EQ(farther.graded_columns, usual_graded_columns(farther));
  EXPECT_EQ(with_better(DepthErrorSource::time_step, problem).time_step_factor, problem.time_step_factor / 2);
}

}  // namespace
}  // namespace percal
