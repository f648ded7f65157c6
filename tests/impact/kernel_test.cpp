// Every instruction level's kernel against the scalar element code, and forces against energies.
#include "percal/impact/kernel/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "impact/element_reference.hpp"
#include "percal/impact/target/contents.hpp"

namespace percal {
namespace {

// Who holds a const block looks and does not write.
static_assert(!std::is_assignable_v<decltype(*std::declval<const Block<float>&>().view().u_r), float>);
static_assert(!std::is_assignable_v<decltype(*std::declval<const Block<float>&>().far_forces().r), float>);

double largest(const NodalForces& forces) {
  double size = 0;
  for (const double f : forces.r) size = std::max(size, std::abs(f));
  for (const double f : forces.z) size = std::max(size, std::abs(f));
  return size;
}

// Largest difference of a nodal force from the reference, over the largest force.
template <class Real>
double largest_difference(const Block<Real>& block, const NodalForces& reference) {
  double worst = 0;
  for (int i = 0; i <= block.mesh().columns(); ++i)
    for (int j = 0; j <= block.mesh().rows; ++j) {
      const long n = block.at(i, j);
      worst = std::max({worst, std::abs(block.far_forces().r[n] - reference.r[n]),
                        std::abs(block.far_forces().z[n] - reference.z[n])});
    }
  return worst / largest(reference);
}

template <class Real>
void meets_the_scalar_code(double tolerance) {
  for (const auto& kernels : kernels_here())
    for (const double alpha : {-6.0, 2.0, 8.5, 20.0})
      for (const double previous_step : {0.0, 0.05})
        for (unsigned seed = 1; seed <= 5; ++seed) {
          const Problem problem = small_problem(alpha);
          const auto& kernel = of<Real>(kernels);
          Block<Real> block(problem, mesh_of(problem), kernel.lanes);
          displace(block, 0.15, seed);
          const NodalForces reference = reference_forces(block, constants_of(problem), previous_step);
          const auto report = all_internal_forces(kernel, block, constants_of(problem), previous_step);
          EXPECT_LT(largest_difference(block, reference), tolerance)
              << kernels.level << ", alpha " << alpha << ", seed " << seed;
          EXPECT_NEAR(report.largest_inverse_step, reference.largest_inverse_step,
                      10 * tolerance * reference.largest_inverse_step);
          EXPECT_NEAR(report.viscous_work, reference.viscous_work, 10 * tolerance * std::abs(reference.viscous_work))
              << kernels.level;
          EXPECT_EQ(report.viscous_work != 0, previous_step > 0);
        }
}

TEST(Kernel, EveryLevelInDoubleMeetsTheScalarElementCode) { meets_the_scalar_code<double>(1e-12); }

// Twenty single roundings; the largest force belongs to an element with J well off 1, the rest are smaller.
TEST(Kernel, EveryLevelInSingleMeetsTheScalarElementCodeWithinFloatAccuracy) {
  meets_the_scalar_code<float>(20 * 0x1p-23);
}

TEST(Kernel, ForcesAreMinusTheDerivativeOfTheEnergy) {
  for (const double alpha : {-6.0, 2.0, 8.5, 20.0}) {
    Problem problem = small_problem(alpha);
    problem.depth = 4;
    problem.hourglass = 5;  // so that its part weighs as much as the others
    const auto& kernel = percal::kernel<double>();
    Block<double> block(problem, mesh_of(problem), kernel.lanes);
    displace(block, 0.15, 11);
    const auto material = constants_of(problem);
    all_internal_forces(kernel, block, material, 0);
    const auto& view = block.view();
    double size = 0;
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j)
        size = std::max(size, std::abs(block.far_forces().r[block.at(i, j)]));
    const auto energy = [&] {
      const EnergyLedger stored = stored_energy(block, material, block.mesh().rows);
      return stored.elastic + stored.hourglass;
    };
    const double step = 1e-6;
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j)
        for (const auto& [u, f] : {std::pair{view.u_r, block.far_forces().r}, {view.u_z, block.far_forces().z}}) {
          const long n = block.at(i, j);
          const double at = u[n];
          u[n] = at + step;
          const double above = energy();
          u[n] = at - step;
          const double below = energy();
          u[n] = at;
          EXPECT_NEAR(f[n], -(above - below) / (2 * step), 1e-7 * size)
              << "alpha " << alpha << ", node " << i << ", " << j;
        }
  }
}

