#include "percal/invert/dehn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace percal {
namespace {

const DehnShot steel{.radius = 1.59e-3, .density = 7800, .speed = 98, .target_density = 1010};

// The way until m v dv/dx = -A (c rho_t v^2 + s) has brought v to 0: x = integral of m v dv/(A (c rho_t v^2 + s)), by Simpson's rule.
double integrated_depth(const DehnShot& shot, double c, double s) {
  const double area = std::numbers::pi * shot.radius * shot.radius;
  const double mass = 4.0 / 3 * std::numbers::pi * std::pow(shot.radius, 3) * shot.density;
  const auto slowness = [&](double v) { return mass * v / (area * (c * shot.target_density * v * v + s)); };
  const int n = 20000;
  const double h = shot.speed / n;
  double sum = slowness(0) + slowness(shot.speed);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4 : 2) * slowness(i * h);
  return sum * h / 3;
}

TEST(Dehn, TheDepthIsTheIntegralOfTheMotion) {
  for (const double c : {0.01, 0.3, 2.0})
    for (const double s : {1e4, 1e6, 1e8})
      EXPECT_NEAR(std::exp(dehn_depth(steel, c, s).log_depth) / integrated_depth(steel, c, s), 1, 1e-9)
          << c << " " << s;
}

TEST(Dehn, WithoutDragItIsTheEnergyOverTheForce) {
  const double depth = 4.0 / 3 * steel.radius * steel.density * steel.speed * steel.speed / (2 * 1e6);
  EXPECT_NEAR(std::exp(dehn_depth(steel, 1e-9, 1e6).log_depth), depth, 1e-7 * depth);
}

TEST(Dehn, TheDerivativesAreTheDifferences) {
  for (const double c : {1e-6, 0.3, 2.0})
    for (const double s : {1e4, 1e6, 1e8}) {
      const double h = 1e-5;
      const auto at = [&](double up_c, double up_s) {
        return dehn_depth(steel, c * std::exp(up_c), s * std::exp(up_s)).log_depth;
      };
      const auto gradient = dehn_depth(steel, c, s).gradient;
      EXPECT_NEAR(gradient[0], (at(h, 0) - at(-h, 0)) / (2 * h), 1e-9) << c << " " << s;
      EXPECT_NEAR(gradient[1], (at(0, h) - at(0, -h)) / (2 * h), 1e-9) << c << " " << s;
    }
}

}  // namespace
}  // namespace percal
