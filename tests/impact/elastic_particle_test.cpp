#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "impact/impulse.hpp"
#include "impact/meeting.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/particle/elastic_sphere.hpp"
#include "percal/impact/settings.hpp"
#include "percal/impact/target/constants.hpp"
#include "percal/math/statistics.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

Problem with_elastic(Problem p, double youngs_modulus, double poisson_ratio = 0.3) {
  p.particle = ElasticSphere{youngs_modulus, poisson_ratio};
  return p;
}

// Half a hexagon of side 1, its middle at the origin.
Outline half_hexagon() {
  const double half = std::sqrt(0.75);
  Outline outline;
  outline.set({{0, -1}, {half, -0.5}, {half, 0.5}, {0, 1}});
  return outline;
}

TEST(Outline, TheGapIsTheDistanceToTheNearestEdgeAndThereIsNoneOutside) {
  const Outline outline = half_hexagon();
  const Inside inside = outline.inside({0.8, 0.1});
  ASSERT_EQ(inside.ways, 1);
  EXPECT_EQ(inside.way[0].edge, 1);
  EXPECT_DOUBLE_EQ(inside.gap, std::sqrt(0.75) - 0.8);
  EXPECT_NEAR(inside.way[0].share, 0.6, 1e-15);
  EXPECT_NEAR(inside.way[0].away[0], 1, 1e-15);
  for (const Point outside : {Point{0.9, 0.1}, Point{0, -1.01}, Point{0, 1.01}, Point{0.6, 0.8}, Point{0.6, -0.8}})
    EXPECT_EQ(outline.inside(outside).ways, 0) << outside[0] << ' ' << outside[1];
  EXPECT_TRUE(outline.may_hold({0.9, 0.1}));
  EXPECT_FALSE(outline.may_hold({0.9, 0.6}));
  EXPECT_EQ(outline.lowest(), -1);
  EXPECT_EQ(outline.highest(), 1);
}

