#include "percal/material/homogeneous.hpp"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "material/solids.hpp"

namespace percal {
namespace {

using test::all_deformations;
using Jet = ceres::Jet<double, 2>;

double stress(double alpha, const Strained& strained) {
  return nominal_stress(Ogden{.mu = 1, .alpha = alpha}, strained);
}

// W of the incompressible solid from its stretches, by the definition.
double energy(const Ogden& solid, double first, double second) {
  double sum = -3;
  for (const double stretch : {first, second, 1 / (first * second)}) sum += std::pow(stretch, solid.alpha);
  return 2 * solid.mu / (solid.alpha * solid.alpha) * sum;
}

TEST(Homogeneous, EveryColumnOfTheExactTableIsMet) {
  std::ifstream file(PERCAL_DATA "/verification/ogden_homogeneous_stress.csv");
  std::string line;
  int rows = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 'a') continue;
    std::istringstream cells(line);
    double v[8];
    char comma;
    for (double& value : v) {
      ASSERT_TRUE(cells >> value) << line;
      cells >> comma;
    }
    const double alpha = v[0], stretch = v[1], gamma = stretch - 1 / stretch;
    const auto meets = [&](double ours, double exact) { EXPECT_NEAR(ours, exact, 1e-10 * std::abs(exact)) << line; };
    meets(stress(alpha, {Deformation::uniaxial, stretch}), v[2]);
    meets(stress(alpha, {Deformation::equibiaxial, stretch}), v[3]);
    meets(stress(alpha, {Deformation::planar, stretch}), v[4]);
    meets(stress(alpha, {Deformation::planar_held, stretch}), v[5]);
    meets(gamma, v[6]);
    meets(stress(alpha, {Deformation::simple_shear, gamma}), v[7]);
    ++rows;
  }
  EXPECT_GE(rows, 150);
}

TEST(Homogeneous, AnUndeformedSolidIsFreeOfStress) {
  for (const auto deformation : all_deformations) {
    const double rest = deformation == Deformation::simple_shear ? 0 : 1;
    for (const double alpha : {-20.0, 0.0, 3.0}) EXPECT_EQ(stress(alpha, {deformation, rest}), 0);
  }
}

TEST(Homogeneous, TheModulusIsTheSmallStrainShearModulus) {
  for (const double alpha : {-20.0, -1e-9, 0.0, 2.0, 26.0}) {
    const Ogden solid{.mu = 2.5, .alpha = alpha};
    EXPECT_NEAR(nominal_stiffness(solid, {Deformation::uniaxial, 1}), 3 * 2.5, 1e-12);
    EXPECT_NEAR(nominal_stiffness(solid, {Deformation::equibiaxial, 1}), 6 * 2.5, 1e-12);
    EXPECT_NEAR(nominal_stiffness(solid, {Deformation::planar, 1}), 4 * 2.5, 1e-12);
    EXPECT_NEAR(nominal_stiffness(solid, {Deformation::planar_held, 1}), 2 * 2.5, 1e-12);
    EXPECT_NEAR(nominal_stiffness(solid, {Deformation::simple_shear, 0}), 2.5, 1e-12);
  }
}

TEST(Homogeneous, TheStiffnessIsTheSlopeOfTheStress) {
  for (const auto deformation : all_deformations)
    for (const double alpha : {-9.0, 0.0, 1.5, 12.0})
      for (const double amount : {0.7, 1.02, 1.9}) {
        const Ogden solid{.mu = 3, .alpha = alpha};
        const double h = 1e-5;
        const double slope = (nominal_stress(solid, Strained{deformation, amount + h, 1.1}) -
                              nominal_stress(solid, Strained{deformation, amount - h, 1.1})) /
                             (2 * h);
        const double ours = nominal_stiffness(solid, {deformation, amount, 1.1});
        EXPECT_NEAR(ours, slope, 1e-7 * (1 + std::abs(ours)))
            << word(deformation) << " alpha " << alpha << " at " << amount;
      }
}

TEST(Homogeneous, StressIsTheDerivativeOfTheEnergy) {
  const double h = 1e-6;
  for (const double alpha : {-5.0, 2.0, 7.0}) {
    const Ogden solid{.mu = 1, .alpha = alpha};
    const double first = 1.3, second = 0.9;
    const double along = (energy(solid, first + h, second) - energy(solid, first - h, second)) / (2 * h);
    EXPECT_NEAR(nominal_stress(solid, Strained{Deformation::biaxial, first, second}), along,
                1e-7 * (1 + std::abs(along)));
    const double equal = (energy(solid, first + h, first + h) - energy(solid, first - h, first - h)) / (2 * h) / 2;
    EXPECT_NEAR(nominal_stress(solid, Strained{Deformation::equibiaxial, first}), equal, 1e-7 * (1 + std::abs(equal)));
  }
}

