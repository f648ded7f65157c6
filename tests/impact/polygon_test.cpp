// Rigid profiles: what they do to nodes against hand computation, and what a free one does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "impact/impulse.hpp"
#include "impact/meeting.hpp"
#include "impact/polygons.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/particle/particle.hpp"
#include "percal/impact/target/constants.hpp"

namespace percal {
namespace {

// An undeformed target at rest, into which a particle moves by that much in one step.
template <class ParticleRun>
class OneStep {
 public:
  OneStep(const Problem& problem, double by)
      : particle_(problem),
        block_(problem, mesh_of(problem), kernel<double>().lanes),
        zone_(block_, kernel<double>(), particle_),
        by_(by) {}
  void take_columns_out_of_reach(int begin, int end) {
    for (int i = begin; i < end; ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j) block_.view().touchable[block_.at(i, j)] = 0;
  }
  void take() {
    zone_.search(block_.mesh().rows, 1);
    meet(zone_, block_.mesh(), 0, by_);
    particle_.drift(by_);
  }
  // Of the target, over what moment(x, z, v_x, v_z) says of unit mass.
  template <class Of>
  double sum(Of of) const {
    double sum = 0;
    for (int i = 0; i <= block_.mesh().columns(); ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j) {
        const long n = block_.at(i, j);
        sum += block_.mass(i, j) *
               of(block_.mesh().radius[i], j * block_.mesh().row_height, block_.view().v_r[n], block_.view().v_z[n]);
      }
    return sum;
  }
  double momentum() const {
    return sum([](double, double, double, double v_z) { return v_z; });
  }
  double lost() const { return zone_.collisions(); }
  const Block<double>& block() const { return block_; }
  const ParticleRun& particle() const { return particle_; }

