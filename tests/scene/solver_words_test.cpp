#include "percal/scene/solver_words.hpp"

#include <gmock/gmock.h>

namespace percal {
namespace {

using ::testing::HasSubstr;

TEST(SolverWords, SayBulkViscosityAndHourglass) {
  SolverScene solver{.linear_viscosity = 0.06, .quadratic_viscosity = 1.2};
  solver.hourglass = 0.5;
  EXPECT_EQ(in_words(solver), "bulk viscosity 0.06 (linear) and 1.2 (quadratic), hourglass stiffness of 0.5 mu");
  solver.hourglass_form = HourglassForm::viscosity;
  EXPECT_THAT(in_words(solver), HasSubstr("hourglass viscosity of 0.5 of the wave impedance"));
}

}  // namespace
}  // namespace percal
