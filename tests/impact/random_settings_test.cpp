// Whatever a scene asks for within reason ends in a way that has a name, and its energy closes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "percal/impact/march/march.hpp"
#include "percal/problem/domain.hpp"

namespace percal {
namespace {

constexpr unsigned seed = 1;

class Drawn {
 public:
  explicit Drawn(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return low + (high - low) * (random_() / 4294967296.0); }
  double between_by_ratio(double low, double high) { return low * std::pow(high / low, between(0, 1)); }

 private:
  std::mt19937 random_;
};

// alpha of -6 to 16, but not next to 0; erosion strain of 0.3 to 2, or none for a fifth; pi4 of 1 to 100; 6 to 12 elements per
// radius; viscosities of none, for a quarter, to three times the default.
Problem random_setting(Drawn& drawn) {
  Problem p;
  const double viscosity = drawn.between(0, 1) < 0.25 ? 0 : drawn.between(0, 3);
  p.linear_viscosity *= viscosity;
  p.quadratic_viscosity *= viscosity;
  do p.alpha = drawn.between(-6, 16);
  while (std::abs(p.alpha) < 0.5);
  const bool erodes = drawn.between(0, 1) > 0.2;
  const double strain = drawn.between_by_ratio(0.3, 2);
  if (erodes) p.erosion = StrainErosion{strain};
  p.pi4 = drawn.between_by_ratio(1, 100);
  p.elements_per_radius = 6 + std::floor(drawn.between(0, 7));
  p.density_ratio = std::array{1.14, 7.6, 16.8}[static_cast<std::size_t>(drawn.between(0, 3))];
  p.bulk_ratio = std::max(least_bulk_ratio, subsonic_bulk_ratio(p.pi4));
  p.depth = 20;
  p.width = 5;
  p.graded_columns = usual_graded_columns(p);
  p.end_time = 40;
  return p;
}

// Nothing takes the energy that squeezed elements swing with: a documented limit (docs/theory/impact.md, "Limits").
bool has_nothing_that_damps(const Problem& p) {
  return p.quadratic_viscosity == 0 && std::holds_alternative<NoErosion>(p.erosion);
}

// Of four hundred. Of those without viscosity and erosion at most one in ten may be unstable, and says so.
TEST(SlowRandomSettings, NoneThatErodesOrIsDampedIsUnstableOrLosesEnergy) {
  Drawn drawn(seed);
  std::vector<double> closures;
  int eroding = 0, undamped = 0, unstable = 0;
  for (int k = 0; k < 400; ++k) {
    const Problem p = random_setting(drawn);
    const ImpactResult result = run_impact(p);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", setting " << k << ": alpha " << p.alpha << ", pi4 "
                                    << p.pi4 << ", " << p.elements_per_radius << " per radius, density ratio "
                                    << p.density_ratio << ", viscosities " << p.linear_viscosity << " and "
                                    << p.quadratic_viscosity);
    if (has_nothing_that_damps(p)) {
      ++undamped;
      unstable += result.outcome == Outcome::unstable;
      EXPECT_TRUE(result.outcome == Outcome::unstable || std::abs(result.energy.closure()) <= 0.05);
      continue;
    }
    EXPECT_NE(result.outcome, Outcome::unstable) << result.reason;
    EXPECT_LE(std::abs(result.energy.closure()), 0.05);
    closures.push_back(std::abs(result.energy.closure()));
    eroding += result.eroded > 0;
  }
  std::ranges::sort(closures);
  std::printf("seed %u: median closure %.4f, of nine in ten below %.4f, worst %.4f\n", seed,
              closures[closures.size() / 2], closures[closures.size() * 9 / 10], closures.back());
  EXPECT_GT(undamped, 10);
  EXPECT_LE(unstable, undamped / 10);
  EXPECT_GT(eroding, 200);
}

}  // namespace
}  // namespace percal
