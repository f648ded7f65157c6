// Impulses between nodes and a rigid body, by hand.
#include "percal/impact/particle/touch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace percal {
namespace {

constexpr ContactColumns columns{0, 5};

// A node below the body's centre that the body runs into at this speed; no force but contact's acts on it.
Touch struck(double mass, double speed) {
  return {.column = 2, .node = 0, .mass = mass, .x = 0, .z = 1, .away_x = 0, .away_z = 1, .rate = speed};
}

TEST(Touch, ANodeAtRestAndTheBodyThatStrikesItGoOnTogether) {
  const double node = 0.3, body = 2, speed = 0.7;
  std::vector<Touch> touches{struck(node, speed)};
  BodyMotion motion{.down = speed};
  const double lost = RigidBody{{.down = 1 / body}}.part(touches, columns, motion);
  EXPECT_NEAR(motion.down, speed * body / (body + node), 1e-15);
  EXPECT_NEAR(touches[0].impulse, node * motion.down, 1e-15);
  EXPECT_NEAR(lost, 0.5 * body * speed * speed - 0.5 * (body + node) * motion.down * motion.down, 1e-15);
}

TEST(Touch, AnImpulseThatOnlyBalancesAForceLosesNothing) {
  Touch resting = struck(0.3, 0);
  resting.before = 0.7;  // as fast as the body
  resting.now = 0.5;     // pushed up by the target
  resting.rate = 0.2;    // and so to be pushed down again
  std::vector<Touch> touches{resting};
  BodyMotion motion{.down = 0.7};
  EXPECT_NEAR((RigidBody{{.down = 0.5}}.part(touches, columns, motion)), 0, 1e-16);
  EXPECT_GT(touches[0].impulse, 0.05);
}

TEST(Touch, ANodeThatPartsOnceTheBodyHasSlowedDownIsLeftAlone) {
  Touch heavy = struck(1, 1), barely = struck(1, 0.1);
  barely.column = 3;
  std::vector<Touch> touches{heavy, barely};
  BodyMotion motion{.down = 1};
  RigidBody{{.down = 1}}.part(touches, columns, motion);
  EXPECT_NEAR(touches[0].impulse, 0.5, 1e-15);
  EXPECT_EQ(touches[1].impulse, 0);
  EXPECT_NEAR(motion.down, 0.5, 1e-15);
}

TEST(Touch, AHeldBodyPushesAndDoesNotMove) {
  std::vector<Touch> touches{struck(0.3, 0.7)};
  BodyMotion motion{.down = 0.7};
  RigidBody{{}}.part(touches, columns, motion);
  EXPECT_EQ(motion.down, 0.7);
  EXPECT_NEAR(touches[0].impulse, 0.3 * 0.7, 1e-15);
}

// Who is pushed parts at just its rate, who is not parts faster; momentum and angular momentum stay; energy is what is said.
TEST(Touch, ImpulsesOnABodyThatIsFreeToTurnDoWhatTheyHaveTo) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  int pushed = 0, left = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double mass = 3, inertia = 1.7;
    const RigidBody body{{1 / mass, 1 / mass, 1 / inertia}, 0.2, -0.4};
    const BodyMotion before{.down = number(random), .right = number(random), .spin = number(random)};
    std::vector<Touch> touches;
    double kinetic = 0.5 * mass * (before.down * before.down + before.right * before.right) +
                     0.5 * inertia * before.spin * before.spin;
    for (int k = 0; k < 8; ++k) {
      const double angle = number(random);
      Touch touch{.column = k % 5, .node = k, .mass = 0.3 + 0.2 * number(random)};
      touch.x = body.x + std::sin(angle) + 0.2 * number(random);
      touch.z = body.z + std::cos(angle);
      touch.away_x = std::sin(angle);
      touch.away_z = std::cos(angle);
      touch.before = touch.now = number(random);
      touch.rate = touch.away_z * (before.down - before.spin * (touch.x - body.x)) +
                   touch.away_x * (before.right + before.spin * (touch.z - body.z)) - touch.now;
      if (touch.rate < 0) continue;
      kinetic += 0.5 * touch.mass * touch.now * touch.now;
      touches.push_back(touch);
    }
    BodyMotion after = before;
    const double lost = body.part(touches, columns, after);
    double down = mass * (after.down - before.down), right = mass * (after.right - before.right),
           turning = inertia * (after.spin - before.spin);
    double kinetic_after =
        0.5 * mass * (after.down * after.down + after.right * after.right) + 0.5 * inertia * after.spin * after.spin;
    for (const Touch& touch : touches) {
      const double now = touch.now + touch.impulse / touch.mass;
      const double closing = touch.away_z * (after.down - after.spin * (touch.x - body.x)) +
                             touch.away_x * (after.right + after.spin * (touch.z - body.z)) - now;
      EXPECT_GE(touch.impulse, 0);
      if (touch.impulse > 0)
        EXPECT_NEAR(closing, 0, 1e-13) << "trial " << trial;
      else
        EXPECT_LE(closing, 1e-13) << "trial " << trial;
      (touch.impulse > 0 ? pushed : left) += 1;
      down += touch.impulse * touch.away_z;
      right += touch.impulse * touch.away_x;
      turning += touch.impulse * (touch.away_x * (touch.z - body.z) - touch.away_z * (touch.x - body.x));
      kinetic_after += 0.5 * touch.mass * now * now;
    }
    EXPECT_NEAR(down, 0, 1e-14);
    EXPECT_NEAR(right, 0, 1e-14);
    EXPECT_NEAR(turning, 0, 1e-14);
    EXPECT_NEAR(lost, kinetic - kinetic_after, 1e-13) << "trial " << trial;
    EXPECT_GE(lost, -1e-14);
  }
  EXPECT_GT(pushed, 300);
  EXPECT_GT(left, 30);
}

