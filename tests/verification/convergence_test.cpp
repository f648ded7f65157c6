// Orders of convergence, as slopes: double precision, no viscosity, a fixed step.
#include <numbers>

#include "verification/shells.hpp"

namespace percal {
namespace {

// Lame's thick sphere and tube under inner pressure p, inner radius 1, outer B: u(R) of linear elasticity.
double lame(Shell shell, double young, double poisson, double outer, double pressure, double R) {
  if (is_sphere(shell)) {
    const double cube = outer * outer * outer;
    return pressure / (young * (cube - 1)) * ((1 - 2 * poisson) * R + (1 + poisson) * cube / (2 * R * R));
  }
  const double square = outer * outer;
  return pressure * (1 + poisson) / (young * (square - 1)) * ((1 - 2 * poisson) * R + square / R);
}

// Root mean square over the body's mass of the error in displacement, over the displacement at the inner face.
double lame_error(Shell shell, double outer, int n) {
  const double young = 1000, poisson = 0.3, pressure = 1e-3;  // so small that nothing but the linear term is left
  ShellBody shell_body(shell, {.outer = outer, .across = n, .along = n, .growth = 1}, elastic_solid(young, poisson, 1));
  shell_body.press(pressure, 0);
  const Body& body = shell_body.body;
  EXPECT_TRUE(settle(shell_body.body, 1e-7).settled);
  double wrong = 0, mass = 0;
  for (int k = 0; k < body.nodes(); ++k) {
    const Point &at = body.mesh().nodes[k], &u = body.displacement(k);
    const double R = shell == Shell::tube_in_the_half_plane ? at[0] : std::hypot(at[0], at[1]);
    const double exact = lame(shell, young, poisson, outer, pressure, R) / R;
    const double along = shell == Shell::tube_in_the_half_plane ? 0 : exact * at[1];
    wrong += body.mass(k) * ((u[0] - exact * at[0]) * (u[0] - exact * at[0]) + (u[1] - along) * (u[1] - along));
    mass += body.mass(k);
  }
  const double error = std::sqrt(wrong / mass) / lame(shell, young, poisson, outer, pressure, 1);
  record_bound("Orders of convergence",
               fmt::format("Lame's {}: root mean square error of the displacement", name_of(shell)),
               fmt::format("{} x {}", n, n), error, "");
  return error;
}

TEST(Convergence, LamesSphereAndTubeAreMetAtSecondOrderOnCurvedMeshes) {
  EXPECT_NEAR(lame(Shell::sphere, 1000, 0.3, 2, 1, 1),
              linear_exact("lame_thick_sphere", "a=1 b=2 E=1000 p=1 nu=0.3", "u_r(a)"), 1e-12);
  EXPECT_NEAR(3 * lame(Shell::tube_in_the_plane, 1000, 0.3, 3, 1, 1),
              linear_exact("lame_thick_cylinder_MacNeal_Harder", "a=3 b=9 E=1000 p=1 nu=0.3", "u_r(a)"), 1e-12);
  for (const Shell shell : {Shell::sphere, Shell::tube_in_the_plane}) {
    std::vector<double> size, error;
    for (const int n : {4, 8, 16, 32}) {
      size.push_back(1.0 / n);
      error.push_back(lame_error(shell, is_sphere(shell) ? 2 : 3, n));
    }
    EXPECT_NEAR(slope(size, error), 2, 0.2) << name_of(shell);
    record_bound("Orders of convergence", fmt::format("Lame's {}: order in space", name_of(shell)), "4 x 4 to 32 x 32",
                 slope(size, error), "2");
  }
}

// Columns of rectangles, held in z, meet it at their nodes without an error that falls with the mesh: there is none.
TEST(Convergence, LamesTubeHeldInZIsMetAtTheNodes) { EXPECT_LT(lame_error(Shell::tube_in_the_half_plane, 3, 4), 1e-5); }

// A bar of the plane, sides held, in its first standing wave of small amplitude: u_y = sin(c k t) cos(k y)/(c k).
class StandingWave {
 public:
  StandingWave(int along, unsigned seed, double amplitude)
      : block_(distorted(rectangle({.right = 4.0 / along, .across = 4, .along = along}), 0.2 / along, seed)),
        body(block_.mesh, Geometry::plane_strain, {.mu = 1, .bulk = 3, .alpha = 2}) {
    for (const auto* side : {&block_.inner, &block_.outer})
      for (const int n : *side) body.hold(n, 0);
    for (int n = 0; n < body.nodes(); ++n)
      body.set_velocity(n, {0, amplitude * std::cos(wave_number * block_.mesh.nodes[n][1])});
    body.forces();
  }
  static constexpr double wave_number = std::numbers::pi;
  double frequency() const { return wave_number * body.solid().wave_speed(); }
  void march(double time, int steps) {
    for (int k = 0; k < steps; ++k) advance(body, time / steps);
  }

