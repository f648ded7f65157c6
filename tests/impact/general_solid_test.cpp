// Targets that are more than one layer of the plain solid: volumetric laws, kinds of erosion, hourglass viscosity, and
// the general kernel as such. Relaxation and layers have files of their own.
#include <gtest/gtest.h>

#include "impact/setting_s.hpp"
#include "impact/specimen.hpp"
#include "percal/impact/kernel/element.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

Problem everything_at_once() {
  Problem p = specimen_problem();
  p.geometry = Geometry::axisymmetric;
  p.linear_viscosity = 0.06;
  p.quadratic_viscosity = 1.2;
  p.volumetric_law = VolumetricLaw::logarithmic;
  p.hourglass_form = HourglassForm::viscosity;
  p.relaxation = PronySeries{{{0.3, 0.1}, {0.2, 1}}};
  p.depth = 4;
  p.below = {{.depth = 25.0 / 3, .density = 1.2, .mu = 5, .alpha = 3, .bulk_ratio = 20, .erosion_limit = 2}};
  return p;
}

// Both write out the same formulas; only the compiler's choice of fused operations may differ.
template <class Real>
void meets_the_plain_kernel(double tolerance) {
  for (const double alpha : {-6.0, 2.0, 8.5, 20.0}) {
    Problem p = specimen_problem();
    p.geometry = Geometry::axisymmetric;
    p.alpha = alpha;
    p.linear_viscosity = 0.06;
    p.quadratic_viscosity = 1.2;
    p.erosion = StrainErosion{0.15};
    StrainedTarget<Real> general(p), plain(p);
    displace_at_random(general.block, 0.03);
    displace_at_random(plain.block, 0.03);
    const auto report = general.look(0.05), expected = plain.look_as_plain(0.05);
    EXPECT_GT(expected.doomed, 0);
    EXPECT_EQ(report.doomed, expected.doomed);
    EXPECT_NEAR(report.viscous_work, expected.viscous_work, 10 * tolerance * expected.viscous_work);
    EXPECT_NEAR(report.largest_inverse_step, expected.largest_inverse_step, tolerance * expected.largest_inverse_step);
    double size = 0;
    for (int i = 0; i <= plain.block.mesh().columns(); ++i)
      for (int j = 0; j <= plain.block.mesh().rows; ++j)
        size = std::max(size, std::abs(double(plain.block.far_forces().z[plain.block.at(i, j)])));
    for (int i = 0; i <= plain.block.mesh().columns(); ++i)
      for (int j = 0; j <= plain.block.mesh().rows; ++j) {
        const long n = plain.block.at(i, j);
        EXPECT_NEAR(general.block.far_forces().r[n], plain.block.far_forces().r[n], tolerance * size);
        EXPECT_NEAR(general.block.far_forces().z[n], plain.block.far_forces().z[n], tolerance * size);
        EXPECT_EQ(general.block.view().alive[n], plain.block.view().alive[n]);
      }
  }
}
TEST(GeneralSolid, WithPlainSettingsGivesTheForcesOfTheUniformSolid) {
  meets_the_plain_kernel<double>(1e-14);
  meets_the_plain_kernel<float>(2e-6);
}

