// The curve of a card, and its table.
#include "percal/card/card_curve.hpp"

#include <gmock/gmock.h>

#include "card/card_test.hpp"

namespace percal {
namespace {

using card_test::lines_of;
using card_test::skin;
using ::testing::HasSubstr;

// Uniaxial at 1.5: (2 mu/alpha) (1.5^(alpha - 1) - 1.5^(-alpha/2 - 1)) with mu 63.75 MPa and alpha 8.5.
TEST(CardCurve, IsTheClosedFormOfTheIncompressibleSolid) {
  const auto curve = card_curve(skin(), {Deformation::uniaxial, 0.5, 1.5, 3});
  ASSERT_EQ(curve.size(), 3u);
  EXPECT_EQ(curve[1].amount, 1);
  EXPECT_EQ(curve[1].stress, 0);
  EXPECT_NEAR(curve[2].stress, 15e6 * (std::pow(1.5, 7.5) - std::pow(1.5, -5.25)), 1);
}

TEST(CardCurve, AddsUpTheTerms) {
  CardMaterial two = skin(), first = skin(), second = skin();
  two.terms = {{60e6, 8}, {3.75e6, -2}};
  first.terms = {two.terms[0]};
  second.terms = {two.terms[1]};
  const CurveRange range{Deformation::equibiaxial, 0.7, 1.4, 5};
  const auto sum = card_curve(two, range), a = card_curve(first, range), b = card_curve(second, range);
  for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(sum[i].stress, a[i].stress + b[i].stress, 1e-6);
}

TEST(CardCurve, RefusesARangeThatIsNone) {
  EXPECT_THROW(card_curve(skin(), {Deformation::uniaxial, 2, 0.5, 3}), BadInput);
  EXPECT_THROW(card_curve(skin(), {Deformation::uniaxial, 0, 2, 3}), BadInput);
  EXPECT_THROW(card_curve(skin(), {Deformation::uniaxial, 0.5, 2, 1}), BadInput);
  EXPECT_NO_THROW(card_curve(skin(), {Deformation::simple_shear, 0, 1, 3}));
}

TEST(CsvCard, HasTheUnitInItsHeaderAndEveryRowItsMode) {
  const std::string card = csv_card(skin(), unit_system("mm-t-s-MPa"), {Deformation::planar, 1, 2, 2});
  EXPECT_THAT(card, HasSubstr("\nmode,stretch,nominal_stress [MPa]\nplanar,1,0\nplanar,2,"));
  for (const auto& line : lines_of(card)) EXPECT_TRUE(line.starts_with("#") || line.find(',') != std::string::npos);
}

}  // namespace
}  // namespace percal
