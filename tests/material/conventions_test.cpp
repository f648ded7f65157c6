// What a modulus as given means, against the energies that the conventions stand for.
#include "percal/material/conventions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percal {
namespace {

// Small-strain shear modulus of W = factor sum(lambda^alpha - 1): in simple shear, W = mu gamma^2/2.
double slope_in_shear(double factor, double alpha) {
  const double gamma = 1e-3, stretch = gamma / 2 + std::sqrt(1 + gamma * gamma / 4);
  const double energy = factor * (std::pow(stretch, alpha) + std::pow(stretch, -alpha) - 2);
  return 2 * energy / (gamma * gamma);
}

TEST(TrueModulus, IsTheSlopeInShearOfTheEnergyThatEachConventionStandsFor) {
  for (const double alpha : {-9.0, -2.0, 2.0, 8.5, 20.0}) {
    const double given = std::copysign(15e6, alpha);  // W = MU1/alpha sum(lambda^alpha - 1): LS-DYNA's *MAT_077_O
    EXPECT_NEAR(true_modulus(given, alpha, ModulusConvention::mu_over_alpha) / slope_in_shear(given / alpha, alpha), 1, 1e-4);
    const double mu = 15e6;  // W = 2 mu/alpha^2 sum(lambda^alpha - 1)
    EXPECT_NEAR(true_modulus(mu, alpha, ModulusConvention::true_shear) /
                    slope_in_shear(2 * mu / (alpha * alpha), alpha), 1, 1e-4);
  }
}

TEST(TrueModulus, IsGivenBackAsItWasGiven) {
  for (const auto convention : {ModulusConvention::mu_over_alpha, ModulusConvention::true_shear})
    EXPECT_NEAR(modulus_as_given(true_modulus(15e6, 8.5, convention), 8.5, convention), 15e6, 1e-6);
}

}  // namespace
}  // namespace percal
