#include "percal/material/plausible.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace percal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Plausible, AModulusThatNoSoftSolidHasIsSaid) {
  EXPECT_THAT(implausible_modulus(3), ElementsAre(HasSubstr("softer")));
  EXPECT_THAT(implausible_modulus(2e10), ElementsAre(HasSubstr("stiffer")));
  for (const double mu : {10.0, 50e3, 10e9}) EXPECT_THAT(implausible_modulus(mu), IsEmpty());
}

// Tonnes read as kilograms and the reverse are a factor of 1000 off.
TEST(Plausible, ADensityThatNoSolidHasIsSaid) {
  for (const double density : {1e15, 1e6, 1.0})
    EXPECT_THAT(implausible_density(density), ElementsAre(HasSubstr("no density")));
  for (const double density : {20.0, 1000.0, 19300.0, std::nan("")})
    EXPECT_THAT(implausible_density(density), IsEmpty());
}

}  // namespace
}  // namespace percal
