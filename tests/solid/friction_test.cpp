// Friction in three dimensions.                                                                   docs/theory/solid.md
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "impact/same_bits.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/solid/march/contact_zone.hpp"
#include "percal/solid/march/march.hpp"
#include "solid/solid_problems.hpp"

namespace percal {
namespace {

Problem rubbing(Problem p, double coefficient = 0.3) {
  p.friction = CoulombFriction{coefficient};
  return p;
}

// One step of contact of a sphere that comes down on nodes at rest: each gets an impulse in its own meridian, along the surface the
// coefficient's share of that across, or what has it follow the surface, if that is less.
TEST(SolidFriction, PushesAlongTheMeridianWithinTheCone) {
  constexpr double coefficient = 0.05, drift = 0.05;
  Problem p = block_dent(5);
  p.arithmetic = Arithmetic::double_precision;
  SolidBlock<double> block(p, solid_kernel<double>().lanes);
  BodyRun<SphereShape> body(p);
  SpaceContact<double, BodyRun<SphereShape>> contact(block, solid_kernel<double>(), body, coefficient);
  body.drift(0.3);  // the tip is so deep
  contact.search(block.grid().rows(), 0.5);
  contact.close(0, drift);
  int met = 0, sliding = 0;
  for (int i = 0; i <= block.slabs(); ++i)
    for (int j = 0; j <= block.columns_y(); ++j) {
      const long n = block.at(i, j, 0);
      const auto& v = block.fields().v;
      const std::array<double, 3> from{block.grid().x[i], block.grid().y[j], -(0.3 + drift - 1)};  // from the centre
      const double radius = std::hypot(from[0], from[1]), distance = std::hypot(radius, from[2]);
      if (v[2][n] == 0) continue;
      EXPECT_LT(distance, 1);
      const double outward = radius == 0 ? 0 : (v[0][n] * from[0] + v[1][n] * from[1]) / radius;
      EXPECT_NEAR(outward, std::hypot(v[0][n], v[1][n]), 1e-12) << "in the meridian, away from the axis";
      const double across = (outward * radius + v[2][n] * from[2]) / distance,
                   along = (v[2][n] * radius - outward * from[2]) / distance;
      const double of_surface = body.speed() * radius / distance;
      EXPECT_NEAR(along, std::min(coefficient * across, of_surface), 1e-9) << i << " " << j;
      sliding += coefficient * across < of_surface ? 1 : 0;
      ++met;
    }
  EXPECT_GT(sliding, 3);
  EXPECT_GT(met, sliding);
}

TEST(SolidFriction, TakesFromADentWhatItTakesFromAnAxisymmetricOne) {
  const auto kept = [](const Problem& smooth, auto run) {
    const ImpactResult rough = run(rubbing(smooth), 1);
    EXPECT_LT(std::abs(rough.energy.closure()), 1e-3);
    EXPECT_GT(rough.energy.friction, 1e-3);
    return rough.depth / run(smooth, 1).depth;
  };
  Problem round = block_dent(6);
  round.geometry = Geometry::axisymmetric;
  round.hourglass = 0.5;
  round.graded_columns = 8;
  const double in_plane = kept(round, [](const Problem&p, int threads) { return run_impact(p, threads); }),
               in_space = kept(block_dent(6), [](const Problem&p, int threads) { return run_solid(p, threads); });
  EXPECT_LT(in_plane, 0.995);
  EXPECT_NEAR(in_space, in_plane, 0.006);
}

TEST(SolidFriction, BothHalvesFeelItAsAQuarterDoes) {
  Problem half = rubbing(block_setting_s(3));
  half.end_time = 10;
  const ImpactResult one = run_solid(half, 1);
  half.whole = true;
  const ImpactResult two = run_solid(half, 1);
  EXPECT_NEAR(two.depth / one.depth, 1, 1e-6);
  EXPECT_NEAR(two.energy.friction, one.energy.friction, 1e-6);
}

TEST(SolidFriction, AnErodingShotClosesAndGoesLessDeep) {
  Problem p = block_setting_s(4);
  p.end_time = 8;
  const ImpactResult smooth = run_solid(p, 1), rough = run_solid(rubbing(p), 1);
  EXPECT_LT(std::abs(rough.energy.closure()), 5e-3);
  EXPECT_GT(rough.energy.friction, 0.02);
  EXPECT_LT(rough.end_speed, smooth.end_speed);
  EXPECT_EQ(smooth.energy.friction, 0);
}

TEST(SolidFriction, AnyNumberOfThreadsGivesTheSameBits) {
  Problem p = rubbing(block_setting_s(3));
  p.end_time = 5;
  const ImpactResult one = run_solid(p, 1);
  same_bits(run_solid(p, 3), one);
  EXPECT_GT(one.energy.friction, 0);
}

// Free to turn: energy of a square that comes down on one side of its centre and rubs.
TEST(SolidFriction, APrismThatTurnsClosesItsBooks) {
  Problem p = rubbing(block_dent(4));
  p.whole = true;
  p.width = 9, p.fine_width = p.block.fine_thickness = 3;
  p.end_time = 6;
  const double c = std::cos(0.3), s = std::sin(0.3);
  p.particle = RigidPolygon{.vertices = {{s, -c}, {c, s}, {-s, c}, {-c, -s}},
                            .mass = 16,
                            .inertia = 5,
                            .free_rotation = true,
                            .half_thickness = 1};
  const ImpactResult result = run_solid(p, 1);
  EXPECT_LT(std::abs(result.energy.closure()), 2e-3);
  EXPECT_GT(result.energy.friction, 0.01);
  EXPECT_GT(std::abs(result.turn), 0.01);
}

}  // namespace
}  // namespace percal
