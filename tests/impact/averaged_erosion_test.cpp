// Erosion judged by an average of the energy over a length: weights, averages, who goes, and what must not change.
#include "percal/impact/target/averaged_erosion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "impact/polygons.hpp"
#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "impact/specimen.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

Problem averaged(Problem p, double length) {
  p.erosion_average = AverageWithin{length};
  return p;
}

// The mean of the bell over the ring, point by point.
double by_points(double radius, double ring, double apart, double length) {
  constexpr int points = 20000;
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const double angle = M_PI * (k + 0.5) / points;
    const double squared = radius * radius + ring * ring - 2 * radius * ring * std::cos(angle) + apart * apart;
    sum += std::pow(std::max(0.0, 1 - squared / (length * length)), 2) / points;
  }
  return sum;
}

TEST(AveragedErosion, TheBellOfARingIsItsMeanOverTheRing) {
  constexpr unsigned seed = 7;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0, 1);
  int seen = 0;
  for (int k = 0; k < 60; ++k) {
    const double length = 0.1 + any(random), radius = 2 * any(random), ring = radius + length * (2 * any(random) - 1),
                 apart = length * any(random);
    if (ring <= 0) continue;
    const double expected = by_points(radius, ring, apart, length);
    EXPECT_NEAR(bell_of_ring(radius, ring, apart, length), expected, 1e-7) << "seed " << seed << ", " << k;
    seen += expected > 0;
  }
  EXPECT_GT(seen, 20);
  EXPECT_EQ(bell_of_ring(1, 1.5, 0, 0.5), 0);
  EXPECT_NEAR(bell_of_ring(0, 0.3, 0.4, 1), 0.5625, 1e-15) << "from the axis all of a ring is as far";
}

// A block of elements with all energies as told.
struct Judged {
  explicit Judged(Problem problem) : p(std::move(problem)), specimen(p), average(p, specimen.block, specimen.solid) {}
  void set(int column, int row, double share_of_limit) {
    specimen.block.view().foreseen_measure[specimen.block.at(column, row)] =
        share_of_limit * specimen.solid.of_row(row).erosion_limit;
  }
  template <class Share>
  void set_all(const Share& share) {
    for (int i = 0; i < specimen.block.mesh().columns(); ++i)
      for (int j = 0; j < specimen.block.mesh().rows; ++j) set(i, j, share(i, j));
  }
  double around(int column, int row) const { return average.average_around(specimen.block, column, row); }

  Problem p;
  StrainedTarget<double> specimen;
  AveragedErosion<double> average;
};

Problem eroding_specimen(Geometry geometry) {
  Problem p = specimen_problem();
  p.geometry = geometry;
  p.erosion = StrainErosion{0.5};
  return averaged(p, 1.2);
}

TEST(AveragedErosion, AUniformFieldIsItsOwnAverageAtTheAxisTheFaceAndTheWall) {
  for (const Geometry geometry : {Geometry::axisymmetric, Geometry::plane_strain}) {
    Judged judged(eroding_specimen(geometry));
    judged.set_all([](int, int) { return 1.7; });
    for (const int column : {0, 1, 2, judged.specimen.block.mesh().columns() - 1})
      for (const int row : {0, 1, 20, 36}) EXPECT_NEAR(judged.around(column, row), 1.7, 1e-13);
  }
}

