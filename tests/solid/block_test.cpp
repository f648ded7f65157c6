// Forces of a whole block: patch test, energy, waves. docs/theory/solid.md.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "percal/solid/march/slabs.hpp"
#include "percal/solid/target/contents.hpp"
#include "solid/solid_problems.hpp"

namespace percal {
namespace {

// A small graded block of both halves, in double.
Problem small_block() {
  Problem p = block_dent(2);
  p.arithmetic = Arithmetic::double_precision;
  p.whole = true;
  p.width = 4;
  p.depth = 5;
  p.block.fine_depth = 2;
  return p;
}

struct Loaded {
  explicit Loaded(const Problem& problem, int threads = 1)
      : block(problem, solid_kernel<double>().lanes),
        solid(solid_of_block(problem, block.layers())),
        slabs(block, solid_kernel<double>(), solid, threads) {
    take_initial_state(block, solid);
  }

  void displace(const std::function<std::array<double, 3>(double, double, double)>& u) {
    const auto& g = block.grid();
    for (std::size_t i = 0; i < g.x.size(); ++i)
      for (std::size_t j = 0; j < g.y.size(); ++j)
        for (std::size_t k = 0; k < g.z.size(); ++k) {
          const auto at = u(g.x[i], g.y[j], g.z[k]);
          for (int d = 0; d < 3; ++d) block.fields().u[d][block.at(i, j, k)] = at[d];
        }
  }
  void find_forces() { slabs.find_forces(block.grid().rows(), 0); }
  template <class Work>
  void each_inner_node(const Work& work) const {
    const auto& g = block.grid();
    for (int i = 1; i < g.columns_x(); ++i)
      for (int j = 1; j < g.columns_y(); ++j)
        for (int k = 1; k < g.rows(); ++k) work(i, j, k);
  }
  double stored() const {
    const EnergyLedger energy = stored_energy(block, solid, block.grid().rows());
    return energy.elastic + energy.hourglass;
  }

