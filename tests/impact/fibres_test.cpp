// Fibres in the plane of the layer: closed forms, the stress as the slope of the energy, runs.
#include "percal/impact/kernel/fibres.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "impact/specimen.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/target/elastic_solid.hpp"

namespace percal {
namespace {

constexpr FibreConstants fibres{.k1 = 0.7, .k2 = 2.3, .kappa = 0.4};

scalar::FibreResponse<double> response(const scalar::Gradient<double>& F, const FibreConstants& f = fibres) {
  return scalar::fibre_response(F, scalar::stretches(F), f.k1, f.k2, f.kappa);
}
scalar::Gradient<double> principal(double r, double z, double hoop) { return {r, 0, 0, z, hoop}; }

// dW/dlambda of the stretch given, volume kept, by the formula; the two others go with it.
struct FibreForm {
  double energy, slope;
};
FibreForm closed(double invariant, double change_of_invariant) {
  const double E = invariant - 1;
  if (E <= 0) return {0, 0};
  const double grown = std::exp(fibres.k2 * E * E);
  return {fibres.k1 / (2 * fibres.k2) * (grown - 1), fibres.k1 * E * grown * change_of_invariant};
}

TEST(Fibres, UniaxialEquibiaxialAndPlanarStatesAreTheClosedForms) {
  const double k = fibres.kappa, through = 1 - 2 * k;
  for (const double l : {0.7, 0.9, 1.1, 1.4, 1.8}) {
    // Along r: 1/sqrt(l) across. Along z. Equibiaxial in the plane. Planar: r against z, the hoop held.
    const struct {
      scalar::Gradient<double> F;
      double invariant, change;          // of kappa (C_r + C_hoop) + (1 - 2 kappa) C_z by l
      double rate_r, rate_z, rate_hoop;  // of the stretches by l
    } states[] = {
        {principal(l, 1 / std::sqrt(l), 1 / std::sqrt(l)), k * (l * l + 1 / l) + through / l,
         k * (2 * l - 1 / (l * l)) - through / (l * l), 1, -0.5 * std::pow(l, -1.5), -0.5 * std::pow(l, -1.5)},
        {principal(1 / std::sqrt(l), l, 1 / std::sqrt(l)), 2 * k / l + through * l * l,
         -2 * k / (l * l) + 2 * through * l, -0.5 * std::pow(l, -1.5), 1, -0.5 * std::pow(l, -1.5)},
        {principal(l, 1 / (l * l), l), 2 * k * l * l + through * std::pow(l, -4),
         4 * k * l - 4 * through * std::pow(l, -5), 1, -2 * std::pow(l, -3), 1},
        {principal(l, 1 / l, 1), k * (l * l + 1) + through / (l * l), 2 * k * l - 2 * through * std::pow(l, -3), 1,
         -1 / (l * l), 0}};
    for (const auto& state : states) {
      const auto found = response(state.F);
      const FibreForm expected = closed(state.invariant, state.change);
      EXPECT_NEAR(found.energy, expected.energy, 1e-12 * (1 + expected.energy)) << l;
      const double slope =
          found.stress.rr * state.rate_r + found.stress.zz * state.rate_z + found.stress.hoop * state.rate_hoop;
      EXPECT_NEAR(slope, expected.slope, 1e-11 * (1 + std::abs(expected.slope))) << l;
    }
  }
}

scalar::Gradient<double> random_gradient(std::mt19937& random) {
  std::uniform_real_distribution<double> small(-0.3, 0.3);
  return {1.1 + small(random), small(random), small(random), 1 + small(random), 1.1 + small(random)};
}

TEST(Fibres, TheirStressIsTheSlopeOfTheirEnergyInAnyState) {
  std::mt19937 random(5);
  int taut = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto F = random_gradient(random);
    const auto P = response(F).stress;
    const double h = 1e-6;
    const auto slope = [&](double scalar::Gradient<double>::*member) {
      auto above = F, below = F;
      above.*member += h;
      below.*member -= h;
      return (response(above).energy - response(below).energy) / (2 * h);
    };
    using G = scalar::Gradient<double>;
    const double size = 1 + std::abs(P.rr) + std::abs(P.zz);
    EXPECT_NEAR(P.rr, slope(&G::rr), 1e-7 * size);
    EXPECT_NEAR(P.rz, slope(&G::rz), 1e-7 * size);
    EXPECT_NEAR(P.zr, slope(&G::zr), 1e-7 * size);
    EXPECT_NEAR(P.zz, slope(&G::zz), 1e-7 * size);
    EXPECT_NEAR(P.hoop, slope(&G::hoop), 1e-7 * size);
    taut += response(F).energy > 0;
  }
  EXPECT_GT(taut, 50);
  EXPECT_LT(taut, 195);
}

TEST(Fibres, ThoseInThePlaneBearNothingInCompressionOfItAndARotationAboutTheHoopMakesNoStressWhereTheyAreDispersed) {
  const auto slack = response(principal(0.9, 1 / 0.81, 0.9), {.k1 = 1, .k2 = 1, .kappa = 0.5});
  EXPECT_EQ(slack.energy, 0);
  EXPECT_EQ(slack.stress.rr, 0);
  EXPECT_EQ(slack.stiffness, 0);
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (const double kappa : {1.0 / 3, 0.5})
    EXPECT_NEAR(response({c, -s, s, c, 1}, {.k1 = 1, .k2 = 1, .kappa = kappa}).stress.rr, 0, 1e-14) << kappa;
}

Problem fibrous(Problem p) {
  p.fibres = PlanarFibres{.k1 = 2 * p.mu(), .k2 = 1.5, .kappa = 0.45};
  return p;
}

// Layers, lanes and single precision: the forces are those of the solid's own stress, per layer.
template <class Real>
void has_the_stress_of_its_solid(double tolerance) {
  Problem p = fibrous(specimen_problem());
  p.below = {{.depth = 5, .mu = p.mu(), .alpha = p.alpha, .bulk_ratio = p.bulk_ratio}};
  p.depth = 22.0 / 3;
  StrainedTarget<Real> specimen(p);
  specimen.stretch(1.2, 0.85);
  specimen.look(0);
  const MaterialConstants& m = specimen.solid.of_row(0);
  const ElasticSolid solid{{m.mu, m.bulk, m.alpha}, m.fibres};
  const auto P = solid.first_piola(principal(1.2, 0.85, 1));
  EXPECT_GT(std::abs(P.rr - ElasticSolid{solid.matrix}.first_piola(principal(1.2, 0.85, 1)).rr), 0.1);
  EXPECT_NEAR(specimen.stress_r(), P.rr, tolerance * std::abs(P.rr));
  EXPECT_NEAR(specimen.stress_z(), P.zz, tolerance * std::abs(P.rr));
  EXPECT_TRUE(specimen.solid.of_row(30).fibres.is_none());
}

TEST(Fibres, TheKernelHasTheStressOfTheSolid) {
  has_the_stress_of_its_solid<double>(1e-12);
  has_the_stress_of_its_solid<float>(3e-5);
}

TEST(Fibres, ADentWithThemClosesToSecondOrderAndIsShallower) {
  Problem p = fibrous(dent());
  const auto run = [&](double factor) {
    p.time_step_factor = factor;
    return run_impact(p, 1);
  };
  const double coarse = std::abs(run(0.8).energy.closure()), fine = std::abs(run(0.2).energy.closure());
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(std::log(coarse / fine) / std::log(4), 1.5);
  EXPECT_LT(run(0.9).depth, run_impact(dent(), 1).depth);
}

TEST(Fibres, AnErodingShotOfAStretchedFibrousLayerClosesOnAnyNumberOfThreads) {
  Problem p = fibrous(setting_s());
  p.stretch = 1.1;
  p.end_time = 8;
  for (const Erosion& erosion : {Erosion(StrainErosion{0.7}), Erosion(EnergyErosion{0.4})}) {
    p.erosion = erosion;
    const ImpactResult one = run_impact(p, 1);
    EXPECT_LT(std::abs(one.energy.closure()), 4e-3);
    EXPECT_GT(one.eroded, 50);
    same_bits(run_impact(p, 3), one);
  }
}

// Of a strain it is the energy of a test along the plane.
TEST(Fibres, AStrainJudgedOverALengthStandsForAnEnergyWithTheirsInIt) {
  Problem p = fibrous(setting_s());
  p.erosion_average = AverageWithin{0.5};
  const double with = constants_of_layers(p).front().erosion_limit, l = 1.7;
  const auto& planar = std::get<PlanarFibres>(p.fibres);
  p.fibres = NoFibres{};
  const double E = planar.kappa * (l * l + 1 / l) + (1 - 2 * planar.kappa) / l - 1;
  EXPECT_NEAR(with - constants_of_layers(p).front().erosion_limit,
              planar.k1 / (2 * planar.k2) * (std::exp(planar.k2 * E * E) - 1), 1e-11 * with);
}

// An average of the energy has the fibres' in it.
TEST(Fibres, AnAverageOfTheEnergyCountsThem) {
  Problem p = fibrous(setting_s(8));
  p.erosion = EnergyErosion{0.4};
  p.erosion_average = AverageWithin{0.4};
  p.end_time = 6;
  const ImpactResult with = run_impact(p, 1);
  p.fibres = NoFibres{};
  const ImpactResult without = run_impact(p, 1);
  EXPECT_LT(std::abs(with.energy.closure()), 5e-3);
  EXPECT_NE(with.eroded, without.eroded);
}

}  // namespace
}  // namespace percal
