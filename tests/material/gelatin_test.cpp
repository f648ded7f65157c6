#include "percal/material/gelatin.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/text/csv.hpp"

namespace percal {
namespace {

const std::string formulations = std::string(PERCAL_DATA) + "/guha2009/gelatin_formulations.csv";

struct Rows {
  std::vector<double> concentrations, quasi_static, high_rate;
};

Rows rows(const std::vector<std::string>& conditions) {
  auto table = read_csv(formulations).where(conditions);
  return {table.numbers("concentration", dimension::none), table.numbers("mu_quasistatic", dimension::pressure),
          table.numbers("mu_highrate", dimension::pressure)};
}

// Half a unit of the last digit that is quoted.
TEST(GelatinLaw, OfTheThreeMeasuredRowsHasTheKnownFactor) {
  auto measured = rows({"source_of_mu=curve"});
  ASSERT_EQ(measured.concentrations.size(), 3u);
  auto law = fit_gelatin_law(measured.concentrations, measured.quasi_static, 1.8, Misfit::absolute);
  EXPECT_NEAR(law.factor, 131.09, 0.005);
  EXPECT_NEAR(law.at(10), 8270, 5);
  EXPECT_NEAR(high_rate_modulus(law.at(10), 9.74), 80.6e3, 50);
}

TEST(GelatinLaw, OfOtherChoicesHasTheKnownFactors) {
  auto measured = rows({"source_of_mu=curve"}), all = rows({});
  ASSERT_EQ(all.concentrations.size(), 4u);
  EXPECT_NEAR(fit_gelatin_law(all.concentrations, all.quasi_static, 1.8, Misfit::absolute).factor, 132.6, 0.05);
  EXPECT_NEAR(fit_gelatin_law(measured.concentrations, measured.quasi_static, 1.8, Misfit::relative).factor, 125.4,
              0.05);
  auto free = fit_gelatin_law(measured.concentrations, measured.quasi_static, Misfit::absolute);
  EXPECT_EQ(free.outcome, FitOutcome::converged);
  EXPECT_NEAR(free.exponent, 1.94, 0.005);
  EXPECT_NEAR(free.factor, 95, 0.5);
}

TEST(RateFactor, OfTheMeasuredRowsIsTheTextsNumber) {
  auto measured = rows({"source_of_mu=curve"});
  auto rate = fit_rate_factor(measured.quasi_static, measured.high_rate);
  EXPECT_NEAR(rate.factor, 9.74, 0.005);
  EXPECT_NEAR(rate.deviation, 0.06, 0.01);
}

TEST(RateFactor, OfOneFormulationHasNoDeviationAndOfNoneIsRefused) {
  EXPECT_EQ(fit_rate_factor(std::vector{2.0}, std::vector{6.0}).factor, 3);
  EXPECT_EQ(fit_rate_factor(std::vector{2.0}, std::vector{6.0}).deviation, 0);
  EXPECT_THROW(fit_rate_factor({}, {}), BadInput);
  EXPECT_THROW(fit_rate_factor(std::vector{2.0}, std::vector{6.0, 7.0}), BadInput);
}

TEST(RateFactor, GoesThereAndBack) {
  EXPECT_DOUBLE_EQ(quasi_static_modulus(high_rate_modulus(3.77e3, 9.74), 9.74), 3.77e3);
}

TEST(YoungsModulus, OfTheIncompressibleSolidIsThreeTimesTheShearModulus) {
  EXPECT_EQ(youngs_modulus_incompressible(0.75e6), 2.25e6);
}

}  // namespace
}  // namespace percal
