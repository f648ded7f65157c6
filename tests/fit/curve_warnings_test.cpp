#include "percal/fit/read/curve_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "percal/fit/read/read_curves.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CurveData read(const std::string& text, const std::string& mode = "") {
  return curves_of(parse_csv(text, "c.csv"), {.mode = mode});
}

std::vector<std::string> warnings(const std::string& text, const std::string& mode = "") {
  return read(text, mode).sources.at(0).warnings;
}

void expect_compressed(const CurveData& data) {
  ASSERT_EQ(data.points.size(), 2u);
  EXPECT_DOUBLE_EQ(data.points[0].strained.amount, 0.97);
  EXPECT_DOUBLE_EQ(data.points[1].strained.amount, 0.70);
  EXPECT_DOUBLE_EQ(data.points[1].nominal_stress, -64311.29738);
}

TEST(CurveWarnings, CompressionWrittenWithPositiveNumbersIsTurnedAndSaid) {
  const std::string rows = "\n0.03,4.57524204\n0.30,64.31129738\n";
  for (const auto& [header, mode] : {std::pair{"Compressive strain (mm/mm),Compressive stress (kPa)", "compression"},
                                     {"strain,stress_kPa", "compression"},
                                     {"Compressive strain (mm/mm),Compressive stress (kPa)", "uniaxial"}}) {
    const CurveData data = read(header + rows, mode);
    expect_compressed(data);
    EXPECT_THAT(data.sources[0].warnings, ElementsAre(AllOf(HasSubstr("c.csv: compression"), HasSubstr("turned"))));
  }
  expect_compressed(read("mode,strain,stress_kPa\ncompression,0.03,4.57524204\ncompression,0.30,64.31129738\n"));
  EXPECT_EQ(read("strain,stress_kPa" + rows, "uniaxial").points[1].strained.amount, 1.3);
}

TEST(CurveWarnings, OnlyThePositiveOneOfTheTwoIsTurned) {
  expect_compressed(read("stretch,stress_kPa\n0.97,4.57524204\n0.70,64.31129738\n", "compression"));
  expect_compressed(read("strain,stress_kPa\n0.03,-4.57524204\n0.30,-64.31129738\n", "compression"));
  const CurveData as_it_is = read("strain,stress_kPa\n-0.03,-4.57524204\n-0.30,-64.31129738\n", "compression");
  expect_compressed(as_it_is);
  EXPECT_THAT(as_it_is.sources[0].warnings, IsEmpty());
}

TEST(CurveWarnings, CompressionWithStretchesAboveOneIsRefused) {
  EXPECT_THAT(
      [] { read("stretch,stress_kPa\n1.1,3\n1.3,9\n", "compression"); },
      testing::ThrowsMessage<BadInput>(HasSubstr("c.csv:1: stretch: found compression, but stretches above 1")));
}

TEST(CurveWarnings, StrainsThatLookLikePercentAreSaid) {
  const std::string rows = "\n5,7.34\n10,14.49\n20,28.73\n";
  EXPECT_THAT(warnings("strain,stress_kPa" + rows, "UT"), ElementsAre(AllOf(HasSubstr("20"), HasSubstr("strain [%]"))));
  EXPECT_THAT(warnings("strain [%],stress_kPa" + rows, "UT"), IsEmpty());
  EXPECT_THAT(warnings("strain,stress_kPa\n0.5,7\n1,9\n", "UT"), IsEmpty());
  EXPECT_THAT(warnings("stretch,stress_kPa\n105,7\n120,9\n", "UT"), ElementsAre(HasSubstr("stretch [%]")));
}

TEST(CurveWarnings, StressAgainstTheStretchIsSaid) {
  EXPECT_THAT(warnings("stretch,stress_kPa\n0.9,3\n0.8,7\n1.2,-1\n1.3,5\n", "UT"),
              ElementsAre(HasSubstr("2 of 4 points have a stretch below 1 and a positive stress"),
                          HasSubstr("1 of 4 points have a stretch above 1 and a negative stress")));
  EXPECT_THAT(warnings("stretch,stress_kPa\n0.999,0.001\n0.8,-7\n1.3,5\n", "UT"), IsEmpty());  // noise about zero
}

}  // namespace
}  // namespace percal
