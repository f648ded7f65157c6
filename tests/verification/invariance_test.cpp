// What must leave stress and energy alone, and what the march must keep: rigid motions, momentum, energy.
#include <numbers>

#include "verification/verification.hpp"

namespace percal {
namespace {

TEST(Invariance, AUniformVelocityAlongTheAxisLeavesStressAndEnergyAlone) {
  const Disc made = half_disc(6);
  Body body(made.mesh, Geometry::axisymmetric, {.mu = 1, .bulk = 50, .alpha = 8.5, .linear_viscosity = 0.06});
  for (int n = 0; n < body.nodes(); ++n) body.set_velocity(n, {0, -3});
  body.forces();
  const BodyEnergy before = body.energy();
  const double dt = 0.8 * body.stable_step();
  for (int k = 0; k < 2000; ++k) advance(body, dt);
  double stress = 0;
  for (int e = 0; e < body.elements(); ++e) {
    const auto P = body.first_piola(e);
    for (const double component : {P.rr, P.rz, P.zr, P.zz, P.hoop}) stress = std::max(stress, std::abs(component));
  }
  EXPECT_LT(stress, 1e-10);
  const double change = std::abs(sum_of(body.energy()) / sum_of(before) - 1);
  EXPECT_LT(change, 1e-12);
  record_bound("Invariance", "uniform velocity along the axis, 2000 steps: largest stress/mu",
               "half disc, 6 per radius", stress, "1e-10");
  record_bound("Invariance", "the same: relative change of energy", "half disc, 6 per radius", change, "1e-12");
}

// A body in a random state, and the same one turned by an angle.
struct Turned {
  Body plain, turned;
};
Turned turned_body(double amount, double angle) {
  const Disc made = disc(5);
  const BodySolid solid{.mu = 1, .bulk = 50, .alpha = 8.5};
  Turned pair{{made.mesh, Geometry::plane_strain, solid}, {made.mesh, Geometry::plane_strain, solid}};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  for (int n = 0; n < pair.plain.nodes(); ++n) {
    const Point at{made.mesh.nodes[n][0] + uniform(random), made.mesh.nodes[n][1] + uniform(random)};
    const Point now{std::cos(angle) * at[0] - std::sin(angle) * at[1],
                    std::sin(angle) * at[0] + std::cos(angle) * at[1]};
    pair.plain.set_displacement(n, {at[0] - made.mesh.nodes[n][0], at[1] - made.mesh.nodes[n][1]});
    pair.turned.set_displacement(n, {now[0] - made.mesh.nodes[n][0], now[1] - made.mesh.nodes[n][1]});
  }
  pair.plain.forces();
  pair.turned.forces();
  return pair;
}

TEST(Invariance, ARotationInPlaneStrainMakesNoStressAndNoEnergy) {
  const Turned rest = turned_body(0, 2.1);
  double force = 0;
  for (int n = 0; n < rest.turned.nodes(); ++n)
    for (const double f : rest.turned.force(n)) force = std::max(force, std::abs(f));
  EXPECT_LT(force, 1e-10);
  EXPECT_LT(std::abs(sum_of(rest.turned.energy())), 1e-10);
  record_bound("Invariance", "rotation by 120 degrees, plane strain: largest nodal force/mu", "disc, 5 per radius",
               force, "1e-10");
}

TEST(Invariance, ARotationTurnsTheForcesOfADeformedBodyAndKeepsItsEnergy) {
  const double angle = 2.1;
  const Turned pair = turned_body(0.04, angle);
  double wrong = 0, largest = 0;
  for (int n = 0; n < pair.plain.nodes(); ++n) {
    const Point &f = pair.plain.force(n), &g = pair.turned.force(n);
    wrong = std::max({wrong, std::abs(std::cos(angle) * f[0] - std::sin(angle) * f[1] - g[0]),
                      std::abs(std::sin(angle) * f[0] + std::cos(angle) * f[1] - g[1])});
    largest = std::max({largest, std::abs(f[0]), std::abs(f[1])});
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_LT(wrong, 1e-12 * largest);
  const BodyEnergy a = pair.plain.energy(), b = pair.turned.energy();
  EXPECT_GT(a.hourglass, 1e-3 * a.elastic);
  EXPECT_NEAR(a.elastic, b.elastic, 1e-12 * a.elastic);
  EXPECT_NEAR(a.hourglass, b.hourglass, 1e-12 * a.elastic);
  record_bound("Invariance", "the same of a deformed body: error of the forces over the largest", "disc, 5 per radius",
               wrong / largest, "1e-12");
}

// Forces are minus the derivative of the energy by each displacement, hourglass and hoop terms included.
TEST(Invariance, ForcesAreTheDerivativesOfTheEnergy) {
  for (const Geometry geometry : {Geometry::axisymmetric, Geometry::plane_strain}) {
    const QuadBlock block = distorted(rectangle({.right = 1, .top = 1, .across = 3, .along = 3}), 0.1, 4);
    Body body(block.mesh, geometry, {.mu = 1, .bulk = 5, .alpha = -5});
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform(-0.05, 0.05);
    for (int n = 0; n < body.nodes(); ++n) body.set_displacement(n, {uniform(random), uniform(random)});
    body.forces();
    for (int n = 0; n < body.nodes(); ++n)
      for (int d = 0; d < 2; ++d) {
        const Point u = body.displacement(n);
        const auto energy_at = [&](double by) {
          Point moved = u;
          moved[d] += by;
          body.set_displacement(n, moved);
          return sum_of(body.energy());
        };
        const double slope = (energy_at(1e-5) - energy_at(-1e-5)) / 2e-5;
        body.set_displacement(n, u);
        EXPECT_NEAR(body.force(n)[d], -slope, 1e-8);
      }
  }
}

TEST(Invariance, MomentumIsClosedToRoundOff) {
  for (const Geometry geometry : {Geometry::axisymmetric, Geometry::plane_strain}) {
    const Disc made = geometry == Geometry::axisymmetric ? half_disc(6) : disc(6);
    PressedBody body(made.mesh, geometry,
                     {.mu = 1, .bulk = 50, .alpha = 8.5, .linear_viscosity = 0.06, .quadratic_viscosity = 1.2});
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    for (int n = 0; n < body.nodes(); ++n)
      body.set_velocity(n, {body.held(n, 0) ? 0 : 0.1 + uniform(random), 0.2 + uniform(random)});
    // A pressure all around: on a closed surface it has no resultant. In axisymmetry the axis takes the radial part.
    auto around = made.boundary;
    if (geometry == Geometry::plane_strain) around.push_back(around.front());
    body.press(around, 0.5);
    body.forces();
    const Point before = body.momentum();
    const double dt = 0.4 * body.stable_step();
    double size = 0, worst = 0;
    for (int n = 0; n < body.nodes(); ++n) size += body.mass(n) * std::hypot(body.velocity(n)[0], body.velocity(n)[1]);
    for (int k = 0; k < 1000; ++k) {
      advance(body, dt);
      worst = std::max(worst, std::abs(body.momentum()[1] - before[1]) / size);
      if (geometry == Geometry::plane_strain) worst = std::max(worst, std::abs(body.momentum()[0] - before[0]) / size);
    }
    EXPECT_LT(worst, 1e-12);
    record_bound("Invariance",
                 fmt::format("momentum of a body thrown, shaken and pressed, {}, 1000 steps",
                             geometry == Geometry::axisymmetric ? "along the axis" : "plane strain"),
                 "6 per radius", worst, "1e-12");
  }
}

}  // namespace
}  // namespace percal