// Against the sum over all elements and the whole ring, eroded ones left out.
TEST(AveragedErosion, IsTheSumOverLiveElementsWithTheirVolumes) {
  for (const Geometry geometry : {Geometry::axisymmetric, Geometry::plane_strain}) {
    Judged judged(eroding_specimen(geometry));
    constexpr unsigned seed = 3;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0, 2);
    const auto& mesh = judged.specimen.block.mesh();
    judged.set_all([&](int, int) { return any(random); });
    const auto& view = judged.specimen.block.view();
    for (const int row : {9, 10, 12}) view.alive[judged.specimen.block.at(1, row)] = 0;
    const auto middle = [&](int i) { return (mesh.radius[i] + mesh.radius[i + 1]) / 2; };
    for (const int column : {0, 2})
      for (const int row : {1, 11}) {
        double sum = 0, whole = 0;
        for (int i = 0; i < mesh.columns(); ++i)
          for (int j = std::max(0, row - 4); j < row + 5; ++j) {
            const double apart = (j - row) * mesh.row_height, width = mesh.radius[i + 1] - mesh.radius[i];
            const auto bell = [&](double along) {
              return std::pow(std::max(0.0, 1 - (along * along + apart * apart) / (1.2 * 1.2)), 2);
            };
            double weight = width * middle(i) * by_points(middle(column), middle(i), apart, 1.2);
            if (geometry == Geometry::plane_strain)
              weight = width * (bell(middle(i) - middle(column)) + bell(middle(i) + middle(column)));
            if (!(view.alive[judged.specimen.block.at(i, j)] > 0)) continue;
            whole += weight;
            sum += weight * view.foreseen_measure[judged.specimen.block.at(i, j)] /
                   judged.specimen.solid.of_row(j).erosion_limit;
          }
        EXPECT_NEAR(judged.around(column, row), sum / whole, 1e-6) << "seed " << seed;
      }
  }
}

// In the half, on the right and on the left of the whole. A run would tell rounding apart only where it decides.
TEST(AveragedErosion, MirroredElementsHaveTheSameAverageToTheLastBit) {
  Problem p = eroding_specimen(Geometry::plane_strain);
  p.elements_per_radius = 4;
  Judged half(p);
  p.whole = true;
  Judged whole(p);
  constexpr unsigned seed = 5;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0, 2);
  const int columns = half.specimen.block.mesh().columns(), rows = half.specimen.block.mesh().rows;
  ASSERT_EQ(whole.specimen.block.mesh().columns(), 2 * columns);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const double share = any(random);
      half.set(i, j, share);
      for (const int column : {columns + i, columns - 1 - i}) whole.set(column, j, share);
      if (share > 0.2) continue;
      half.specimen.block.view().alive[half.specimen.block.at(i, j)] = 0;
      for (const int column : {columns + i, columns - 1 - i})
        whole.specimen.block.view().alive[whole.specimen.block.at(column, j)] = 0;
    }
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      for (const int column : {columns + i, columns - 1 - i})
        EXPECT_EQ(half.around(i, j), whole.around(column, j)) << "seed " << seed << ", " << i << " " << j;
}

// W_t of a strain is the energy in uniaxial tension at its stretch, whichever measure says it.
TEST(AveragedErosion, TheLimitOfAStrainIsItsEnergyInUniaxialTension) {
  Problem p = averaged(setting_s(10), 0.3);
  const double l = 1.7, expected = 2 * p.mu() / (8.5 * 8.5) * (std::pow(l, 8.5) + 2 * std::pow(l, -4.25) - 3);
  EXPECT_NEAR(constants_of_layers(p).front().erosion_limit, expected, 1e-12 * expected);
  p.erosion = StrainErosion{std::log(l), StrainMeasure::true_strain};
  EXPECT_NEAR(constants_of_layers(p).front().erosion_limit, expected, 1e-12 * expected);
  p.erosion = EnergyErosion{0.123};
  EXPECT_EQ(constants_of_layers(p).front().erosion_limit, 0.123);
}