  SolidBlock<double> block;
  TargetSolid solid;
  Slabs<double> slabs;
};

TEST(SolidBlock, AHomogeneousStrainHasNoForcesOnInnerNodes) {
  Loaded loaded(small_block());
  loaded.displace([](double x, double y, double z) {
    return std::array{0.2 * x + 0.1 * y - 0.05 * z, 0.07 * x - 0.1 * y + 0.02 * z, -0.03 * x + 0.06 * y - 0.08 * z};
  });
  loaded.find_forces();
  const auto P = first_piola(loaded.solid.layers[0].material, element_gradient(loaded.block, 0, 0, 0));
  ASSERT_GT(std::abs(P.xx), 0.05);
  loaded.each_inner_node([&](int i, int j, int k) {
    for (const double* f : std::as_const(loaded.block).fields().f) EXPECT_NEAR(f[loaded.block.at(i, j, k)], 0, 1e-12);
  });
}

TEST(SolidBlock, ForcesAreTheDerivativeOfItsEnergy) {
  Loaded loaded(small_block());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.03, 0.03);
  loaded.displace([&](double, double, double) { return std::array{noise(random), noise(random), noise(random)}; });
  loaded.find_forces();
  const auto& fields = loaded.block.fields();
  for (const auto& [i, j, k] : {std::array{0, 0, 0}, {3, 0, 2}, {4, 3, 5}, {2, 4, 1}, {7, 1, 6}})
    for (int d = 0; d < 3; ++d) {
      double& u = fields.u[d][loaded.block.at(i, j, k)];
      constexpr double step = 1e-6;
      u += step;
      const double above = loaded.stored();
      u -= 2 * step;
      const double below = loaded.stored();
      u += step;
      EXPECT_NEAR(fields.f[d][loaded.block.at(i, j, k)], -(above - below) / (2 * step), 1e-6);
    }
}

TEST(SolidBlock, ForcesHaveTheSameBitsForAnyNumberOfThreads) {
  std::vector<double> first;
  for (const int threads : {1, 2, 3, 7}) {
    Loaded loaded(small_block(), threads);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> noise(-0.03, 0.03);
    loaded.displace([&](double, double, double) { return std::array{noise(random), noise(random), noise(random)}; });
    loaded.find_forces();
    std::vector<double> forces;
    for (int i = 0; i <= loaded.block.slabs(); ++i)
      for (int j = 0; j <= loaded.block.columns_y(); ++j)
        for (int k = 0; k <= loaded.block.grid().rows(); ++k)
          for (const double* f : std::as_const(loaded.block).fields().f) forces.push_back(f[loaded.block.at(i, j, k)]);
    if (first.empty()) first = forces;
    EXPECT_EQ(forces, first) << threads << " threads";
  }
}

// Two layers, stretched apart and with fibres: no node that may move is pushed.
TEST(SolidBlock, AStretchedTargetIsInEquilibrium) {
  Problem p = small_block();
  p.bottom = Bottom::free;
  p.stretch = 1.2;
  p.stretch_across = 1.05;
  p.fibres = FibreFamilies{.k1 = 0.3, .k2 = 1, .kappa = 0.1, .angle = 0.6};
  p.depth = 2;
  p.below = {
      {.depth = 3, .density = 1.2, .mu = 2, .alpha = -3, .bulk_ratio = 50, .erosion_limit = INFINITY, .stretch = 0.9}};
  Loaded loaded(p);
  ASSERT_EQ(loaded.solid.layers.size(), 2u);
  loaded.find_forces();
  const auto& fields = std::as_const(loaded.block).fields();
  double tension = 0;
  for (int i = 0; i <= loaded.block.slabs(); ++i)
    for (int j = 0; j <= loaded.block.columns_y(); ++j)
      for (int k = 0; k <= loaded.block.grid().rows(); ++k) {
        const long n = loaded.block.at(i, j, k);
        const auto held = loaded.block.held(i, j);
        for (int d = 0; d < 3; ++d) {
          if (fields.inverse_mass[n] > 0 && !held[d])
            EXPECT_NEAR(fields.f[d][n], 0, 1e-12) << i << " " << j << " " << k;
          tension = std::max(tension, std::abs(fields.f[d][n]));
        }
      }
  EXPECT_GT(tension, 0.01);  // on the walls
  EXPECT_NEAR(loaded.stored(), 0, 1e-10);
}

// Half of the block: 4 to both sides, 4 to one.
TEST(SolidBlock, WeighsWhatItsLayersWeigh) {
  Problem p = small_block();
  p.depth = 2;
  p.below = {{.depth = 3, .density = 1.5, .mu = 2, .alpha = -3, .bulk_ratio = 50, .erosion_limit = INFINITY}};
  const Loaded loaded(p);
  double mass = 0;
  for (int i = 0; i <= loaded.block.slabs(); ++i)
    for (int j = 0; j <= loaded.block.columns_y(); ++j)
      for (int k = 0; k <= loaded.block.grid().rows(); ++k) mass += loaded.block.mass(i, j, k);
  EXPECT_NEAR(mass, 8 * 4 * (2 + 1.5 * 3), 1e-9);
}

// Of one-point bricks and lumped masses omega = (2 c/h) sin(k h/2), exactly.     docs/theory/solid.md (11)
TEST(SolidBlock, PlaneWavesRunAtTheSpeedOfTheSolid) {
  Problem p = small_block();
  p.width = 3, p.fine_width = p.block.fine_thickness = 3;
  p.depth = p.block.fine_depth = 8;
  constexpr double amplitude = 1e-6, wave_number = 1.3, h = 0.5;
  for (const int component : {0, 2}) {
    Loaded loaded(p);
    loaded.displace([&](double, double, double z) {
      std::array<double, 3> u{};
      u[component] = amplitude * std::sin(wave_number * z);
      return u;
    });
    loaded.find_forces();
    const double mu = p.mu(), speed = component == 2 ? std::sqrt(p.bulk() + 4.0 / 3 * mu) : std::sqrt(mu);
    const double omega = 2 * speed / h * std::sin(wave_number * h / 2);
    const auto& fields = std::as_const(loaded.block).fields();
    const long n = loaded.block.at(3, 3, 5);
    const double mass = loaded.block.mass(3, 3, 5), u = fields.u[component][n];
    ASSERT_GT(std::abs(u), 0.05 * amplitude);
    EXPECT_NEAR(fields.f[component][n] / (mass * u), -omega * omega, 1e-4 * omega * omega) << component;
  }
}

}  // namespace
}  // namespace percal