TEST(Kernel, ARigidTranslationAlongTheAxisMakesNoForceAndNoEnergy) {
  const Problem problem = small_problem(8.5);
  for (const auto& kernels : kernels_here()) {
    Block<float> block(problem, mesh_of(problem), kernels.single->lanes);
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) block.view().u_z[block.at(i, j)] = 17.3f;
    all_internal_forces(*kernels.single, block, constants_of(problem), 0);
    // Far below mu times an element's face, 2 x 0.33 x 0.33: rounding of the stress-free state.
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) {
        EXPECT_NEAR(block.far_forces().r[block.at(i, j)], 0, 1e-7) << kernels.level;
        EXPECT_NEAR(block.far_forces().z[block.at(i, j)], 0, 1e-7) << kernels.level;
      }
    const EnergyLedger stored = stored_energy(block, constants_of(problem), block.mesh().rows);
    EXPECT_NEAR(stored.elastic, 0, 1e-10);
    EXPECT_EQ(stored.hourglass, 0);
  }
}

TEST(Kernel, InternalForcesAlongTheAxisAddUpToNothing) {
  const Problem problem = small_problem(8.5);
  const auto& kernel = percal::kernel<double>();
  Block<double> block(problem, mesh_of(problem), kernel.lanes);
  displace(block, 0.2, 4);
  all_internal_forces(kernel, block, constants_of(problem), 0.05);
  double sum = 0, size = 0;
  for (int i = 0; i <= block.mesh().columns(); ++i)
    for (int j = 0; j <= block.mesh().rows; ++j) {
      sum += block.far_forces().z[block.at(i, j)];
      size += std::abs(block.far_forces().z[block.at(i, j)]);
    }
  EXPECT_GT(size, 1);
  EXPECT_NEAR(sum, 0, 1e-14 * size);
}

TEST(Kernel, ElementsBeyondTheErosionStretchAreMarkedAndPullNoMore) {
  const Problem problem = small_problem(8.5);
  for (const auto& kernels : kernels_here()) {
    Block<double> block(problem, mesh_of(problem), kernels.twice->lanes);
    auto material = constants_of(problem);
    material.erosion_stretch = 1.5;
    // Row 20 is pulled to a stretch of 1.6; everything else moves with it unstrained.
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 21; j <= block.mesh().rows; ++j) block.view().u_z[block.at(i, j)] = 0.6 * block.mesh().row_height;
    for (int i = 0; i < block.mesh().columns(); ++i) {
      ColumnReport report;
      column_internal_forces(*kernels.twice, block, i, material, 0.05, report);
      ASSERT_EQ(report.doomed, 1) << kernels.level;
      for (int j = 0; j < block.mesh().rows; ++j)
        EXPECT_EQ(block.view().alive[block.at(i, j)], j == 20 ? -1 : 1) << kernels.level << ", row " << j;
      block.take_out(i, 20, false);
    }
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (const int j : {20, 21}) EXPECT_NEAR(block.far_forces().z[block.at(i, j)], 0, 1e-11) << kernels.level;
    EXPECT_EQ(all_internal_forces(*kernels.twice, block, material, 0.05).doomed, 0) << "what is gone is not marked twice";
  }
}

