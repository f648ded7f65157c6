#include "percal/fit/read/curve_measures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "percal/fit/read/read_curves.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// One point of a uniaxial test; x and y are headers.
StressPoint point_of(const std::string& x, const std::string& y, double strain, double stress,
                     const std::string& mode = "UT") {
  const std::string row = std::to_string(strain) + ";" + std::to_string(stress);
  return curves_of(parse_csv(x + ";" + y + "\n" + row + "\n", "c.csv"), {.mode = mode}).points.at(0);
}

std::string refusal_of(const std::string& x, const std::string& y, const std::string& mode = "UT") {
  try {
    point_of(x, y, 0.25, 8, mode);
  } catch (const BadInput& error) {
    return error.what();
  }
  ADD_FAILURE() << x << "; " << y << " was not refused";
  return "";
}

TEST(CurveMeasures, EveryStressOfTheFieldBecomesNominal) {
  // lambda 2: nominal 8, Cauchy and Kirchhoff 16 = 8 * 2, second Piola-Kirchhoff 4 = 8/2.
  for (const std::string y :
       {"stress_kPa", "Nominal stress (kPa)", "engineering stress [kPa]", "First Piola-Kirchhoff stress (kPa)",
        "1st Piola Kirchoff stress (kPa)", "PK1 (kPa)", "Biot stress (kPa)", "lagrangian_stress_kPa"})
    EXPECT_DOUBLE_EQ(point_of("stretch", y, 2, 8).nominal_stress, 8000) << y;
  for (const std::string y : {"cauchy_xx_kPa", "True stress, kPa", "TrueStress [kPa]", "Kirchhoff stress (kPa)"})
    EXPECT_DOUBLE_EQ(point_of("stretch", y, 2, 16).nominal_stress, 8000) << y;
  for (const std::string y :
       {"Second Piola-Kirchhoff stress (kPa)", "2nd Piola-Kirchhoff (kPa)", "PK2 stress/kPa", "2PK stress kPa"})
    EXPECT_DOUBLE_EQ(point_of("stretch", y, 2, 4).nominal_stress, 8000) << y;
}

TEST(CurveMeasures, EveryStrainOfTheFieldBecomesAStretch) {
  const auto stretch = [](const std::string& x, double strain) {
    return point_of(x, "stress_kPa", strain, 1).strained.amount;
  };
  for (const std::string x :
       {"strain", "Engineering strain [-]", "nominal strain (mm/mm)", "infinitesimal strain", "Biot strain"})
    EXPECT_DOUBLE_EQ(stretch(x, 0.25), 1.25) << x;
  for (const std::string x :
       {"natural strain", "Hencky strain", "log_strain", "logarithmic strain [mm/mm]", "LnStrain", "true_strain"})
    EXPECT_DOUBLE_EQ(stretch(x, 0.25), std::exp(0.25)) << x;
  for (const std::string x : {"Green strain", "Green-Lagrange strain", "lagrangian_strain", "Green-St. Venant strain"})
    EXPECT_DOUBLE_EQ(stretch(x, 1.5), 2) << x;  // (2^2 - 1)/2
  for (const std::string x : {"Almansi strain", "Euler-Almansi strain", "eulerian strain"})
    EXPECT_DOUBLE_EQ(stretch(x, 0.375), 2) << x;  // (1 - 2^-2)/2
  EXPECT_DOUBLE_EQ(point_of("engineering shear strain", "stress_kPa", 0.25, 1, "SS").strained.amount, 0.25);
}

TEST(CurveMeasures, PercentIsUnderstoodWhereverMachinesWriteIt) {
  for (const std::string x : {"Strain %", "% strain", "strain in %", "Strain/%", "Strain, percent", "strainPercent",
                              "Strain (perc)", "strain_pct", "strain [%]", "Percent strain", "strain per cent",
                              "Tensile strain (Percentage)", "Strain% axial"})
    EXPECT_DOUBLE_EQ(point_of(x, "stress_kPa", 25, 1).strained.amount, 1.25) << x;
  EXPECT_DOUBLE_EQ(point_of("strain [microstrain]", "stress_kPa", 250000, 1).strained.amount, 1.25);
  EXPECT_DOUBLE_EQ(point_of("strain (um/m)", "stress_kPa", 250000, 1).strained.amount, 1.25);
  EXPECT_DOUBLE_EQ(point_of("stretch ratio [--]", "stress_kPa", 1.25, 1).strained.amount, 1.25);
}

TEST(CurveMeasures, AWordThatIsNotKnownIsRefusedByName) {
  for (const std::string x : {"Swainger strain", "plastic strain", "tensor shear strain", "strain (foo)", "E strain"})
    EXPECT_THAT(refusal_of(x, "stress_kPa"),
                AllOf(HasSubstr("c.csv:1: " + x), HasSubstr("the word"), HasSubstr("hencky")));
  for (const std::string y :
       {"Mises stress (kPa)", "Piola-Kirchhoff stress (kPa)", "S stress (kPa)", "corotational_stress_kPa"})
    EXPECT_THAT(refusal_of("stretch", y),
                AllOf(HasSubstr("c.csv:1: " + y), HasSubstr("the word"), HasSubstr("second piola")));
  EXPECT_THAT(refusal_of("shear strain [deg]", "stress_kPa", "SS"), HasSubstr("the unit \"deg\""));
  EXPECT_THAT(refusal_of("strain [wt%]", "stress_kPa"), HasSubstr("the unit \"wt%\""));
  EXPECT_THAT(refusal_of("strain [foo]", "stress_kPa"), HasSubstr("foo"));
  EXPECT_THAT(refusal_of("strain", "true nominal stress (kPa)"), HasSubstr("two measures"));
  EXPECT_THAT(refusal_of("% strain [-]", "stress_kPa"), HasSubstr("two units"));
  EXPECT_THAT(refusal_of("true stretch", "stress_kPa"), HasSubstr("a measure of strain"));
  EXPECT_THAT(refusal_of("gamma", "PK2 stress (kPa)", "SS"), HasSubstr("normal stress"));
}

// The documentation lists what the reader knows.
TEST(CurveMeasures, ThePageOfTheFormatHasEveryPhrase) {
  const std::string page = read_file(PERCAL_DATA "/../docs/formats/csv.md");
  for (const auto& phrases : {stress_phrases(), strain_phrases()})
    for (const auto& [words, measure] : phrases) {
      EXPECT_THAT(page, HasSubstr(words));
      EXPECT_THAT(page, HasSubstr(measure));
    }
}

}  // namespace
}  // namespace percal
