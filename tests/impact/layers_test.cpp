// Targets of several layers.
#include <gtest/gtest.h>

#include <limits>

#include "impact/setting_s.hpp"
#include "impact/specimen.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

LowerLayer same_again(const Problem& p, double depth) {
  LowerLayer layer{.depth = depth, .density = 1, .mu = p.mu(), .alpha = p.alpha, .bulk_ratio = p.bulk_ratio};
  if (const auto* strain = std::get_if<StrainErosion>(&p.erosion)) layer.erosion_limit = strain->limit;
  return layer;
}
Problem cut_at(Problem p, double depth) {
  p.below = {same_again(p, p.depth - depth)};
  p.depth = depth;
  return p;
}

TEST(Layers, WhereALikeLayerBeginsChangesNoBit) {
  Problem p = setting_s(6);
  p.end_time = 8;
  p.depth = 30;
  const ImpactResult one = run_impact(cut_at(p, 7.3)), other = run_impact(cut_at(p, 1.5));
  EXPECT_GT(one.eroded, 50);
  EXPECT_EQ(one.depth, other.depth);
  for (const auto& [key, share, words] : energy_terms) EXPECT_EQ(one.energy.*share, other.energy.*share) << key;
}

// The kernel of one plain layer is another one: the same to rounding, as long as erosion does not amplify it.
TEST(Layers, TwoLikeLayersAreOne) {
  const Problem p = dent();
  const ImpactResult two = run_impact(cut_at(p, 1.4)), one = run_impact(p);
  EXPECT_EQ(two.steps, one.steps);
  EXPECT_NEAR(two.depth, one.depth, 1e-10);
  for (const auto& [key, share, words] : energy_terms) EXPECT_NEAR(two.energy.*share, one.energy.*share, 1e-10) << key;
}

// Row by row, whether its group of lanes lies in one layer or in two.
TEST(Layers, EveryRowHasTheStressOfItsOwnLayer) {
  Problem p = specimen_problem();
  p.depth = 13.0 / 3;
  p.below = {{.depth = 4.0 / 3, .density = 2, .mu = 5, .alpha = 3, .bulk_ratio = 20},
             {.depth = 20.0 / 3, .density = 0.5, .mu = 1, .alpha = -5, .bulk_ratio = 15}};
  StrainedTarget<> specimen(p);
  const double l = 1.2;
  specimen.stretch(1, l);
  specimen.look(0);
  const auto stress = [&](int row) {
    const double mu = row < 13   ? p.mu()
                      : row < 17 ? 5
                                 : 1,
                 alpha = row < 13   ? p.alpha
                         : row < 17 ? 3
                                    : -5,
                 ratio = row < 13   ? p.bulk_ratio
                         : row < 17 ? 20
                                    : 15;
    return (isochoric_stress_of(mu, alpha, l, 1, 1) + ratio * mu / 2 * (l * l - 1)) / l;
  };
  const auto& block = specimen.block;
  const double width = block.mesh().radius[2];  // of the two columns around node column 1, half of it counts
  for (int j = 0; j <= 37; ++j) {
    const double expected = ((j < 37 ? stress(j) : 0) - (j > 0 ? stress(j - 1) : 0)) * width / 2;
    EXPECT_NEAR(block.far_forces().z[block.at(1, j)], expected, 1e-10) << "row " << j;
  }
}

TEST(Layers, EachHasItsOwnStableStepAndMass) {
  Problem p = specimen_problem();
  p.depth = 4;
  p.below = {
      {.depth = 8, .density = 4, .mu = 32, .alpha = 3, .bulk_ratio = 10}};  // 16 times as stiff, 4 times as heavy
  StrainedTarget<> specimen(p);
  const double of_first = std::sqrt(2 * (p.bulk() + 4.0 / 3 * p.mu())) * 3;
  EXPECT_NEAR(specimen.look(0).largest_inverse_step, 2 * of_first, 1e-3 * of_first)
      << "1e-12 in the split of stretches";
  EXPECT_NEAR(1 / step_limits(p).first_step, 2 * of_first, 1e-12 * of_first);
  const auto& block = specimen.block;
  EXPECT_NEAR(block.mass(1, 30) / block.mass(1, 5), 4, 1e-12);
  EXPECT_NEAR(block.mass(1, 12) / block.mass(1, 5), 2.5, 1e-12) << "between the two";
}

TEST(Layers, BulkViscosityGoesByTheDensityAndWaveSpeedOfEach) {
  Problem p = specimen_problem();
  p.linear_viscosity = 0.3;
  p.quadratic_viscosity = 1.5;
  p.depth = 4;
  p.below = {{.depth = 8, .density = 4, .mu = 5, .alpha = 3, .bulk_ratio = 20}};
  StrainedTarget<> specimen(p);
  specimen.look(0);
  const double J = 0.9, step = 0.05, closing = (1 - J) / (J * step), length = std::sqrt(J) / 3;
  specimen.stretch(1, J);
  specimen.look(step);
  const auto pressure = [&](double density, double modulus) {
    return density * length * (0.3 * std::sqrt(modulus / density) + 2.25 * length * closing) * closing;
  };
  const auto* q = specimen.block.view().viscous_pressure;
  EXPECT_NEAR(q[3], pressure(1, p.bulk() + 4.0 / 3 * p.mu()), 1e-10);
  EXPECT_NEAR(q[30], pressure(4, 5 * (20 + 4.0 / 3)), 1e-10);
}

