#include "percal/material/stability.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "material/solids.hpp"

namespace percal {
namespace {

using test::mooney_rivlin;
using testing::HasSubstr;

TEST(Stability, OneTermWithAPositiveModulusIsAlwaysStable) {
  for (const double alpha : {-40.0, -8.0, -1.0, 0.0, 0.5, 2.0, 9.0, 40.0}) {
    const auto ranges = stable_ranges({{{1000, alpha}}}, {.low = 0.05, .high = 20});
    EXPECT_TRUE(stable_throughout(ranges)) << alpha;
    EXPECT_THAT(stability_sentence(ranges, {0.05, 20}), HasSubstr("at stretches from 0.05 to 20"));
  }
}

TEST(Stability, SumsOfPositiveModuliAreAlwaysStable) {
  EXPECT_TRUE(stable_throughout(stable_ranges({{{3, 9}, {1, -14}, {0.1, 0.3}}}, {})));
}

// With C01 < 0 the side stress softens in tension until C10/lambda = |C01| lambda.
TEST(Stability, MooneyRivlinWithANegativeC01EndsInTensionWhereItIsKnownTo) {
  for (const double c01 : {-0.9, -0.5, -0.1}) {
    const auto ranges = stable_ranges(mooney_rivlin(1, c01), {.low = 0.1, .high = 10});
    ASSERT_EQ(ranges[0].deformation, Deformation::uniaxial);
    EXPECT_NEAR(ranges[0].high, std::sqrt(-1 / c01), 1e-8);
    EXPECT_FALSE(ranges[0].high_open);
  }
}

// Equibiaxial tension ends where t_1 + 2 t_3 = 0, t = 4 C10 l^2 + 4 C01 l^-2 in each direction.
TEST(Stability, MooneyRivlinWithANegativeC01EndsInEquibiaxialTensionWhereItIsKnownTo) {
  const double c01 = -0.2;
  const auto ranges = stable_ranges(mooney_rivlin(1, c01), {});
  ASSERT_EQ(ranges[1].deformation, Deformation::equibiaxial);
  const double l = ranges[1].high;
  EXPECT_GT(l, 1.05);
  EXPECT_NEAR(l * l + c01 / (l * l) + 2 * (std::pow(l, -4) + c01 * std::pow(l, 4)), 0, 1e-7);
  EXPECT_FALSE(stable_throughout(ranges));
  EXPECT_THAT(stability_sentence(ranges, {}), HasSubstr("only at: uniaxial"));
}

TEST(Stability, MooneyRivlinWithPositiveConstantsIsAlwaysStable) {
  EXPECT_TRUE(stable_throughout(stable_ranges(mooney_rivlin(1, 0.3), {})));
}

TEST(Stability, ASolidThatSoftensAtRestIsStableNowhere) {
  const auto ranges = stable_ranges({{{1, 2}, {-2, -2}}}, {});
  for (const auto& range : ranges) EXPECT_EQ(range.low, range.high);
  EXPECT_THAT(stability_sentence(ranges, {}), HasSubstr("uniaxial nowhere"));
}

// The same from the stresses themselves: in-plane true stresses with a free third direction, differenced by the two
// logarithmic strains; both eigenvalues of the tangent have to be positive.
TEST(Stability, IsThePositiveDefiniteTangentOfTheStresses) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> modulus(-1, 3), exponent(-9, 9), strain(-0.8, 0.8);
  int stable = 0, unstable = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Hyperelastic solid{{{modulus(random), exponent(random)}, {modulus(random), exponent(random)}}};
    const double e1 = strain(random), e2 = strain(random), h = 1e-5;
    const auto stress = [&](double a, double b, bool second) {
      double sum = 0;
      for (const auto& term : solid.terms)
        sum += 2 * term.mu / term.alpha * (std::exp(term.alpha * (second ? b : a)) - std::exp(term.alpha * (-a - b)));
      return sum;
    };
    const double d11 = (stress(e1 + h, e2, false) - stress(e1 - h, e2, false)) / (2 * h);
    const double d12 = (stress(e1, e2 + h, false) - stress(e1, e2 - h, false)) / (2 * h);
    const double d22 = (stress(e1, e2 + h, true) - stress(e1, e2 - h, true)) / (2 * h);
    const double smallest = (d11 + d22) / 2 - std::hypot((d11 - d22) / 2, d12);
    if (std::abs(smallest) < 1e-4 * (std::abs(d11) + std::abs(d22))) continue;  // too close for differences
    EXPECT_EQ(is_stable(solid, e1, e2), smallest > 0) << trial;
    ++(smallest > 0 ? stable : unstable);
  }
  EXPECT_GT(stable, 100);
  EXPECT_GT(unstable, 100);
}

}  // namespace
}  // namespace percal