 private:
  QuadBlock block_;

 public:
  Body body;
};

TEST(Convergence, AStandingWaveIsMetAtSecondOrderOnDistortedMeshes) {
  const double amplitude = 1e-5;
  std::vector<double> size, error;
  for (const int along : {8, 16, 32, 64}) {
    StandingWave wave(along, 5, amplitude);
    const double time = 1.0 / wave.body.solid().wave_speed() * 1.7;
    wave.march(time, 10 * along);
    double wrong = 0, mass = 0;
    for (int n = 0; n < wave.body.nodes(); ++n) {
      const double y = wave.body.mesh().nodes[n][1];
      const double exact =
          amplitude / wave.frequency() * std::sin(wave.frequency() * time) * std::cos(wave.wave_number * y);
      const Point& u = wave.body.displacement(n);
      wrong += wave.body.mass(n) * (u[0] * u[0] + (u[1] - exact) * (u[1] - exact));
      mass += wave.body.mass(n);
    }
    size.push_back(1.0 / along);
    error.push_back(std::sqrt(wrong / mass) * wave.frequency() / amplitude);
    record_bound("Orders of convergence",
                 "standing wave, inner nodes moved by up to a fifth of an edge: error of the displacement",
                 fmt::format("4 x {}", along), error.back(), "");
  }
  EXPECT_NEAR(slope(size, error), 2, 0.2);
  record_bound("Orders of convergence", "standing wave: order in space", "4 x 8 to 4 x 64", slope(size, error), "2");
}

TEST(Convergence, TheMarchIsOfSecondOrderInTheStepAndSoIsItsEnergy) {
  std::vector<double> size, difference, closure;
  std::vector<Point> coarser;
  for (const int steps : {50, 100, 200, 400, 800}) {
    StandingWave wave(12, 5, 0.3);  // not small: the solid is far from linear
    const double start = sum_of(wave.body.energy()), time = 1;
    double worst = 0;
    for (int k = 0; k < steps; ++k) {
      advance(wave.body, time / steps);
      worst = std::max(worst, std::abs(sum_of(wave.body.energy()) / start - 1));
    }
    std::vector<Point> u;
    for (int n = 0; n < wave.body.nodes(); ++n) u.push_back(wave.body.displacement(n));
    if (!coarser.empty()) {
      double squares = 0;
      for (std::size_t n = 0; n < u.size(); ++n)
        for (int d = 0; d < 2; ++d) squares += (u[n][d] - coarser[n][d]) * (u[n][d] - coarser[n][d]);
      size.push_back(1.0 / steps);
      difference.push_back(std::sqrt(squares));
      closure.push_back(worst);
      record_bound("Orders of convergence", "large standing wave: worst energy closure", fmt::format("{} steps", steps),
                   worst, "");
    }
    coarser = u;
  }
  EXPECT_NEAR(slope(size, difference), 2, 0.1);
  EXPECT_NEAR(slope(size, closure), 2, 0.1);
  record_bound("Orders of convergence", "large standing wave: order in the step", "4 x 12", slope(size, difference),
               "2");
  record_bound("Orders of convergence", "large standing wave: order of the energy in the step", "4 x 12",
               slope(size, closure), "2");
}

// With viscosity and a pressure: what they take and give is booked to second order as well.
TEST(Convergence, EnergyWithViscosityAndPressureClosesAtSecondOrder) {
  std::vector<double> size, closure;
  for (const int steps : {100, 200, 400, 800}) {
    const QuadBlock block = sector({.across = 4, .along = 6});
    PressedBody body(block.mesh, Geometry::axisymmetric,
                     {.mu = 1, .bulk = 5, .alpha = 3, .linear_viscosity = 0.3, .quadratic_viscosity = 1.2});
    for (const int n : block.first) body.hold(n, 1);
    body.press(block.inner, 0.4);
    body.forces();
    double worst = 0;
    for (int k = 0; k < steps; ++k) {
      advance(body, 2.0 / steps);
      worst = std::max(worst, std::abs(body.balance()));
    }
    EXPECT_GT(body.energy().viscous, 1e-3 * body.pressure_work());
    size.push_back(1.0 / steps);
    closure.push_back(worst / body.pressure_work());
  }
  EXPECT_NEAR(slope(size, closure), 2, 0.25);
  record_bound("Orders of convergence", "shell pressed at once, with viscosity: order of the energy in the step",
               "4 x 6", slope(size, closure), "2");
}

}  // namespace
}  // namespace percal
