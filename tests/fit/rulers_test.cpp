#include "percal/fit/interval/rulers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "percal/fit/read/read_curves.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// mu 50 kPa, alpha 4; the first points, to stretch `slack`, carry next to nothing, of the wrong sign.
CurveData with_slack(double slack) {
  CurveData data;
  for (int i = 0; i < 50; ++i) {
    const Strained strained{Deformation::uniaxial, 1 + 0.02 * i};
    const double stress = nominal_stress(Ogden{50e3, 4}, strained);
    data.points.push_back({strained, strained.amount <= slack ? -400 + 7000 * (strained.amount - 1) : stress});
  }
  return data;
}

TEST(Rulers, AFitThatFollowsItsCurveHasNone) {
  const CurveData data = with_slack(0);
  EXPECT_THAT(rulers(data, fit_curves(data, {})), IsEmpty());
}

TEST(Rulers, FewPointsOfSmallStressThatRuleRelativeResidualsAreNamed) {
  const CurveData data = with_slack(1.061);
  const auto fit = fit_curves(data, {});
  ASSERT_LT(fit.minima.at(0).r2.value(), 0.1);  // 0.3 kPa where 50 are true
  EXPECT_THAT(rulers(data, fit), ElementsAre(AllOf(HasSubstr("the fit misses the curve"),
                                                   HasSubstr("of 50 points rule it, at stretches 1.0"),
                                                   HasSubstr("--residual absolute gives mu 4"), HasSubstr("--where"))));
  EXPECT_THAT(rulers(data, fit_curves(data, {.residual = Residual::absolute})), IsEmpty());
}

}  // namespace
}  // namespace percal
