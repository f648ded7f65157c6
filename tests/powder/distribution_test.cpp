// Distributions of sizes, densities and speeds, and their classes.
#include "percal/powder/distribution.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "percal/powder/powder.hpp"

namespace percal {
namespace {

// Sums over cells.
struct Sums {
  double share = 0, moment = 0, mean_log = 0, variance_log = 0, weighted_log = 0;
};
Sums sums_of(const std::vector<DistributionCell>& cells) {
  Sums sums;
  for (const DistributionCell& cell : cells) {
    const double middle = std::log(cell.low * cell.high) / 2;
    sums.share += cell.share;
    sums.moment += cell.moment;
    sums.mean_log += cell.share * middle;
    sums.weighted_log += cell.moment * middle;
  }
  for (const DistributionCell& cell : cells)
    sums.variance_log += cell.share * (std::pow(std::log(cell.low * cell.high) / 2 - sums.mean_log, 2) +
                                       std::pow(std::log(cell.high / cell.low), 2) / 12);
  sums.weighted_log /= sums.moment;
  return sums;
}

TEST(DistributionOfParticles, LognormalCellsHaveItsMomentsAndThoseOfItsMass) {
  const Lognormal sizes{2e-6, 0.6};
  for (const auto& cells : {cells_of(sizes, 100, 3), nodes_of(sizes, 16, 3)}) {
    const Sums sums = sums_of(cells);
    EXPECT_NEAR(sums.share, 1, 1e-12);
    EXPECT_NEAR(sums.mean_log, std::log(2e-6), 1e-6);
    EXPECT_NEAR(std::sqrt(sums.variance_log), 0.6, 1e-5);
    EXPECT_NEAR(sums.moment / (8e-18 * std::exp(4.5 * 0.36)), 1, 1e-4);  // <r^3>
    EXPECT_NEAR(sums.weighted_log, std::log(2e-6) + 3 * 0.36, 1e-4);     // Hatch and Choate
  }
}

TEST(DistributionOfParticles, MeanAndDeviationAreThoseOfTheValuesThemselves) {
  const Lognormal sizes = lognormal_of(0.9e-6, 0.6e-6);
  const double s2 = sizes.log_deviation * sizes.log_deviation, mean = sizes.median * std::exp(s2 / 2);
  EXPECT_NEAR(mean / 0.9e-6, 1, 1e-12);
  EXPECT_NEAR(mean * std::sqrt(std::expm1(s2)) / 0.6e-6, 1, 1e-12);
}

TEST(DistributionOfParticles, WeighedSizesAreCountedAndWeighedAgain) {
  const Lognormal weighed{3e-6, 0.4};
  EXPECT_NEAR(sums_of(cells_of(by_number(weighed), 200, 3)).weighted_log, std::log(3e-6), 1e-5);
  const Histogram classes{{1e-6, 2e-6, 0.25}, {2e-6, 4e-6, 0.75}};
  double below = 0, all = 0;
  for (const DistributionCell& cell : cells_of(by_number(classes), 400, 3)) {
    all += cell.moment;
    if (cell.high < 2.0001e-6) below += cell.moment;
  }
  EXPECT_NEAR(below / all, 0.25, 1e-3);
}

TEST(DistributionOfParticles, AHistogramIsEvenWithinItsClassesAndExactAtSingleValues) {
  const Histogram classes{{1e-6, 2e-6, 0.5}, {2e-6, 2e-6, 0.5}};
  const auto cells = cells_of(classes, 100, 3);
  EXPECT_EQ(cells.back().low, cells.back().high);
  EXPECT_NEAR(sums_of(cells).moment, 0.5 * 7e-18 / (3 * std::log(2)) + 0.5 * 8e-18, 1e-24);
  EXPECT_NEAR(median_of(classes), 2e-6, 1e-12);
}

TEST(DistributionOfParticles, ManyValuesAreJoinedAndKeepTheirNumberAndMass) {
  Histogram values;
  double moment = 0;
  for (int k = 0; k < 1000; ++k) {
    const double value = 1e-6 + 1e-9 * k;
    values.push_back({value, value, 1e-3});
    moment += 1e-3 * value * value * value;
  }
  const auto cells = cells_of(values, 90, 3);
  EXPECT_EQ(cells.size(), 90u);
  EXPECT_NEAR(sums_of(cells).share, 1, 1e-12);
  EXPECT_NEAR(sums_of(cells).moment / moment, 1, 1e-12);
  EXPECT_EQ(cells.back().high, values.back().high);
}

TEST(DistributionOfParticles, SpreadGrowsAboutTheMedian) {
  EXPECT_EQ(log_deviation_of(spread_by(Lognormal{2, 0.3}, 2)), 0.6);
  EXPECT_TRUE(is_one_value(spread_by(Lognormal{2, 0.3}, 0)));
  const Histogram classes{{1, 2, 0.5}, {2, 4, 0.5}};
  EXPECT_NEAR(log_deviation_of(spread_by(classes, 2)) / log_deviation_of(classes), 2, 1e-12);
  EXPECT_NEAR(median_of(spread_by(classes, 2)), 2, 1e-12);
}

TEST(PowderClasses, AddUpToOneAndKeepTheSpeedOfTheirSize) {
  Powder powder{.radius = Lognormal{1e-6, 0.5}, .density = Lognormal{1e4, 0.1}, .speed = Lognormal{1, 0.05}};
  powder.by_size = SpeedBySize{{0.5e-6, 2e-6}, {800, 400}};
  EXPECT_NEAR(powder.by_size->at(1e-6), std::sqrt(800. * 400), 1e-9);
  EXPECT_EQ(powder.by_size->at(9e-6), 400);
  EXPECT_EQ(powder.by_size->at(0.1e-6), 800);
  double number = 0, mass = 0;
  for (const ParticleClass& one : classes_of(powder, {})) {
    number += one.number;
    mass += one.mass;
    EXPECT_NEAR(std::log(one.low.speed / powder.by_size->at(one.low.radius)), 0, 0.31);
  }
  EXPECT_NEAR(number, 1, 1e-10);
  EXPECT_NEAR(mass, 1, 1e-10);
}

}  // namespace
}  // namespace percal
