// Cards as other people have them: what changes the material is read right, refused or said, and what is no Ogden card is named.
#include <gmock/gmock.h>

#include <cmath>

#include "card/card_test.hpp"
#include "support/replaced.hpp"

namespace percal {
namespace {

using card_test::found_card;
using test::replaced;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const UnitSystem milli = unit_system("mm-kg-ms-GPa"), megapascal = unit_system("mm-t-s-MPa");

std::string refused(const std::string& solver, const std::string& text) {
  return card_test::reader_refusal(solver, text, megapascal);
}

std::string dyna(const std::string& pr, const std::string& erosion) {
  return "*KEYWORD\n*MAT_OGDEN_RUBBER\n         1    1.0E-6" + std::string(10 - pr.size(), ' ') + pr +
         "         0         0\n      0.01\n       8.0\n*MAT_ADD_EROSION\n" + erosion + "*END\n";
}

const std::string no_limits = "     0.000     0.000     0.000     0.000     0.000     0.000     0.000     0.000\n";

TEST(ForeignLsDyna, SaysEveryLimitOfItsErosion) {
  const FoundCard found = found_card(
      "lsdyna",
      dyna("0.499", "        01     0.000     0.000     0.000     0.900     0.000     1.000     1.000\n" + no_limits),
      milli);
  EXPECT_DOUBLE_EQ(found.material.terms[0].mu, 40e6);
  EXPECT_FALSE(found.material.erosion);
  EXPECT_TRUE(found.erodes_otherwise);
  EXPECT_THAT(found.ignored, ElementsAre("EFFEPS of *MAT_ADD_EROSION: 0.9"));
}

// EXCL is the number that switches a limit off; NCS = 2 wants two limits passed at once.
TEST(ForeignLsDyna, KnowsWhichLimitsAreOff) {
  const std::string second = "     0.000     0.000     0.000     0.700     0.000     0.000     0.000     0.000\n";
  const std::string comment = "$ strain measure of MXEPS: engineering\n";
  const auto read = [&](const std::string& first, const std::string& line) {
    return found_card("lsdyna", comment + dyna("0.499", first + line), milli);
  };
  const FoundCard off = read("         1       0.9     0.000     0.000     0.900\n", second);
  EXPECT_THAT(off.ignored, IsEmpty());
  EXPECT_DOUBLE_EQ(off.material.erosion->limit, 0.7);
  const FoundCard both =
      read("         1     0.000     0.000     0.000     0.900     0.000     1.000     2.000\n", second);
  EXPECT_FALSE(both.material.erosion);
  EXPECT_TRUE(both.erodes_otherwise);
  EXPECT_THAT(both.ignored, ElementsAre(HasSubstr("NCS"), HasSubstr("EFFEPS"), HasSubstr("MXEPS")));
}

TEST(ForeignLsDyna, HasTermsAlthoughNobodySaysWhichStrainMxepsIs) {
  const FoundCard found =
      found_card("lsdyna",
                 dyna("0.499", "         1\n" + replaced(no_limits, "0.000     0.000     0.000     0.000",
                                                         "0.000     0.000     0.000     0.700")),
                 milli);
  EXPECT_DOUBLE_EQ(found.material.terms[0].alpha, 8);
  EXPECT_FALSE(found.material.erosion);
  EXPECT_TRUE(found.erodes_otherwise);
  EXPECT_THAT(found.ignored, ElementsAre(AllOf(HasSubstr("MXEPS"), HasSubstr("not known"), HasSubstr("0.7"))));
}

TEST(ForeignLsDyna, SaysWhatElseIsAddedToItsMaterial) {
  const std::string damage = "*MAT_ADD_DAMAGE_GISSMO\n         1\n*MAT_ADD_INELASTICITY\n         2\n";
  const FoundCard found = found_card("lsdyna", dyna("0.499", "         1\n" + no_limits) + damage, milli);
  EXPECT_THAT(found.ignored, ElementsAre("*MAT_ADD_DAMAGE_GISSMO (line 10)"));
  EXPECT_TRUE(found.erodes_otherwise);
}

// No rubber is auxetic; some decks carry a flag in the sign.
TEST(ForeignLsDyna, RefusesANegativePoissonsRatio) {
  EXPECT_THAT(card_test::reader_refusal("lsdyna", dyna("-0.4990", "         2\n" + no_limits), milli),
              AllOf(HasSubstr("card:3: PR: found -0.499"), HasSubstr("auxetic")));
}

TEST(ForeignLsDyna, RefusesTermsFromACurveBeforeItLooksForConstants) {
  EXPECT_THAT(refused("lsdyna",
                      "*KEYWORD\n*MAT_077_O\n         7   1.0E-9     0.495         2         6       0.0       0.0\n"
                      "       1.0       1.0       1.0        12       1.0         0       0.0       0.0\n*END\n"),
              HasSubstr("card:3: N: found 2; accepted: 0: constants, not curves"));
}

TEST(ForeignAbaqus, RefusesViscosity) {
  EXPECT_THAT(refused("abaqus",
                      "*MATERIAL, NAME=skin\n*DENSITY\n1.0e-09\n*HYPERELASTIC, OGDEN, N=1, MODULI=INSTANTANEOUS\n"
                      "0.1, 9.0, 0.02\n*VISCOELASTIC, TIME=PRONY\n0.3, 0.0, 0.01\n"),
              AllOf(HasSubstr("card:6: *VISCOELASTIC: found a Prony series"), HasSubstr("without viscosity")));
}

TEST(ForeignAbaqus, SaysEveryKeywordInsideItsMaterial) {
  const FoundCard found = found_card(
      "abaqus",
      "*MATERIAL, NAME=skin\n*HYPERELASTIC, OGDEN, N=1\n0.1, 9.0, 0.02\n*MULLINS EFFECT\n1, 2, 3\n*DAMAGE EVOLUTION\n"
      "0.1\n*NEVER HEARD OF\n*DENSITY\n1e-9\n*SOLID SECTION, ELSET=A, MATERIAL=skin\n*ELASTIC\n",
      megapascal);
  EXPECT_NEAR(found.material.density, 1000, 1e-9);
  EXPECT_THAT(found.ignored, ElementsAre("*MULLINS EFFECT", "*DAMAGE EVOLUTION", "*NEVER HEARD OF"));
}

// Blank fields keep their places: D1 = 0 is an incompressible solid, and 20 a temperature.
TEST(ForeignAbaqus, IsIncompressibleWhereD1IsZeroOrBlank) {
  for (const char* constants : {"0.1, 9., 0.", "0.1, 9.", "0.1, 9., , 20."}) {
    const FoundCard found = found_card(
        "abaqus", std::string("*MATERIAL, NAME=X\n*HYPERELASTIC, OGDEN, N=1\n") + constants + "\n", megapascal);
    EXPECT_TRUE(std::isinf(found.material.bulk_modulus)) << constants;
    EXPECT_TRUE(std::isnan(found.material.density));
    EXPECT_THAT(found.material.comments, ElementsAre(HasSubstr("incompressible: D1 = 0")));
  }
  const FoundCard calculix =
      found_card("calculix", "*MATERIAL, NAME=X\n*HYPERELASTIC, OGDEN, N=1\n0.1, 9., 0.\n", megapascal);
  EXPECT_DOUBLE_EQ(calculix.material.bulk_modulus, 20 * 0.1e6);
  EXPECT_THAT(calculix.ignored, ElementsAre(HasSubstr("CalculiX puts 0.1/mu")));
  // 0.1 over the sum of all mu, as ccx 2.20 prints it
  const FoundCard two = found_card(
      "calculix", "*MATERIAL, NAME=X\n*HYPERELASTIC, OGDEN, N=2\n2000., 4., 1000., -3., 0., 0.\n", megapascal);
  EXPECT_DOUBLE_EQ(two.material.bulk_modulus, 20 * 3000e6);
  EXPECT_THAT(two.ignored, ElementsAre(HasSubstr("CalculiX puts 0.1/mu"), HasSubstr("D2 = 0")));
}

TEST(ForeignAbaqus, HasAMaterialForEachTemperature) {
  const std::string one = "*MATERIAL, NAME=X\n*HYPERELASTIC, OGDEN, N=2\n0.6, 8., 0.04, -2., 1e-3, 0., 20.\n";
  EXPECT_EQ(found_card("abaqus", one, megapascal).material.name, "X");
  EXPECT_THAT(
      refused("abaqus", one + "0.5, 8., 0.03, -2., 1e-3, 0., 60.\n"),
      AllOf(HasSubstr("2 materials"), HasSubstr("'X at 20.' (line"), HasSubstr("'X at 60.'"), HasSubstr("--name")));
  const std::string three =
      "*MATERIAL, NAME=X\n*HYPERELASTIC, OGDEN, N=3\n60., 8., 5., -2., -1.25, 4., 1e-3, 0.,\n0., 20.\n";
  EXPECT_EQ(found_card("abaqus", three, megapascal).material.terms.size(), 3U);
}

TEST(ForeignAnsys, ComparesFourLettersAsApdlDoes) {
  for (const char* card :
       {"TB,HYPE,1,1,1,OGDE\nTBDATA,1,0.63,1.3,0.001\nMP,DENS,1,1e-9\n",
        "tb,hyper,1,,1,ogden $ tbda,1,0.63,1.3,0.001\nMPDATA,R5.0, 1,DENS,       1, 1, 1.0e-9    ,\n",
        "TB,HYPE,1,1,1,OGDE\nTBDAT,1,0.63\nTBDAT,,1.3,0.001\nMPDATA,DENS,1,,1e-9\n"}) {
    const CardMaterial read = card_test::read_card("ansys", card, megapascal);
    EXPECT_NEAR(read.terms[0].mu, 409.5e3, 1e-6) << card;
    EXPECT_EQ(read.terms[0].alpha, 1.3);
    EXPECT_NEAR(read.bulk_modulus, 2e9, 1);
    EXPECT_NEAR(read.density, 1000, 1e-9) << card;
    EXPECT_EQ(solver_of(card)->word, "ansys");
  }
}

TEST(ForeignAnsys, HasAMaterialForEachTemperature) {
  const std::string card =
      "TB,HYPER,1,2,1,OGDEN\nTBTEMP,20\nTBDATA,1,0.63,1.3,0.001\nTBTEMP,60\nTBDATA,1,0.50,1.3,0.001\nMP,DENS,1,1e-9\n";
  EXPECT_THAT(refused("ansys", card),
              AllOf(HasSubstr("'material 1 at 20' (line 2)"), HasSubstr("'material 1 at 60' (line 4)")));
  const auto found = solver_named("ansys").read(card, "card", megapascal);
  EXPECT_NEAR(chosen_card(found, "material 1 at 20", "card").material.terms[0].mu, 409.5e3, 1e-6);
  EXPECT_NEAR(chosen_card(found, "material 1 at 60", "card").material.terms[0].mu, 325e3, 1e-6);
}

TEST(ForeignAnsys, RefusesAPronySeriesOfItsMaterialAndSaysItsOtherTables) {
  const std::string card = "TB,HYPE,1,1,1,OGDE\nTBDATA,1,0.63,1.3,0.001\n";
  EXPECT_THAT(refused("ansys", card + "TB,PRONY,1,1,1,SHEAR\nTBDATA,1,0.3,0.01\n"), HasSubstr("card:3: TB,PRONY"));
  EXPECT_THAT(found_card("ansys", card + "TB,PRONY,2,1,1,SHEAR\nTB,CDM,1,1,3,PSE2\n", megapascal).ignored,
              ElementsAre("TB,CDM,1,1,3,PSE2"));
  EXPECT_TRUE(
      std::isinf(found_card("ansys", "TB,HYPE,1,1,1,OGDE\nTBDATA,1,0.63,1.3\n", megapascal).material.bulk_modulus));
}

TEST(ForeignOpenRadioss, RefusesViscosityAndSaysOtherFailures) {
  const std::string card = card_test::write_card("openradioss", card_test::skin(), megapascal);
  EXPECT_THAT(refused("openradioss", card + "/VISC/PRONY/1\n"), HasSubstr("/VISC/PRONY/1"));
  const FoundCard found =
      found_card("openradioss", card + "/FAIL/JOHNSON/1\n/EOS/POLYNOMIAL/1\n/FAIL/BIQUAD/2\n", megapascal);
  EXPECT_THAT(found.ignored, ElementsAre("/FAIL/JOHNSON/1", "/EOS/POLYNOMIAL/1"));
  EXPECT_TRUE(found.erodes_otherwise);
}

// 0.7 in version 2017 is lambda^2 - 1: 0.35 Green-Lagrange, a stretch of 1.304.
TEST(ForeignOpenRadioss, ComparesAnotherStrainBeforeVersion2018) {
  const std::string card = card_test::write_card("openradioss", card_test::skin(), megapascal);
  const auto erosion = [&](const std::string& version) {
    return found_card("openradioss", "/BEGIN\nrun\n      " + version + "         0\n" + card, megapascal)
        .material.erosion;
  };
  EXPECT_NEAR(stretch_at(erosion("2017")->limit, erosion("2017")->measure), 1.304, 5e-4);
  EXPECT_NEAR(stretch_at(erosion("2022")->limit, erosion("2022")->measure), 1.7, 1e-12);
  EXPECT_THAT(card, AllOf(HasSubstr("/BEGIN 2018 or later"), HasSubstr("1.304")));
}

// What the card advises against LAW42's own K: a function that is 1 throughout.
TEST(ForeignOpenRadioss, TakesAConstantFunctionOfTheBulkModulus) {
  const std::string card = card_test::write_card("openradioss", card_test::skin(), megapascal);
  EXPECT_THAT(card, HasSubstr("LAW42 raises K by itself"));
  CardMaterial soft = card_test::skin();
  soft.bulk_modulus = 40 * shear_modulus(soft);
  EXPECT_THAT(card_test::write_card("openradioss", soft, megapascal), Not(HasSubstr("LAW42 raises")));
  const std::string zeros = "                   0         0         0";  // sigma_cut, Jstrain, Fct_IDblk
  const std::string with = replaced(card, zeros, "                   0         0         5");
  const std::string points = "/FUNCT/5\nones\n                  0.                  1.\n                 10.";
  EXPECT_NEAR(card_test::read_card("openradioss", with + points + "                  1.\n", megapascal).bulk_modulus,
              50 * 63.75e6, 1e-3);
  EXPECT_THAT(refused("openradioss", with + points + "                  2.\n"), HasSubstr("Fct_IDblk"));
}

TEST(ForeignFebio, ErodesTheMaterialsThatItsAdaptorsName) {
  const std::string materials =
      "<febio_spec version='4.0'><Material><material id='1' name='skin' "
      "type='Ogden'><c1>2</c1><m1>8</m1><k>100</k></material>"
      "<material id='2' name='fat' type='Ogden'><c1>1</c1><m1>8</m1><k>100</k></material></Material>"
      "<MeshDomains><SolidDomain name='upper' mat='skin'/><SolidDomain name='lower' mat='fat'/></MeshDomains>";
  const auto adaptor = [](const std::string& set) {
    return "<MeshAdaptor><mesh_adaptor type='erosion'" + set +
           "><criterion type='min-max filter'><min>0.9</min>"
           "<data type='element data'><element_data>E1</element_data></data></criterion></mesh_adaptor></MeshAdaptor>"
           "</febio_spec>";
  };
  const auto cards = [&](const std::string& set) {
    return solver_named("febio").read(materials + adaptor(set), "card", megapascal).cards;
  };
  const auto all = cards(""), upper = cards(" elem_set='upper'"), other = cards(" elem_set='wall'");
  EXPECT_TRUE(all[0].material.erosion && all[1].material.erosion);
  EXPECT_TRUE(upper[0].material.erosion && !upper[1].material.erosion);
  EXPECT_THAT(upper[1].ignored, IsEmpty());
  EXPECT_FALSE(other[0].material.erosion);
  EXPECT_THAT(other[0].ignored, ElementsAre(HasSubstr("erosion adaptor")));
}

// K = 2 mu/3 is a Poisson's ratio of 0.
TEST(ForeignCards, HaveNoAuxeticRubber) {
  const auto febio = [](const std::string& k) {
    return refused("febio", "<material type='Ogden'><c1>3</c1><m1>2</m1><k>" + k + "</k></material>");
  };
  EXPECT_THAT(febio("0.9"), AllOf(HasSubstr("bulk_modulus_Pa"), HasSubstr("2/3 mu")));
  EXPECT_EQ(febio("1.1"), "");
  CardMaterial material = card_test::skin();
  material.bulk_modulus = 0.6 * shear_modulus(material);
  for (const Solver& solver : solvers()) EXPECT_THROW(solver.card(material, milli), BadInput) << solver.word;
}

struct Named {
  const char *solver, *card, *keyword, *law;
};

class OtherLaws : public testing::TestWithParam<Named> {};

TEST_P(OtherLaws, AreNamedWithTheirLine) {
  const Named& one = GetParam();
  EXPECT_THAT(refused(one.solver, one.card),
              AllOf(HasSubstr("card:1: found no Ogden material, but " + std::string(one.keyword) + " (line 1)"),
                    HasSubstr(one.law)));
}

INSTANTIATE_TEST_SUITE_P(
    Cards, OtherLaws,
    testing::Values(Named{"openradioss", "/MAT/LAW69/1\nrubber\n", "/MAT/LAW69",
                          "Ogden from a curve: fit the curve with percal fit"},
                    Named{"openradioss", "/MAT/LAW62/1\nrubber\n", "/MAT/LAW62", "viscosity"},
                    Named{"openradioss", "/MAT/LAW88/1\nrubber\n", "/MAT/LAW88", "percal fit"},
                    Named{"openradioss", "/MAT/LAW1/1\nsteel\n", "/MAT/LAW1", ""},
                    Named{"lsdyna", "*MAT_027\n", "*MAT_027", "Mooney-Rivlin"},
                    Named{"lsdyna", "*MAT_077_H\n", "*MAT_077_H", "no Ogden terms"},
                    Named{"lsdyna", "*MAT_181\n", "*MAT_181", "percal fit"},
                    Named{"lsdyna", "*MAT_SIMPLIFIED_RUBBER/FOAM\n", "*MAT_SIMPLIFIED_RUBBER/FOAM", "percal fit"},
                    Named{"abaqus", "*MATERIAL, NAME=steel\n*ELASTIC\n", "*MATERIAL, NAME=steel", ""},
                    Named{"ansys", "TB,HYPE,1,1,2,MOON\n", "TB,HYPE,1,1,2,MOON", "Mooney-Rivlin"},
                    Named{"febio", "<material type='neo-Hookean'/>", "<material type=\"neo-Hookean\">", "alpha = 2"}));

TEST(OtherMaterials, OgdenInsideViscosityIsNamed) {
  EXPECT_THAT(
      refused("febio",
              "<material name='a' type='uncoupled viscoelastic'>\n<elastic type='Ogden'><c1>1</c1></elastic>\n"
              "</material>"),
      AllOf(HasSubstr("Prony series"), HasSubstr("<elastic type=\"Ogden\"> (line 2): Ogden inside another material"),
            HasSubstr("uncoupled viscoelastic")));
  EXPECT_THAT(refused("abaqus", "*MATERIAL, NAME=a\n*HYPERELASTIC, OGDEN, TEST DATA INPUT\n"), HasSubstr("percal fit"));
}

// Tonnes are no kilograms: 1e-9 t/mm3 read as kg/mm3 is 1 kg/m3, as kg/m3 it is less.
TEST(ForeignUnits, AreDoubtedWhereNoSolidHasTheNumbers) {
  const std::string card = "*MATERIAL, NAME=X\n*DENSITY\n1e-9\n*HYPERELASTIC, OGDEN, N=1\n0.1, 8.5, 6e-4\n";
  const auto warnings = [&](const std::string& units) {
    return percal::read_card({card, "card", "", units, ""}).warnings;
  };
  EXPECT_THAT(warnings("mm-t-s-MPa"), IsEmpty());
  EXPECT_THAT(warnings("mm-kg-ms-GPa"),
              ElementsAre(AllOf(HasSubstr("1 kg/m3 is no density"), HasSubstr("mm-kg-ms-GPa"))));
  EXPECT_THAT(warnings("si"), ElementsAre(HasSubstr("softer"), HasSubstr("no density")));
}

}  // namespace
}  // namespace percal
