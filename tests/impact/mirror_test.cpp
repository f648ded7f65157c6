// A plane-strain scene and its mirror image are one run.
#include <gtest/gtest.h>

#include <cmath>

#include "impact/polygons.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

void mirrored_bits(const ImpactResult& one, const ImpactResult& other) {
  EXPECT_EQ(one.outcome, other.outcome);
  EXPECT_EQ(one.depth, other.depth);
  EXPECT_EQ(one.end_time, other.end_time);
  EXPECT_EQ(one.end_speed, other.end_speed);
  EXPECT_EQ(one.sideways, -other.sideways);
  EXPECT_EQ(one.turn, -other.turn);
  EXPECT_EQ(one.steps, other.steps);
  EXPECT_EQ(one.eroded, other.eroded);
  EXPECT_EQ(one.smallest_jacobian, other.smallest_jacobian);
  EXPECT_EQ(one.smallest_step, other.smallest_step);
  EXPECT_EQ(one.energy.particle, other.energy.particle);
}

TEST(Mirror, ASkewRhombusThatIsFreeToTurnHasMirroredBits) {
  for (const Arithmetic arithmetic : {Arithmetic::single_precision, Arithmetic::double_precision})
    for (const int rates : {1, 2})
      for (const int threads : {1, 3}) {
        SCOPED_TRACE(testing::Message() << rates << " rates, " << threads << " threads");
        Problem p = prism_impact(parallelogram({1, 0.3}, {-0.2, 0.8}));
        auto& profile = std::get<RigidPolygon>(p.particle);
        profile.free_rotation = true;
        p.arithmetic = arithmetic;
        p.rates = rates;
        p.end_time = 5;
        const ImpactResult right = run_impact(p, threads);
        profile = mirror_image(profile);
        const ImpactResult left = run_impact(p, threads);
        mirrored_bits(right, left);
        EXPECT_GT(right.eroded, 20);
        EXPECT_GT(std::abs(right.turn), 0.005) << "it does turn";
        EXPECT_GT(std::abs(right.sideways), 0.003) << "and moves aside";
      }
}

TEST(Mirror, ASkewRhombusThatRubsAndIsFreeToTurnHasMirroredBits) {
  Problem p = prism_impact(parallelogram({1, 0.3}, {-0.2, 0.8}));
  auto& profile = std::get<RigidPolygon>(p.particle);
  profile.free_rotation = true;
  p.end_time = 4;
  const ImpactResult smooth = run_impact(p);
  p.friction = CoulombFriction{0.3};
  const ImpactResult right = run_impact(p);
  profile = mirror_image(profile);
  mirrored_bits(right, run_impact(p));
  EXPECT_NE(right.turn, smooth.turn) << "friction has a moment";
  EXPECT_GT(right.energy.friction, 0.01);
}

TEST(Mirror, ASymmetricProfileThatIsFreeGoesStraightDown) {
  for (const Friction friction : {Friction(NoFriction{}), Friction(CoulombFriction{0.3})}) {
    Problem p = prism_impact(square_on_its_corner());
    std::get<RigidPolygon>(p.particle).free_rotation = true;
    p.friction = friction;
    const ImpactResult result = run_impact(p);
    EXPECT_GT(result.depth, 1.5);
    EXPECT_EQ(result.sideways, 0);
    EXPECT_EQ(result.turn, 0);
  }
}

// The half model has half of the elements: twice as many erode in the whole.
void same_in_half_and_whole(Problem p) {
  for (const Arithmetic arithmetic : {Arithmetic::single_precision, Arithmetic::double_precision})
    for (const int rates : {1, 2}) {
      SCOPED_TRACE(testing::Message() << rates << " rates");
      p.arithmetic = arithmetic;
      p.rates = rates;
      p.whole = true;
      const ImpactResult whole = run_impact(p);
      p.whole = false;
      ImpactResult half = run_impact(p);
      EXPECT_GT(half.eroded, 10);
      half.eroded *= 2;
      mirrored_bits(half, whole);
    }
}

TEST(Mirror, HalfAModelOfARhombusGivesTheDepthOfTheWholeToTheLastBit) {
  Problem p = prism_impact(parallelogram({1, 0}, {0, 1.7}));
  p.end_time = 6;
  same_in_half_and_whole(p);
}

TEST(Mirror, HalfAModelOfACylinderThatRubsGivesTheDepthOfTheWholeToTheLastBit) {
  Problem p = prism_impact(square_on_its_corner());
  p.particle = RigidSphere{};
  p.friction = CoulombFriction{0.3};
  p.end_time = 4;
  same_in_half_and_whole(p);
}

TEST(Mirror, HalfAModelOfACylinderGivesTheDepthOfTheWholeToTheLastBit) {
  Problem p = prism_impact(square_on_its_corner());
  p.particle = RigidSphere{};
  p.end_time = 6;
  same_in_half_and_whole(p);
}

}  // namespace
}  // namespace percal
