// Impacts faster than the target's waves, in a K that stays as given.
#include <gtest/gtest.h>

#include <cmath>

#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/settings.hpp"
#include "percal/impact/target/constants.hpp"

namespace percal {
namespace {

Problem fast(double pi4, int elements_per_radius = 5) {
  Problem p = setting_s(elements_per_radius);
  p.pi4 = pi4;
  p.depth = 20;
  return p;
}

TEST(Supersonic, ImpactsEndAsANamedOutcomeWithTheirEnergyAccountedFor) {
  for (const double pi4 : {60.0, 240.0, 1000.0, 10000.0})
    for (const int rates : {1, 2}) {
      Problem p = fast(pi4);
      p.rates = rates;
      EXPECT_GT(mach_number(p), 1);
      const ImpactResult result = run_impact(p);
      EXPECT_TRUE(result.outcome == Outcome::stopped || result.outcome == Outcome::passed_through)
          << pi4 << ": " << word(result.outcome) << " " << result.reason;
      EXPECT_LT(std::abs(result.energy.closure()), 0.05) << pi4 << ", " << rates << " rates";
      for (const double number :
           {result.depth, result.end_speed, result.end_time, result.smallest_jacobian, result.smallest_step})
        EXPECT_TRUE(std::isfinite(number)) << pi4;
      for (const auto& [key, share, words] : energy_terms) EXPECT_TRUE(std::isfinite(result.energy.*share)) << key;
      EXPECT_GT(result.energy.viscosity, 0.02) << "shocks dissipate";
    }
}

// Nodes that take the long step meet the particle once in it: were it half a row in the short one only, elements would be crushed
// from one look to the next, and go with energies that nothing gave them.
TEST(Supersonic, ALongStepCrushesNoElementUnseen) {
  Problem p = fast(1000, 7);
  p.graded_columns = 12;
  const ImpactResult result = run_impact(p);
  EXPECT_NE(result.outcome, Outcome::unstable) << result.reason;
  EXPECT_LT(std::abs(result.energy.closure()), 0.01);
}

TEST(Supersonic, TheFasterTheDeeperInALayerThatHoldsThem) {
  double last = 0;
  for (const double pi4 : {20.0, 60.0, 240.0}) {
    Problem p = fast(pi4);
    p.depth = 60;
    p.density_ratio = 2;
    const ImpactResult result = run_impact(p);
    ASSERT_EQ(result.outcome, Outcome::stopped) << pi4;
    EXPECT_GT(result.depth, last);
    last = result.depth;
  }
}

TEST(Supersonic, ShockViscosityAndASmallerStepComeWithTheMachNumber) {
  Problem p = setting_s(5);
  const auto shock = [](const Problem& at) {
    return constants_of_layers(at).front().quadratic_viscosity >= supersonic_quadratic * supersonic_quadratic &&
           step_limits(at).time_step_factor <= supersonic_step;
  };
  p.bulk_ratio = p.pi4 - 4.0 / 3 + 0.01;
  EXPECT_LT(mach_number(p), 1);
  EXPECT_FALSE(shock(p));
  p.speed_factor = 1.01;
  EXPECT_TRUE(shock(p)) << "the replicate's own speed counts";
  p.speed_factor = 1;
  p.bulk_ratio = p.pi4 - 4.0 / 3 - 0.01;
  EXPECT_GT(mach_number(p), 1);
  EXPECT_TRUE(shock(p));
  EXPECT_EQ(constants_of_layers(p).front().bulk, p.bulk()) << "K stays as given";
  p.quadratic_viscosity = 3;
  p.time_step_factor = 0.2;
  EXPECT_EQ(constants_of_layers(p).front().quadratic_viscosity, 9) << "more viscosity is kept";
  EXPECT_EQ(step_limits(p).time_step_factor, 0.2) << "and a smaller step";
}

}  // namespace
}  // namespace percal
