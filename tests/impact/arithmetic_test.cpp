// Single against double precision: docs/verification/arithmetic.md has a table of what this prints.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/math/statistics.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

struct Sample {
  std::vector<double> depths;
  double standard_error = 0, seconds = 0;
  EnergyLedger energy;  // mean
};

constexpr int replicates = 20;

Sample run_sample(Problem problem, Arithmetic arithmetic) {
  problem.arithmetic = arithmetic;
  Sample sample;
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < replicates; ++k) {
    problem.speed_factor = replicate_speed_factor(k);
    const ImpactResult result = run_impact(problem);
    EXPECT_EQ(result.outcome, Outcome::stopped) << "replicate " << k;
    sample.depths.push_back(result.depth);
    for (double EnergyLedger::*share : {&EnergyLedger::live_kinetic, &EnergyLedger::elastic, &EnergyLedger::viscosity,
                                        &EnergyLedger::eroded, &EnergyLedger::collisions, &EnergyLedger::freed_mass})
      sample.energy.*share += result.energy.*share / replicates;
  }
  sample.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  sample.standard_error = sample_deviation(sample.depths) / std::sqrt(replicates);
  return sample;
}

class SlowArithmetic : public testing::TestWithParam<int> {};

TEST_P(SlowArithmetic, SinglePrecisionGivesTheDepthOfDouble) {
  const Problem problem = setting_s(GetParam());
  const Sample single = run_sample(problem, Arithmetic::single_precision),
               twice = run_sample(problem, Arithmetic::double_precision);
  const double difference = mean(single.depths) - mean(twice.depths);
  const double error = std::hypot(single.standard_error, twice.standard_error);
  std::printf("| %d | %.2f ± %.2f | %.2f ± %.2f | %+.2f ± %.2f | %.1f | %s\n", GetParam(), mean(single.depths),
              single.standard_error, mean(twice.depths), twice.standard_error, difference, error,
              twice.seconds / single.seconds, instruction_level().c_str());
  EXPECT_LT(std::abs(difference), 3 * error);
  for (const auto& [name, share] : {std::pair{"live kinetic", &EnergyLedger::live_kinetic},
                                    {"elastic", &EnergyLedger::elastic},
                                    {"viscosity", &EnergyLedger::viscosity},
                                    {"eroded", &EnergyLedger::eroded},
                                    {"collisions", &EnergyLedger::collisions},
                                    {"freed mass", &EnergyLedger::freed_mass}}) {
    std::printf("  %-16s %.4f %.4f\n", name, single.energy.*share, twice.energy.*share);
    EXPECT_NEAR(single.energy.*share, twice.energy.*share, 0.01) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(SlowMeshes, SlowArithmetic, testing::Values(7, 10));

}  // namespace
}  // namespace percal
