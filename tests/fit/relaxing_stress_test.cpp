// The stress of a solid that relaxes, over ramps, holds and jumps.                               docs/theory/relaxation.md
#include <gmock/gmock.h>

#include <functional>

#include "percal/base/error.hpp"
#include "percal/fit/points/thin_curves.hpp"
#include "support/relaxing_tests.hpp"

namespace percal {
namespace {

using test::add_test;
using test::relaxing_gel;
using testing::HasSubstr;

Eigen::VectorXd stress_of(const CurveData& data, const RelaxingSolid& solid) {
  return relaxing_stress(relaxing_rows(data, histories_of(data)), solid);
}

StressPoint timed(const Strained& strained, double time) {
  return {.strained = strained, .nominal_stress = 0, .time = time};
}

// Every test of the bench, tension and compression.
const std::vector<Strained> states_of_all_tests = {{Deformation::uniaxial, 0.6},      {Deformation::uniaxial, 1.8},
                                                   {Deformation::equibiaxial, 1.5},   {Deformation::planar, 1.7},
                                                   {Deformation::planar_held, 0.7},   {Deformation::simple_shear, 0.9},
                                                   {Deformation::simple_shear, -0.4}, {Deformation::biaxial, 1.4, 0.8}};

TEST(HereditaryStep, ALinearRampAndAHoldFollowTheClosedForm) {
  const double tau = 0.7, ramp = 2, height = 3;
  double h = 0, time = 0;
  for (const double step : {0.1, 0.45, 0.05, 1.4}) {
    const HereditaryStep by = hereditary_step(step, tau);
    h = by.decay * h + by.taken * height * step / ramp;
    time += step;
    EXPECT_NEAR(h, height / ramp * tau * (1 - std::exp(-time / tau)), 1e-14);
  }
  const double top = h;
  for (const double step : {0.3, 1e-7, 5.0}) {
    h = hereditary_step(step, tau).decay * h;
    time += step;
    EXPECT_NEAR(h, top * std::exp(-(time - ramp) / tau), 1e-15);
  }
}

TEST(HereditaryStep, ShortStepsJoinTheLongOnesAndSlopesAreDifferences) {
  for (const double x : {0.0, 1e-9, 0.99999e-4, 1.00001e-4, 0.3, 40.0}) {
    const HereditaryStep at = hereditary_step(x, 1), up = hereditary_step(x, std::exp(1e-5)),
                         down = hereditary_step(x, std::exp(-1e-5));
    EXPECT_NEAR(at.taken, x == 0 ? 1 : -std::expm1(-x) / x, 1e-14) << x;
    EXPECT_NEAR(at.decay_slope, (up.decay - down.decay) / 2e-5, 1e-9) << x;
    EXPECT_NEAR(at.taken_slope, (up.taken - down.taken) / 2e-5, 1e-9) << x;
  }
}

TEST(RelaxingStress, WithoutTermsItIsTheElasticOne) {
  for (const Strained& strained : states_of_all_tests) {
    CurveData data;
    for (int k = 1; k <= 4; ++k) data.points.push_back(timed({strained.deformation, 1 + 0.1 * k, 1 + 0.05 * k}, k));
    const Eigen::VectorXd stress = stress_of(data, {relaxing_gel.instantaneous});
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(stress[static_cast<Eigen::Index>(i)],
                  nominal_stress(relaxing_gel.instantaneous, data.points[i].strained), 1e-11 * 20e3);
  }
}

TEST(RelaxingStress, AnInstantRampIsTheInstantaneousLawAndAHoldTheShareThatIsLeft) {
  for (const Strained& strained : states_of_all_tests) {
    const bool shear = strained.deformation == Deformation::simple_shear;
    CurveData data;
    data.points = {timed({strained.deformation, shear ? 0.0 : 1.0, 1}, 3), timed(strained, 3), timed(strained, 3.8),
                   timed(strained, 40), timed(strained, 1e5)};
    const Eigen::VectorXd stress = stress_of(data, relaxing_gel);
    const double elastic = nominal_stress(relaxing_gel.instantaneous, strained), rounding = 1e-12 * std::abs(elastic);
    EXPECT_NEAR(stress[1], elastic, rounding);
    EXPECT_NEAR(stress[2], share_left(relaxing_gel.series, 0.8) * elastic, rounding);
    EXPECT_NEAR(stress[3], share_left(relaxing_gel.series, 37) * elastic, rounding);
    EXPECT_NEAR(stress[4], lasting_share(relaxing_gel.series) * elastic, rounding);
  }
}

// The integral of the second Piola stress itself, by the midpoint rule over 200,000 slices of a ramp.
double by_quadrature(double rate, double end, const RelaxingSolid& solid) {
  constexpr int slices = 200000;
  const auto isochoric = [&](double l) {
    const Ogden& term = solid.instantaneous.terms[0];
    const double along = std::pow(l, term.alpha), across = std::pow(l, -term.alpha / 2),
                 deviator = 2 * term.mu / term.alpha * (along - across);
    return std::pair{2.0 / 3 * deviator / (l * l), -1.0 / 3 * deviator * l};
  };
  const double whole = std::abs(end - 1) / rate;
  double along = 0, across = 0;
  auto before = isochoric(1);
  for (int k = 0; k < slices; ++k) {
    const auto now = isochoric(1 + (end - 1) * (k + 1.0) / slices);
    const double left = share_left(solid.series, whole * (1 - (k + 0.5) / slices));
    along += left * (now.first - before.first);
    across += left * (now.second - before.second);
    before = now;
  }
  return end * along - across / (end * end);
}

double at_the_end_of_a_ramp(int rows, double rate, double end) {
  CurveData data;
  add_test(data, {.rate = rate, .stretch = end, .ramp_rows = rows, .hold_rows = 0});
  return stress_of(data, relaxing_gel)[rows];
}

TEST(RelaxingStress, ItIsTheHereditaryIntegralToSecondOrderInTheRows) {
  for (const auto& [rate, end] : {std::pair{0.1, 0.6}, {0.5, 1.6}, {0.01, 1.3}}) {
    const double exact = by_quadrature(rate, end, relaxing_gel);
    const double coarse = std::abs(at_the_end_of_a_ramp(20, rate, end) - exact),
                 fine = std::abs(at_the_end_of_a_ramp(160, rate, end) - exact);
    EXPECT_LT(coarse, 3e-3 * std::abs(exact));
    EXPECT_NEAR(std::log(coarse / fine) / std::log(8), 2, 0.15);
  }
}

TEST(Histories, ATimeThatRunsBackBeginsAnother) {
  CurveData data;
  add_test(data, {.rate = 1});
  add_test(data, {.rate = 0.1});
  const auto histories = histories_of(data);
  ASSERT_EQ(histories.size(), 2u);
  EXPECT_EQ(histories[1].begin, 51u);
  EXPECT_EQ(histories[1].end, 102u);
  EXPECT_EQ(histories[0].from_rest, FromRest::at_rest);
}

TEST(Histories, AFirstRowThatIsStrainedWasReachedAtItsRateOrAtOnce) {
  CurveData data;
  data.points = {timed({Deformation::uniaxial, 0.9}, 5), timed({Deformation::uniaxial, 0.8}, 7)};
  EXPECT_NEAR(histories_of(data)[0].start, 3, 1e-12);
  EXPECT_THAT(starts_in_words(data, histories_of(data))[0], HasSubstr("reached from rest in 2 s"));
  data.points[1].strained.amount = 0.9;
  EXPECT_EQ(histories_of(data)[0].start, 5);
  EXPECT_THAT(starts_in_words(data, histories_of(data))[0], HasSubstr("at once"));
  data.points.pop_back();
  EXPECT_THROW(histories_of(data), BadInput);
}

TEST(Histories, LongLogsAreAveragedInTimeAndNotOverTheirStretch) {
  CurveData data;
  data.sources.push_back({.file = "long.csv", .x = "", .y = ""});
  add_test(data, {.rate = 0.1, .ramp_rows = 5000, .hold_rows = 5000});
  thin(data);
  EXPECT_GT(data.points.size(), 1600u);  // six rows a point
  EXPECT_LE(data.points.size(), 2010u);
  EXPECT_EQ(histories_of(data).size(), 1u);
  int rows = 0, held = 0;
  for (const StressPoint& point : data.points) rows += point.rows, held += point.strained.amount == 0.7;
  EXPECT_EQ(rows, 10001);
  EXPECT_GT(held, 800);
  EXPECT_THAT(data.sources[0].warnings[0], HasSubstr("10001 rows are averaged"));
}

}  // namespace
}  // namespace percal
