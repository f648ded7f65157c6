// An elastic sphere thrown at a rigid frictionless plane: Hertz's quasi-static impact. Radius, density and Young's modulus are 1.
// Hertz takes the sphere for a half space: what is found differs by a share of contact radius over radius, 0.14 at a speed of 0.004
// and 0.08 at 0.001, on top of the mesh's error.
#include <numbers>

#include "verification/verification.hpp"

namespace percal {
namespace {

struct Impact {
  double largest_force, contact_time, restitution;
};

constexpr double poisson = 0.3, stiffness = 5;

// F = (4/3) E* sqrt(R) d^(3/2), so that m v^2/2 = (8/15) E* sqrt(R) d^(5/2) at the deepest d.
Impact closed_form(double speed) {
  const double modulus = 1 / (1 - poisson * poisson), mass = 4 * std::numbers::pi / 3;
  const double depth = std::pow(15 * mass * speed * speed / (16 * modulus), 0.4);
  const double coefficient = 2 * std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);
  return {4.0 / 3 * modulus * std::pow(depth, 1.5), coefficient * depth / speed, 1};
}

// The plane z = -1 pushes each node of the boundary with a spring, `stiffness` times E a unit area and element length.
Impact impact(int elements_per_radius, double speed) {
  const Disc made = half_disc(elements_per_radius);
  BodySolid solid = elastic_solid(1, poisson, 1);
  solid.linear_viscosity = 0.06;
  Body body(made.mesh, Geometry::axisymmetric, solid);
  for (int n = 0; n < body.nodes(); ++n) body.set_velocity(n, {0, -speed});
  body.forces();
  struct Spring {
    int node;
    double stiffness;
  };
  std::vector<Spring> springs;
  const double full_turn = 2 * std::numbers::pi;
  const int near_pole = static_cast<int>(made.boundary.size()) / 4;
  const auto radius = [&](int k) { return made.mesh.nodes[made.boundary[k]][0]; };
  for (int k = 0; k < near_pole; ++k) {
    // The ring that belongs to the node, a radian: its hat function against r dr.
    const double after = (radius(k + 1) - radius(k)) * (2 * radius(k) + radius(k + 1)) / 6;
    const double before = k == 0 ? 0 : (radius(k) - radius(k - 1)) * (2 * radius(k) + radius(k - 1)) / 6;
    springs.push_back({made.boundary[k], stiffness * elements_per_radius * (before + after)});
  }
  double stiffest = 0;  // largest k/m
  for (const auto& spring : springs) stiffest = std::max(stiffest, spring.stiffness / body.mass(spring.node));
  const double element = body.stable_step(), dt = 0.8 / std::sqrt(1 / (element * element) + stiffest / 4);
  std::vector<double> forces;
  double force = 0;
  const auto plane = [&] {
    force = 0;
    for (const auto& spring : springs) {
      const double push = spring.stiffness * std::max(0.0, -1 - body.position(spring.node)[1]);
      body.add_force(spring.node, {0, push});
      force += full_turn * push;
    }
  };
  const double expected = closed_form(speed).contact_time;
  for (double time = 0; time < 1.2 * expected; time += dt) {
    forces.push_back(force);
    advance(body, dt, plane);
  }
  Impact found{*std::max_element(forces.begin(), forces.end()), 0, 0};
  const auto times = crossings(forces, dt, 1e-9 * found.largest_force);
  found.contact_time = times.back() - times.front();
  double mass = 0;
  for (int n = 0; n < body.nodes(); ++n) mass += body.mass(n);
  found.restitution = body.momentum()[1] / (mass * speed);
  return found;
}

TEST(SlowHertz, AnElasticSphereOnARigidPlaneMeetsForceAndTimeOfContact) {
  struct Run {
    int elements_per_radius;
    double speed;
  };
  for (const auto& [n, speed] : {Run{12, 0.004}, Run{24, 0.004}, Run{48, 0.004}, Run{48, 0.001}}) {
    const Impact exact = closed_form(speed), found = impact(n, speed);
    const auto line = [&, n = n, speed = speed](const char* what, double value, double expected) {
      return record({"Hertz impact", fmt::format("sphere on a plane, speed {} sqrt(E/rho): {}", speed, what),
                     "closed form", fmt::format("{} elements per radius", n), value, expected});
    };
    const double force = line("largest force", found.largest_force, exact.largest_force);
    const double time = line("contact time", found.contact_time, exact.contact_time);
    const double rebound = line("rebound speed over impact speed", found.restitution, 1);
    if (n < 48) continue;
    EXPECT_LT(std::abs(force), 0.05) << speed;
    EXPECT_LT(std::abs(time), 0.05) << speed;
    EXPECT_LT(std::abs(rebound), 0.01) << speed;
  }
}

// The coefficient above is the table's: its steel sphere on a half space of steel.
TEST(Hertz, TheClosedFormIsTheTables) {
  const std::string steel = "steel sphere R=10 mm";
  const double depth = linear_exact("hertz_impact_quasi_static", steel, "max_indentation");
  const double modulus = 210e9 / 2 / (1 - 0.09), mass = 4 * std::numbers::pi / 3 * 1e-6 * 7800;
  EXPECT_NEAR(std::pow(15 * mass / (16 * modulus * 0.1), 0.4), depth, 1e-9 * depth);
  EXPECT_NEAR(linear_exact("hertz_impact_quasi_static", steel, "contact_time"),
              2 * std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9) * depth, 1e-9 * depth);
}

}  // namespace
}  // namespace percal