// Column by column in lanes against element by element and node by node.
template <class Real>
void holds_what_its_elements_hold() {
  Problem p = specimen_problem();
  p.geometry = Geometry::axisymmetric;
  StrainedTarget<Real> specimen(p);
  Block<Real>& block = specimen.block;
  displace_at_random(block, 0.03);
  const int columns = block.mesh().columns(), rows = block.mesh().rows;
  for (int j = 5; j < 20; ++j)
    for (int i = 0; i < 3; ++i) block.take_out(i, j, false);
  EnergyLedger sum;
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      const long n = block.at(i, j);
      block.view().v_r[n] = Real(0.1 * i), block.view().v_z[n] = Real(0.01 * j);
      const double squared = std::pow(double(block.view().v_r[n]), 2) + std::pow(double(block.view().v_z[n]), 2);
      (block.has_live_element(i, j) ? sum.live_kinetic : sum.freed_mass) += 0.5 * block.mass(i, j) * squared;
      if (i == columns || j == rows || !(block.view().alive[n] > 0)) continue;
      const ElementEnergy one = element_energy(block, specimen.solid, i, j, 0);
      sum.elastic += one.elastic;
      sum.hourglass += one.hourglass;
    }
  const EnergyLedger held = stored_energy(block, specimen.solid, rows);
  for (const auto share :
       {&EnergyLedger::live_kinetic, &EnergyLedger::freed_mass, &EnergyLedger::elastic, &EnergyLedger::hourglass}) {
    EXPECT_GT(sum.*share, 0);
    EXPECT_NEAR(held.*share / sum.*share, 1, 1e-12);
  }
}

TEST(StoredEnergy, OfAPlainSolidIsThatOfItsElementsAndNodes) {
  holds_what_its_elements_hold<float>();
  holds_what_its_elements_hold<double>();
}

constexpr PressureLaw laws[] = {PressureLaw::log_quadratic, PressureLaw::quadratic, PressureLaw::logarithmic};

TEST(VolumetricLaw, PressureAndStiffnessAreDerivativesOfTheEnergyAndKAtRest) {
  const double K = 3, h = 1e-5;
  for (const PressureLaw law : laws) {
    EXPECT_NEAR(scalar::volumetric_stiffness(law, 1.0, K), K, 1e-12);
    EXPECT_EQ(scalar::kirchhoff_pressure(law, 1.0, K), 0);
    for (const double J : {0.4, 0.8, 1.1, 1.7}) {
      const auto U = [&](double at) { return scalar::volumetric_energy(law, at, K); };
      EXPECT_NEAR(scalar::kirchhoff_pressure(law, J, K), J * (U(J + h) - U(J - h)) / (2 * h), 1e-7);
      const auto slope = [&](double at) { return scalar::kirchhoff_pressure(law, at, K) / at; };
      EXPECT_NEAR(scalar::volumetric_stiffness(law, J, K), J * J * (slope(J + h) - slope(J - h)) / (2 * h), 1e-7);
    }
  }
}

TEST(VolumetricLaw, TheThreeAreThreeDifferentLaws) {
  const double J = 1.5, K = 2;
  EXPECT_NEAR(scalar::volumetric_energy(PressureLaw::log_quadratic, J, K), 0.5 * (1.25 - 2 * std::log(1.5)), 1e-14);
  EXPECT_NEAR(scalar::volumetric_energy(PressureLaw::quadratic, J, K), 0.25, 1e-14);
  EXPECT_NEAR(scalar::volumetric_energy(PressureLaw::logarithmic, J, K), std::pow(std::log(1.5), 2), 1e-14);
}

TEST(VolumetricLaw, NodalForcesAreMinusTheDerivativeOfTheEnergyUnderEveryLaw) {
  for (const auto law : {VolumetricLaw::log_quadratic, VolumetricLaw::quadratic, VolumetricLaw::logarithmic}) {
    Problem p = specimen_problem();
    p.geometry = Geometry::axisymmetric;
    p.volumetric_law = law;
    p.depth = 2;
    p.below = {{.depth = 2, .density = 1.5, .mu = 7, .alpha = -4, .bulk_ratio = 20}};
    StrainedTarget<> specimen(p);
    displace_at_random(specimen.block, 0.04);
    specimen.look(0);
    const auto energy = [&] {
      const EnergyLedger stored = stored_energy(specimen.block, specimen.solid, specimen.block.mesh().rows);
      return stored.elastic + stored.hourglass;
    };
    const auto& view = specimen.block.view();
    const auto& forces = specimen.block.far_forces();
    for (const auto& [i, j] : {std::pair{1, 0}, {2, 3}, {3, 6}, {1, 9}, {4, 12}})
      for (const auto& [u, f] : {std::pair{view.u_r, forces.r}, {view.u_z, forces.z}}) {
        const long n = specimen.block.at(i, j);
        const double at = u[n], h = 1e-6;
        u[n] = at + h;
        const double above = energy();
        u[n] = at - h;
        const double below = energy();
        u[n] = at;
        EXPECT_NEAR(f[n], -(above - below) / (2 * h), 1e-6) << "node " << i << ", " << j;
      }
  }
}