// Three layers of three rows and more: each row over its own limit, averaged across; what cannot erode does not enter.
TEST(AveragedErosion, LayersCountByTheirOwnLimitsAndOneThatCannotErodeNotAtAll) {
  Problem p = eroding_specimen(Geometry::axisymmetric);
  p.depth = 4;
  p.below = {{.depth = 4, .density = 1, .mu = 4, .alpha = 3, .bulk_ratio = 10, .erosion_limit = 1.1},
             {.depth = 13.0 / 3,
              .density = 1,
              .mu = 1,
              .alpha = 2,
              .bulk_ratio = 10,
              .erosion_limit = std::numeric_limits<double>::infinity()}};
  Judged judged(p);
  const auto& solid = judged.specimen.solid;
  ASSERT_NE(solid.of_row(0).erosion_limit, solid.of_row(12).erosion_limit);
  for (int i = 0; i < judged.specimen.block.mesh().columns(); ++i)
    for (int j = 0; j < judged.specimen.block.mesh().rows; ++j)
      judged.specimen.block.view().foreseen_measure[judged.specimen.block.at(i, j)] =
          1.3 * (j < 24 ? solid.of_row(j).erosion_limit : 1000.0);
  for (const int row : {0, 10, 11, 12, 13, 23}) EXPECT_NEAR(judged.around(1, row), 1.3, 1e-12) << row;
  judged.set_all([](int, int row) { return row < 12 ? 2.0 : 0.0; });
  EXPECT_GT(judged.around(1, 11), 1) << "most of what is near";
  EXPECT_GT(judged.around(1, 12), 0.3) << "across the boundary";
  EXPECT_LT(judged.around(1, 12), 1);
}

// A peak beyond its own limit stays where its surroundings are weak, and goes, at the next look, where they are not. While it waits it bears
// load as if nothing had been found.
TEST(AveragedErosion, ACandidateGoesOnlyIfItsSurroundingsExceedTheLimitToo) {
  for (const double elsewhere : {0.5, 1.5, 2.5}) {
    Judged judged(eroding_specimen(Geometry::plane_strain));
    auto& block = judged.specimen.block;
    EXPECT_NEAR(judged.average.largest_average(), 1 + 0.8 / 3 / 1.2, 1e-12) << "elements of 1/3";
    judged.set_all([&](int i, int j) { return i == 1 && j == 17 ? 1.2 : elsewhere; });
    block.view().alive[block.at(1, 17)] = candidate;
    judged.average.judge(block, 1, {0, 37});
    EXPECT_EQ(block.view().alive[block.at(1, 17)], elsewhere > judged.average.largest_average() ? condemned : 1.0);
  }
  Judged judged(eroding_specimen(Geometry::plane_strain));
  auto& specimen = judged.specimen;
  const auto look_at = [&](double stretch, double step) {
    specimen.stretch(1 / stretch, stretch);
    return specimen.look(step);
  };
  look_at(1.4, 0.01);
  const double whole = specimen.stress_z();
  specimen.block.view().alive[specimen.block.at(0, 0)] = candidate;
  EXPECT_EQ(look_at(1.4, 0).doomed, 0);
  EXPECT_EQ(specimen.stress_z(), whole);
  specimen.block.view().alive[specimen.block.at(0, 0)] = condemned;
  EXPECT_EQ(look_at(1.4, 0).doomed, 0) << "looked at again, nothing is decided";
  EXPECT_EQ(specimen.stress_z(), whole);
  EXPECT_EQ(look_at(1.4, 0.01).doomed, 1);
  EXPECT_EQ(specimen.stress_z(), 0);
  const ColumnReport all = look_at(1.6, 0.01);
  EXPECT_EQ(all.doomed, 0);
  EXPECT_EQ(all.candidates.begin, 0);
  EXPECT_GT(all.candidates.end, 36);
}

// Foreseen by a step and a half, gone a step later: an element leaves neither early nor late, as by its own value.
TEST(AveragedErosion, ForeseesTheEnergyAStepAndAHalfOn) {
  Judged judged(eroding_specimen(Geometry::plane_strain));
  auto& specimen = judged.specimen;
  const auto measure = [&] { return specimen.block.view().erosion_measure[0]; };
  specimen.stretch(1 / 1.2, 1.2);
  specimen.look(0.01);
  const double before = measure();
  specimen.stretch(1 / 1.21, 1.21);
  specimen.look(0.01);
  EXPECT_NEAR(specimen.block.view().foreseen_measure[0], measure() + 1.5 * (measure() - before), 1e-14);
}