// A node under the body, which slides over it to the right at `sliding` and has been pushed down with `impulse`.
Touch pressed(double mass, double impulse, double sliding) {
  return {.column = 2,
          .mass = mass,
          .x = 0,
          .z = 1,
          .away_x = 0,
          .away_z = 1,
          .impulse = impulse,
          .along_x = 1,
          .along_z = 0,
          .along_before = -sliding,
          .along_now = -sliding};
}

TEST(Friction, BrakesASlidingNodeByTheCoefficientTimesTheImpulseAcross) {
  std::vector<Touch> touches{pressed(0.3, 0.2, 5)};
  BodyMotion motion{};
  const double lost = RigidBody{}.rub(touches, columns, 0.1, motion);
  EXPECT_NEAR(touches[0].rub, 0.02, 1e-15);
  EXPECT_NEAR(lost, 0.02 * (5 - 0.5 * 0.02 / 0.3), 1e-15) << "force times way, braked on it";
}

TEST(Friction, StopsANodeThatItCouldMoreThanStop) {
  std::vector<Touch> touches{pressed(0.3, 0.2, 0.05)};
  BodyMotion motion{.down = 0, .right = 0.01};
  RigidBody{}.rub(touches, columns, 0.1, motion);
  EXPECT_NEAR(touches[0].along_now + touches[0].rub / 0.3, 0.01, 1e-16) << "goes on with the body";
  EXPECT_LT(touches[0].rub, 0.02);
}

