// What `percal fit --relaxation` takes for the stress of a test is what the solver's target does in it.   docs/theory/relaxation.md
#include <gtest/gtest.h>

#include "impact/specimen.hpp"
#include "percal/fit/relaxation/relaxing_curves.hpp"

namespace percal {
namespace {

// Planar tension to 1.4 in 2 time units and a hold of 3, at constant volume: nominal stress where the face across is free.
double of_the_solver(const Problem& problem, int steps) {
  StrainedTarget<> specimen(problem);
  specimen.look(0);
  double along = 1, across = 1;
  for (int n = 1; n <= steps; ++n) {
    const double time = 5.0 * n / steps;
    along = 1 + 0.4 * std::min(1.0, time / 2), across = 1 / along;
    specimen.stretch(across, along);
    specimen.look(5.0 / steps);
  }
  return specimen.stress_z() - across / along * specimen.stress_r();
}

double of_the_fit(const Problem& problem, int steps) {
  CurveData data;
  for (int n = 0; n <= steps; ++n) {
    const double time = 5.0 * n / steps;
    data.points.push_back(
        {.strained = {Deformation::planar, 1 + 0.4 * std::min(1.0, time / 2)}, .nominal_stress = 0, .time = time});
  }
  const RelaxingSolid solid{{{{problem.mu(), problem.alpha}}}, std::get<PronySeries>(problem.relaxation)};
  return relaxing_stress(relaxing_rows(data, histories_of(data)), solid)[steps];
}

TEST(RelaxationOfCurves, TheFitsStressIsTheSolversHomogeneousOne) {
  Problem problem = specimen_problem();
  problem.relaxation = PronySeries{{{0.3, 0.4}, {0.25, 3}}};
  const double exact = of_the_fit(problem, 20000);
  EXPECT_NEAR(of_the_solver(problem, 20000), exact, 1e-6 * exact);
  const double coarse = std::abs(of_the_solver(problem, 100) - exact),
               fine = std::abs(of_the_solver(problem, 400) - exact);
  EXPECT_LT(coarse, 1e-2 * exact);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4), 2, 0.2);
}

}  // namespace
}  // namespace percal