// When the corner element goes, stretched along z at speed 1 with a step, in steps after the stretch reached the value.
double steps_late(const Problem& p, double at_stretch, double step) {
  StrainedTarget<> specimen(p);
  specimen.look(0);
  for (int n = 1; n < 100000; ++n) {
    specimen.stretch(1, 1 + n * step);
    specimen.look(step);
    if (specimen.block.view().alive[0] < 0) {
      EXPECT_EQ(specimen.block.view().alive[0], -1);
      return n - (at_stretch - 1) / step;
    }
  }
  return 1e30;
}

// Uniformly spread over half a step before and after: neither early nor late.
void goes_on_time(const Problem& p, double at_stretch) {
  double sum = 0;
  const int count = 40;
  for (int k = 0; k < count; ++k) {
    const double late = steps_late(p, at_stretch, 0.002 * (1 + 0.01237 * k));
    EXPECT_LT(std::abs(late), 0.6);
    sum += late;
  }
  EXPECT_NEAR(sum / count, 0, 0.15);
}

TEST(Erosion, ByStressAnElementGoesWhenItsLargestPrincipalCauchyStressReachesTheLimit) {
  Problem p = specimen_problem();
  const double l = 1.3, K = p.bulk();
  p.erosion = StressErosion{(isochoric_stress_of(p.mu(), p.alpha, l, 1, 1) + K / 2 * (l * l - 1)) / l};
  goes_on_time(p, l);
}

TEST(Erosion, ByEnergyAnElementGoesWhenItsStoredEnergyReachesTheLimit) {
  Problem p = specimen_problem();
  const double l = 1.3, g = std::pow(l, p.alpha * 2 / 3), others = std::pow(l, -p.alpha / 3);
  p.erosion = EnergyErosion{2 * p.mu() / (p.alpha * p.alpha) * (g + 2 * others - 3) +
                            p.bulk() / 4 * (l * l - 1 - 2 * std::log(l))};
  goes_on_time(p, l);
}

// Limits that single criteria would reach at three stretches: the least decides, whatever kind it is of.
TEST(Erosion, OfSeveralLimitsTheFirstReachedDecidesAndIsNamed) {
  const Problem plain = specimen_problem();
  const double K = plain.bulk();
  const auto strain_at = [](double l) { return l - 1; };
  const auto stress_at = [&](double l) {
    return (isochoric_stress_of(plain.mu(), plain.alpha, l, 1, 1) + K / 2 * (l * l - 1)) / l;
  };
  const auto energy_at = [&](double l) {
    return 2 * plain.mu() / (plain.alpha * plain.alpha) *
               (std::pow(l, plain.alpha * 2 / 3) + 2 * std::pow(l, -plain.alpha / 3) - 3) +
           K / 4 * (l * l - 1 - 2 * std::log(l));
  };
  const double l = 1.3, later = 1.4;
  for (const Criterion first : {Criterion::strain, Criterion::stress, Criterion::energy}) {
    const auto at = [&](Criterion one) { return one == first ? l : later; };
    Problem p = plain;
    p.erosion = StrainErosion{strain_at(at(Criterion::strain))};
    p.further_erosion = {stress_at(at(Criterion::stress)), energy_at(at(Criterion::energy))};
    goes_on_time(p, l);
    StrainedTarget<> specimen(p);
    specimen.stretch(1, l);
    EXPECT_EQ(leading_criterion(specimen.block, specimen.solid, 1, 3), first);
    EXPECT_TRUE(specimen.solid.erodes(3));
  }
}

