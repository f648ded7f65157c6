// What contact by impulses does to whole runs. Where it conserves momentum: momentum_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/math/statistics.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

// How deep a node of a live element lies inside the sphere, at the worst of all long steps.
class DeepestNode : public FrameObserver {
 public:
  bool is_due(const Moment&) override { return true; }
  void see(const Frame& frame) override {
    const auto& target = frame.target;
    int corner = 0;
    for (std::size_t cell = 0; cell < target.ends.size(); ++cell)
      for (; corner < target.ends[cell]; ++corner) {
        if (target.eroded[cell]) continue;
        const Point& at = target.position[target.corners[corner]];
        gap = std::max(gap, 1 - std::hypot(at[0], at[1] + frame.moment.tip - 1));
      }
    ++steps;
  }
  double gap = 0;
  long steps = 0;
};

// A step's own slowing down of the sphere, squared, is what the linear condition leaves.
TEST(Contact, NoNodeIsInsideTheSphereAfterAStep) {
  for (const int rates : {1, 2}) {
    Problem p = setting_s(6);
    p.rates = rates;
    p.end_time = 6;
    p.arithmetic = Arithmetic::double_precision;
    DeepestNode deepest;
    const ImpactResult result = run_impact(p, deepest);
    EXPECT_GT(result.eroded, 50);
    EXPECT_GT(deepest.steps, 50);
    EXPECT_LT(deepest.gap, 1e-4) << rates << " rates";
  }
}

// What meets the particle once and stays costs a fixed share; where nothing erodes nothing is bared.
TEST(Contact, CollisionsAreFewWhereNothingErodes) {
  Problem p = dent();
  p.end_time = 1000;
  p.alpha = 8.5;
  const ImpactResult result = run_impact(p);
  EXPECT_EQ(result.outcome, Outcome::stopped);
  EXPECT_GE(result.energy.collisions, 0);
  EXPECT_LT(result.energy.collisions, 0.02);
  EXPECT_LT(std::abs(result.energy.closure()), 1e-3);
}

// The five runs at 10 per radius; of springs of any stiffness 25.5 to 26.8 (docs/decisions/0013-contact-by-impulses.md).
TEST(Contact, SettingSGoesAsDeepAsWithStiffSprings) {
  Problem p = setting_s(10);
  p.graded_columns = 12;
  double depth = 0, collisions = 0;
  const auto runs = replicates_of(p, 5);
  for (const Problem& run : runs) {
    const ImpactResult result = run_impact(run);
    EXPECT_EQ(result.outcome, Outcome::stopped);
    EXPECT_LT(std::abs(result.energy.closure()), 0.01);
    depth += result.depth / 5;
    collisions += result.energy.collisions / 5;
  }
  RecordProperty("depth", std::to_string(depth));
  RecordProperty("collisions", std::to_string(collisions));
  EXPECT_NEAR(depth, 26, 1);
  EXPECT_GT(collisions, 0.03);
  EXPECT_LT(collisions, 0.2);
}

struct Depths {
  double mean, error;
};
Depths depths(Problem p, double time_step_factor) {
  p.time_step_factor = time_step_factor;
  std::vector<double> found;
  for (const Problem& run : replicates_of(p, 10)) found.push_back(run_impact(run).depth);
  return {mean(found), sample_deviation(found) / std::sqrt(10.0)};
}

// The rate at which a gap closes is as finite as the step, the momentum that it hands over is not.
TEST(SlowContact, TheDepthDoesNotDependOnTheStep) {
  Problem weak = setting_s(7);
  weak.pi4 = 1.813;
  weak.erosion = StrainErosion{0.3};
  for (const Problem& p : {setting_s(7), weak}) {
    const Depths usual = depths(p, 0.9), half = depths(p, 0.45);
    EXPECT_LT(std::abs(half.mean - usual.mean), 3 * std::hypot(half.error, usual.error))
        << usual.mean << " ± " << usual.error << " and " << half.mean << " ± " << half.error;
  }
}

}  // namespace
}  // namespace percal
