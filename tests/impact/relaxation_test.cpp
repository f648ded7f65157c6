// Stress that relaxes, by a Prony series.
#include <gtest/gtest.h>

#include "impact/setting_s.hpp"
#include "impact/specimen.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

Problem relaxing(std::vector<PronyTerm> terms) {
  Problem p = specimen_problem();
  p.relaxation = PronySeries{std::move(terms)};
  return p;
}

// First Piola stress along z of the elastic solid with this modulus, stretched along z alone.
double elastic_stress(const Problem& p, double mu, double l) {
  return (isochoric_stress_of(mu, p.alpha, l, 1, 1) + p.bulk() / 2 * (l * l - 1)) / l;
}

TEST(Relaxation, AfterAStepOfStrainTheStressFollowsTheSeries) {
  const Problem p = relaxing({{0.3, 0.4}, {0.25, 3}});
  StrainedTarget<> specimen(p);
  const double l = 1.25;
  specimen.look(0);
  specimen.stretch(1, l);
  specimen.look(1e-12);
  EXPECT_NEAR(specimen.stress_z(), elastic_stress(p, p.mu(), l), 1e-9 * p.mu());
  double t = 0;
  for (const double step : {0.01, 0.3, 0.002, 1.5, 4.0}) {
    specimen.look(step);
    t += step;
    const double mu = p.mu() * (1 - 0.3 * (1 - std::exp(-t / 0.4)) - 0.25 * (1 - std::exp(-t / 3)));
    EXPECT_NEAR(specimen.stress_z(), elastic_stress(p, mu, l), 1e-9 * p.mu()) << t;
  }
}

TEST(Relaxation, MuIsTheModulusOfAFastChangeAndMuTimesTheRestThatOfASlowOne) {
  for (const auto& [time, mu_ratio] : {std::pair{1e9, 1.0}, {1e-9, 0.45}}) {
    const Problem p = relaxing({{0.3, time}, {0.25, time}});
    StrainedTarget<> specimen(p);
    for (int n = 0; n <= 10; ++n) {
      specimen.stretch(1, 1 + 0.03 * n);
      specimen.look(0.1);
    }
    specimen.look(0.1);
    EXPECT_NEAR(specimen.stress_z(), elastic_stress(p, mu_ratio * p.mu(), 1.3), 1e-8 * p.mu()) << time;
  }
}

// Stretch 1 + 0.3 sin t until t = 2.
struct Ramp {
  double stress, work,
      booked;  // work by the trapezoidal rule over nodal motion; what ledger and report say; per volume
};
Ramp ramp(int steps) {
  const Problem p = relaxing({{0.5, 0.7}});
  StrainedTarget<> specimen(p);
  specimen.look(0);
  double work = 0, booked = 0, old_stress = 0, old_stretch = 1;
  for (int n = 1; n <= steps; ++n) {
    const double l = 1 + 0.3 * std::sin(2.0 * n / steps);
    specimen.stretch(1, l);
    booked += specimen.look(2.0 / steps).relaxing_work / specimen.volume();
    const double stress = specimen.stress_z();
    work += 0.5 * (stress + old_stress) * (l - old_stretch);
    old_stress = stress;
    old_stretch = l;
  }
  booked += stored_energy(specimen.block, specimen.solid, specimen.block.mesh().rows).elastic / specimen.volume();
  return {old_stress, work, booked};
}

TEST(Relaxation, StressIsOfSecondOrderInTheStep) {
  const double exact = ramp(20480).stress;
  const double coarse = std::abs(ramp(40).stress - exact), fine = std::abs(ramp(160).stress - exact);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4), 2, 0.1);
}

TEST(Relaxation, WhatIsBookedIsTheWorkDoneToSecondOrder) {
  const Ramp coarse = ramp(40), fine = ramp(160);
  EXPECT_GT(fine.booked, 0.01);
  EXPECT_LT(std::abs(fine.booked - fine.work), 1e-3 * fine.work);
  EXPECT_NEAR(std::log((coarse.booked - coarse.work) / (fine.booked - fine.work)) / std::log(4), 2, 0.1);
}

// Its stress does not last to the end of the step that it goes in: only the first half of the trapezoid is done.
TEST(Relaxation, AnElementThatGoesDoesHalfTheWorkOfItsLastStep) {
  Problem p = relaxing({{0.5, 0.7}});
  p.erosion = StrainErosion{0.3};
  StrainedTarget<> specimen(p);
  specimen.look(0);
  const double l = 1.1, last = 1.5;
  specimen.stretch(1, l);
  specimen.look(0.2);
  const double overstress = (specimen.stress_z() - elastic_stress(p, 0.5 * p.mu(), l)) / l;
  specimen.stretch(1, last);
  const ColumnReport report = specimen.look(0.2);
  ASSERT_EQ(report.doomed, 37 * specimen.block.mesh().columns());
  EXPECT_GT(overstress, 0.01);
  EXPECT_NEAR(report.relaxing_work / specimen.volume(), 0.5 * overstress * (last * last - l * l) / 2, 1e-9);
}

