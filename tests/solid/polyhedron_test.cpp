// Polyhedra in a block: how they turn, and whole runs against prisms, halves and mirror images.     docs/theory/solid.md
#include "percal/solid/particle/polyhedron.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "percal/solid/march/march.hpp"
#include "percal/solid/target/contents.hpp"
#include "solid/solid_problems.hpp"

namespace percal {
namespace {

const Vertices cube_corners{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                            {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};

// From the centre of mass, in half widths.
Vertices centred(Vertices points) {
  const auto centre = mass_properties(convex_polyhedron(points)).centre;
  const auto [low, high] = extent(points, 0);
  for (auto& point : points)
    for (int d = 0; d < 3; ++d) point[d] = (point[d] - centre[d]) / ((high - low) / 2);
  return points;
}

// No mirror image of itself, and no axis along an edge.
const Vertices chip = centred({{-1, -0.7, 0}, {1, -0.5, 0.2}, {0, 0.9, 0.1}, {0.2, 0.1, 1.6}});

Problem shot(const Vertices& vertices, double elements_per_radius = 4) {
  Problem p = block_dent(elements_per_radius);
  p.alpha = 2;
  p.particle = RigidPolyhedron{.vertices = vertices,
                               .mass = p.density_ratio * mass_properties(convex_polyhedron(vertices)).volume};
  return p;
}

// All of it, free to turn about all axes, with no wave at a wall before the end.
Problem whole_shot(const Vertices& vertices) {
  Problem p = shot(vertices, 3);
  p.arithmetic = Arithmetic::double_precision;
  p.pi4 = 6.6474;
  p.width = 10, p.fine_width = p.block.fine_thickness = 3;
  p.depth = p.block.fine_depth = 12;
  p.end_time = 1;
  p.whole = p.block.whole_across = true;
  std::get<RigidPolyhedron>(p.particle).free_rotation = true;
  return p;
}

Eigen::Matrix3d diagonal(double a, double b, double c) { return Eigen::Vector3d(a, b, c).asDiagonal(); }

// Moments 1, 2, 3: about the middle one it tumbles. Angular momentum is kept by construction, so what is judged is where the body
// points: against 64 times as many steps, of second order; and its energy, which swings and does not drift.
TEST(FreeTop, AnAsymmetricOneKeepsItsEnergyAndIsTurnedInSecondOrder) {
  const auto after = [](int steps) {
    Top top(diagonal(1, 2, 3), Eigen::Vector3d::Ones());
    top.push({0.1, 2, 0.1});
    const double first = top.energy();
    double swing = 0;
    for (int k = 0; k < steps; ++k) {
      top.turn(20.0 / steps);
      swing = std::max(swing, std::abs(top.energy() / first - 1));
    }
    EXPECT_LT(swing, 20.0 / steps * 20.0 / steps) << steps;
    EXPECT_LT((top.attitude() * top.attitude().transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    return top;
  };
  const Eigen::Matrix3d exact = after(64'000).attitude();
  const double coarse = (after(500).attitude() - exact).norm(), fine = (after(1000).attitude() - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  EXPECT_LT(fine, 0.01);
}

// Of Euler's equations: in the body's own frame the momentum's course hangs on T and L alone; its middle component changes sign.
TEST(FreeTop, TumblesAboutItsMiddleAxis) {
  Top top(diagonal(1, 2, 3), Eigen::Vector3d::Ones());
  top.push({0.05, 2, 0});
  double least = 2;
  for (int k = 0; k < 4000; ++k) {
    top.turn(0.01);
    least = std::min(least, (top.attitude().transpose() * top.momentum())[1]);
  }
  EXPECT_LT(least, -1.9);
}

// Spin (w sin t, w cos t) about the axis of symmetry's neighbours, with the rate of the books.
TEST(FreeTop, ASymmetricOnePrecessesAtTheRateOfTheBooks) {
  Top top(diagonal(1, 1, 1.5), Eigen::Vector3d::Ones());
  const Eigen::Vector3d momentum(0.3, 0, 1.2);
  top.push(momentum);
  constexpr double time = 3;
  constexpr int steps = 3000;
  for (int k = 0; k < steps; ++k) top.turn(time / steps);
  const double rate = momentum.norm() / 1;  // of the axis of symmetry about the momentum: L over the moment across it
  const Eigen::Vector3d axis = Eigen::AngleAxisd(rate * time, momentum.normalized()) * Eigen::Vector3d::UnitZ();
  EXPECT_LT((top.attitude().col(2) - axis).norm(), 1e-6);
}

TEST(FreeTop, WhatIsHeldDoesNotTurn) {
  Top top(diagonal(1, 2, 3), {0, 1, 0});
  top.push({5, 2, 7});
  EXPECT_EQ(top.momentum(), Eigen::Vector3d(0, 2, 0));
  top.turn(0.5);
  EXPECT_NEAR(top.attitude()(0, 2), std::sin(0.5), 1e-14);
  EXPECT_EQ(top.attitude()(1, 1), 1);
}

// Of the inertia tensor: pushed off its centre, it begins to turn as its inverse says.
TEST(PolyhedronRun, ABlowTurnsItAsItsInertiaSays) {
  const Problem p = whole_shot(chip);
  const auto& body = std::get<RigidPolyhedron>(p.particle);
  const MassProperties found = mass_properties(convex_polyhedron(chip));
  Eigen::Matrix3d inertia;  // z upwards
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) inertia(i, j) = found.inertia[i][j] * body.mass / found.volume;
  PolyhedronRun run(p);
  run.foresee(0);
  const Eigen::Vector3d place(0.3, -0.2, 0.4), away(0, 0.6, 0.8);  // z upwards, from the centre
  const double depth = run.tip() + extent(chip, 2)[0];
  std::vector<Touch> touches{{.column = 0,
                              .node = 0,
                              .mass = 300,
                              .x = place[0],
                              .y = place[1],
                              .z = depth - place[2],
                              .away_x = away[0],
                              .away_y = away[1],
                              .away_z = -away[2],
                              .rate = 0.01}};
  run.meet(touches, {0, 1});
  const double impulse = touches[0].impulse;
  ASSERT_GT(impulse, 0);
  const Eigen::Vector3d spin = inertia.inverse() * place.cross(-impulse * away), moved = -impulse / body.mass * away;
  for (const Eigen::Vector3d& from : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
    const auto velocity = run.velocity_at({from[0], from[1], depth - from[2]});
    const Eigen::Vector3d expected = moved + spin.cross(from) + Eigen::Vector3d(0, 0, -1);
    EXPECT_NEAR(velocity[0], expected[0], 1e-12);
    EXPECT_NEAR(velocity[1], expected[1], 1e-12);
    EXPECT_NEAR(-velocity[2], expected[2], 1e-12);
  }
}

// A quarter of either. Where they stand on the surface, corners and centre are the same numbers.
TEST(PolyhedronMarch, ACubeGoesAsDeepAsThePrismOfTheSameCorners) {
  Problem prism = shot(cube_corners);
  prism.particle = cube_prism(prism.density_ratio);
  const ImpactResult expected = run_solid(prism), found = run_solid(shot(cube_corners));
  EXPECT_NEAR(found.depth, expected.depth, 1e-9 * expected.depth) << found.depth / expected.depth - 1;
  EXPECT_EQ(found.steps, expected.steps);
  EXPECT_NEAR(found.energy.sum(), expected.energy.sum(), 1e-8) << found.energy.sum() - expected.energy.sum();
}

// Free to turn in its plane, as half of the block and of an eroding target.
TEST(PolyhedronMarch, ASquareThatTurnsIsThePrismThatDoes) {
  const double c = std::cos(0.2), s = std::sin(0.2);
  Vertices corners;
  std::vector<std::array<double, 2>> profile;
  for (const auto& [x, y] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
    profile.push_back({c * x - s * y, s * x + c * y});
    for (const double across : {-0.6, 0.6}) corners.push_back({profile.back()[0], across, profile.back()[1]});
  }
  Problem solid = shot(corners), prism = solid;
  for (Problem* p : {&solid, &prism}) p->whole = true, p->end_time = 3;
  std::get<RigidPolyhedron>(solid.particle).free_rotation = true;
  const double mass = std::get<RigidPolyhedron>(solid.particle).mass;
  prism.particle = RigidPolygon{
      .vertices = profile, .mass = mass, .inertia = mass * 2 / 3, .free_rotation = true, .half_thickness = 0.6};
  const ImpactResult expected = run_solid(prism), found = run_solid(solid);
  ASSERT_GT(std::abs(expected.turn), 0.01);
  EXPECT_NEAR(found.turn, expected.turn, 1e-5);
  EXPECT_NEAR(found.depth, expected.depth, 1e-5 * expected.depth);
  EXPECT_NEAR(found.sideways, expected.sideways, 1e-5);
  EXPECT_FALSE(found.in_space);
}

TEST(PolyhedronMarch, HalvesAndTheWholeGoAsDeepAsAQuarter) {
  Problem quarter = block_setting_s();
  quarter.particle = shot(cube_corners).particle;
  quarter.end_time = 5;
  const ImpactResult expected = run_solid(quarter);
  ASSERT_GT(expected.eroded, 10);
  for (const auto& [along, across] : {std::pair(true, false), {false, true}, {true, true}}) {
    Problem more = quarter;
    more.whole = along, more.block.whole_across = across;
    const ImpactResult found = run_solid(more);
    const double times = (along ? 2 : 1) * (across ? 2 : 1);
    EXPECT_EQ(found.elements, times * expected.elements);
    EXPECT_NEAR(found.depth, expected.depth, 1e-6 * expected.depth) << along << across;
    EXPECT_NEAR(found.eroded, times * expected.eroded, 0.01 * times * expected.eroded);
    EXPECT_NEAR(found.energy.collisions, expected.energy.collisions, 1e-6);
  }
}

TEST(PolyhedronMarch, ACubeThatIsFreeToTurnAboutAllAxesAndStandsStraightGoesStraight) {
  Problem held = whole_shot(cube_corners);
  std::get<RigidPolyhedron>(held.particle).free_rotation = false;
  const ImpactResult expected = run_solid(held), found = run_solid(whole_shot(cube_corners));
  EXPECT_NEAR(found.depth, expected.depth, 1e-9);
  ASSERT_TRUE(found.in_space);
  EXPECT_LT(std::abs(found.sideways), 1e-9);
  EXPECT_LT(std::abs(found.in_space->across), 1e-9);
  EXPECT_LT(std::abs(found.turn), 1e-9);
}

// In x = 0, in y = 0, and turned by a right angle about the vertical, which takes x to y. A vector about which a body turns keeps its part
// across the mirror, and the others change sign.
TEST(PolyhedronMarch, AMirroredBodyHasTheMirroredPath) {
  const ImpactResult path = run_solid(whole_shot(chip));
  ASSERT_TRUE(path.in_space);
  ASSERT_GT(std::abs(path.turn), 0.01);
  ASSERT_GT(std::abs(path.in_space->across), 1e-4);
  const auto run_of = [](auto image) {
    Vertices points;
    for (const auto& [x, y, z] : chip) points.push_back(image(x, y, z));
    return run_solid(whole_shot(points));
  };
  using Point3 = std::array<double, 3>;
  const auto expect_path = [&](const ImpactResult& found, double x, double y, const Point3& axis) {
    constexpr double near = 1e-7;
    EXPECT_NEAR(found.depth, path.depth, near);
    EXPECT_NEAR(found.turn, path.turn, near);
    EXPECT_NEAR(found.sideways, x, near);
    EXPECT_NEAR(found.in_space->across, y, near);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(found.in_space->axis[d], axis[d], 1e-5) << d;
  };
  const auto [ax, ay, az] = path.in_space->axis;
  const double x = path.sideways, y = path.in_space->across;
  expect_path(run_of([](double a, double b, double c) { return Point3{-a, b, c}; }), -x, y, {ax, -ay, -az});
  expect_path(run_of([](double a, double b, double c) { return Point3{a, -b, c}; }), x, -y, {-ax, ay, -az});
  expect_path(run_of([](double a, double b, double c) { return Point3{-b, a, c}; }), -y, x, {-ay, ax, az});
}

TEST(PolyhedronMarch, TheSameBitsForAnyNumberOfThreads) {
  Problem p = whole_shot(chip);
  p.arithmetic = Arithmetic::single_precision;
  p.erosion = StrainErosion{0.3};
  p.friction = CoulombFriction{0.2};
  const ImpactResult one = run_solid(p, 1);
  EXPECT_GT(one.eroded, 10);
  for (const int threads : {2, 5}) {
    const ImpactResult more = run_solid(p, threads);
    EXPECT_EQ(more.depth, one.depth);
    EXPECT_EQ(more.turn, one.turn);
    EXPECT_EQ(more.in_space->axis, one.in_space->axis);
    EXPECT_EQ(more.energy.sum(), one.energy.sum());
  }
}

struct Momentum {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
};
// Of nodes with an eighth of the mass of each brick around them; z upwards, about a point.
Momentum momentum_of(const SpaceTarget& target) {
  Momentum sum;
  const auto vector = [](const SpacePoint& p) { return Eigen::Vector3d(p[0], p[1], p[2]); };
  for (std::size_t k = 0; k < target.ends.size(); ++k)
    for (int a = 0; a < 8; ++a) {
      const int n = target.corners[8 * k + a];
      const Eigen::Vector3d mv = target.volume[k] / 8 * vector(target.velocity[n]);
      sum.linear += mv;
      sum.angular += vector(target.position[n]).cross(mv);
    }
  return sum;
}

// Momenta of body and target at the end, over the body's mass.
struct Books {
  ImpactResult result;
  Momentum body, target;
};
Books books_of(const Problem& p) {
  LastFrame last;
  Books books{run_solid(p, last, 1), {}, momentum_of(last.space.target)};
  const SpacePiece& chip_now = last.space.particle;
  const auto vector = [](const SpacePoint& point) { return Eigen::Vector3d(point[0], point[1], point[2]); };
  // The centre of a tetrahedron is the mean of its corners; about it, it has the angular momentum of a twentieth of its mass at each.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), centre = velocity;
  for (int k = 0; k < 4; ++k) {
    velocity += vector(chip_now.velocity[k]) / 4;
    centre += vector(chip_now.position[k]) / 4;
  }
  for (int k = 0; k < 4; ++k)
    books.body.angular += (vector(chip_now.position[k]) - centre).cross(vector(chip_now.velocity[k]) - velocity) / 20;
  books.body.angular += centre.cross(velocity);
  books.body.linear = velocity;
  EXPECT_NEAR(centre[0], books.result.sideways, 1e-12);
  EXPECT_NEAR(centre[1], books.result.in_space->across, 1e-12);
  const double mass = std::get<RigidPolyhedron>(p.particle).mass;
  books.target.linear /= mass;
  books.target.angular /= mass;
  return books;
}

TEST(PolyhedronMarch, WhatTheBodyLosesAlongAllAxesTheTargetGains) {
  for (const bool erodes : {false, true})
    for (const double friction : {0.0, 0.3}) {
      Problem p = whole_shot(chip);
      if (erodes) p.erosion = StrainErosion{0.3};
      if (friction > 0) p.friction = CoulombFriction{friction};
      const auto [result, body, target] = books_of(p);
      EXPECT_EQ(result.eroded > 0, erodes);
      EXPECT_NEAR(result.end_speed + result.target_momentum, 1, 1e-12);
      EXPECT_LT(std::abs(result.energy.closure()), 2e-3);
      EXPECT_LT((body.linear + target.linear + Eigen::Vector3d::UnitZ()).norm(), 1e-10) << "of what runs to the walls";
      EXPECT_GT(target.linear.head<2>().norm(), 1e-4) << "it goes aside";
    }
}

// Impulses act where nodes are at the end of a step and move nodes and body on: what that leaves of the angular momentum is of the
// order of the step.
TEST(PolyhedronMarch, WhatTheBodyLosesAboutAllAxesTheTargetGainsAsTheStepShrinks) {
  std::vector<double> errors;
  for (const double factor : {0.8, 0.4, 0.2, 0.1}) {
    Problem p = whole_shot(chip);
    p.time_step_factor = factor;
    const auto [result, body, target] = books_of(p);
    errors.push_back((body.angular + target.angular).norm() / target.angular.norm());
  }
  for (std::size_t k = 1; k < errors.size(); ++k) EXPECT_LT(errors[k], 0.6 * errors[k - 1]) << k;
  EXPECT_LT(errors.back(), 0.01);
}

TEST(PolyhedronMarch, AnErodingWholeRunKeepsItsEnergy) {
  Problem p = block_setting_s(3);
  p.particle = shot(chip).particle;
  std::get<RigidPolyhedron>(p.particle).free_rotation = true;
  p.whole = p.block.whole_across = true;
  p.fine_width = p.block.fine_thickness = 2;
  p.block.fine_depth = 12;
  const ImpactResult result = run_solid(p);
  EXPECT_EQ(result.outcome, Outcome::stopped) << result.reason;
  EXPECT_GT(result.eroded, 50);
  EXPECT_LT(std::abs(result.energy.closure()), 0.01);
  EXPECT_GT(result.turn, 0.1);
}

// Of a quarter nothing lies beyond its planes of symmetry; of a whole body all corners are there, and the cut is where the plane is.
TEST(PolyhedronFrame, HasTheBodyWhereItIs) {
  Problem quarter = shot(cube_corners, 3);
  quarter.end_time = 2;
  LastFrame last;
  const ImpactResult result = run_solid(quarter, last, 1);
  for (const auto& [x, y, z] : last.space.particle.position) {
    EXPECT_GE(x, -1e-12);
    EXPECT_GE(y, -1e-12);
    EXPECT_GE(z, -result.depth - 1e-9);
  }
  ASSERT_EQ(last.frame.particle.outline.size(), 4u);
  EXPECT_EQ(last.frame.particle.position[0][0], 0) << "from the axis at the bottom";
  EXPECT_NEAR(last.frame.particle.position[0][1], -result.depth, 1e-9);
  EXPECT_EQ(last.frame.particle.position[3][0], 0) << "to the axis at the top";
  Problem whole = whole_shot(chip);
  whole.end_time = 0.5;
  run_solid(whole, last, 1);
  ASSERT_EQ(last.space.particle.position.size(), 4u);
  ASSERT_EQ(last.space.particle.ends.size(), 4u);
  EXPECT_GE(last.frame.particle.outline.size(), 3u);
  const auto& grid = last.frame.target.position;
  EXPECT_TRUE(std::ranges::any_of(grid, [](const Point& p) { return p[0] < -8; }));
}

}  // namespace
}  // namespace percal