// The plain kernel and the general one: the same to rounding as long as erosion does not amplify it.
TEST(AveragedErosion, BothKernelsFindTheSameEnergy) {
  Judged one(eroding_specimen(Geometry::axisymmetric)), other(eroding_specimen(Geometry::axisymmetric));
  for (Judged* judged : {&one, &other}) judged->specimen.stretch(0.8, 1.3, 0.1);
  one.specimen.look(0.01);
  other.specimen.look_as_plain(0.01);
  for (const int row : {0, 5, 36})
    EXPECT_NEAR(one.specimen.block.view().erosion_measure[row], other.specimen.block.view().erosion_measure[row],
                1e-13);
  EXPECT_GT(one.specimen.block.view().erosion_measure[0], 0.01);
}

TEST(AveragedErosion, AnyNumberOfThreadsGivesTheSameBits) {
  for (const Geometry geometry : {Geometry::axisymmetric, Geometry::plane_strain})
    for (const Arithmetic arithmetic : {Arithmetic::single_precision, Arithmetic::double_precision}) {
      Problem p = averaged(setting_s(6), 0.5);
      p.geometry = geometry;
      p.whole = geometry == Geometry::plane_strain;
      p.arithmetic = arithmetic;
      p.depth = 20;
      p.end_time = 5;
      const ImpactResult alone = run_impact(p, 1);
      EXPECT_GT(alone.eroded, 10);
      for (const int threads : {2, 3}) same_bits(run_impact(p, threads), alone);
    }
}

TEST(AveragedErosion, HalfAModelGivesTheWholeToTheLastBit) {
  for (const Arithmetic arithmetic : {Arithmetic::single_precision, Arithmetic::double_precision})
    for (const int rates : {1, 2}) {
      Problem p = averaged(prism_impact(square_on_its_corner()), 0.6);
      p.particle = RigidSphere{};
      p.arithmetic = arithmetic;
      p.rates = rates;
      p.end_time = 6;
      p.whole = true;
      const ImpactResult whole = run_impact(p);
      p.whole = false;
      const ImpactResult half = run_impact(p);
      EXPECT_GT(half.eroded, 10);
      EXPECT_EQ(2 * half.eroded, whole.eroded);
      EXPECT_EQ(half.depth, whole.depth);
      EXPECT_EQ(half.steps, whole.steps);
      EXPECT_EQ(half.energy.particle, whole.energy.particle);
    }
}

TEST(AveragedErosion, WhereALikeLayerBeginsChangesNoBit) {
  Problem p = averaged(setting_s(6), 0.5);
  p.end_time = 8;
  const auto cut_at = [&p](double depth) {
    Problem cut = p;
    cut.depth = depth;
    cut.below = {
        {.depth = 30 - depth, .mu = p.mu(), .alpha = p.alpha, .bulk_ratio = p.bulk_ratio, .erosion_limit = 0.7}};
    return cut;
  };
  const ImpactResult one = run_impact(cut_at(7.3)), other = run_impact(cut_at(1.5));
  EXPECT_GT(one.eroded, 30);
  same_bits(one, other);
}

// Setting S and l = 0.3 at 7 elements per radius, which the rule allows to tests only. A sketch with a contact and a mesh of its own has
// 22.8 +- 2.0 over the phase of the mesh.
TEST(AveragedErosion, SettingSGoesAsDeepAsInTheStudyAndItsEnergyCloses) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    Problem p = averaged(setting_s(7), 0.3);
    p.speed_factor = replicate_speed_factor(k);
    const ImpactResult result = run_impact(p);
    EXPECT_EQ(result.outcome, Outcome::stopped);
    EXPECT_LT(std::abs(result.energy.closure()), 0.01);
    EXPECT_EQ(result.distorted, 0);
    sum += result.depth / 3;
  }
  RecordProperty("depth", std::to_string(sum));
  EXPECT_GT(sum, 19);
  EXPECT_LT(sum, 28);
}

}  // namespace
}  // namespace percal
