// Rigid profiles: contact forces against hand computation, and what a free one does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "impact/polygons.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/particle/particle.hpp"
#include "percal/impact/target/constants.hpp"

namespace percal {
namespace {

constexpr double stiffness_per_mass = 3;

// An undeformed target with a profile or cylinder pushed into it.
template <class ParticleRun>
class Pushed {
 public:
  Pushed(const Problem& problem, double by)
      : particle_(problem), block_(problem, mesh_of(problem), stiffness_per_mass, kernel<double>().lanes) {
    particle_.drift(by);
  }
  ContactReport touch() { return touch_columns_of(0, block_.mesh().columns() + 1); }
  ContactReport touch_columns_of(int begin, int end) {
    const int lanes = kernel<double>().lanes;
    const Rows all{0, (block_.mesh().rows + lanes) / lanes * lanes};
    return particle_.touch(kernel<double>(), block_, block_.far_forces(), {begin, end, all});
  }
  const Block<double>& block() const { return block_; }
  ParticleRun& particle() { return particle_; }

 private:
  ParticleRun particle_;
  Block<double> block_;
};

// A cone in an axisymmetric scene, its tip at the origin's height: half width 1 at height h, and a flat top.
Problem cone(double half_angle, int elements_per_radius) {
  Problem p = prism_impact({}, elements_per_radius);
  p.geometry = Geometry::axisymmetric;
  p.whole = false;
  p.depth = 4;
  const double height = 1 / std::tan(half_angle);
  p.particle = RigidPolygon{.vertices = {{0, -0.5 * height}, {1, 0.5 * height}, {-1, 0.5 * height}}, .mass = 1};
  return p;
}

// With s = D - z below the tip's height, a point is s sin - r cos deep behind the side: the integral of that, times sin, over the
// part of the cone that is in the target is sin^2 tan^2 D^4/24 per radian.
TEST(Polygon, AConesForceIsTheIntegralOfItsOverlap) {
  for (const double half_angle : {0.3, std::numbers::pi / 4}) {
    const double depth = 0.5, sine = std::sin(half_angle), tangent = std::tan(half_angle);
    const double exact = stiffness_per_mass * sine * sine * tangent * tangent * std::pow(depth, 4) / 24;
    double last = 1;
    for (const int elements : {20, 40, 80}) {
      const double error = std::abs(Pushed<PolygonRun>(cone(half_angle, elements), depth).touch().force / exact - 1);
      EXPECT_LT(error, 0.35 * last) << "of second order in the mesh";
      last = error;
    }
    EXPECT_LT(last, 0.02) << "a cone of 0.3 rad is 12 elements wide here";
  }
}

// Corner first, two sides at 45 degrees: 2 sin^2 tan D^3/6 = D^3/6 per thickness.
TEST(Polygon, ASquaresForceCornerFirstIsTheIntegralOfItsOverlap) {
  const double depth = 0.6;
  Problem p = prism_impact(square_on_its_corner(), 60);
  const ContactReport report = Pushed<PolygonRun>(p, depth).touch();
  const double exact = stiffness_per_mass * std::pow(depth, 3) / 6;
  EXPECT_NEAR(report.force, exact, 2e-3 * exact);
  EXPECT_EQ(report.sideways, 0);
  EXPECT_EQ(report.torque, 0);
}

// Side first, the bottom is the nearest side where |x| < 1 - s: the integral of 2 s (1 - s) to D.
TEST(Polygon, ASquaresForceSideFirstIsTheIntegralOverThePartThatItsBottomIsNearestTo) {
  const double depth = 0.45;
  Problem p = prism_impact(square_on_its_side(), 60);
  const double exact = stiffness_per_mass * (depth * depth - 2.0 / 3 * std::pow(depth, 3));
  EXPECT_NEAR(Pushed<PolygonRun>(p, depth).touch().force, exact, 1e-2 * exact);
}

TEST(Polygon, ANodeAsNearToTwoSidesIsPushedAlongTheirMean) {
  const double depth = 0.55;
  Pushed<PolygonRun> pushed(prism_impact(square_on_its_corner(), 10), depth);
  pushed.touch();
  const auto& block = pushed.block();
  int middle = 0;
  while (block.mesh().radius[middle] != 0) ++middle;
  for (int j = 0; j <= block.mesh().rows; ++j) {
    // On the middle line both sides are (D - z) sin 45 deg away; the mean normal is (0, sin 45 deg).
    const double below = std::max(0.0, depth - j * block.mesh().row_height);
    EXPECT_EQ(block.far_forces().r[block.at(middle, j)], 0);
    EXPECT_NEAR(block.far_forces().z[block.at(middle, j)], stiffness_per_mass * block.mass(middle, j) * below / 2,
                1e-14);
  }
  // Beside it only the nearer side pushes, along its own normal.
  const long beside = block.at(middle + 1, 0);
  EXPECT_GT(block.far_forces().r[beside], 0);
  EXPECT_NEAR(block.far_forces().r[beside], block.far_forces().z[beside], 1e-14);
}

// Nodes under the right half of a square push it up there, and to the left at its corner: it turns anticlockwise.
TEST(Polygon, NodesToTheRightTurnItAnticlockwise) {
  Problem p = prism_impact(square_on_its_side(), 10);
  std::get<RigidPolygon>(p.particle).free_rotation = true;
  Pushed<PolygonRun> pushed(p, 0.3);
  const int columns = pushed.block().mesh().columns();
  const ContactReport right = pushed.touch_columns_of(columns / 2 + 1, columns + 1);
  EXPECT_GT(right.torque, 0);
  EXPECT_LT(right.sideways, 0);
  pushed.particle().kick(right, 0.1);
  pushed.particle().drift(0.1);
  EXPECT_GT(pushed.particle().turn(), 0);
  EXPECT_LT(pushed.particle().sideways(), 0);
  const ContactReport left = Pushed<PolygonRun>(p, 0.3).touch_columns_of(0, columns / 2);
  EXPECT_EQ(left.torque, -right.torque);
  EXPECT_EQ(left.sideways, -right.sideways);
}

// The torque is the derivative of the spring energy by the angle, the force by the depth.
TEST(Polygon, ForceAndTorqueAreDerivativesOfTheSpringEnergy) {
  const auto energy = [](double angle, double depth) {
    Pushed<PolygonRun> pushed(prism_impact(turned(parallelogram({1, 0.3}, {-0.2, 0.8}), angle), 40), 0);
    pushed.particle().drift(depth - pushed.particle().tip());
    return pushed.touch().spring_energy;
  };
  // Turning keeps the centre of mass where it is: the tip's depth changes by as much as the tip below the centre does.
  const auto lowest = [](double angle) {
    double low = 0;
    for (const auto& corner : turned(parallelogram({1, 0.3}, {-0.2, 0.8}), angle)) low = std::min(low, corner[1]);
    return -low;
  };
  Pushed<PolygonRun> pushed(prism_impact(parallelogram({1, 0.3}, {-0.2, 0.8}), 40), 0.4);
  const ContactReport report = pushed.touch();
  const double step = 1e-5;
  EXPECT_NEAR(report.force, (energy(0, 0.4 + step) - energy(0, 0.4 - step)) / (2 * step), 1e-3 * report.force);
  const double centre = 0.4 - lowest(0);
  const double by_angle = (energy(step, centre + lowest(step)) - energy(-step, centre + lowest(-step))) / (2 * step);
  EXPECT_NEAR(report.torque, -by_angle, 1e-3 * std::abs(report.torque));
  EXPECT_GT(std::abs(report.torque), 0.01 * report.force);
}

// A corner to the right of the centre of mass makes it fall over anticlockwise: what tips goes on tipping.
TEST(Polygon, AFreeSquareDroppedCornerFirstTipsOverToTheSideItLeansTo) {
  for (const double lean : {0.05, -0.05}) {
    Problem p = prism_impact(turned(square_on_its_corner(), lean), 7);
    std::get<RigidPolygon>(p.particle).free_rotation = true;
    p.end_time = 3;
    const ImpactResult result = run_impact(p);
    EXPECT_GT(result.turn * lean, 0) << "turned by " << result.turn << " rad, leaning by " << lean;
    EXPECT_GT(std::abs(result.turn), 0.01);
  }
}

TEST(Polygon, ThatIsHeldDoesNotTurn) {
  Problem p = prism_impact(turned(square_on_its_corner(), 0.3));
  p.end_time = 3;
  const ImpactResult result = run_impact(p);
  EXPECT_EQ(result.turn, 0);
  EXPECT_EQ(result.sideways, 0);
  EXPECT_GT(result.depth, 1);
}

// Without its corners' flat sides a polygon of 64 sides is a cylinder.
TEST(Polygon, APolygonOfManySidesMeetsTheCylinder) {
  Corners corners;
  for (int k = 0; k < 64; ++k)
    corners.push_back({std::cos(k * std::numbers::pi / 32), std::sin(k * std::numbers::pi / 32)});
  const Problem polygon = prism_impact(corners, 40);
  Problem cylinder = polygon;
  cylinder.particle = RigidSphere{};
  const double of_polygon = Pushed<PolygonRun>(polygon, 0.5).touch().force,
               of_cylinder = Pushed<SphereRun>(cylinder, 0.5).touch().force;
  EXPECT_NEAR(of_polygon, of_cylinder, 0.01 * of_cylinder);
  EXPECT_LT(of_polygon, of_cylinder) << "the sides lie inside the circle";
}

// A disc pushed in by D below the surface: the integral of (1 - rho) (z/rho) over the part in the target.
TEST(Cylinder, ForceIsTheIntegralOfItsOverlap) {
  Problem p = prism_impact(square_on_its_corner(), 60);
  p.particle = RigidSphere{};
  const double depth = 0.5, surface = 1 - depth;  // the surface lies this far below the centre
  double exact = 0;
  const int parts = 20000;
  for (int k = 0; k < parts; ++k) {
    // Rings: of the circle of radius rho the arc with z > surface has the integral 2 sqrt(rho^2 - surface^2) of z/rho.
    const double rho = surface + depth * (k + 0.5) / parts;
    exact += stiffness_per_mass * (1 - rho) * 2 * std::sqrt(rho * rho - surface * surface) * depth / parts;
  }
  EXPECT_NEAR(Pushed<SphereRun>(p, depth).touch().force, exact, 3e-3 * exact);
}

// pi rho per thickness for the cylinder, area times density for the prism, half of it in half a model.
TEST(PlaneStrain, TheForcesImpulseIsTheMassTimesTheSpeedLost) {
  Problem p = prism_impact(square_on_its_corner());
  p.alpha = 3;
  p.erosion = NoErosion{};
  p.arithmetic = Arithmetic::double_precision;
  p.rates = 1;
  p.end_time = 2;
  p.history_samples = 100000;
  for (const bool whole : {true, false})
    for (const bool round : {true, false}) {
      p.whole = whole;
      if (round)
        p.particle = RigidSphere{};
      else
        p.particle = prism_of(square_on_its_corner(), p.density_ratio);
      const ImpactResult result = run_impact(p);
      double impulse = 0;
      for (std::size_t k = 1; k < result.history.size(); ++k)
        impulse += 0.5 * (result.history[k].force + result.history[k - 1].force) *
                   (result.history[k].time - result.history[k - 1].time);
      const double mass = (whole ? 1 : 0.5) * p.density_ratio * (round ? std::numbers::pi : 2);
      EXPECT_NEAR(impulse, mass * (1 - result.end_speed), 2e-3 * impulse);
      EXPECT_LT(result.end_speed, 0.95);
    }
}

TEST(PlaneStrain, EnergyClosesForEveryParticle) {
  const auto closure = [](const Particle& particle, int rates) {
    Problem p = prism_impact(square_on_its_corner(), 7);
    p.particle = particle;
    p.rates = rates;
    p.end_time = 4;
    const ImpactResult result = run_impact(p);
    EXPECT_GT(result.eroded, 20);
    return std::abs(result.energy.closure());
  };
  RigidPolygon free = prism_of(parallelogram({1, 0.3}, {-0.2, 0.8}), 8.4);
  free.free_rotation = true;
  for (const int rates : {1, 2}) {
    EXPECT_LT(closure(RigidSphere{}, rates), 5e-3);
    EXPECT_LT(closure(prism_of(square_on_its_corner(), 8.4), rates), 5e-3);
    EXPECT_LT(closure(prism_of(square_on_its_side(), 8.4), rates), 5e-3);
    EXPECT_LT(closure(free, rates), 5e-3) << "turning";
  }
}

}  // namespace
}  // namespace percal
