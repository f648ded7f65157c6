#include "percal/card/unit_system.hpp"

#include <gmock/gmock.h>

#include "percal/base/error.hpp"

namespace percal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string units_refusal(const std::string& name) {
  try {
    unit_system(name);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(UnitSystem, KnowsTheCommonOnes) {
  EXPECT_DOUBLE_EQ(unit_system("si").density(), 1);
  EXPECT_DOUBLE_EQ(unit_system("si").stress, 1);
  EXPECT_DOUBLE_EQ(unit_system("mm-t-s-MPa").density(), 1e12);   // 1000 kg in a cubic millimetre
  EXPECT_DOUBLE_EQ(unit_system("mm-ms-kg-GPa").density(), 1e9);  // 1 kg in a cubic millimetre
  EXPECT_DOUBLE_EQ(unit_system("um-us-ng-MPa").density(), 1e6);  // 1e-12 kg in 1e-18 m3
  EXPECT_DOUBLE_EQ(unit_system("um-us-ng-MPa").stress, 1e6);
}

TEST(UnitSystem, TakesItsUnitsInAnyOrder) {
  EXPECT_DOUBLE_EQ(unit_system("GPa-kg-ms-mm").density(), unit_system("mm-ms-kg-GPa").density());
}

TEST(UnitSystem, RefusesAStressThatIsNotMassOverLengthTimeSquared) {
  EXPECT_THAT(units_refusal("mm-t-s-GPa"),
              AllOf(HasSubstr("units"), HasSubstr("GPa is 1e+09 Pa"), HasSubstr("1e+06 Pa")));
  EXPECT_NE(units_refusal("mm-s-kg-MPa"), "");  // kg/(mm s2) is a kilopascal
  EXPECT_EQ(units_refusal("mm-s-kg-kPa"), "");
}

TEST(UnitSystem, RefusesWhatIsMissingTwiceThereOrUnknown) {
  EXPECT_THAT(units_refusal("mm-ms-kg"), HasSubstr("mm-ms-kg-GPa"));
  EXPECT_THAT(units_refusal("mm-m-s-kg-Pa"), HasSubstr("both mm and m"));
  EXPECT_THAT(units_refusal("mm-t-s-furlong"), HasSubstr("furlong"));
  EXPECT_NE(units_refusal(""), "");
  EXPECT_NE(units_refusal("mm-t-s-MPa-m/s"), "");
}

}  // namespace
}  // namespace percal
