// The element's stress at given deformations against closed forms written with pow, in double.
#include "percal/impact/kernel/element.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace percal {
namespace {

using Gradient = scalar::Gradient<double>;
using Piola = scalar::Piola<double>;

struct Solid {
  double mu, bulk, alpha;
};

Piola piola(const Solid& solid, const Gradient& F) {
  const auto s = scalar::stretches(F);
  const auto g = scalar::isochoric_powers(F, s, solid.alpha);
  return scalar::first_piola(F, s, scalar::isochoric_stress(g, 2 * solid.mu / solid.alpha),
                             solid.bulk / 2 * (s.jacobian * s.jacobian - 1));
}

// lambda_i dW/dlambda_i from the definition of W: the isochoric part by the chain rule through J^(-1/3), the rest K/2 (J^2 - 1).
double kirchhoff(const Solid& solid, const double (&stretch)[3], int i) {
  const double J = stretch[0] * stretch[1] * stretch[2];
  double mean = 0;
  for (const double lambda : stretch) mean += std::pow(lambda / std::cbrt(J), solid.alpha) / 3;
  const double own = std::pow(stretch[i] / std::cbrt(J), solid.alpha);
  return 2 * solid.mu / solid.alpha * (own - mean) + solid.bulk / 2 * (J * J - 1);
}

constexpr double exponents[] = {-6, 2, 8.5, 20};
constexpr double near_and_far[] = {0.6, 0.9, 0.999, 1.001, 1.2, 1.7};

TEST(Element, UniaxialStrainAlongTheAxisMeetsTheClosedForm) {
  for (const double alpha : exponents)
    for (const double lambda : near_and_far) {
      const Solid solid{1.3, 65, alpha};
      const Piola P = piola(solid, {1, 0, 0, lambda, 1});
      const double stretch[3] = {1, lambda, 1};
      const double size = 1e-9 * (solid.bulk + std::abs(kirchhoff(solid, stretch, 1)));
      EXPECT_NEAR(P.rr, kirchhoff(solid, stretch, 0), size) << alpha << " " << lambda;
      EXPECT_NEAR(P.zz, kirchhoff(solid, stretch, 1) / lambda, size) << alpha << " " << lambda;
      EXPECT_NEAR(P.hoop, kirchhoff(solid, stretch, 2), size) << alpha << " " << lambda;
      EXPECT_NEAR(P.rz, 0, size);
      EXPECT_NEAR(P.zr, 0, size);
    }
}

TEST(Element, PureDilatationMakesAPressureThatKnowsNoAlpha) {
  for (const double alpha : exponents)
    for (const double lambda : near_and_far) {
      const Piola P = piola({1.3, 65, alpha}, {lambda, 0, 0, lambda, lambda});
      const double exact = 65.0 / 2 * (std::pow(lambda, 6) - 1) / lambda;
      EXPECT_NEAR(P.rr, exact, 1e-9 * std::abs(exact) + 1e-11);
      EXPECT_NEAR(P.zz, exact, 1e-9 * std::abs(exact) + 1e-11);
      EXPECT_NEAR(P.hoop, exact, 1e-9 * std::abs(exact) + 1e-11);
    }
}

TEST(Element, ThreeDifferentStretchesMeetTheClosedForm) {
  for (const double alpha : exponents)
    for (const double first : near_and_far)
      for (const double hoop : near_and_far) {
        const Solid solid{1, 50, alpha};
        const double stretch[3] = {first, 0.8, hoop};
        const Piola P = piola(solid, {first, 0, 0, 0.8, hoop});
        for (const auto& [ours, i] : {std::pair{P.rr, 0}, {P.zz, 1}, {P.hoop, 2}}) {
          const double exact = kirchhoff(solid, stretch, i) / stretch[i];
          EXPECT_NEAR(ours, exact, 1e-9 * (std::abs(exact) + solid.bulk)) << alpha << " " << first << " " << hoop;
        }
      }
}

TEST(Element, ARotationTurnsTheStressAndChangesNothingElse) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  for (int k = 0; k < 200; ++k) {
    const Gradient F{1 + uniform(random), uniform(random), uniform(random), 1 + uniform(random), 1 + uniform(random)};
    const double angle = 8 * uniform(random), c = std::cos(angle), s = std::sin(angle);
    const Gradient turned{c * F.rr - s * F.zr, c * F.rz - s * F.zz, s * F.rr + c * F.zr, s * F.rz + c * F.zz, F.hoop};
    const Solid solid{1, 50, 8.5};
    const Piola P = piola(solid, F), Q = piola(solid, turned);
    const double size =
        1e-11 * (std::abs(P.rr) + std::abs(P.zz) + std::abs(P.rz) + std::abs(P.zr) + std::abs(P.hoop) + 1);
    EXPECT_NEAR(Q.rr, c * P.rr - s * P.zr, size);
    EXPECT_NEAR(Q.rz, c * P.rz - s * P.zz, size);
    EXPECT_NEAR(Q.zr, s * P.rr + c * P.zr, size);
    EXPECT_NEAR(Q.zz, s * P.rz + c * P.zz, size);
    EXPECT_NEAR(Q.hoop, P.hoop, size);
  }
}

// What is left at a strain e is of the order alpha e: 1e-5 times 20.
TEST(Element, SmallStrainsAreLinearElasticityWithKAndMu) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-1e-5, 1e-5);
  for (const double alpha : exponents)
    for (int k = 0; k < 50; ++k) {
      const double rr = uniform(random), rz = uniform(random), zr = uniform(random), zz = uniform(random),
                   hoop = uniform(random);
      const Solid solid{3, 7, alpha};
      const Piola P = piola(solid, {1 + rr, rz, zr, 1 + zz, 1 + hoop});
      const double pressure_like = (solid.bulk - 2.0 / 3 * solid.mu) * (rr + zz + hoop), shear = solid.mu * (rz + zr);
      const double left = 1e-3 * 1e-5 * solid.bulk;
      EXPECT_NEAR(P.rr, pressure_like + 2 * solid.mu * rr, left) << alpha;
      EXPECT_NEAR(P.zz, pressure_like + 2 * solid.mu * zz, left) << alpha;
      EXPECT_NEAR(P.hoop, pressure_like + 2 * solid.mu * hoop, left) << alpha;
      EXPECT_NEAR(P.rz, shear, left) << alpha;
      EXPECT_NEAR(P.zr, shear, left) << alpha;
    }
}

TEST(Element, TheUndeformedElementIsFreeOfStress) {
  for (const double alpha : exponents) {
    const Piola P = piola({1, 50, alpha}, {1, 0, 0, 1, 1});
    for (const double stress : {P.rr, P.rz, P.zr, P.zz, P.hoop}) EXPECT_NEAR(stress, 0, 1e-11);
  }
}

}  // namespace
}  // namespace percal
