// Doses against closed forms: a lognormal powder and depths that go as powers of its numbers.
#include "percal/powder/dose.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "percal/math/draws.hpp"
#include "powder/power_law.hpp"

namespace percal {
namespace {

using test::closed_form;
using test::lognormal_powder;
using test::PowerLaw;

constexpr double deep = 1;  // m: nothing passes
constexpr double close = 1e-4;

DoseQuestion question_of(std::vector<double> ends, Bounce bounce = NoBounce{}, double layer_depth = deep) {
  return {.bounce = bounce, .layer_depth = layer_depth, .ends = std::move(ends)};
}

double sum_of(const DoseShares& shares) {
  double sum = shares.bounced.best + shares.deeper.best + shares.passed.best;
  for (const DoseEstimate& layer : shares.layers) sum += layer.best;
  return sum;
}

TEST(Dose, LognormalInIsLognormalOut) {
  const PowerLaw law;
  for (const double scatter : {0.0, 0.2})
    for (const Powder& powder : {lognormal_powder(), lognormal_powder(0.5, 0, 0), lognormal_powder(0, 0, 0.3)}) {
      const Dose dose = dose_of(powder, law.model(scatter), question_of({10e-6, 30e-6}));
      for (const By by : {By::number, By::mass}) {
        const auto truth = closed_form(law, powder, by, scatter);
        const DoseShares& shares = by == By::mass ? dose.mass_shares : dose.number_shares;
        const DoseDepths& depths = by == By::mass ? dose.mass_depths : dose.number_depths;
        EXPECT_NEAR(shares.layers[0].best, truth.share_above(10e-6), close);
        EXPECT_NEAR(shares.layers[1].best, truth.share_above(30e-6) - truth.share_above(10e-6), close);
        EXPECT_NEAR(depths.mean.best / truth.mean_depth(), 1, 5 * close);
        EXPECT_NEAR(depths.deviation.best / truth.deviation_of_depth(), 1, 2e-3);  // its tail is all of it
        EXPECT_NEAR(depths.median.best / std::exp(truth.mean), 1, 5 * close);
        EXPECT_NEAR(sum_of(shares), 1, 1e-9);
      }
      EXPECT_LT(dose.integration_error, 1e-3);
    }
}

TEST(Dose, TheCurveIsTheShareAboveEachDepth) {
  const PowerLaw law;
  const Powder powder = lognormal_powder();
  const Dose dose = dose_of(powder, law.model(0.1), question_of({}));
  ASSERT_GT(dose.curve.size(), 20u);
  for (const DosePoint& point : dose.curve) {
    if (point.depth == 0) continue;
    EXPECT_NEAR(point.mass.best, closed_form(law, powder, By::mass, 0.1).share_above(point.depth), close);
    EXPECT_NEAR(point.number.best, closed_form(law, powder, By::number, 0.1).share_above(point.depth), close);
  }
  EXPECT_GT(dose.curve.back().mass.best, 0.99);
}

TEST(Dose, WhatIsBelowTheBreachBounces) {
  const PowerLaw law;
  const Powder powder = lognormal_powder();
  const double breach = 4;  // the middle has 6
  const Dose dose = dose_of(powder, law.model(), question_of({}, Breach{breach}));
  const double spread = std::hypot(0.5, 0.1, 0.2), below = std::log(breach / 6);
  EXPECT_NEAR(dose.number_shares.bounced.best, test::normal_cdf(below / spread), 2 * close);
  EXPECT_NEAR(dose.mass_shares.bounced.best, test::normal_cdf((below - 3 * 0.25 - 0.01) / spread), 2 * close);
  EXPECT_NEAR(sum_of(dose.mass_shares), 1, 1e-9);
}

TEST(Dose, WhatIsNotCoveredBouncesByTheModel) {
  const PowerLaw law;  // depth over radius goes with density and speed alone
  const Dose dose = dose_of(lognormal_powder(0.3, 0, 0.4), law.model(), question_of({}, LeastDepth{15}));
  EXPECT_NEAR(dose.number_shares.bounced.best, test::normal_cdf(std::log(15.0 / 20) / (1.3 * 0.4)), 2 * close);
}

TEST(Dose, WhatGoesAsDeepAsTheLayerPasses) {
  const PowerLaw law;
  const Powder powder = lognormal_powder();
  const Dose dose = dose_of(powder, law.model(0.1), question_of({}, NoBounce{}, 30e-6));
  EXPECT_NEAR(dose.mass_shares.passed.best, 1 - closed_form(law, powder, By::mass, 0.1).share_above(30e-6), close);
  EXPECT_LT(dose.mass_depths.ninetieth.best, 30e-6);
  EXPECT_LT(dose.mass_depths.mean.best, closed_form(law, powder, By::mass, 0.1).mean_depth());
}

TEST(Dose, ParticlesOfOneKindEndWhereTheyMust) {
  const PowerLaw law;
  const Dose dose = dose_of(lognormal_powder(0, 0, 0), law.model(), question_of({19e-6, 21e-6}));
  EXPECT_NEAR(dose.mass_shares.layers[1].best, 1, 1e-9);
  EXPECT_NEAR(dose.mass_depths.mean.best, 20e-6, 1e-10);
}

TEST(Dose, ScatterOfSingleParticlesWidensTheDoseAndNotItsInterval) {
  const PowerLaw law{.offsets = {0, -0.1, 0.1}};
  const auto width = [](const DoseEstimate& estimate) { return estimate.high - estimate.low; };
  const Dose sharp = dose_of(lognormal_powder(), law.model(0), question_of({})),
             scattered = dose_of(lognormal_powder(), law.model(0.5), question_of({}));
  EXPECT_GT(scattered.number_depths.deviation.best, 1.3 * sharp.number_depths.deviation.best);
  EXPECT_NEAR(width(scattered.number_depths.median) / width(sharp.number_depths.median), 1, 0.02);
  const Dose unsure = dose_of(lognormal_powder(), law.model(0, 0.2), question_of({}));
  EXPECT_GT(width(unsure.number_depths.median), 1.5 * width(sharp.number_depths.median));
  EXPECT_NEAR(unsure.number_depths.deviation.best, sharp.number_depths.deviation.best, 1e-12);
}

TEST(Dose, EachSourceAloneSpreadsAsInClosedForm) {
  const PowerLaw law;
  const Powder powder = lognormal_powder();
  const auto sources = spread_by_source(powder, law.model(0.2), question_of({}));
  ASSERT_EQ(sources.size(), 5u);
  for (const SpreadSource& source : sources) {
    const auto of = [&](const char* name) { return source.name == "all" || source.name == name; };
    const auto truth =
        closed_form(law, lognormal_powder(of("size") ? 0.5 : 0, of("density") ? 0.1 : 0, of("speed") ? 0.2 : 0),
                    By::number, of("scatter") ? 0.2 : 0);
    EXPECT_NEAR(source.deviation.best / truth.deviation_of_depth(), 1, 3e-3) << source.name;
  }
}

// A truth that a calibration has found with an error of its own: how often the interval of the mean depth has it.
TEST(Dose, ItsIntervalsHoldTheTruthAsOftenAsTheySay) {
  constexpr int trials = 200, points = 40;
  constexpr double parameters = 0.1, emulator = 0.05, scatter = 0.3;
  Draws random(7);
  const Powder powder = lognormal_powder(0.4, 0, 0);
  const auto classes = classes_of(powder, {.cells = 60, .values = 4});
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const double found = parameters * random.normal(), learnt = emulator * random.normal();  // the truth is 0
    PowerLaw law;
    law.offsets = {found + learnt};
    for (int k = 1; k < points; ++k) law.offsets.push_back(found + learnt + parameters * random.normal());
    const ForwardModel model = law.model(scatter, emulator);
    const DepthTable table(model, box_of(classes));
    const auto means =
        readings_of(classes, table, draws_of(model, table.points(), 200), NoBounce{}, [](const DepthDistribution& one) {
          return Eigen::VectorXd(Eigen::VectorXd::Constant(1, one.moments_above(By::number, deep).mean));
        });
    const DoseEstimate mean = estimate_of(means.col(0), 0.95);
    const double truth = closed_form(PowerLaw{}, powder, By::number, scatter).mean_depth();
    held += mean.low <= truth && truth <= mean.high;
  }
  EXPECT_GE(held, 0.90 * trials);
  EXPECT_LE(held, 0.99 * trials);
}

TEST(Dose, AnUnknownScatterIsDrawnFromWhatTellsIt) {
  ForwardModel model = PowerLaw{.offsets = {0, 0.1}}.model(0.2);
  model.freedom = 6;
  const auto draws = draws_of(model, 2, 1000);
  EXPECT_EQ(draws.front().scatter, 0.2);
  double mean = 0;  // of the precision: s^2/sigma^2 has chi-squared over its freedom
  for (const Draw& draw : draws) mean += 0.04 / (draw.scatter * draw.scatter) / static_cast<double>(draws.size());
  EXPECT_NEAR(mean, 1, 0.02);
}

}  // namespace
}  // namespace percal
