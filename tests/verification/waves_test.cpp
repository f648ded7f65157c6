// Speeds of waves from the standing waves of bars, and the bar that hits a wall.
#include <numbers>

#include "verification/verification.hpp"

namespace percal {
namespace {

// The speed of the longest longitudinal wave of a block along y, free at both ends: its half length is the block's.
double standing_wave_speed(const QuadBlock& block, Geometry geometry, const BodySolid& solid, bool sides_held) {
  Body body(block.mesh, geometry, solid);
  const double length = block.mesh.nodes.back()[1], k = std::numbers::pi / length;
  const double speed_of_nodes = 1e-6 * solid.wave_speed();
  for (int n = 0; n < body.nodes(); ++n) {
    if (sides_held) body.hold(n, 0);
    body.set_velocity(n, {0, speed_of_nodes * std::cos(k * body.position(n)[1])});
  }
  body.forces();
  const double dt = 0.8 * body.stable_step();
  std::vector<double> amplitude;
  for (double time = 0; time < 2.0 * 2 * length / solid.wave_speed(); time += dt) {
    double projected = 0;
    for (int n = 0; n < body.nodes(); ++n)
      projected += body.mass(n) * body.velocity(n)[1] * std::cos(k * block.mesh.nodes[n][1]);
    amplitude.push_back(projected);
    advance(body, dt);
  }
  const auto zeros = crossings(amplitude, dt, 0);
  EXPECT_GE(zeros.size(), 3u);
  return 2 * length / (zeros.at(2) - zeros.at(0));
}

double rod(int along) {
  const double density = 7800;
  const QuadBlock block =
      rectangle({.left = 0, .right = 1, .bottom = 0, .top = 40, .across = 2, .along = along});  // radius 1, in any unit
  return standing_wave_speed(block, Geometry::axisymmetric, elastic_solid(2.1e11, 0.3, density), false);
}

TEST(Waves, ARodCarriesItsLongWavesAtTheSpeedOfTheClosedForm) {
  const double exact = linear_exact("wave_speed", "steel: E", "rod");
  for (const int along : {10, 20, 80}) {
    const double error = record({"Waves", "rod wave, steel, 40 radii long", "linear_and_wave_exact.csv",
                                 fmt::format("2 x {}", along), rod(along), exact});
    if (along == 80) {
      EXPECT_LT(std::abs(error), 0.005);
    }
  }
}

TEST(Waves, ADilatationalWaveHasTheSpeedOfTheClosedForm) {
  struct Case {
    const char* inputs;
    BodySolid solid;
  };
  const Case cases[] = {
      {"steel: E", elastic_solid(2.1e11, 0.3, 7800)},
      {"gelatin 10%: mu=80000 Pa K=8e+07", {.mu = 80e3, .bulk = 80e6, .alpha = 8.5, .density = 1010}}};
  for (const auto& [inputs, solid] : cases)
    for (const Geometry geometry : {Geometry::plane_strain, Geometry::axisymmetric})
      for (const int along : {10, 40}) {
        const QuadBlock block =
            rectangle({.left = 0, .right = 2.0 / along, .bottom = 0, .top = 1, .across = 2, .along = along});
        const double error = record(
            {"Waves",
             fmt::format("dilatational wave, {}, {}", std::string(inputs).substr(0, std::string(inputs).find(':')),
                         geometry == Geometry::axisymmetric ? "axisymmetric" : "plane strain"),
             "linear_and_wave_exact.csv", fmt::format("2 x {}", along),
             standing_wave_speed(block, geometry, solid, true), linear_exact("wave_speed", inputs, "dilatational")});
        if (along == 40) {
          EXPECT_LT(std::abs(error), 0.005) << inputs;
        }
      }
}

// St Venant's bar: 1 m of steel, nu = 0, at 1 m/s end-on against a rigid wall. The stress there is constant until the wave is back.
struct BarImpact {
  double stress, duration, rebound;
};
BarImpact bar_impact(int along) {
  const double radius = 1.0 / along, face = radius * radius / 2;  // a radian
  const double speed = 1, young = 210e9;
  const BodySolid steel = elastic_solid(young, 0, 7800);
  const QuadBlock block = rectangle({.left = 0, .right = radius, .bottom = 0, .top = 1, .across = 1, .along = along});
  Body body(block.mesh, Geometry::axisymmetric, steel);
  for (int n = 0; n < body.nodes(); ++n) body.set_velocity(n, {0, -speed});
  body.forces();
  // The wall: a spring under each node of the end face, twice as stiff as the element above its share of the face.
  const double stiffness = 2 * young * along;  // a unit area
  std::vector<double> stress;
  double force = 0;
  const auto wall = [&] {
    force = 0;
    for (const int n : block.first) {
      const double area = body.mass(n) * 2 * along / steel.density;
      const double push = stiffness * area * std::max(0.0, -body.position(n)[1]);
      body.add_force(n, {0, push});
      force += push;
    }
  };
  const double dt = 0.5 * body.stable_step(), expected = 2 / std::sqrt(young / steel.density);
  for (double time = 0; time < 1.3 * expected; time += dt) {
    stress.push_back(force / face);
    advance(body, dt, wall);
  }
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const double share = dt * static_cast<double>(i) / expected;
    if (share > 0.2 && share < 0.8) sum += stress[i], ++count;
  }
  const double plateau = sum / count;
  const auto half = crossings(stress, dt, plateau / 2);
  double mass = 0;
  for (int n = 0; n < body.nodes(); ++n) mass += body.mass(n);
  return {plateau, half.back() - half.front(), body.momentum()[1] / mass};
}

TEST(Waves, ABarOnAWallHasTheStressAndTheTimeOfStVenant) {
  const std::string bar = "steel bar L=1 m";
  for (const int along : {50, 100, 200}) {
    const BarImpact found = bar_impact(along);
    const auto line = [&](const char* what, const char* quantity, double value) {
      return record({"Waves", fmt::format("bar on a wall: {}", what), "linear_and_wave_exact.csv",
                     fmt::format("1 x {}", along), value, linear_exact("bar_on_rigid_wall", bar, quantity)});
    };
    const double stress = line("stress, Pa", "impact_stress", found.stress);
    const double time = line("contact time, s", "contact_time", found.duration);
    const double rebound = line("rebound, m/s", "rebound_speed", found.rebound);
    if (along < 200) continue;
    EXPECT_LT(std::abs(stress), 0.005);
    EXPECT_LT(std::abs(time), 0.005);
    EXPECT_LT(std::abs(rebound), 0.01);
  }
}

}  // namespace
}  // namespace percal
