// log2 and exp2 on scalars and lanes against libm in long double, over the ranges that the header promises.
#include "percal/math/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace percal {
namespace {

using scalar::exp2_of;
using scalar::log2_of;

template <class Real>
struct Worst {
  double log2 = 0, exp2 = 0;  // relative errors
};

template <class Real>
Worst<Real> worst_errors(Real log_range, Real exp_range) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Worst<Real> worst;
  for (int k = 0; k < 400'000; ++k) {
    // Half of the numbers spread over the range, half close to 1 (log2) and 0 (exp2), where the undeformed elements are.
    const double u = k % 2 ? uniform(random) : std::pow(uniform(random), 7);
    const Real x = static_cast<Real>(std::exp2(static_cast<double>(log_range) * u));
    const long double log2 = std::log2(static_cast<long double>(x));
    if (log2 != 0) worst.log2 = std::max(worst.log2, static_cast<double>(std::abs((log2_of(x) - log2) / log2)));
    const Real y = static_cast<Real>(static_cast<double>(exp_range) * u);
    const long double exp2 = std::exp2(static_cast<long double>(y));
    worst.exp2 = std::max(worst.exp2, static_cast<double>(std::abs((exp2_of(y) - exp2) / exp2)));
  }
  return worst;
}

TEST(Lanes, Log2AndExp2OfFloatsAreRightToFourRoundings) {
  const auto worst = worst_errors<float>(125.0f, 125.0f);
  EXPECT_LT(worst.log2, 4 * 0x1p-24);
  EXPECT_LT(worst.exp2, 4 * 0x1p-24);
}

TEST(Lanes, Log2AndExp2OfDoublesAreRightToFourRoundings) {
  const auto worst = worst_errors<double>(1020.0, 1020.0);
  EXPECT_LT(worst.log2, 4 * 0x1p-53);
  EXPECT_LT(worst.exp2, 4 * 0x1p-53);
}

TEST(Lanes, Log2OfOneIsZeroAndPowersOfTwoAreExact) {
  EXPECT_EQ(log2_of(1.0f), 0);
  EXPECT_EQ(log2_of(1.0), 0);
  for (int n = -120; n <= 120; n += 8) {
    EXPECT_EQ(log2_of(std::ldexp(1.0f, n)), n);
    EXPECT_EQ(exp2_of(static_cast<float>(n)), std::ldexp(1.0f, n));
    EXPECT_EQ(log2_of(std::ldexp(1.0, 8 * n)), 8 * n);
    EXPECT_EQ(exp2_of(8.0 * n), std::ldexp(1.0, 8 * n));
  }
}

TEST(Lanes, Exp2IsClampedWhereItWouldOverflow) {
  EXPECT_EQ(exp2_of(1e4f), 0x1p126f);
  EXPECT_EQ(exp2_of(-1e4f), 0x1p-126f);
  EXPECT_EQ(exp2_of(1e5), 0x1p1022);
  EXPECT_EQ(exp2_of(std::numeric_limits<double>::infinity()), 0x1p1022);
}

TEST(Lanes, EveryLaneHasTheBitsOfTheScalar) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.05f, 20.0f);
  for (int k = 0; k < 1000; ++k) {
    scalar::FloatLanes::Vector x;
    scalar::DoubleLanes::Vector y;
    for (int l = 0; l < scalar::FloatLanes::count; ++l) x[l] = uniform(random);
    for (int l = 0; l < scalar::DoubleLanes::count; ++l) y[l] = uniform(random);
    const auto log_x = log2_of(x), exp_x = exp2_of(x);
    const auto log_y = log2_of(y), exp_y = exp2_of(y);
    for (int l = 0; l < scalar::FloatLanes::count; ++l) {
      EXPECT_EQ(log_x[l], log2_of(static_cast<float>(x[l])));
      EXPECT_EQ(exp_x[l], exp2_of(static_cast<float>(x[l])));
    }
    for (int l = 0; l < scalar::DoubleLanes::count; ++l) {
      EXPECT_EQ(log_y[l], log2_of(static_cast<double>(y[l])));
      EXPECT_EQ(exp_y[l], exp2_of(static_cast<double>(y[l])));
    }
  }
}

TEST(Lanes, ShiftedMovesUpByOneLaneAcrossGroups) {
  using Lanes = scalar::FloatLanes;
  Lanes::Vector before, now;
  for (int l = 0; l < Lanes::count; ++l) {
    before[l] = static_cast<float>(l);
    now[l] = static_cast<float>(100 + l);
  }
  const auto moved = scalar::shifted(now, before);
  EXPECT_EQ(moved[0], Lanes::count - 1);
  for (int l = 1; l < Lanes::count; ++l) EXPECT_EQ(moved[l], 100 + l - 1);
}

TEST(Lanes, SumsAndExtremesRunOverAllLanes) {
  scalar::DoubleLanes::Vector v{};
  v[0] = 3;
  v[scalar::DoubleLanes::count - 1] = -7;
  EXPECT_EQ(scalar::lane_sum(v), -4);
  EXPECT_EQ(scalar::lane_largest(v), 3);
  EXPECT_EQ(scalar::lane_smallest(v), -7);
  EXPECT_TRUE(scalar::any(v < 0.0));
  EXPECT_FALSE(scalar::any(v > 3.0));
}

}  // namespace
}  // namespace percal