TEST(Erosion, ALayerMayHaveAFurtherLimitAlone) {
  Problem p = setting_s();
  p.further_erosion.energy = 1e6;
  p.below = {
      {.depth = 40, .mu = p.mu(), .alpha = p.alpha, .erosion_limit = INFINITY, .further_erosion = {.energy = 0.1}}};
  p.depth = 2;
  p.end_time = 8;
  const ImpactResult result = run_impact(p, 1);
  EXPECT_NE(result.outcome, Outcome::unstable) << result.reason;
  EXPECT_GT(result.eroded_by.strain, 20);
  EXPECT_GT(result.eroded_by.energy, 50);
  EXPECT_EQ(result.eroded_by.stress, 0);
  EXPECT_EQ(result.eroded_by.strain + result.eroded_by.energy + result.distorted, result.eroded);
  EXPECT_LT(std::abs(result.energy.closure()), 5e-3);
}

// Nothing but a stretch of hundreds of times its length takes it out, when its step collapses; that is counted apart.
TEST(Erosion, WhatIsCrushedIsMarkedAsDistorted) {
  Problem p = specimen_problem();
  p.erosion = StressErosion{1e6};
  StrainedTarget<> specimen(p);
  specimen.stretch(1, 0.04);
  EXPECT_GT(specimen.look(0.1).doomed, 0);
  EXPECT_EQ(specimen.block.view().alive[0], -2);
}

TEST(Erosion, TheStressThatDecidesHasNoBulkViscosityInIt) {
  Problem p = specimen_problem();
  p.erosion = StressErosion{1e6};
  Problem viscous = p;
  viscous.linear_viscosity = 0.5;
  StrainedTarget<> without(p), with(viscous);
  for (auto* specimen : {&without, &with}) {
    EXPECT_EQ(specimen->block.view().erosion_measure[0], 0) << "no stress before the first look";
    specimen->look(0);
    specimen->stretch(1.2, 0.7);
    specimen->look(0.1);
  }
  EXPECT_GT(with.block.view().viscous_pressure[0], 0.1);
  EXPECT_NEAR(with.block.view().erosion_measure[0], without.block.view().erosion_measure[0], 1e-10);
}

// Half of f.v dt, whatever the law: what an element that goes does not do any more.
TEST(VolumetricLaw, TheLastWorkIsThatOfTheLawsOwnStress) {
  for (const auto law : {VolumetricLaw::log_quadratic, VolumetricLaw::quadratic, VolumetricLaw::logarithmic}) {
    Problem p = specimen_problem();
    p.volumetric_law = law;
    StrainedTarget<> specimen(p);
    const double l = 1.4, step = 0.01;
    specimen.stretch(1, l);
    specimen.look(0);
    auto& block = specimen.block;
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) block.view().v_z[block.at(i, j)] = j * block.mesh().row_height;
    const double volume = block.shapes()[1].width * block.shapes()[1].height;
    EXPECT_NEAR(element_energy(block, specimen.solid, 1, 5, step).last_work, -0.5 * step * volume * specimen.stress_z(),
                1e-12);
  }
}

TEST(HourglassViscosity, TheModeLosesTheShareThatItsCoefficientSays) {
  Problem p = specimen_problem();
  p.hourglass_form = HourglassForm::viscosity;
  p.hourglass = 0.1;
  StrainedTarget<> specimen(p);
  auto& block = specimen.block;
  const double amplitude = 1e-6;
  for (int i = 0; i <= block.mesh().columns(); ++i)
    for (int j = 0; j <= block.mesh().rows; ++j)
      block.view().v_z[block.at(i, j)] = (i + j) % 2 ? -amplitude : amplitude;
  specimen.look(0.01);
  // An inner node of the square elements: four elements pull at it with eta times the mode, 4 amplitudes.
  const double h = block.mesh().row_height, impedance = std::sqrt(p.bulk() + 4.0 / 3 * p.mu());
  const double eta = 0.25 * p.hourglass * impedance * h;
  EXPECT_NEAR(block.far_forces().z[block.at(1, 1)], 4 * 4 * eta * -amplitude * 1, 1e-12 * amplitude)
      << "node (1, 1) moves with +amplitude";
}

