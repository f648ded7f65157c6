#include "percal/card/abaqus/abaqus.hpp"

#include <gmock/gmock.h>

#include "card/card_test.hpp"

namespace percal {
namespace {

using card_test::line_under;
using card_test::lines_of;
using card_test::read_card;
using card_test::skin;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(AbaqusCard, CarriesTheTrueModulusAndTwoOverK) {
  const std::string card = abaqus_card(skin(), unit_system("mm-t-s-MPa"));
  // K = 50 * 63.75 = 3187.5 MPa; 2/K = 6.274509803921568627e-4 per MPa
  EXPECT_EQ(line_under(card, "*HYPERELASTIC, OGDEN, N=1", 1), "63.75, 8.5, 0.000627450980392157");
  EXPECT_EQ(line_under(card, "*DENSITY", 1), "1.e-9");
  EXPECT_EQ(line_under(card, "*MATERIAL", 0), "*MATERIAL, NAME=skin");
}

TEST(AbaqusCard, KeepsTheModulusPositiveForANegativeAlpha) {
  CardMaterial material = skin();
  material.terms[0].alpha = -4;
  EXPECT_TRUE(line_under(abaqus_card(material, unit_system("si")), "*HYPERELASTIC", 1).starts_with("63750000., -4., "));
}

TEST(AbaqusCard, SaysThatItHasNoErosionAndWhereElementsShouldGo) {
  const std::string card = abaqus_card(skin(), unit_system("si"));
  EXPECT_THAT(card, AllOf(HasSubstr("no erosion in this card"), HasSubstr("0.7 engineering"), HasSubstr("stretch 1.7"),
                          HasSubstr("unit system: si"), HasSubstr("Guha 2009, Table 4-1")));
}

TEST(AbaqusCard, HasFieldsOfAtMostTwentyCharactersAndComesBack) {
  CardMaterial material = skin();
  material.terms[0].mu = 1e8 / 3;
  material.terms[0].alpha = -20.0 / 7;
  material.bulk_modulus = 1e10 / 7;
  material.density = 1e4 / 9;
  for (const char* name : {"si", "mm-t-s-MPa", "mm-ms-kg-GPa", "um-us-ng-MPa"}) {
    const UnitSystem units = unit_system(name);
    const std::string card = abaqus_card(material, units);
    std::string field;
    for (char letter : line_under(card, "*HYPERELASTIC", 1) + ",") {
      if (letter != ',') {
        field += letter;
        continue;
      }
      EXPECT_LE(field.size() - (field.starts_with(' ') ? 1 : 0), 20u) << field;
      field.clear();
    }
    const CardMaterial back = read_card("abaqus", card, units, "card.inp");
    // twenty characters hold at least fifteen digits of these numbers
    EXPECT_NEAR(back.terms[0].mu / material.terms[0].mu, 1, 3e-14) << name;
    EXPECT_NEAR(back.terms[0].alpha / material.terms[0].alpha, 1, 3e-14) << name;
    EXPECT_NEAR(back.bulk_modulus / material.bulk_modulus, 1, 3e-14) << name;
    EXPECT_NEAR(back.density / material.density, 1, 3e-14) << name;
    EXPECT_FALSE(back.erosion) << name;
  }
}

TEST(AbaqusCard, MakesANameThatBothProgramsTake) {
  const auto name = [](const std::string& text) {
    CardMaterial material = skin();
    material.name = text;
    return line_under(abaqus_card(material, unit_system("si")), "*MATERIAL", 0);
  };
  EXPECT_EQ(name("3 mm gel, 12 %"), "*MATERIAL, NAME=M3_mm_gel__12__");
  EXPECT_EQ(name("a\n*END STEP"), "*MATERIAL, NAME=a__END_STEP");
  EXPECT_EQ(name("M\xC3\xBCller"), "*MATERIAL, NAME=M_ller");
  EXPECT_EQ(name(""), "*MATERIAL, NAME=M");
  EXPECT_EQ(name(std::string(200, 'x')), "*MATERIAL, NAME=" + std::string(80, 'x'));
}

TEST(AbaqusCard, IsNotBrokenByOddComments) {
  CardMaterial material = skin();
  material.comments = {"one\n*INCLUDE, INPUT=x\r\n", std::string(500, '*'), "\xFF\xFE"};
  int keywords = 0;
  for (const auto& line : lines_of(abaqus_card(material, unit_system("si")))) {
    EXPECT_LE(line.size(), 80u) << line;
    if (line.starts_with('*') && !line.starts_with("**")) ++keywords;
  }
  EXPECT_EQ(keywords, 3);
}

std::string abaqus_refusal(const std::string& card) {
  return card_test::reader_refusal("abaqus", card, unit_system("si"), "card.inp");
}

TEST(AbaqusReader, NamesFileLineAndFieldOfWhatItCannotRead) {
  const std::string start = "*MATERIAL, NAME=X\n*DENSITY\n1000.\n";
  EXPECT_EQ(abaqus_refusal(start + "*Hyperelastic, Ogden, N=1\n1e6, 3, 1e-8\n"), "");
  EXPECT_THAT(abaqus_refusal(start + "*HYPERELASTIC, OGDEN, N=4\n1, 2, 3\n"),
              AllOf(HasSubstr("card.inp:4"), HasSubstr("N=4")));
  EXPECT_THAT(abaqus_refusal(start + "*HYPERELASTIC, OGDEN, N=2\n1, 2, 3\n"), HasSubstr("card.inp:5"));
  EXPECT_THAT(abaqus_refusal(start + "*HYPERELASTIC, NEO HOOKE\n1, 2\n"),
              AllOf(HasSubstr("NEO HOOKE"), HasSubstr("alpha = 2")));
  EXPECT_THAT(abaqus_refusal(start + "*HYPERELASTIC, OGDEN, TEST DATA INPUT\n1, 2\n"), HasSubstr("percal fit"));
  EXPECT_THAT(abaqus_refusal(start + "*HYPERELASTIC, OGDEN, N=1\n1\n"), HasSubstr("card.inp:5"));
  EXPECT_THAT(abaqus_refusal(start + "*HYPERELASTIC, OGDEN, N=1\n1, 2, -1\n"), HasSubstr("D1"));
  EXPECT_THAT(abaqus_refusal(start + "*HYPERELASTIC, OGDEN, N=1\n1, b, 1\n"), HasSubstr("alpha"));
}

}  // namespace
}  // namespace percal
