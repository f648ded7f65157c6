#include "percal/fit/read/curve_shapes.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "percal/fit/read/read_curves.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Ogden elastic{.mu = 50e3, .alpha = 4};

struct Row {
  double strain, factor = 1, added = 0;  // stress = factor * (the elastic's + added), kPa
};

std::vector<std::string> warnings(const std::vector<Row>& rows, const std::string& mode = "UT") {
  std::string text = "strain,stress_kPa\n";
  for (const auto& [strain, factor, added] : rows)
    text += fmt::format("{:.6f},{:.6f}\n", strain,
                        factor * (nominal_stress(elastic, Strained{Deformation::uniaxial, 1 + strain}) / 1e3 + added));
  return curves_of(parse_csv(text, "c.csv"), {.mode = mode}).sources.at(0).warnings;
}

// `count` strains from low to high, low left out.
void ramp(std::vector<Row>& rows, double low, double high, int count, double factor = 1) {
  for (int i = 1; i <= count; ++i) rows.push_back({low + i * (high - low) / count, factor});
}

TEST(CurveShapes, APlainLoadingIsNotRemarkedOn) {
  std::vector<Row> rows{{0}};
  ramp(rows, 0, 1, 40);
  EXPECT_THAT(warnings(rows), IsEmpty());
  std::vector<Row> both;
  ramp(both, -0.4, 0.5, 45);
  EXPECT_THAT(warnings(both), IsEmpty());  // compression and tension in one go
  std::vector<Row> stiffening;
  for (int i = 0; i <= 30; ++i) stiffening.push_back({0.01 * i});
  EXPECT_THAT(warnings(stiffening), IsEmpty());
}

TEST(CurveShapes, CyclesAreCounted) {
  std::vector<Row> rows{{0}};
  for (const double peak : {0.5, 0.8}) ramp(rows, 0, peak, 20), ramp(rows, peak, 0, 20, 0.8);
  EXPECT_THAT(warnings(rows), ElementsAre(AllOf(HasSubstr("c.csv: uniaxial tension: the stretch runs back"),
                                                HasSubstr("4 branches, 2 of loading and 2 of unloading"))));
}

TEST(CurveShapes, CurvesOneBehindTheOtherAreCounted) {
  std::vector<Row> rows;
  for (int specimen = 0; specimen < 3; ++specimen) ramp(rows, 0, 0.6, 12, 1 + 0.1 * specimen);
  EXPECT_THAT(warnings(rows), ElementsAre(AllOf(HasSubstr("starts anew 2 times"), HasSubstr("3 curves in one file"))));
}

TEST(CurveShapes, AStressThatFallsAtAHeldStretchIsAHold) {
  std::vector<Row> rows;
  ramp(rows, 0, 0.3, 12);
  for (int i = 1; i <= 6; ++i) rows.push_back({0.3, 1 - 0.05 * i});
  ramp(rows, 0.3, 0.6, 12);
  EXPECT_THAT(warnings(rows),
              ElementsAre(AllOf(HasSubstr("1 hold:"), HasSubstr("the constant strain 0.300000 (lines 13 to 19)"))));
}

TEST(CurveShapes, APeakWithAFallingBranchIsNamedWithTheRowsToKeep) {
  std::vector<Row> rows;
  ramp(rows, 0, 0.5, 20);
  for (int i = 1; i <= 5; ++i) rows.push_back({0.5 + 0.02 * i, 1 - 0.15 * i});
  EXPECT_THAT(warnings(rows),
              ElementsAre(AllOf(HasSubstr("the stress peaks at strain 0.500000"), HasSubstr("falling branch"),
                                HasSubstr("--where \"strain<=0.500000\""))));
}

TEST(CurveShapes, AnOffsetIsStressAtStretchOne) {
  std::vector<Row> rows;
  for (int i = 0; i <= 30; ++i) rows.push_back({0.02 * i, 1, 8});
  EXPECT_THAT(warnings(rows), ElementsAre(AllOf(HasSubstr("an offset"), HasSubstr("8 kPa at stretch 1"))));
}

// As a machine writes it that pulls slack first.
TEST(CurveShapes, AToeIsSaidWithItsPoints) {
  std::vector<Row> rows{{0, 0, 0}, {0.02, 0.01}, {0.04, 0.01}, {0.06, 0.01}};
  for (int i = 4; i <= 50; ++i) rows.push_back({0.02 * i});
  EXPECT_THAT(warnings(rows),
              ElementsAre(AllOf(HasSubstr("a toe: the first points, to strain 0.060000"),
                                HasSubstr("--where \"strain>0.060000\""), HasSubstr("--residual absolute"))));
}

TEST(CurveShapes, TheNoiseOfARawLogIsNoToe) {
  std::vector<Row> rows;
  for (int i = 0; i < 5000; ++i) rows.push_back({0.0002 * i, 1, (i % 7 - 3) * 0.2});
  EXPECT_THAT(warnings(rows), ElementsAre(HasSubstr("5000 rows are averaged")));
}

TEST(CurveShapes, AColumnOfTextWithSeveralValuesIsNamed) {
  const std::string head = "material,strain,stress_kPa\n", soft = "soft,0.1,14\nsoft,0.2,29\n",
                    hard = "hard,0.1,30\nhard,0.2,60\n";
  const auto read = [](const std::string& text, const CurveColumns& columns) {
    return curves_of(parse_csv(text, "c.csv"), columns).sources.at(0).warnings;
  };
  EXPECT_THAT(read(head + soft + hard, {.mode = "UT"}),
              ElementsAre(AllOf(HasSubstr("column \"material\" has 2 values (\"hard\", \"soft\")"),
                                HasSubstr("--where \"material=hard\""))));
  EXPECT_THAT(read(head + soft + hard, {.mode = "UT", .where = {"material=soft"}}), IsEmpty());
  EXPECT_THAT(read("specimen,strain,stress_kPa\n1,0.1,14\n1,0.2,29\n2,0.1,30\n2,0.2,60\n", {.mode = "UT"}),
              ElementsAre(HasSubstr("column \"specimen\" has 2 values")));
  EXPECT_THAT(read("mode,strain,stress_kPa\nUT,0.1,14\nUT,0.2,29\nET,0.1,30\nET,0.2,60\n", {}), IsEmpty());
}

}  // namespace
}  // namespace percal