// What has relaxed no longer takes its share off the modulus of P: a compressed element gets stiffer by it, by the
// largest principal value of what is missing.
TEST(Relaxation, TheStableStepFollowsTheStressThatIsLeft) {
  const Problem p = relaxing({{0.6, 1}});
  StrainedTarget<> specimen(p);
  const double l = 0.7, per_height2 = 9;
  specimen.look(0);
  specimen.stretch(1, l);
  const double fresh = std::pow(specimen.look(1e-12).largest_inverse_step, 2);
  const double relaxed = std::pow(specimen.look(1e6).largest_inverse_step, 2);
  const double missing = -0.6 * isochoric_stress_of(p.mu(), p.alpha, l, 1, 1);
  EXPECT_GT(missing, 0.1);
  EXPECT_NEAR(relaxed - fresh, missing * per_height2 * (1 + 1 / (l * l)), 1e-6);
}

TEST(Relaxation, ARigidRotationLeavesTheStressAsItIs) {
  const Problem p = relaxing({{0.5, 0.7}});
  StrainedTarget<> straight(p), turned(p);
  const auto turn = [](Block<double>& block, double angle) {
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) {
        const long n = block.at(i, j);
        const double r = block.mesh().radius[i], z = j * block.mesh().row_height;
        const double x = r + block.view().u_r[n], y = z + block.view().u_z[n];
        block.view().u_r[n] = std::cos(angle) * x - std::sin(angle) * y - r;
        block.view().u_z[n] = std::sin(angle) * x + std::cos(angle) * y - z;
      }
  };
  for (int n = 0; n <= 8; ++n) {
    for (auto* specimen : {&straight, &turned}) specimen->stretch(1, 1 + 0.03 * n);
    turn(turned.block, 0.2 * n);
    straight.look(0.1);
    turned.look(0.1);
  }
  const auto &before = straight.block.far_forces(), &after = turned.block.far_forces();
  EXPECT_NEAR(std::hypot(after.r[0], after.z[0]), std::hypot(before.r[0], before.z[0]), 1e-10);
  EXPECT_NEAR(after.r[0], std::cos(1.6) * before.r[0] - std::sin(1.6) * before.z[0], 1e-10);
}

Problem relaxing_dent(double time) {
  Problem p = dent();
  p.relaxation = PronySeries{{{0.4, time}, {0.2, 5 * time}}};
  return p;
}

TEST(Relaxation, TheEnergyOfARunClosesWithOneRateAndWithTwo) {
  for (const int rates : {1, 2}) {
    Problem p = relaxing_dent(0.3);
    p.rates = rates;
    const auto closure = [&](double factor) {
      p.time_step_factor = factor;
      const EnergyLedger energy = run_impact(p).energy;
      EXPECT_GT(energy.relaxation, 0.005);
      return std::abs(energy.closure());
    };
    // From one halving to the next it swings, with the step that contact begins in.
    EXPECT_LT(closure(0.8), 1e-4) << rates;
    EXPECT_LT(closure(0.1), 1e-5) << rates;
  }
}

TEST(Relaxation, ErodedElementsTakeNothingUnseen) {
  Problem p = setting_s(7);
  p.arithmetic = Arithmetic::double_precision;
  p.relaxation = PronySeries{{{0.5, 0.5}}};
  p.depth = 40;
  p.end_time = 4;
  const ImpactResult result = run_impact(p);
  EXPECT_GT(result.eroded, 20);
  EXPECT_GT(result.energy.relaxation, 0.02);
  EXPECT_LT(std::abs(result.energy.closure()), 1e-3);
}

// The whole solver between the two elastic limits.
TEST(Relaxation, ARunWithVerySlowOrVeryFastRelaxationIsTheElasticOne) {
  Problem p = dent();
  const double instantaneous = run_impact(p).energy.particle;
  Problem soft = p;
  soft.pi4 = p.pi4 / 0.4;
  soft.bulk_ratio = p.bulk_ratio / 0.4;
  soft.hourglass = p.hourglass / 0.4;  // springs keep the instantaneous modulus
  const double lasting = run_impact(soft).energy.particle;
  EXPECT_GT(lasting - instantaneous, 0.005);
  EXPECT_NEAR(run_impact(relaxing_dent(1e7)).energy.particle, instantaneous, 1e-5);
  EXPECT_NEAR(run_impact(relaxing_dent(1e-7)).energy.particle, lasting, 0.03 * (lasting - instantaneous));
}

}  // namespace
}  // namespace percal
