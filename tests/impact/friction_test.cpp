// Impacts with friction.
#include <gtest/gtest.h>

#include <cmath>

#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

Problem rubbing(Problem p, double coefficient) {
  p.friction = CoulombFriction{coefficient};
  return p;
}

TEST(Friction, ADentIsTheShallowerTheMoreFrictionThereIsAndItsEnergyIsATermOfItsOwn) {
  double depth = INFINITY;
  for (const double coefficient : {0.0, 0.1, 0.5}) {
    const ImpactResult result = run_impact(coefficient > 0 ? rubbing(dent(), coefficient) : dent(), 1);
    EXPECT_LT(result.depth, depth) << coefficient;
    EXPECT_LT(std::abs(result.energy.closure()), 1e-3) << coefficient;
    EXPECT_EQ(result.energy.friction > 1e-3, coefficient > 0) << result.energy.friction;
    depth = result.depth;
  }
}

// By the identity that its terms are summed by: docs/theory/impact.md (17b).
TEST(Friction, ItsEnergyIsBookedToSecondOrder) {
  const auto closure = [](double factor) {
    Problem p = rubbing(dent(), 0.2);
    p.time_step_factor = factor;
    return std::abs(run_impact(p, 1).energy.closure());
  };
  const double coarse = closure(0.8), fine = closure(0.2);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(std::log(coarse / fine) / std::log(4), 1.6);
}

TEST(Friction, AnErodingShotClosesAndGoesLessDeep) {
  Problem p = setting_s();
  p.end_time = 8;
  const ImpactResult smooth = run_impact(p, 1), rough = run_impact(rubbing(p, 0.3), 1);
  EXPECT_LT(std::abs(rough.energy.closure()), 3e-3);
  EXPECT_GT(rough.energy.friction, 0.02);
  EXPECT_LT(rough.end_speed, smooth.end_speed);
  EXPECT_EQ(smooth.energy.friction, 0);
}

TEST(Friction, AnyNumberOfThreadsGivesTheSameBits) {
  Problem p = rubbing(setting_s(6), 0.3);
  p.end_time = 5;
  const ImpactResult one = run_impact(p, 1);
  same_bits(run_impact(p, 3), one);
  EXPECT_GT(one.energy.friction, 0);
}

}  // namespace
}  // namespace percal