// Within the cone, never past a standstill; momentum and angular momentum stay; energy is what is said.
TEST(Friction, ImpulsesOnABodyThatIsFreeToTurnStayInTheConeAndReverseNothing) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  int stuck = 0, sliding = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double mass = 3, inertia = 1.7, coefficient = 0.4;
    const RigidBody body{{1 / mass, 1 / mass, 1 / inertia}, 0.2, -0.4};
    const BodyMotion before{.down = number(random), .right = number(random), .spin = number(random)};
    std::vector<Touch> touches;
    for (int k = 0; k < 8; ++k) {
      const double angle = number(random);
      Touch touch{.column = k % 5, .node = k, .mass = 0.3 + 0.2 * number(random)};
      touch.x = body.x + std::sin(angle) + 0.2 * number(random);
      touch.z = body.z + std::cos(angle);
      touch.away_x = touch.along_z = std::sin(angle);
      touch.away_z = std::cos(angle);
      touch.along_x = touch.away_z;
      touch.along_z = -touch.away_x;
      touch.along_before = touch.along_now = number(random);
      touch.impulse = std::max(0.0, number(random));
      touches.push_back(touch);
    }
    BodyMotion after = before;
    const double lost = body.rub(touches, columns, coefficient, after);
    const auto slip = [&](const Touch& touch, const BodyMotion& motion) {
      return touch.along_z * (motion.down - motion.spin * (touch.x - body.x)) +
             touch.along_x * (motion.right + motion.spin * (touch.z - body.z));
    };
    double down = mass * (after.down - before.down), right = mass * (after.right - before.right),
           turning = inertia * (after.spin - before.spin);
    const auto kinetic_of = [&](const BodyMotion& m) {
      return 0.5 * mass * (m.down * m.down + m.right * m.right) + 0.5 * inertia * m.spin * m.spin;
    };
    double less = kinetic_of(before) - kinetic_of(after);
    for (const Touch& touch : touches) {
      const double now = touch.along_now + touch.rub / touch.mass, left = slip(touch, after) - now;
      EXPECT_LE(std::abs(touch.rub), coefficient * touch.impulse);
      if (std::abs(touch.rub) < coefficient * touch.impulse * (1 - 1e-12)) {
        EXPECT_NEAR(left, 0, 1e-13) << "trial " << trial;
        ++stuck;
      } else {
        EXPECT_GE(left * touch.rub, -1e-14) << "trial " << trial;
        sliding += touch.rub != 0;
      }
      down += touch.rub * touch.along_z;
      right += touch.rub * touch.along_x;
      turning += touch.rub * (touch.along_x * (touch.z - body.z) - touch.along_z * (touch.x - body.x));
      less += 0.5 * touch.mass * (touch.along_now * touch.along_now - now * now);
    }
    EXPECT_NEAR(down, 0, 1e-14);
    EXPECT_NEAR(right, 0, 1e-14);
    EXPECT_NEAR(turning, 0, 1e-14);
    EXPECT_NEAR(lost, less, 1e-13) << "trial " << trial;
    EXPECT_GE(lost, -1e-14);
  }
  EXPECT_GT(stuck, 200);
  EXPECT_GT(sliding, 200);
}

// Both sides of x = 0 in pairs of columns.
TEST(Touch, MirroredTouchesMoveABodyStraightDownToTheLastBit) {
  std::vector<Touch> touches;
  for (const int side : {-1, 1})
    for (int k = 1; k <= 2; ++k) {
      const double angle = side * 0.37 * k;
      touches.push_back({.column = 2 + side * k,
                         .node = k,
                         .mass = 0.1 * k,
                         .x = std::sin(angle),
                         .z = std::cos(angle),
                         .away_x = std::sin(angle),
                         .away_z = std::cos(angle),
                         .rate = 0.3 / k});
    }
  std::ranges::sort(touches, {}, &Touch::column);
  BodyMotion motion{.down = 1};
  RigidBody{{0.5, 0.5, 0.9}, 0, 0, true}.part(touches, columns, motion);
  EXPECT_LT(motion.down, 0.99);
  EXPECT_EQ(motion.right, 0);
  EXPECT_EQ(motion.spin, 0);
  EXPECT_EQ(touches[0].impulse, touches[3].impulse);
}

}  // namespace
}  // namespace percal