TEST(HourglassViscosity, AnElementThatGoesDoesHalfTheWorkOfItsLastStep) {
  Problem p = specimen_problem();
  p.hourglass_form = HourglassForm::viscosity;
  p.erosion = StrainErosion{0.3};
  StrainedTarget<> specimen(p);
  auto& block = specimen.block;
  for (int i = 0; i <= block.mesh().columns(); ++i)
    for (int j = 0; j <= block.mesh().rows; ++j) block.view().v_z[block.at(i, j)] = (i + j) % 2 ? -1 : 1;
  specimen.look(0.01);
  const double full = specimen.look(0.01).viscous_work;
  specimen.stretch(1, 1.5);
  const ColumnReport last = specimen.look(0.01);
  ASSERT_GT(last.doomed, 0);
  EXPECT_GT(full, 0.01);
  EXPECT_NEAR(last.viscous_work, full / 2, 1e-12);
}

TEST(HourglassViscosity, ItsWorkIsBookedToSecondOrder) {
  Problem p = dent();
  p.hourglass_form = HourglassForm::viscosity;
  p.hourglass = 0.1;
  const auto closure = [&](double factor) {
    p.time_step_factor = factor;
    return std::abs(run_impact(p).energy.closure());
  };
  const double coarse = closure(0.8), fine = closure(0.2);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(std::log(coarse / fine) / std::log(4), 1.6);
}

TEST(HourglassViscosity, EvenMuchOfItStaysBounded) {
  Problem p = dent();
  p.hourglass_form = HourglassForm::viscosity;
  for (const double share : {0.5, 1.0, 2.0}) {
    p.hourglass = share;
    const ImpactResult result = run_impact(p);
    EXPECT_NE(result.outcome, Outcome::unstable) << share;
    EXPECT_LT(std::abs(result.energy.closure()), 2e-3) << share;
  }
}

TEST(GeneralSolid, ForcesAlongTheAxisAddUpToNothingWithAllOptionsOn) {
  StrainedTarget<> specimen(everything_at_once());
  displace_at_random(specimen.block, 0.03);
  specimen.look(0.05);
  double sum = 0, size = 0;
  for (int i = 0; i <= specimen.block.mesh().columns(); ++i)
    for (int j = 0; j <= specimen.block.mesh().rows; ++j) {
      sum += specimen.block.far_forces().z[specimen.block.at(i, j)];
      size += std::abs(specimen.block.far_forces().z[specimen.block.at(i, j)]);
    }
  EXPECT_GT(size, 1);
  EXPECT_NEAR(sum, 0, 1e-13 * size);
}

TEST(GeneralSolid, AnyNumberOfThreadsGivesTheSameBitsWithAllOptionsOn) {
  Problem p = setting_s(6);
  const Problem options = everything_at_once();
  p.volumetric_law = options.volumetric_law;
  p.hourglass_form = options.hourglass_form;
  p.hourglass = 0.1;
  p.relaxation = options.relaxation;
  p.depth = 3;
  p.below = {{.depth = 40, .density = 1.2, .mu = 0.5 * p.mu(), .alpha = 6, .bulk_ratio = 60, .erosion_limit = 0.5}};
  p.end_time = 6;
  const ImpactResult one = run_impact(p, 1);
  EXPECT_NE(one.outcome, Outcome::unstable);
  EXPECT_GT(one.eroded, 50);
  for (const int threads : {2, 3}) {
    const ImpactResult more = run_impact(p, threads);
    EXPECT_EQ(more.depth, one.depth);
    EXPECT_EQ(more.eroded, one.eroded);
    for (const auto& [key, share, words] : energy_terms) EXPECT_EQ(more.energy.*share, one.energy.*share) << key;
  }
}

}  // namespace
}  // namespace percal