TEST(Homogeneous, AlphaTwoIsTheNeoHookeanSolidAndShearIsLinear) {
  EXPECT_NEAR(stress(2, {Deformation::uniaxial, 2}), 2 - 1.0 / 4, 1e-14);
  EXPECT_NEAR(stress(2, {Deformation::simple_shear, 3}), 3, 1e-14);
}

TEST(Homogeneous, TheLimitOfVanishingAlphaIsSmooth) {
  for (const auto deformation : all_deformations) {
    const Strained strained{deformation, 1.7, 1.2};
    const double limit = stress(0, strained);
    EXPECT_GT(limit, 0);
    for (const double alpha : {1e-15, 1e-9, 1e-5, -1e-5, -1e-9})
      EXPECT_NEAR(stress(alpha, strained), limit, 2 * std::abs(alpha) * limit + 1e-15) << word(deformation);
  }
  EXPECT_NEAR(stress(0, {Deformation::uniaxial, 2}), 2 * 1.5 * std::log(2.0) / 2, 1e-15);
}

TEST(Homogeneous, DerivativesByJetsMeetDifferencesEverywhere) {
  for (const auto deformation : all_deformations)
    for (const double alpha : {-20.0, -3.0, -1e-7, 0.0, 1e-7, 0.3, 1.5, 9.0, 20.0})
      for (const double amount : {0.5, 0.999999, 1.000001, 1.5, 2.5}) {
        const Strained strained{deformation, amount, 1.05};
        const OgdenOf<Jet> solid{Jet(2.0, 0), Jet(alpha, 1)};
        const Jet value = nominal_stress(solid, strained);
        const double h = 1e-5;
        const double difference = 2 * (stress(alpha + h, strained) - stress(alpha - h, strained)) / (2 * h);
        EXPECT_NEAR(value.a, 2 * stress(alpha, strained), 1e-14 * std::abs(value.a));
        EXPECT_NEAR(value.v[0], stress(alpha, strained), 1e-14 * std::abs(value.a));
        EXPECT_NEAR(value.v[1], difference, 1e-8 * std::abs(difference) + 1e-9 * std::abs(value.a))
            << word(deformation) << ' ' << alpha << ' ' << amount;
      }
}

TEST(Homogeneous, TheSeriesOfSinhJoinsTheFunction) {
  for (const double x : {0.0, 1e-8, 0.5, 0.999999999, 1.0, 1.000000001, -0.7, -1.5}) {
    const auto value = sinh_over(ceres::Jet<double, 1>(x, 0));
    EXPECT_NEAR(value.a, x == 0 ? 1 : std::sinh(x) / x, 1e-15);
    const double slope = std::abs(x) < 1e-3 ? x / 3 : (std::cosh(x) * x - std::sinh(x)) / (x * x);
    EXPECT_NEAR(value.v[0], slope, 3e-15) << x;
  }
}

TEST(Homogeneous, ACauchyStressBecomesNominalByItsAreaChange) {
  for (const auto deformation :
       {Deformation::uniaxial, Deformation::equibiaxial, Deformation::planar, Deformation::biaxial})
    EXPECT_EQ(nominal_of_cauchy(6, {deformation, 1.5, 1.1}), 4);
  EXPECT_EQ(nominal_of_cauchy(6, {Deformation::simple_shear, 1.5}), 6);
  EXPECT_EQ(nominal_of_cauchy(6, {Deformation::planar_held, 1.5}), 6);
}

TEST(Homogeneous, ModesAreKnownByManyWords) {
  const std::pair<const char*, Deformation> known[] = {{"UT", Deformation::uniaxial},
                                                       {"tension", Deformation::uniaxial},
                                                       {"Compression", Deformation::uniaxial},
                                                       {"tension_compression", Deformation::uniaxial},
                                                       {"tension-compression", Deformation::uniaxial},
                                                       {"ET", Deformation::equibiaxial},
                                                       {"Equibiaxial", Deformation::equibiaxial},
                                                       {"equi-biaxial", Deformation::equibiaxial},
                                                       {"biaxial", Deformation::equibiaxial},
                                                       {"PS", Deformation::planar},
                                                       {"planar", Deformation::planar},
                                                       {"Pure Shear", Deformation::planar},
                                                       {"pure-shear", Deformation::planar},
                                                       {"SS", Deformation::simple_shear},
                                                       {"shear", Deformation::simple_shear},
                                                       {"SIMPLE_SHEAR", Deformation::simple_shear},
                                                       {"general_biaxial", Deformation::biaxial}};
  for (const auto& [text, deformation] : known) EXPECT_EQ(deformation_of(text), deformation) << text;
  for (const auto deformation : all_deformations) EXPECT_EQ(deformation_of(word(deformation)), deformation);
  for (const char* text : {"", "U", "torsion", "UTX"}) EXPECT_EQ(deformation_of(text), std::nullopt) << text;
}

}  // namespace
}  // namespace percal
