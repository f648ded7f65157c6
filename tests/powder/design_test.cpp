// Designs against closed forms: of a lognormal powder most is in a band whose middle is the median's depth.
#include "percal/powder/design.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "powder/power_law.hpp"

namespace percal {
namespace {

using test::closed_form;
using test::lognormal_powder;
using test::PowerLaw;

class DesignTest : public testing::Test {
 protected:
  DesignTest() {
    question_.bounce = NoBounce{};
    question_.layer_depth = 1;
    question_.band = DepthBand{20e-6, 45e-6};
    asked_.radius = {0.3e-6, 4e-6};
    asked_.speed = {200, 1500};
    asked_.map = 15;
  }
  Powder at(const PowderParticle& middle) const {
    return {Lognormal{middle.radius, 0.2}, Lognormal{middle.density, 0}, Lognormal{middle.speed, 0.1}};
  }
  // Of a powder with this middle particle.
  double dose_at(const PowderParticle& middle) const {
    const auto truth = closed_form(law_, at(middle), By::mass, scatter_);
    return truth.share_above(question_.band->to) - truth.share_above(question_.band->from);
  }
  PowderDesign found() const { return design_of(powder_, law_.model(scatter_), question_, asked_); }

  PowerLaw law_;
  double scatter_ = 0.1;
  Powder powder_ = lognormal_powder(0.2, 0, 0.1);
  DoseQuestion question_;
  DesignQuestion asked_;
};

TEST_F(DesignTest, TheBestIsTheAnalyticOptimum) {
  const PowderDesign design = found();
  ASSERT_TRUE(design.best);
  const auto truth = closed_form(law_, at(design.best->middle), By::mass, scatter_);
  EXPECT_NEAR(truth.mean, std::log(std::sqrt(20e-6 * 45e-6)), 0.01);
  const double most = 2 * test::normal_cdf(std::log(45.0 / 20) / 2 / truth.deviation) - 1;
  EXPECT_NEAR(design.best->shares.dose, most, 1e-3);
  EXPECT_NEAR(design.dose.best, most, 2e-4);
  // The line of best speeds is that of the optimum, at every radius that has one.
  for (const DesignPoint& point : design.line)
    if (point.middle.speed > 250 && point.middle.speed < 1200) {
      EXPECT_NEAR(closed_form(law_, at(point.middle), By::mass).mean, truth.mean, 0.02);
    }
}

TEST_F(DesignTest, TheMapIsTheDoseOfEachPowder) {
  for (const DesignPoint& point : found().map) EXPECT_NEAR(point.shares.dose, dose_at(point.middle), 1.5e-3);
}

TEST_F(DesignTest, ALimitMovesTheBestToItsEdge) {
  asked_.radius = {1e-6, 1.01e-6};
  question_.band = DepthBand{20e-6, 80e-6};
  asked_.limits.deeper_than = 60e-6;
  asked_.limits.deeper = 0.05;
  const PowderDesign design = found();
  ASSERT_TRUE(design.best);
  EXPECT_NEAR(design.best->shares.deeper, 0.05, 2e-3);
  EXPECT_LE(design.best->shares.deeper, 0.05 + 1e-6);
  // Without the limit it would be deeper.
  asked_.limits = {};
  EXPECT_GT(1 - closed_form(law_, at(found().best->middle), By::mass, scatter_).share_above(60e-6), 0.055);
  asked_.limits.most_impact = 5;
  const PowderDesign slow = found();
  EXPECT_NEAR(impact_parameter(slow.best->middle), 5, 0.05);
}

TEST_F(DesignTest, AModelIsKeptToWhatItHasSeen) {
  ForwardModel model = law_.model(scatter_);
  model.has_seen = [](const PowderParticle& particle) { return particle.radius < 1e-6; };
  asked_.limits.beyond = 0.1;
  const PowderDesign design = design_of(powder_, model, question_, asked_);
  ASSERT_TRUE(design.best);
  // The mass has 3 s^2 = 0.12 more in ln radius, and s = 0.2.
  const auto beyond = [](const PowderParticle& middle) {
    return test::normal_cdf((std::log(middle.radius / 1e-6) + 0.12) / 0.2);
  };
  EXPECT_NEAR(design.best->shares.beyond, beyond(design.best->middle), 0.04);  // by whole classes
  EXPECT_LT(beyond(design.best->middle), 0.15);
  for (const DesignPoint& point : design.map) EXPECT_EQ(point.allowed, point.shares.beyond <= 0.1);
}

TEST_F(DesignTest, NothingWithinTheLimitsIsSaid) {
  question_.bounce = Breach{7};
  asked_.limits.bounced = 0;
  asked_.limits.most_impact = 2;
  const PowderDesign design = found();
  EXPECT_FALSE(design.best);
  EXPECT_EQ(design.map.size(), 225u);
  EXPECT_TRUE(design.line.empty());
}

TEST_F(DesignTest, ToleranceEndsWhereTheDoseDoes) {
  const PowderDesign design = found();
  ASSERT_TRUE(design.best);
  const double best = dose_at(design.best->middle);
  const auto left = [&](double PowderParticle::*number, double value) {
    PowderParticle off = design.best->middle;
    off.*number = value;
    return dose_at(off) / best;
  };
  for (const auto& [number, tolerance] :
       {std::pair{&PowderParticle::speed, design.speed}, {&PowderParticle::radius, design.radius}}) {
    if (!tolerance.low_open) {
      EXPECT_NEAR(left(number, tolerance.low), 0.9, 5e-3);
    }
    if (!tolerance.high_open) {
      EXPECT_NEAR(left(number, tolerance.high), 0.9, 5e-3);
    }
  }
  EXPECT_FALSE(design.radius.low_open && design.radius.high_open);
  EXPECT_FALSE(design.speed.low_open && design.speed.high_open);
}

TEST_F(DesignTest, MoreSpreadLeavesLess) {
  const PowderDesign design = found();
  double before = 1;
  int sizes = 0;
  for (const OtherSpread& one : design.spreads)
    if (one.of == "size") {
      EXPECT_LT(one.dose, before + 1e-4);
      before = one.dose;
      ++sizes;
    }
  EXPECT_EQ(sizes, 5);
  EXPECT_NEAR(design.spreads[2].dose, design.best->shares.dose, 1e-3);  // as the powder is
}

TEST_F(DesignTest, UncertainParametersMakeAnIntervalOfTheBestSpeed) {
  law_.offsets = {0};
  for (int k = -10; k <= 10; ++k) law_.offsets.push_back(0.02 * k);
  const PowderDesign design = found();
  ASSERT_TRUE(design.best);
  // The best speed goes as exp(-offset/1.3).
  EXPECT_NEAR(std::log(design.best_speed.high / design.best_speed.low), 0.4 / 1.3, 0.06);
  EXPECT_LT(design.dose.low, design.dose.best);
}

TEST_F(DesignTest, ADenserParticleMayBeSmaller) {
  asked_.densities = {1e4, 2e4};
  asked_.speed = {600, 602};
  const PowderDesign design = found();
  ASSERT_EQ(design.by_density.size(), 2u);
  EXPECT_NEAR(design.by_density[0].middle.radius / design.by_density[1].middle.radius, std::pow(2, 0.7),
              0.05);  // the optimum is flat
}

}  // namespace
}  // namespace percal
