// Reading an erosion strain off a ridge.
#include "percal/identify/ridge.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percal {
namespace {

RidgePoint point(double strain, double mu, double solver_error = 0, double data_error = 0) {
  RidgePoint at;
  at.erosion_strain = strain;
  at.mu = mu;
  at.solver_error = solver_error;
  at.data_error = data_error;
  return at;
}

TEST(StrainAt, IsLinearInTheLogarithmOfTheModulus) {
  const std::vector<RidgePoint> ridge{point(0.4, 40e6), point(0.6, 20e6), point(0.8, 10e6)};
  EXPECT_NEAR(strain_at(ridge, std::sqrt(40e6 * 20e6))->strain, 0.5, 1e-12);
  EXPECT_NEAR(strain_at(ridge, 20e6 * std::pow(0.5, 0.25))->strain, 0.65, 1e-12);
}

TEST(StrainAt, MeetsEveryPointOfTheRidge) {
  const std::vector<RidgePoint> ridge{point(0.4, 40e6), point(0.6, 20e6), point(0.8, 10e6)};
  for (const RidgePoint& at : ridge) EXPECT_NEAR(strain_at(ridge, at.mu)->strain, at.erosion_strain, 1e-12);
}

TEST(StrainAt, DoesNotExtrapolate) {
  const std::vector<RidgePoint> ridge{point(0.4, 40e6), point(0.6, 20e6)};
  EXPECT_FALSE(strain_at(ridge, 40.1e6));
  EXPECT_FALSE(strain_at(ridge, 19.9e6));
  EXPECT_FALSE(strain_at({}, 20e6));
  EXPECT_FALSE(strain_at({point(0.4, 20e6)}, 20e6));
}

TEST(StrainAt, PassesOverStrainsWithoutAModulus) {
  const std::vector<RidgePoint> ridge{point(0.2, 0), point(0.4, 40e6), point(0.5, 0), point(0.6, 10e6), point(0.8, 0)};
  EXPECT_NEAR(strain_at(ridge, 20e6)->strain, 0.5, 1e-12);
}

TEST(StrainAt, ServesARidgeThatRises) {
  const std::vector<RidgePoint> ridge{point(0.4, 10e6), point(0.8, 40e6)};
  EXPECT_NEAR(strain_at(ridge, 20e6)->strain, 0.6, 1e-12);
}

TEST(StrainAt, CarriesTheLargerErrorOfTheTwoPointsOverTheSlope) {
  const std::vector<RidgePoint> ridge{point(0.4, 40e6, 0.03, 0.04), point(0.6, 20e6, 0.06, 0.08),
                                      point(0.8, 10e6, 0.5, 0.5)};
  EXPECT_NEAR(strain_at(ridge, 30e6)->error, 0.2 / std::log(2) * 0.1, 1e-12)
      << "d strain/d ln mu times hypot(0.06, 0.08)";
}

}  // namespace
}  // namespace percal