TEST(Layers, OneWithAnInfiniteLimitDoesNotErode) {
  Problem p = specimen_problem();
  p.erosion = StrainErosion{0.2};
  p.depth = 4;
  p.below = {same_again(p, 4), same_again(p, 13.0 / 3)};
  p.below[0].erosion_limit = std::numeric_limits<double>::infinity();
  p.below[1].erosion_limit = 0.4;
  StrainedTarget<> specimen(p);
  specimen.look(0);
  specimen.stretch(1, 1.3);
  specimen.look(0.1);  // judged at 1.3 and half a step more
  const auto* alive = specimen.block.view().alive;
  for (int j = 0; j < 37; ++j) EXPECT_EQ(alive[j], j < 12 ? -1 : j < 24 ? 1 : -1) << j;
  StrainedTarget<> slower(p);
  slower.look(0);
  for (const double l : {1.1, 1.15, 1.18, 1.2, 1.22}) {
    slower.stretch(1, l);
    slower.look(0.1);
  }
  for (int j = 0; j < 37; ++j) EXPECT_EQ(slower.block.view().alive[j], j < 12 ? -1 : 1) << j;
}

// A plane wave of longitudinal motion in a column of plane strain that moves along z only, without viscosity.
class Column {
 public:
  explicit Column(const Problem& problem) : specimen(problem) {
    auto& block = specimen.block;
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j)
        block.view().inverse_mass[block.at(i, j)] = 1 / block.mass(i, j);  // the wall lets go too
  }
  // Amplitude of velocity of a pulse that runs downwards at this speed.
  void start(double centre, double width, double amplitude, double speed, double step) {
    auto& block = specimen.block;
    const auto bump = [&](double z) { return std::exp(-std::pow((z - centre) / width, 2)); };
    const auto integral = [&](double z) {
      return width * std::sqrt(std::acos(-1.0)) / 2 * std::erf((z - centre) / width);
    };
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) {
        const double z = j * block.mesh().row_height;
        block.view().v_z[block.at(i, j)] = amplitude * bump(z + speed * step / 2);
        block.view().u_z[block.at(i, j)] = -amplitude / speed * integral(z);
      }
  }
  void advance(int steps, double step) {
    auto& block = specimen.block;
    const int end = (block.mesh().rows + kernel<double>().lanes) / kernel<double>().lanes * kernel<double>().lanes;
    for (int n = 0; n < steps; ++n) {
      specimen.look(step);
      for (int i = 0; i <= block.mesh().columns(); ++i)
        kernel<double>().kick_and_drift(block.view(), block.far_forces(), i, {0, end}, true, step, step);
    }
  }
  // Where between two depths the velocity is largest in size, and what it is there.
  std::pair<double, double> peak(double from, double to) const {
    const auto& block = specimen.block;
    std::pair<double, double> found{0, 0};
    for (int j = 0; j <= block.mesh().rows; ++j) {
      const double z = j * block.mesh().row_height, v = block.view().v_z[block.at(1, j)];
      if (z >= from && z <= to && std::abs(v) > std::abs(found.second)) found = {z, v};
    }
    return found;
  }

 private:
  StrainedTarget<> specimen;
};

TEST(Layers, APlaneWaveIsReflectedAsTheImpedancesSayAndRunsOnAtTheSpeedOfEachLayer) {
  Problem p = specimen_problem();
  p.elements_per_radius = 20;
  p.fine_width = 0.1;
  p.graded_columns = 1;
  p.width = 0.2;
  p.depth = 10;
  p.below = {{.depth = 10, .density = 0.5, .mu = 0.5, .alpha = 3, .bulk_ratio = 10}};
  const double c1 = std::sqrt(p.bulk() + 4.0 / 3 * p.mu()), c2 = std::sqrt(0.5 * (10 + 4.0 / 3) / 0.5);
  const double impedance = c1, lower_impedance = 0.5 * c2;
  ASSERT_GT(impedance / lower_impedance, 2.5) << "a stiff layer on a soft one";
  const double step = 0.25 * step_limits(p).first_step, amplitude = 1e-5;
  Column column(p);
  column.start(6, 0.8, amplitude, c1, step);
  const double time = 7 / c1;  // 4 to the boundary, 3 back
  const int steps = static_cast<int>(std::lround(time / step));
  column.advance(steps, step);
  const auto reflected = column.peak(0, 10), transmitted = column.peak(10.2, 20);
  EXPECT_NEAR(reflected.second / amplitude, (impedance - lower_impedance) / (impedance + lower_impedance), 0.01);
  EXPECT_NEAR(transmitted.second / amplitude, 2 * impedance / (impedance + lower_impedance), 0.02);
  EXPECT_NEAR(reflected.first, 7, 0.05);
  EXPECT_NEAR(transmitted.first, 10 + 3 * c2 / c1, 0.05);
}

TEST(Layers, AStiffSkinOnASoftBlockCostsTheParticleMoreThanTheSoftBlockAlone) {
  Problem soft = dent();
  soft.end_time = 1;
  Problem skinned = soft;
  skinned.pi4 = soft.pi4 / 4;
  skinned.depth = 0.5;
  skinned.below = {same_again(soft, soft.depth - 0.5)};
  const ImpactResult alone = run_impact(soft), under_skin = run_impact(skinned);
  EXPECT_LT(under_skin.energy.particle, alone.energy.particle);
  EXPECT_LT(std::abs(under_skin.energy.closure()), 1e-3);
}

}  // namespace
}  // namespace percal
