#include "percal/card/lsdyna/lsdyna.hpp"

#include <gmock/gmock.h>

#include "card/card_test.hpp"
#include "percal/base/version.hpp"
#include "support/replaced.hpp"

namespace percal {
namespace {

using card_test::columns;
using card_test::line_under;
using card_test::lines_of;
using card_test::read_card;
using card_test::skin;
using test::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string general = "$      MID        RO        PR";
const std::string moduli = "$      MU1";
const std::string exponents = "$   ALPHA1";
const std::string limits = "$   MNPRES";

TEST(LsDynaCard, ConvertsTheModulusAndTheBulkModulus) {
  const std::string card = lsdyna_card(skin(), unit_system("mm-ms-kg-GPa"));
  EXPECT_EQ(columns(line_under(card, moduli, 1), 0), "0.015");  // MU1 = 15 MPa
  EXPECT_EQ(columns(line_under(card, exponents, 1), 0), "8.5");
  EXPECT_EQ(columns(line_under(card, general, 1), 1), "1.e-6");       // kg/mm3
  EXPECT_EQ(columns(line_under(card, general, 1), 2), ".490066225");  // nu = 148/302 for K = 50 mu
  EXPECT_EQ(columns(line_under(card, general, 1), 3), "0");           // N: constants follow
  EXPECT_EQ(columns(line_under(card, limits, 1), 3), "0.7");          // MXEPS
}

TEST(LsDynaCard, SaysWhereTheSolidIsStable) {
  std::string comments;
  for (const auto& line : lines_of(lsdyna_card(skin(), unit_system("si"))))
    if (line.starts_with('$')) comments += line.substr(1);
  EXPECT_THAT(comments, HasSubstr("Drucker-stable in uniaxial, equibiaxial and planar deformation"));
}

TEST(LsDynaCard, WritesTheKnownUnitSystems) {
  const auto mu1 = [](const std::string& units) {
    return columns(line_under(lsdyna_card(skin(), unit_system(units)), moduli, 1), 0);
  };
  EXPECT_EQ(mu1("si"), "1.5e7");
  EXPECT_EQ(mu1("mm-t-s-MPa"), "15.");
  EXPECT_EQ(mu1("um-us-ng-MPa"), "15.");
  const std::string tonnes = lsdyna_card(skin(), unit_system("mm-t-s-MPa"));
  EXPECT_EQ(columns(line_under(tonnes, general, 1), 1), "1.e-9");  // t/mm3
}

TEST(LsDynaCard, HasANegativeModulusForANegativeAlpha) {
  CardMaterial material = skin();
  material.terms[0].alpha = -8.5;
  const std::string card = lsdyna_card(material, unit_system("si"));
  EXPECT_EQ(columns(line_under(card, moduli, 1), 0), "-1.5e7");
  EXPECT_EQ(columns(line_under(card, exponents, 1), 0), "-8.5");
  EXPECT_DOUBLE_EQ(read_card("lsdyna", card, unit_system("si"), "card.k").terms[0].mu, 63.75e6);
}

TEST(LsDynaCard, FillsEightColumnsOfTenAndNoMoreThanEighty) {
  const std::string card = lsdyna_card(skin(), unit_system("mm-ms-kg-GPa"));
  int number_lines = 0;
  for (const auto& line : lines_of(card)) {
    EXPECT_LE(line.size(), 80u) << line;
    if (line.starts_with('$') || line.starts_with('*') || line == "skin") continue;
    EXPECT_EQ(line.size(), 80u) << line;
    ++number_lines;
  }
  EXPECT_EQ(number_lines, 5);
}

TEST(LsDynaCard, SaysItsUnitsItsModulusAndWhatItsErosionStrainIs) {
  const std::string card = lsdyna_card(skin(), unit_system("mm-ms-kg-GPa"));
  EXPECT_THAT(card, AllOf(HasSubstr("percal " + version()), HasSubstr("unit system: mm-ms-kg-GPa"),
                          HasSubstr("mu: 63750000 Pa"), HasSubstr("MU1 = 2 mu/alpha: 15000000 Pa = 0.015 GPa"),
                          HasSubstr("1000 kg/m3"), HasSubstr("0.490066225166"), HasSubstr("Guha 2009, Table 4-1")));
  // ln 1.7 = 0.530628, (1.7^2 - 1)/2 = 0.945
  EXPECT_THAT(card, AllOf(HasSubstr("strain measure of MXEPS: engineering"), HasSubstr("0.530628 true"),
                          HasSubstr("0.945"), HasSubstr("documented")));
}

TEST(LsDynaCard, HasNoErosionKeywordForAMaterialThatStays) {
  CardMaterial material = skin();
  material.erosion.reset();
  const std::string card = lsdyna_card(material, unit_system("si"));
  EXPECT_THAT(card, Not(HasSubstr("EROSION")));
  EXPECT_FALSE(read_card("lsdyna", card, unit_system("si"), "card.k").erosion);
}

TEST(LsDynaCard, ComesBackToTheLastDigitOfItsColumns) {
  CardMaterial material{.name = "odd",
                        .density = 1063.7351982,
                        .terms = {{123456.789123, -13.987654321}},
                        .bulk_modulus = 7654321.98765,
                        .erosion = CardErosion{0.123456789, StrainMeasure::green_lagrange},
                        .comments = {}};
  for (const char* name : {"si", "mm-t-s-MPa", "mm-ms-kg-GPa", "um-us-ng-MPa"}) {
    const UnitSystem units = unit_system(name);
    const std::string card = lsdyna_card(material, units);
    const CardMaterial back = read_card("lsdyna", card, units, "card.k");
    // ten columns hold at least five digits ("-1.2345e-5"); K comes from nu, 1 - 2 nu = 0.016 known to 1e-9
    EXPECT_NEAR(back.density / material.density, 1, 1e-5) << name;
    EXPECT_NEAR(back.terms[0].mu / material.terms[0].mu, 1, 5e-5) << name;
    EXPECT_NEAR(back.terms[0].alpha / material.terms[0].alpha, 1, 1e-7) << name;
    EXPECT_NEAR(back.bulk_modulus / back.terms[0].mu * material.terms[0].mu / material.bulk_modulus, 1, 1e-6) << name;
    ASSERT_TRUE(back.erosion) << name;
    EXPECT_NEAR(back.erosion->limit, material.erosion->limit, 1e-9) << name;
    EXPECT_EQ(back.erosion->measure, StrainMeasure::green_lagrange) << name;
    EXPECT_EQ(line_under(lsdyna_card(back, units), moduli, 1), line_under(card, moduli, 1)) << name;
  }
}

TEST(LsDynaCard, IsNotBrokenByOddNamesAndComments) {
  CardMaterial material = skin();
  material.name = "a\n*END\nstrain measure of MXEPS: true";
  material.comments = {"first\r\n*KEYWORD", std::string(200, 'x'), "", "$ strain measure of MXEPS: green-lagrange"};
  const std::string card = lsdyna_card(material, unit_system("si"));
  for (const auto& line : lines_of(card)) {
    EXPECT_TRUE(!line.starts_with('*') || line.starts_with("*MAT_")) << line;
  }
  EXPECT_EQ(read_card("lsdyna", card, unit_system("si"), "card.k").erosion->measure, StrainMeasure::engineering);
}

TEST(LsDynaCard, RefusesABulkModulusThatTwentyColumnsCannotTell) {
  CardMaterial material = skin();
  material.bulk_modulus = 1e9 * 63.75e6;
  EXPECT_NO_THROW(lsdyna_card(material, unit_system("si")));
  material.bulk_modulus = 1e15 * 63.75e6;  // PR would be 0.5
  EXPECT_THROW(lsdyna_card(material, unit_system("si")), BadInput);
}

TEST(LsDynaCard, RefusesAnExponentSoSmallThatItsModulusOverflows) {
  CardMaterial material = skin();
  material.terms[0].alpha = 1e-305;
  EXPECT_THROW(lsdyna_card(material, unit_system("si")), BadInput);
  material.terms[0].alpha = 0;
  EXPECT_THROW(lsdyna_card(material, unit_system("si")), BadInput);
}

std::string lsdyna_refusal(const std::string& card) {
  return card_test::reader_refusal("lsdyna", card, unit_system("si"), "card.k");
}

TEST(LsDynaReader, NamesFileLineAndFieldOfWhatItCannotRead) {
  const std::string card = lsdyna_card(skin(), unit_system("si"));
  EXPECT_THAT(lsdyna_refusal("*MAT_ELASTIC\n"), AllOf(HasSubstr("card.k"), HasSubstr("no Ogden material")));
  EXPECT_THAT(lsdyna_refusal(replaced(card, "     1.5e7", "     1.5q7")), AllOf(HasSubstr("MU1"), HasSubstr("1.5q7")));
  EXPECT_THAT(lsdyna_refusal(replaced(card, "1000..490066225", "1000.       0.5")), HasSubstr("PR"));
  EXPECT_THAT(lsdyna_refusal(replaced(card, "     1.5e7        0.", "     1.5e7        1.")), HasSubstr("ALPHA2"));
  EXPECT_THAT(lsdyna_refusal("*MAT_OGDEN_RUBBER\n         1     1000.\n"), HasSubstr("MU1 to MU8"));
  EXPECT_THAT(lsdyna_refusal(replaced(card, "     1.5e7        0.        0.", "     1.5e7        0.        1.")),
              HasSubstr("ALPHA3"));
}

TEST(LsDynaReader, TakesACardWithWindowsLineEnds) {
  std::string card;
  for (const auto& line : lines_of(lsdyna_card(skin(), unit_system("si")))) card += line + "\r\n";
  EXPECT_DOUBLE_EQ(read_card("lsdyna", card, unit_system("si"), "card.k").terms[0].mu, 63.75e6);
}

}  // namespace
}  // namespace percal