// The hoop stretch counts as a principal stretch: a ring that is widened as a whole erodes although nothing stretches in the plane.
TEST(Kernel, TheHoopStretchErodesToo) {
  const Problem problem = small_problem(8.5);
  const auto& kernel = percal::kernel<double>();
  Block<double> block(problem, mesh_of(problem), kernel.lanes);
  auto material = constants_of(problem);
  material.erosion_stretch = 1.5;
  for (int i = 0; i <= block.mesh().columns(); ++i)
    for (int j = 0; j <= block.mesh().rows; ++j) block.view().u_r[block.at(i, j)] = 0.6 / block.shapes()[2].per_radius;
  ColumnReport report;
  column_internal_forces(kernel, block, 2, material, 0.05, report);
  EXPECT_EQ(report.doomed, block.mesh().rows);
}

// Nodes that `is_inside` says are inside the particle, by the scalar code.
template <class Real, class IsInside>
std::vector<std::pair<int, int>> nodes_by_hand(const Block<Real>& block, IsInside is_inside) {
  std::vector<std::pair<int, int>> nodes;
  for (int i = 0; i <= block.mesh().columns(); ++i)
    for (int j = 0; j <= block.mesh().rows; ++j)
      if (block.view().touchable[block.at(i, j)] > 0 && is_inside(block.mesh().radius[i], j * block.mesh().row_height))
        nodes.push_back({i, j});
  return nodes;
}
template <class Real, class Find>
std::vector<std::pair<int, int>> nodes_found(const Block<Real>& block, int lanes, Find find) {
  const Rows rows{0, (block.mesh().rows + lanes) / lanes * lanes};
  std::vector<int> found(rows.end);
  std::vector<std::pair<int, int>> nodes;
  for (int i = 0; i <= block.mesh().columns(); ++i) {
    const int count = find(ContactNodes{i, block.mesh().radius[i], block.mesh().row_height, rows}, found.data());
    for (int k = 0; k < count; ++k) nodes.push_back({i, found[k]});
  }
  return nodes;
}

TEST(Kernel, EveryLevelFindsTheNodesInsideASphereThatTheParticleCanMeet) {
  const Problem problem = small_problem(8.5);
  const double centre = 4.1;
  for (const auto& kernels : kernels_here()) {
    Block<double> block(problem, mesh_of(problem), kernels.twice->lanes);
    block.view().touchable[block.at(1, 12)] = 0;
    const auto& looked_at = std::as_const(block);
    const auto inside =
        nodes_by_hand(looked_at, [&](double r, double z) { return r * r + (z - centre) * (z - centre) < 1; });
    EXPECT_GT(inside.size(), 10u);
    EXPECT_EQ(nodes_found(looked_at, kernels.twice->lanes,
                          [&](const ContactNodes& nodes, int* found) {
                            return kernels.twice->nodes_in_sphere(looked_at.view(), nodes, centre, found);
                          }),
              inside)
        << kernels.level;
  }
}

TEST(Kernel, EveryLevelFindsTheNodesBehindAllSidesOfAPolygon) {
  const Problem problem = small_problem(8.5);
  const PolygonSide sides[] = {{1, 0, 0.8}, {-1, 0, 0.5}, {0.6, 0.8, 0.9}, {0, -1, 1.2}};
  const double centre_x = 0.3, centre_z = 2.2;
  for (const auto& kernels : kernels_here()) {
    Block<double> block(problem, mesh_of(problem), kernels.twice->lanes);
    const auto& looked_at = std::as_const(block);
    const auto inside = nodes_by_hand(looked_at, [&](double x, double z) {
      return std::ranges::all_of(sides, [&](const PolygonSide& side) {
        return side.normal_x * (x - centre_x) + side.normal_z * (z - centre_z) < side.offset;
      });
    });
    EXPECT_GT(inside.size(), 10u);
    EXPECT_EQ(nodes_found(looked_at, kernels.twice->lanes,
                          [&](const ContactNodes& nodes, int* found) {
                            return kernels.twice->nodes_in_polygon(looked_at.view(), nodes, sides, 4, centre_x, centre_z,
                                                                   found);
                          }),
              inside)
        << kernels.level;
  }
}

}  // namespace
}  // namespace percal