 private:
  ParticleRun particle_;
  Block<double> block_;
  ContactZone<double, ParticleRun> zone_;
  double by_;
};

// What a particle too heavy to be slowed down does in one step, over the step: nodes are moved to its surface.
constexpr double heavy = 1e7;
template <class ParticleRun = PolygonRun>
double push_of_heavy(Problem p, double depth) {
  if (auto* profile = std::get_if<RigidPolygon>(&p.particle)) profile->mass = heavy;
  p.density_ratio = heavy;
  OneStep<ParticleRun> step(p, depth);
  step.take();
  return step.momentum() * depth;
}

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
TEST(Polygon, AConesPushIsTheIntegralOfItsOverlap) {
  for (const double half_angle : {0.7, std::numbers::pi / 4}) {
    const double depth = 0.5, sine = std::sin(half_angle), tangent = std::tan(half_angle);
    const double exact = sine * sine * tangent * tangent * std::pow(depth, 4) / 24;
    double last = 1;
    for (const int elements : {20, 40, 80}) {
      const double error = std::abs(push_of_heavy(cone(half_angle, elements), depth) / exact - 1);
      EXPECT_LT(error, 0.35 * last) << half_angle << ": of second order in the mesh";
      last = error;
    }
    EXPECT_LT(last, 0.02);
  }
}

// The bottom is the nearest side where |x| < 1 - s: the integral of 2 s (1 - s) to D.
TEST(Polygon, ASquaresPushSideFirstIsTheIntegralOverThePartThatItsBottomIsNearestTo) {
  const double depth = 0.45, exact = depth * depth - 2.0 / 3 * std::pow(depth, 3);
  EXPECT_NEAR(push_of_heavy(prism_impact(square_on_its_side(), 60), depth), exact, 2e-2 * exact)
      << "the diagonals count twice";
}

TEST(Polygon, ANodeIsPushedAcrossTheNearestSide) {
  PolygonRun square(prism_impact(square_on_its_side()));
  square.foresee(0.45);  // its bottom is then at z = 0.45
  const Overlap below = square.overlap(0.2, 0.3), beside = square.overlap(-0.9, 0.2);
  EXPECT_NEAR(below.gap, 0.15, 1e-15);
  EXPECT_NEAR(below.normal_z, 1, 1e-15);
  EXPECT_NEAR(beside.gap, 0.1, 1e-15);
  EXPECT_NEAR(beside.normal_x, -1, 1e-15);
  EXPECT_EQ(square.overlap(0.2, 0.46).gap, 0);
  EXPECT_EQ(square.overlap(1.01, 0.2).gap, 0);
}

TEST(Polygon, ANodeAsNearToTwoSidesIsPushedAlongTheirMean) {
  const double depth = 0.55;
  OneStep<PolygonRun> step(prism_impact(square_on_its_corner(), 10), depth);
  step.take();
  const auto& block = step.block();
  int middle = 0;
  while (block.mesh().radius[middle] != 0) ++middle;
  for (int j = 0; j <= block.mesh().rows; ++j) {
    // On the middle line both sides are (D - z) sin 45 deg away, and the mean normal (0, sin 45 deg): it ends at the tip.
    const double below = std::max(0.0, step.particle().tip() - j * block.mesh().row_height);
    EXPECT_EQ(block.view().u_r[block.at(middle, j)], 0);
    if (below > 0.1)
      EXPECT_NEAR(block.view().u_z[block.at(middle, j)], below, 0.01 * depth) << "the particle slows down";
  }
  // Beside it only the nearer side pushes, along its own normal.
  const long beside = block.at(middle + 1, 0);
  EXPECT_GT(block.view().v_r[beside], 0);
  EXPECT_NEAR(block.view().v_r[beside], block.view().v_z[beside], 1e-14);
}

// Nodes under the right half of a square push it up there, and to the left at its corner: it turns anticlockwise.
TEST(Polygon, NodesToTheRightTurnItAnticlockwise) {
  Problem p = prism_impact(square_on_its_side(), 10);
  std::get<RigidPolygon>(p.particle).free_rotation = true;
  OneStep<PolygonRun> right(p, 0.3), left(p, 0.3);
  const int columns = right.block().mesh().columns();
  right.take_columns_out_of_reach(0, columns / 2 + 1);
  right.take();
  EXPECT_GT(right.particle().turn(), 0);
  EXPECT_LT(right.particle().sideways(), 0);
  left.take_columns_out_of_reach(columns / 2, columns + 1);
  left.take();
  EXPECT_EQ(left.particle().turn(), -right.particle().turn());
  EXPECT_EQ(left.particle().sideways(), -right.particle().sideways());
}

TEST(Polygon, WhatAFreeOneLosesTheNodesGain) {
  Problem p = prism_impact(parallelogram({1, 0.3}, {-0.2, 0.8}), 10);
  auto& profile = std::get<RigidPolygon>(p.particle);
  profile.free_rotation = true;
  const double by = 0.4, centre = by - 0.8;  // where the step would take it
  OneStep<PolygonRun> step(p, by);
  step.take();
  const double spin = step.particle().velocity_at(0, 1).x - step.particle().velocity_at(0, 0).x;
  const double right = step.sum([](double, double, double v_x, double) { return v_x; });
  const double turning =
      step.sum([&](double x, double z, double v_x, double v_z) { return v_x * (z - centre) - v_z * x; });
  EXPECT_LT(step.particle().speed(), 0.999);
  EXPECT_NEAR(step.momentum(), profile.mass * (1 - step.particle().speed()), 1e-13);
  EXPECT_GT(std::abs(spin), 1e-4);
  EXPECT_NEAR(turning, -profile.inertia * spin, 1e-13);
  EXPECT_NEAR(right, -profile.mass * step.particle().sideways() / by, 1e-13);
  const double nodes = step.sum([](double, double, double v_x, double v_z) { return 0.5 * (v_x * v_x + v_z * v_z); });
  EXPECT_NEAR(step.lost(), 0.5 * profile.mass - step.particle().energy().kinetic - nodes, 1e-13);
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
  const double of_polygon = push_of_heavy(polygon, 0.5), of_cylinder = push_of_heavy<SphereRun>(cylinder, 0.5);
  EXPECT_NEAR(of_polygon, of_cylinder, 0.01 * of_cylinder);
  EXPECT_LT(of_polygon, of_cylinder) << "the sides lie inside the circle";
}

// A disc pushed in by D below the surface: the integral of (1 - rho) (z/rho) over the part in the target.
TEST(Cylinder, PushIsTheIntegralOfItsOverlap) {
  Problem p = prism_impact(square_on_its_corner(), 60);
  p.particle = RigidSphere{};
  const double depth = 0.5, surface = 1 - depth;  // the surface lies this far below the centre
  double exact = 0;
  const int parts = 20000;
  for (int k = 0; k < parts; ++k) {
    // Rings: of the circle of radius rho the arc with z > surface has the integral 2 sqrt(rho^2 - surface^2) of z/rho.
    const double rho = surface + depth * (k + 0.5) / parts;
    exact += (1 - rho) * 2 * std::sqrt(rho * rho - surface * surface) * depth / parts;
  }
  EXPECT_NEAR(push_of_heavy<SphereRun>(p, depth), exact, 3e-3 * exact);
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
      const double mass = (whole ? 1 : 0.5) * p.density_ratio * (round ? std::numbers::pi : 2);
      expect_that_the_force_slows_it(result.history, mass);
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
