// The energy ledger closes, and the better the smaller the step.
#include <gtest/gtest.h>

#include <cmath>

#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

double closure_at(Problem problem, double time_step_factor) {
  problem.time_step_factor = time_step_factor;
  return std::abs(run_impact(problem).energy.closure());
}

// Exponent n of closure ~ step^n between the first and the last factor.
double slope(double first, double first_closure, double last, double last_closure) {
  return std::log(first_closure / last_closure) / std::log(first / last);
}

TEST(Energy, ClosesBelowAThousandthAtTheDefaultStepWhereNothingErodes) {
  for (const double alpha : {2.0, 3.0, 8.5, 20.0}) {
    Problem p = dent();
    p.alpha = alpha;
    for (const auto arithmetic : {Arithmetic::double_precision, Arithmetic::single_precision}) {
      p.arithmetic = arithmetic;
      EXPECT_LT(closure_at(p, Problem{}.time_step_factor), 1e-3) << alpha;
    }
  }
}

TEST(Energy, TheErrorFallsAsTheSquareOfTheStep) {
  Problem p = dent();
  p.rates = 1;
  const double coarse = closure_at(p, 0.8), middle = closure_at(p, 0.4), fine = closure_at(p, 0.1);
  EXPECT_LT(coarse, 3e-5);
  EXPECT_LT(middle, coarse);
  EXPECT_LT(fine, middle);
  EXPECT_NEAR(slope(0.8, coarse, 0.1, fine), 2, 0.45);  // it swings, with the steps that nodes' contact begins in
}

TEST(Energy, TheErrorFallsAsTheSquareUntilTheSphereStopsToo) {
  Problem p = dent();
  p.rates = 1;
  p.alpha = 8.5;
  p.end_time = 1000;
  EXPECT_NEAR(slope(0.8, closure_at(p, 0.8), 0.2, closure_at(p, 0.2)), 2, 0.35);
}

// Without viscosity the error of a conservative scheme swings about zero, so it is taken over ten end times; and nothing
// damps what contact excites, so the impact is slower than elsewhere (docs/theory/impact.md, "Limits").
Problem undamped_dent() {
  Problem p = dent();
  p.linear_viscosity = p.quadratic_viscosity = 0;
  p.pi4 = 2;
  return p;
}
double typical_closure(Problem p, double factor) {
  double squares = 0;
  for (int k = 0; k < 10; ++k) {
    p.end_time = 1.5 + 0.1 * k;
    squares += std::pow(closure_at(p, factor), 2) / 10;
  }
  return std::sqrt(squares);
}

TEST(Energy, TheErrorFallsAsTheSquareWithoutViscosityToo) {
  Problem p = undamped_dent();
  p.rates = 1;
  const double coarse = typical_closure(p, 0.8), fine = typical_closure(p, 0.05);
  EXPECT_LT(coarse, 5e-5);
  EXPECT_NEAR(slope(0.8, coarse, 0.05, fine), 2, 0.4);
  EXPECT_EQ(run_impact(p).energy.viscosity, 0);
}

// Without the half-step corrections of elements the error falls as the step at best.
// Which elements take the short step is chosen anew every near_interval long steps; one that changes over is settled (Sweep::settle).
void erosion_takes_nothing_unseen(int rates, double tolerance) {
  Problem p = setting_s();
  p.rates = rates;
  p.arithmetic = Arithmetic::double_precision;
  p.end_time = 5;
  p.depth = 40;
  const double coarse = closure_at(p, 0.8), middle = closure_at(p, 0.4), fine = closure_at(p, 0.2);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(middle, coarse);
  EXPECT_LT(fine, middle);
  EXPECT_NEAR(slope(0.8, coarse, 0.2, fine), 2, tolerance);
}
TEST(Energy, ErosionTakesNothingUnseen) { erosion_takes_nothing_unseen(1, 0.25); }
TEST(Energy, ErosionTakesNothingUnseenWithTwoRates) { erosion_takes_nothing_unseen(2, 0.35); }

TEST(Energy, SettingSClosesToTwoPercentAndStopsWhereItShould) {
  const ImpactResult result = run_impact(setting_s());
  EXPECT_EQ(result.outcome, Outcome::stopped);
  EXPECT_GT(result.depth, 24);
  EXPECT_LT(result.depth, 31);
  EXPECT_LT(std::abs(result.energy.closure()), 0.02);
  EXPECT_GT(result.eroded, 100);
  EXPECT_GT(result.energy.eroded, 0.2);
  EXPECT_GT(result.energy.collisions, 0.02);
  EXPECT_EQ(result.distorted, 0);
}

TEST(Energy, NoTermIsNegative) {
  const EnergyLedger e = run_impact(setting_s()).energy;
  for (const double share :
       {e.particle, e.live_kinetic, e.freed_mass, e.elastic, e.hourglass, e.viscosity, e.eroded, e.collisions})
    EXPECT_GE(share, 0);
}

}  // namespace
}  // namespace percal
