// What an observer sees of a block: the cut, and all that is computed.                          docs/formats/fields.md
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "percal/solid/march/march.hpp"
#include "percal/solid/target/contents.hpp"
#include "solid/solid_problems.hpp"

namespace percal {
namespace {

// alpha 2 is the neo-Hookean solid: J sigma = mu dev(J^(-2/3) F F^T) + K/2 (J^2 - 1) 1.
TEST(SolidFrame, HasTheCauchyStressWithZUpwards) {
  Problem p = block_dent(2);
  p.arithmetic = Arithmetic::double_precision;
  p.alpha = 2;
  p.whole = true;
  SolidBlock<double> block(p, solid_kernel<double>().lanes);
  const TargetSolid solid = solid_of_block(p, block.layers());
  take_initial_state(block, solid);
  Eigen::Matrix3d gradient;  // of the displacement, z upwards
  gradient << 0.1, 0.05, -0.2, 0.02, -0.08, 0.12, 0.07, -0.03, 0.04;
  const auto& g = block.grid();
  for (std::size_t i = 0; i < g.x.size(); ++i)
    for (std::size_t j = 0; j < g.y.size(); ++j)
      for (std::size_t k = 0; k < g.z.size(); ++k) {
        const Eigen::Vector3d u = gradient * Eigen::Vector3d(g.x[i], g.y[j], -g.z[k]);
        const long n = block.at(static_cast<int>(i), static_cast<int>(j), static_cast<int>(k));
        for (int d = 0; d < 3; ++d) block.fields().u[d][n] = d == 2 ? -u[d] : u[d];
      }
  const Eigen::Matrix3d F = Eigen::Matrix3d::Identity() + gradient;
  const double J = F.determinant(), mu = solid.of_row(0).mu;
  const Eigen::Matrix3d b = std::pow(J, -2.0 / 3) * F * F.transpose();
  const Eigen::Matrix3d expected = (mu * (b - b.trace() / 3 * Eigen::Matrix3d::Identity()) +
                                    0.5 * mu * p.bulk_ratio * (J * J - 1) * Eigen::Matrix3d::Identity()) /
                                   J;
  const SpaceTarget space = space_piece(block, solid);
  const TargetPiece cut = cut_piece(block, solid);
  const auto& in_space = space.states[5].stress;
  const auto& in_cut = cut.states[5].stress;
  const double size = expected.norm();
  constexpr std::array<std::array<int, 2>, 6> in_order{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
  for (int c = 0; c < 6; ++c) EXPECT_NEAR(in_space[c], expected(in_order[c][0], in_order[c][1]), 1e-9 * size) << c;
  EXPECT_NEAR(in_cut[1], expected(2, 2), 1e-9 * size) << "up";
  EXPECT_NEAR(in_cut[2], expected(1, 1), 1e-9 * size) << "out of the plane";
  EXPECT_NEAR(in_cut[3], expected(0, 2), 1e-9 * size);
  EXPECT_NEAR(space.states[5].stretches[0],
              std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(F * F.transpose()).eigenvalues()[2]), 1e-9);
  const SpacePoint corner = space.position[space.corners[0]];
  const Eigen::Vector3d place = F * Eigen::Vector3d(g.x[0], g.y[0], -g.z[1]);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(corner[d], place[d], 1e-12) << "below the first element's first corner";
}

TEST(SolidFrame, HasTheElementsAndTheEnergyOfTheRun) {
  Problem p = block_setting_s(3);
  p.end_time = 12;
  LastFrame last;
  const ImpactResult result = run_solid(p, last, 1);
  const SpaceTarget& target = last.space.target;
  ASSERT_EQ(static_cast<long>(target.ends.size()), result.elements);
  EXPECT_EQ(target.corners.size(), 8 * target.ends.size());
  EXPECT_EQ(std::ranges::count(target.eroded, 1), result.eroded);
  double elastic = 0, volume = 0;
  for (std::size_t k = 0; k < target.states.size(); ++k) {
    elastic += target.states[k].energy_density * target.volume[k];
    volume += target.volume[k];
  }
  const double impact_energy = 0.25 * 4 / 3 * std::numbers::pi * p.density_ratio / 2;
  EXPECT_NEAR(elastic / impact_energy, result.energy.elastic, 1e-5);
  EXPECT_NEAR(volume, p.width * p.width * p.depth, 1e-9 * volume);
  // No hexahedron is inside out where it stood at first: its first four corners lie below the others, counter-clockwise.
  const auto at_first = [&](int corner) {
    const auto &x = target.position[corner], &u = target.displacement[corner];
    return Eigen::Vector3d(x[0] - u[0], x[1] - u[1], x[2] - u[2]);
  };
  for (std::size_t k = 0; k < target.ends.size(); k += 97) {
    const int* c = &target.corners[8 * k];
    const Eigen::Vector3d right = at_first(c[1]) - at_first(c[0]), away = at_first(c[3]) - at_first(c[0]),
                          up = at_first(c[4]) - at_first(c[0]);
    EXPECT_NEAR(right.cross(away).dot(up), target.volume[k], 1e-6 * target.volume[k]);
  }
}

// The lowest point of a sphere and of a prism is the tip; nothing of either lies beyond its planes of symmetry.
TEST(SolidFrame, HasTheParticleWhereItIs) {
  for (const bool sphere : {true, false}) {
    Problem p = block_setting_s(3);
    p.end_time = 6;
    if (!sphere)
      p.particle =
          RigidPolygon{.vertices = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, .mass = 8, .inertia = 1, .half_thickness = 0.7};
    LastFrame last;
    const ImpactResult result = run_solid(p, last, 1);
    double lowest = 0, least_x = 0, least_y = 0, furthest = 0;
    for (const auto& [x, y, z] : last.space.particle.position) {
      lowest = std::min(lowest, z);
      least_x = std::min(least_x, x);
      least_y = std::min(least_y, y);
      furthest = std::max(furthest, y);
    }
    EXPECT_NEAR(lowest, -result.depth, 1e-9) << sphere;
    EXPECT_GE(least_x, -1e-12) << sphere;
    EXPECT_GE(least_y, -1e-12) << sphere;
    EXPECT_NEAR(furthest, sphere ? 1 : 0.7, 1e-12);
  }
}

}  // namespace
}  // namespace percal
