// The interval of a number that a search found, on closed-form forward models.
#include "percal/one_depth/value_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "percal/math/distributions.hpp"

namespace percal {
namespace {

constexpr double truth = 2.3, true_depth = 26;  // ln of the number, and the depth that belongs to it

Inversion line(double slope, double error, int points) {
  Inversion found;
  found.outcome = InversionOutcome::found;
  found.slope = slope;
  found.log_modulus_error = error;
  found.points_in_line = points;
  return found;
}

// A modulus, and an erosion strain: depths that fall by the root, and faster than by the inverse.
TEST(ValueError, ItsIntervalHoldsTheTruthAsOftenAsItSays) {
  constexpr int problems = 1000;
  for (const double exponent : {0.5, 1.5})
    for (const double scatter : {0.01, 0.02, 0.03}) {
      int held = 0;
      for (int k = 0; k < problems; ++k) {
        std::mt19937 random(2000 + k);
        std::normal_distribution<double> normal;
        constexpr double depth_error = 0.05, speed_error = 0.02;
        const double speed_exponent = 1.0;  // of the depth
        const DepthOfModulus forward = [&](double x) {
          return DepthAnswer{.depth = true_depth * std::exp(-exponent * (x - truth) + scatter * normal(random)),
                             .why = ""};
        };
        const double measured =
            true_depth * std::exp(depth_error * normal(random) + speed_exponent * speed_error * normal(random));
        const Inversion found = invert_modulus(forward, {.target = measured,
                                                         .start = truth + normal(random),
                                                         .expected_slope = exponent == 0.5 ? 0.4 : 1.2,
                                                         .fewest_in_line = k % 2 == 0 ? 5 : 10});
        ASSERT_EQ(found.outcome, InversionOutcome::found);
        const std::vector<ValueErrorPart> others{
            depth_share("measured depth", depth_error, "", found),
            value_share("speed", speed_error * speed_exponent / exponent, "", found)};
        held += std::abs(found.log_modulus - truth) < half_width(found, others, 0.95);
      }
      EXPECT_GE(held, 0.93 * problems) << exponent << " " << scatter;
      EXPECT_LE(held, 0.97 * problems) << exponent << " " << scatter;
    }
}

TEST(ValueError, IsThatOfTheDepthOverTheSlope) {
  const Inversion found = line(-0.5, 0.01, 10);
  const ValueErrorPart depth = depth_share("", 0.05, "", found), value = value_share("", 0.04, "", found);
  EXPECT_NEAR(*depth.of_value, 0.1, 1e-12);
  EXPECT_NEAR(*value.of_depth, 0.02, 1e-12);
  EXPECT_NEAR(*solver_share(found).of_depth, 0.005, 1e-12);
  EXPECT_NEAR(half_width(found, {depth, value}, 0.95),
              std::hypot(student_quantile(0.975, 8) * 0.01, normal_quantile(0.975) * std::hypot(0.1, 0.04)), 1e-12);
}

TEST(ValueError, ThatIsNotKnownIsLeftOut) {
  const Inversion found = line(-0.5, 0.01, 10);
  EXPECT_EQ(half_width(found, {{"speed", {}, {}, ""}}, 0.9), half_width(found, {}, 0.9));
  EXPECT_LT(half_width(found, {}, 0.9), half_width(line(-0.5, 0.01, 5), {}, 0.9)) << "fewer answers tell it less well";
}

}  // namespace
}  // namespace percal
