#include "percal/invert/reach.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percal {
namespace {

TEST(Reach, AndTheShareOfTheSpeedThatIsLeftAreEachOthersInverse) {
  for (const double share : {0.01, 0.3, 0.7, 0.95})
    EXPECT_NEAR(share_left(0.02, reach_of_passage(0.02, share)), share, 1e-12);
  EXPECT_EQ(reach_of_passage(0.02, 0), 0.02);
  EXPECT_EQ(share_left(0.02, 0.019), 0);
}

// Half of the energy lost in the layer: all of it in two.
TEST(Reach, IsWhereTheEnergyWouldBeGone) { EXPECT_NEAR(reach_of_passage(1, std::sqrt(0.5)), 2, 1e-12); }

TEST(Reach, ItsSlopesAreItsDerivatives) {
  constexpr double speed = 80, left = 30, small = 1e-6;
  const auto log_reach = [](double v, double v_left) { return std::log(reach_of_passage(1, v_left / v)); };
  const double share = left / speed;
  EXPECT_NEAR(reach_slope(share) / speed,
              (log_reach(speed, left + small) - log_reach(speed, left - small)) / (2 * small), 1e-8);
  EXPECT_NEAR(reach_speed_slope(share) / speed,
              (log_reach(speed + small, left) - log_reach(speed - small, left)) / (2 * small), 1e-8);
}

}  // namespace
}  // namespace percal