TEST(Outline, AHollowSideIsOutside) {
  Outline outline;
  outline.set({{0, -1}, {1, -1}, {0.2, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(outline.inside({0.5, 0.1}).ways, 0);
  EXPECT_EQ(outline.inside({0.5, 0.9}).ways, 1);
  const Inside at_the_dent = outline.inside({0.15, 0.01});
  EXPECT_GT(at_the_dent.ways, 0);
  EXPECT_NEAR(at_the_dent.gap, std::hypot(0.05, 0.01), 1e-15) << "a point, not the line behind it";
}

TEST(Outline, BetweenTwoEquallyNearEdgesHalfOfThePushGoesEachWay) {
  const Inside inside = half_hexagon().inside({0.5, 0});
  EXPECT_EQ(inside.ways, 1);
  Outline square;
  square.set({{0, -1}, {1, -1}, {1, 1}, {0, 1}});
  const Inside corner = square.inside({0.75, -0.75});
  ASSERT_EQ(corner.ways, 2);
  EXPECT_EQ(corner.away(), (Point{0.5, -0.5}));
}

// So contact has an energy, gap^2/2 times the stiffness, and its forces balance. The last point is between chord and arc.
TEST(Outline, ForcesAreTheDerivativesOfTheGap) {
  Outline outline(0.05);
  outline.set(half_hexagon().points());
  constexpr double h = 1e-6;
  for (const Point at : {Point{0.8, 0.1}, Point{0.3, -0.7}, Point{0.1, 0.85}, Point{0.02, -0.9}, Point{0.89, 0.1}}) {
    const Inside inside = outline.inside(at);
    ASSERT_EQ(inside.ways, 1);
    const WayOut& way = inside.way[0];
    for (int d = 0; d < 2; ++d) {
      Point plus = at, minus = at;
      plus[d] += h;
      minus[d] -= h;
      EXPECT_NEAR((outline.inside(plus).gap - outline.inside(minus).gap) / (2 * h), -way.away[d], 1e-9);
      for (int end = 0; end < 2; ++end) {
        const auto moved = [&](double by) {
          auto points = outline.points();
          points[way.edge + end][d] += by;
          Outline other(0.05);
          other.set(points);
          return other.inside(at).gap;
        };
        EXPECT_NEAR((moved(h) - moved(-h)) / (2 * h), way.by_end[end][d], 1e-8);
      }
      EXPECT_NEAR(way.by_end[0][d] + way.by_end[1][d], way.away[d], 1e-15);
    }
  }
}

// To the fourth power of the angle between two points.
TEST(ElasticParticle, ItsOutlineIsTheSphere) {
  for (const int n : {6, 12}) {
    Problem p = with_elastic(dent(), 100);
    p.elements_per_radius = n;
    const ElasticSphereRun run(p);
    const double near = 3.0 / std::pow(n, 4);
    for (double angle = 0.01; angle < 3.1; angle += 0.02) {
      const Overlap overlap = run.overlap(0.95 * std::sin(angle), 1 + 0.95 * std::cos(angle) - 2);
      EXPECT_NEAR(overlap.gap, 0.05, near + 1e-4) << angle;
      EXPECT_NEAR(overlap.normal_x, std::sin(angle), 0.1 / n);
      EXPECT_NEAR(overlap.normal_z, std::cos(angle), 0.1 / n);
      EXPECT_EQ(run.overlap((1 + near) * std::sin(angle), (1 + near) * std::cos(angle) - 1).gap, 0) << angle;
    }
  }
}

TEST(ElasticParticle, HasTheSpheresMassAndStandsOnTheSurface) {
  const ElasticSphereRun run(with_elastic(dent(), 100));
  double mass = 0;
  for (int n = 0; n < run.body().nodes(); ++n) mass += run.body().mass(n);
  EXPECT_NEAR(mass, 2.0 / 3 * 16.8, 1e-12 * 16.8);
  EXPECT_EQ(run.tip(), 0);
  EXPECT_NEAR(run.top(), -2, 1e-14);
  EXPECT_NEAR(run.speed(), 1, 1e-14);
  EXPECT_NEAR(run.energy().kinetic, 0.5 * mass, 1e-12 * mass);
}

// The sphere ploughs through nodes that nothing holds together: what it loses is what they have.
struct Cloud {
  explicit Cloud(const Problem& problem)
      : block(problem, mesh_of(problem), kernel<double>().lanes),
        sphere(problem),
        zone(block, kernel<double>(), sphere),
        step(0.5 * step_limits(problem).first_step) {}

  void run(int steps) {
    const int columns = block.mesh().columns(), lanes = kernel<double>().lanes;
    const Rows rows{0, block.mesh().rows / lanes * lanes};
    for (int k = 0; k < steps; ++k) {
      if (k % search_interval == 0) zone.search(block.mesh().rows, 0.25 + 3 * search_interval * step);
      for (int i = 0; i <= columns; ++i)
        kernel<double>().kick_and_drift(block.view(), block.far_forces(), i, rows, i == 0, 0, step);
      meet(zone, block.mesh(), step, step);
      sphere.drift(step);
    }
  }
  template <class Of>
  double sum(Of of) const {
    double sum = 0;
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) sum += block.mass(i, j) * of(block.at(i, j));
    return sum;
  }
  double momentum() const {
    return sum([&](long n) { return block.view().v_z[n]; }) - sphere.body().momentum()[1];
  }
  double energy() const {
    const auto& view = block.view();
    const double nodes = sum([&](long n) { return 0.5 * (view.v_r[n] * view.v_r[n] + view.v_z[n] * view.v_z[n]); });
    const ParticleEnergy own = sphere.energy();
    return nodes + zone.collisions() + own.collisions + own.kinetic + own.stored + own.viscous;
  }

  Block<double> block;
  ElasticSphereRun sphere;
  ContactZone<double, ElasticSphereRun> zone;
  double step;
};

TEST(ElasticParticle, WhatItLosesTheTargetGains) {
  for (const double youngs_modulus : {5.0, 200.0, 2e4}) {
    Cloud cloud(with_elastic(dent(), youngs_modulus));
    const double before = cloud.momentum();
    cloud.run(100);
    EXPECT_LT(cloud.sphere.speed(), 0.99);
    EXPECT_NEAR(cloud.momentum(), before, 1e-12 * before) << youngs_modulus;
    EXPECT_NEAR(cloud.energy(), 0.5 * before, 2e-3 * before) << youngs_modulus;
  }
}

// From one own step for one of the march's to dozens, and from heavy to light.
TEST(ElasticParticle, EnergyCloses) {
  for (const double youngs_modulus : {1.5, 20.0, 186.0, 2e4})
    for (const double density_ratio : {16.8, 1.15}) {
      Problem p = with_elastic(dent(), youngs_modulus);
      p.density_ratio = density_ratio;
      const ImpactResult result = run_impact(p);
      EXPECT_EQ(result.outcome, Outcome::time_up) << result.reason;
      EXPECT_LT(std::abs(result.energy.closure()), 3e-3) << youngs_modulus << ' ' << density_ratio;
    }
}

TEST(ElasticParticle, TheForceReportedIsWhatSlowsIt) {
  Problem p = with_elastic(dent(), 186);
  p.history_samples = 100000;
  const ImpactResult result = run_impact(p);
  EXPECT_LT(result.end_speed, 0.95);
  expect_that_the_force_slows_it(result.history, 2.0 / 3 * 16.8);
}

TEST(ElasticParticle, AStiffOneMovesAsTheRigidOneAndStoresOneOverItsModulus) {
  const ImpactResult rigid = run_impact(dent());
  double last = 1;
  for (const double youngs_modulus : {2e3, 2e4}) {
    const ImpactResult elastic = run_impact(with_elastic(dent(), youngs_modulus));
    EXPECT_NEAR(elastic.depth, rigid.depth, 0.003 * rigid.depth);
    EXPECT_NEAR(elastic.end_speed, rigid.end_speed, 0.005);
    if (last < 1) {
      // Waves that the collisions of nodes leave in it are in both: 14 was seen.
      EXPECT_GT(last / elastic.energy.particle_elastic, 6);
      EXPECT_LT(last / elastic.energy.particle_elastic, 18);
    }
    last = elastic.energy.particle_elastic;
  }
  EXPECT_LT(last, 1e-5);
  EXPECT_EQ(rigid.energy.particle_elastic, 0);
}

TEST(ElasticParticle, ASoftOneDeformsAndStops) {
  Problem p = dent();
  p.end_time = 1000;
  p.alpha = 8.5;
  p.density_ratio = 1.15;
  const ImpactResult rigid = run_impact(p), soft = run_impact(with_elastic(p, 10 * p.mu()));
  EXPECT_EQ(soft.outcome, Outcome::stopped) << soft.reason;
  EXPECT_GT(soft.energy.particle_elastic, 0.03);
  EXPECT_GT(std::abs(soft.depth - rigid.depth), 0.05 * rigid.depth);
  EXPECT_LT(std::abs(soft.energy.closure()), 0.01);
}

// A ring where the sphere is thickest stands further out, the lowest point nearer to the middle.
// As dense and as soft as the target, it is squeezed to half its length, and its outline folds. Bits differ between instruction levels,
// and one run of some sixty still fails: three of 27 may.
TEST(ElasticParticle, OneAsSoftAsTheTargetKeepsItsEnergy) {
  int kept = 0, runs = 0;
  for (const int elements_per_radius : {7, 8, 10}) {
    Problem p = setting_s(elements_per_radius);
    p.density_ratio = 1;
    p.depth = 12;
    for (const Problem& replicate : replicates_of(with_elastic(p, 3 * p.mu()), 9)) {
      const ImpactResult result = run_impact(replicate);
      ++runs;
      kept += result.outcome == Outcome::stopped && std::abs(result.energy.closure()) < 0.05;
    }
  }
  EXPECT_GE(kept, runs - 3);
}

TEST(ElasticParticle, ItFlattensWhereItStrikes) {
  Cloud cloud(with_elastic(dent(), 5));
  const double height = cloud.sphere.tip() - cloud.sphere.top();
  cloud.run(100);
  EXPECT_LT(cloud.sphere.tip() - cloud.sphere.top(), 0.98 * height);
}

TEST(ElasticParticle, AnyNumberOfThreadsGivesTheSameBits) {
  Problem p = with_elastic(setting_s(5), 186, 0.42);
  p.end_time = 10;
  const ImpactResult one = run_impact(p, 1), three = run_impact(p, 3);
  EXPECT_GT(one.eroded, 50);
  EXPECT_EQ(one.depth, three.depth);
  EXPECT_EQ(one.steps, three.steps);
  EXPECT_EQ(one.energy.sum(), three.energy.sum());
  EXPECT_EQ(one.energy.particle_elastic, three.energy.particle_elastic);
}

TEST(ElasticParticle, OneTooStiffForItsStepsIsNotRunAndSaysWhy) {
  const ImpactResult result = run_impact(with_elastic(setting_s(), 1e8));
  EXPECT_EQ(result.outcome, Outcome::unstable);
  EXPECT_EQ(result.steps, 0);
  EXPECT_THAT(result.reason, testing::HasSubstr("at most " + std::to_string(most_particle_steps)));
  EXPECT_THAT(result.reason, testing::HasSubstr("a rigid one will do"));
}

TEST(ElasticParticle, InPlaneStrainItIsNotRun) {
  Problem p = with_elastic(dent(), 100);
  p.geometry = Geometry::plane_strain;
  EXPECT_EQ(run_impact(p).outcome, Outcome::unstable);
}

// A heavy drop of next to no stiffness runs out sideways until its mesh fails.
TEST(ElasticParticle, OneThatLosesItsShapeEndsAsUnstableWithAReason) {
  for (const double youngs_modulus : {0.1, 0.01}) {
    const ImpactResult result = run_impact(with_elastic(setting_s(), youngs_modulus));
    EXPECT_EQ(result.outcome, Outcome::unstable);
    EXPECT_THAT(result.reason, testing::HasSubstr("particle"));
    EXPECT_LT(result.end_time, 100);
  }
}

// Depths of replicates, in radii.
std::vector<double> depths(Problem p, int replicates) {
  std::vector<double> found;
  for (int k = 0; k < replicates; ++k) {
    p.speed_factor = replicate_speed_factor(k);
    const ImpactResult result = run_impact(p);
    EXPECT_EQ(result.outcome, Outcome::stopped) << result.reason;
    EXPECT_LT(std::abs(result.energy.closure()), 0.01);
    found.push_back(result.depth);
  }
  return found;
}

// (rho_t v^2 + 10 mu)/E = 0.0135: a loss of depth of a few per cent at most.
TEST(SlowElasticParticle, GoldIntoSkinGoesAsDeepAsARigidSphereToAFewPerCent) {
  const auto rigid = depths(setting_s(), 7), elastic = depths(with_elastic(setting_s(), 186.4, 0.42), 7);
  EXPECT_NEAR(mean(elastic) / mean(rigid), 1, 0.05);
}

TEST(SlowElasticParticle, AVeryStiffSphereGoesAsDeepAsTheRigidOne) {
  const auto rigid = depths(setting_s(), 5), elastic = depths(with_elastic(setting_s(), 2e4), 5);
  EXPECT_NEAR(mean(elastic) / mean(rigid), 1, 0.04) << "4 % is three standard errors of either";
}

// Material lifted by more than a radius meets the particle in time, not deep inside.
TEST(SlowElasticParticle, SteelInSoftGelatinKeepsItsEnergyToTheEnd) {
  Problem p = setting_s(7);
  p.pi4 = 696;
  p.density_ratio = 7.72;
  p.bulk_ratio = subsonic_bulk_ratio(p.pi4);
  struct Run {
    double youngs_modulus, end_time;
  };
  for (const auto& [youngs_modulus, end_time] : {Run{100, 300}, Run{30180, 60}}) {
    p.end_time = end_time;
    const ImpactResult result = run_impact(with_elastic(p, youngs_modulus));
    EXPECT_NE(result.outcome, Outcome::unstable) << result.reason;
    EXPECT_LT(std::abs(result.energy.closure()), 5e-3);
  }
}

}  // namespace
}  // namespace percal
