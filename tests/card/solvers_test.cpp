// One material in six programs: the numbers that each must carry, worked out by hand, and back.
#include <gmock/gmock.h>

#include <random>

#include "card/card_test.hpp"
#include "support/replaced.hpp"

namespace percal {
namespace {

using card_test::line_under;
using card_test::lines_of;
using card_test::read_card;
using card_test::skin;
using card_test::write_card;
using test::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const UnitSystem tonnes = unit_system("mm-t-s-MPa");

std::string refusal(const std::string& solver, const std::string& text) {
  return card_test::reader_refusal(solver, text, tonnes);
}

std::ptrdiff_t line_of(const std::string& text, const std::string& what) {
  return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(what)), '\n');
}

std::string without_comments(const std::string& card) {
  std::string rest;
  bool in_xml_comment = false;
  for (const auto& line : lines_of(card)) {
    if (line.starts_with("<!--")) in_xml_comment = true;
    const bool comment = line.starts_with('$') || line.starts_with("**") || line.starts_with('!') ||
                         line.starts_with('#') || in_xml_comment;
    if (!comment) rest += line + "\n";
    if (line.ends_with("-->")) in_xml_comment = false;
  }
  return rest;
}

CardMaterial two_terms() {
  CardMaterial material = skin();
  material.terms = {{60e6, 8}, {3.75e6, -2}};
  return material;
}

CardMaterial three_terms() {
  CardMaterial material = skin();
  material.terms = {{60e6, 8}, {5e6, -2}, {-1.25e6, 4}};
  return material;
}

// mu = 63.75 MPa, alpha = 8.5, K = 50 mu = 3187.5 MPa, stretch 1.7 at erosion.
//   2 mu/alpha = 127.5/8.5 = 15 MPa; 2 mu = 127.5 MPa; 2/K = 6.27450980392157e-4 per MPa; nu = 148/302 = 0.490066225165563
TEST(Solvers, EveryCardSaysWhichElementsItsErosionStrainBelongsTo) {
  CardMaterial known = skin(), whole = skin();
  known.erosion->element_over_radius = 0.1;
  known.erosion->element = 1e-7;
  whole.erosion.reset();
  for (const Solver& solver : solvers()) {
    const auto card = [&](const CardMaterial& material) { return solver.card(material, tonnes); };
    EXPECT_THAT(card(known), HasSubstr("erosion strain 0.7 for elements of 0.1 radii (100 nm)")) << solver.word;
    EXPECT_THAT(card(skin()), HasSubstr("erosion strain 0.7: the element size")) << solver.word;
    EXPECT_THAT(card(whole), Not(HasSubstr("for elements of"))) << solver.word;
  }
}

TEST(Solvers, EveryCardThatErodesSaysHowAnImpactIsModelled) {
  CardMaterial whole = skin();
  whole.erosion.reset();
  for (const Solver& solver : solvers()) {
    EXPECT_THAT(solver.card(skin(), tonnes), AllOf(HasSubstr("as secondaries"), HasSubstr("time step"))) << solver.word;
    EXPECT_THAT(solver.card(whole, tonnes), Not(HasSubstr("secondaries"))) << solver.word;
  }
}

TEST(Solvers, AStrainForOtherElementsTakesItsIntervalAlong) {
  CardMaterial own = skin();
  own.intervals = CardIntervals{0.95, {{"erosion_strain", 0.6, std::nullopt}, {"alpha", 8, 9}}};
  const CardMaterial other = for_elements(own, 0.35, 2e-7, 1e-6, "by runs");
  EXPECT_EQ(other.erosion->limit, 0.35);
  EXPECT_EQ(other.erosion->measure, own.erosion->measure);
  EXPECT_NEAR(*other.erosion->element_over_radius, 0.2, 1e-12);
  EXPECT_NEAR(*other.intervals->of[0].low, 0.3, 1e-12);
  EXPECT_FALSE(other.intervals->of[0].high);
  EXPECT_EQ(other.intervals->of[1].low, 8);
  EXPECT_EQ(other.comments.back(), "by runs");
}

TEST(Solvers, EachCarriesItsOwnModulus) {
  const auto card = [](const std::string& solver) { return write_card(solver, skin(), tonnes); };
  EXPECT_THAT(line_under(card("lsdyna"), "$      MU1", 1), testing::StartsWith("       15."));
  EXPECT_EQ(line_under(card("abaqus"), "*HYPERELASTIC", 1), "63.75, 8.5, 0.000627450980392157");
  EXPECT_EQ(card("calculix"), card("abaqus"));
  EXPECT_EQ(line_under(card("openradioss"), "#               MU_1", 1).substr(0, 20), "                 15.");
  EXPECT_EQ(line_under(card("openradioss"), "#            ALPHA_1", 1).substr(0, 20), "                 8.5");
  EXPECT_EQ(line_under(card("openradioss"), "#                 NU", 1).substr(0, 20), "   0.490066225165563");
  EXPECT_THAT(card("febio"), AllOf(HasSubstr("<c1>127.5</c1>"), HasSubstr("<m1>8.5</m1>"), HasSubstr("<k>3187.5</k>"),
                                   HasSubstr("<density>1.e-9</density>")));
  EXPECT_THAT(card("ansys"), AllOf(HasSubstr("\nMP,DENS,1,1.e-9\nTB,HYPER,1,1,1,OGDEN\n"),
                                   HasSubstr("\nTBDATA,1,15.,8.5,0.000627450980392157\n")));
}

// 2 mu/alpha: 120/8 = 15 and 7.5/-2 = -3.75; of three terms 15, -5 and -2.5/4 = -0.625.
TEST(Solvers, WriteTwoAndThreeTerms) {
  EXPECT_THAT(write_card("ansys", two_terms(), tonnes),
              HasSubstr("TB,HYPER,1,1,2,OGDEN\nTBDATA,1,15.,8.,-3.75,-2.,0.000627450980392157,0.\n"));
  EXPECT_THAT(write_card("ansys", three_terms(), tonnes),
              HasSubstr("TBDATA,1,15.,8.,-5.,-2.,-0.625,4.\nTBDATA,7,0.000627450980392157,0.,0.\n"));
  EXPECT_THAT(write_card("abaqus", two_terms(), tonnes),
              HasSubstr("*HYPERELASTIC, OGDEN, N=2\n60., 8., 3.75, -2., 0.000627450980392157, 0.\n"));
  EXPECT_THAT(write_card("calculix", three_terms(), tonnes),
              HasSubstr("N=3\n60., 8., 5., -2., -1.25, 4., 0.000627450980392157, 1.e20,\n1.e20\n"));
  EXPECT_THAT(write_card("febio", two_terms(), tonnes),
              AllOf(HasSubstr("<c1>120.</c1>"), HasSubstr("<c2>7.5</c2>"), HasSubstr("<m2>-2.</m2>")));
  EXPECT_THAT(line_under(write_card("lsdyna", three_terms(), tonnes), "$      MU1", 1),
              testing::StartsWith("       15.       -5.    -0.625"));
}

TEST(Solvers, KeepTheirConventionForANegativeAlpha) {
  CardMaterial material = skin();
  material.terms[0].alpha = -8.5;
  EXPECT_THAT(write_card("ansys", material, tonnes), HasSubstr("TBDATA,1,-15.,-8.5,"));
  EXPECT_THAT(write_card("openradioss", material, tonnes), HasSubstr("                -15."));
  EXPECT_THAT(write_card("febio", material, tonnes), HasSubstr("<c1>127.5</c1>"));
  for (const std::string& solver : solver_words())
    EXPECT_DOUBLE_EQ(read_card(solver, write_card(solver, material, tonnes), tonnes).terms[0].mu, 63.75e6) << solver;
}

// The stretch 1.7 is 0.7 engineering, 0.530628251062170 true, 0.945 Green-Lagrange.
TEST(Solvers, ConvertTheErosionStrainWhereTheMeasureIsDocumented) {
  for (const CardErosion& erosion :
       {CardErosion{0.7, StrainMeasure::engineering}, CardErosion{0.945, StrainMeasure::green_lagrange}}) {
    CardMaterial material = skin();
    material.erosion = erosion;
    const std::string radioss = line_under(write_card("openradioss", material, tonnes), "#         EPSILON_T1", 1);
    EXPECT_EQ(radioss,
              "                 0.7                 0.7         0                   0                   0"
              "        13");
    EXPECT_THAT(write_card("febio", material, tonnes), HasSubstr("<min>0.945</min>"));
  }
  CardMaterial material = skin();
  material.erosion = CardErosion{0.5, StrainMeasure::true_strain};
  EXPECT_THAT(line_under(write_card("openradioss", material, tonnes), "#         EPSILON_T1", 1),
              AllOf(testing::StartsWith("                 0.5"), testing::EndsWith("        23")));
  // (exp(1) - 1)/2 = 0.859140914229523
  EXPECT_THAT(write_card("febio", material, tonnes), HasSubstr("<min>0.859140914229523</min>"));
  EXPECT_THAT(write_card("lsdyna", material, tonnes), HasSubstr("measure not documented"));
  for (const std::string solver : {"abaqus", "ansys"})
    EXPECT_THAT(write_card(solver, material, tonnes), HasSubstr("no erosion in this card: elements should go"));
}

TEST(Solvers, AreRecognisedByTheirKeywordsAndUnits) {
  for (const std::string& solver : solver_words()) {
    const std::string card = write_card(solver, skin(), unit_system("um-us-ng-MPa"));
    const auto expected = solver == "calculix" ? "abaqus" : solver;
    ASSERT_TRUE(solver_of(card)) << solver;
    EXPECT_EQ(solver_of(card)->word, expected);
    ASSERT_TRUE(unit_system_of(card)) << solver;
    EXPECT_EQ(unit_system_of(card)->name, "um-us-ng-MPa");
  }
  EXPECT_FALSE(solver_of("density 1000\n"));
  EXPECT_FALSE(unit_system_of("*MATERIAL, NAME=X\n"));
}

TEST(Solvers, TakeTheirCardsBackInEveryUnitSystem) {
  std::mt19937 random(20261123);
  const auto log_uniform = [&](double low, double high) {
    return std::exp(std::uniform_real_distribution(std::log(low), std::log(high))(random));
  };
  for (const char* units_name : {"si", "mm-t-s-MPa", "mm-kg-ms-GPa", "um-ng-us-MPa", "MPa-s-t-mm"}) {
    const UnitSystem units = unit_system(units_name);
    for (int sample = 0; sample < 6; ++sample) {
      CardMaterial material{.name = "gel", .density = log_uniform(500, 20000), .terms = {}, .bulk_modulus = 0};
      for (int k = 0; k <= sample % 3; ++k)
        material.terms.push_back({log_uniform(1e2, 1e9), (k % 2 == 0 ? 1 : -1) * log_uniform(0.5, 25)});
      const double mu = shear_modulus(material);
      material.bulk_modulus = mu * log_uniform(10, 1e5);
      material.erosion = CardErosion{log_uniform(0.1, 3), StrainMeasure::engineering};
      for (const std::string& solver : solver_words()) {
        SCOPED_TRACE(solver + " " + units_name);
        if (solver == "calculix" && 2 * units.stress / material.bulk_modulus < 1e-10) continue;  // refused
        const std::string card = write_card(solver, material, units);
        const CardMaterial back = read_card(solver, card, units);
        // 15 digits; LS-DYNA's ten columns are used where they hold 1e-5
        const double tolerance = solver == "lsdyna" ? 2e-5 : 1e-13;
        ASSERT_EQ(back.terms.size(), material.terms.size());
        for (std::size_t k = 0; k < back.terms.size(); ++k) {
          EXPECT_NEAR(back.terms[k].mu / material.terms[k].mu, 1, tolerance);
          EXPECT_NEAR(back.terms[k].alpha / material.terms[k].alpha, 1, tolerance);
        }
        EXPECT_NEAR(back.density / material.density, 1, tolerance);
        // nu = 0.5 - mu/(2 K): fifteen digits of it hold ten of K at K = 1e5 mu
        const bool by_nu = solver == "lsdyna" || solver == "openradioss";
        EXPECT_NEAR(back.bulk_modulus / material.bulk_modulus, 1, by_nu ? std::max(tolerance, 1e-9) * 2 : tolerance);
        const bool erodes = solver == "lsdyna" || solver == "openradioss" || solver == "febio";
        ASSERT_EQ(back.erosion.has_value(), erodes);
        if (erodes) {
          EXPECT_NEAR(stretch_at(back.erosion->limit, back.erosion->measure) / (1 + material.erosion->limit), 1,
                      tolerance);
        }
        // and to the last digit: what was read writes the same numbers
        EXPECT_EQ(without_comments(write_card(solver, back, units)), without_comments(card));
      }
    }
  }
}

TEST(Solvers, SayWhereTheirNumbersComeFrom) {
  CardMaterial material = skin();
  material.intervals = CardIntervals{0.95,
                                     {{"mu_true_Pa", 60e6, 68e6},
                                      {"alpha", 8.2, std::nullopt},
                                      {"mu_over_alpha_Pa", 14e6, 16e6},
                                      {"erosion_strain", 0.6, 0.8}}};
  material.fit_error = "R^2 0.997 in stress";
  material.data = {{"skin.csv", std::string(64, 'a')}};
  for (const std::string& solver : solver_words()) {
    SCOPED_TRACE(solver);
    std::string text;  // without the line breaks of comments
    for (const auto& line : lines_of(write_card(solver, material, tonnes)))
      text += line.substr(std::min(line.find_first_not_of("$*!# "), line.size())) + " ";
    EXPECT_THAT(text, AllOf(HasSubstr("95 % interval of mu: 6e+07 to 6.8e+07 Pa"),
                            HasSubstr("95 % interval of alpha: 8.2 to open"),
                            HasSubstr("95 % interval of 2 mu/alpha: 1.4e+07 to 1.6e+07 Pa"),
                            HasSubstr("95 % interval of erosion strain: 0.6 to 0.8"),
                            HasSubstr("error of the fit: R^2 0.997 in stress"), HasSubstr("data: skin.csv, SHA-256")));
    EXPECT_THAT(text, AllOf(HasSubstr("volumetric law"), HasSubstr("unit system: mm-t-s-MPa"), HasSubstr("Drucker")));
  }
}

TEST(Solvers, RefuseWhatTheyCannotRead) {
  const std::string radioss = write_card("openradioss", skin(), tonnes);
  EXPECT_THAT(refusal("openradioss", replaced(radioss, "/MAT/LAW42/1", "/MAT/LAW42/1/7")), HasSubstr("unit"));
  EXPECT_THAT(refusal("openradioss", replaced(radioss, "                 8.5", "                 8,5")),
              AllOf(HasSubstr("card:"), HasSubstr("alpha_1")));
  EXPECT_THAT(refusal("openradioss", "/MAT/LAW1/1\nsteel\n"), HasSubstr("no Ogden material"));
  EXPECT_THAT(refusal("openradioss", radioss + replaced(radioss, "skin", "skin")), HasSubstr("2 materials"));
  const std::string febio = write_card("febio", skin(), tonnes);
  EXPECT_THAT(refusal("febio", replaced(febio, "</material>", "</materiel>")), HasSubstr("materiel"));
  EXPECT_THAT(refusal("febio", "<febio_spec>\n<Material>\n</febio_spec>\n"), HasSubstr("card:3"));
  EXPECT_THAT(refusal("febio", replaced(febio, "<m1>8.5</m1>", "<m1>8,5</m1>")),
              AllOf(HasSubstr("card:" + std::to_string(line_of(febio, "<m1>"))), HasSubstr("m1")));
  EXPECT_THAT(refusal("febio", replaced(febio, "<m1>8.5</m1>", "")), HasSubstr("m1"));
  EXPECT_THAT(refusal("febio", replaced(febio, "<k>", "<k lc=\"1\">")), HasSubstr("load curve"));
  const std::string ansys = write_card("ansys", skin(), tonnes);
  EXPECT_THAT(refusal("ansys", replaced(ansys, ",OGDEN", ",MOON")), HasSubstr("MOON"));
  EXPECT_THAT(refusal("ansys", replaced(ansys, "TBDATA,1,15.", "TBDATA,1,MU")), HasSubstr("'MU'"));
  for (const std::string& solver : solver_words()) EXPECT_THAT(refusal(solver, ""), HasSubstr("no Ogden material"));
}

// LAW82 has mu itself, and D = 2/K where Nu is 0; LAW42 takes 0.495 for a Nu of 0.
TEST(Solvers, ReadForeignCardsInTheirOwnConvention) {
  const std::string law82 =
      "/MAT/LAW82/3\nrubber\n                1e-9\n         2                             0.\n"
      "                 60.                3.75\n                  8.                 -2.\n"
      "               1.e-3                  0.\n";
  const CardMaterial of82 = read_card("openradioss", law82, tonnes);
  ASSERT_EQ(of82.terms.size(), 2u);
  EXPECT_DOUBLE_EQ(of82.terms[0].mu, 60e6);
  EXPECT_DOUBLE_EQ(of82.bulk_modulus, 2000e6);
  const CardMaterial of42 = read_card(
      "openradioss", "/MAT/OGDEN/3\nrubber\n                1e-9\n\n                 15.\n\n                 8.5\n\n",
      tonnes);
  EXPECT_DOUBLE_EQ(of42.terms[0].mu, 63.75e6);
  EXPECT_NEAR(of42.bulk_modulus / 63.75e6, 99.6666666666667, 1e-9);
  // K = cp + 2 mu/3
  const CardMaterial free = read_card("febio",
                                      "<febio_spec version='4.0'><Material><material id='4' type='Ogden unconstrained'>"
                                      "<density>1e-9</density><c1>120</c1><m1>8</m1><cp>1000</cp></material></Material>"
                                      "</febio_spec>",
                                      tonnes);
  EXPECT_DOUBLE_EQ(free.terms[0].mu, 60e6);
  EXPECT_DOUBLE_EQ(free.bulk_modulus, 1040e6);
  EXPECT_EQ(free.name, "material 4");
  const CardMaterial commented =
      read_card("febio",
                "<material name='a &lt; b' type='Ogden'><density>1e<!-- of water -->-9</density>"
                "<c1>\n  120\n</c1><m1>8</m1><k>1000</k></material>",
                tonnes);
  EXPECT_EQ(commented.name, "a < b");
  EXPECT_DOUBLE_EQ(commented.density, 1000);
  EXPECT_DOUBLE_EQ(commented.terms[0].mu, 60e6);
}

TEST(Solvers, ChooseAmongSeveralMaterialsByName) {
  CardMaterial other = skin();
  other.name = "gel";
  other.terms[0].mu = 1e6;
  other.bulk_modulus = 50e6;
  const std::string both =
      write_card("abaqus", skin(), tonnes) + write_card("abaqus", other, tonnes) + "*NODE\n1, 0, 0, 0\n";
  const auto cards = solver_named("abaqus").read(both, "deck.inp", tonnes);
  EXPECT_DOUBLE_EQ(chosen_card(cards, "gel", "deck.inp").material.terms[0].mu, 1e6);
  EXPECT_THROW(chosen_card(cards, "bone", "deck.inp"), BadInput);
  EXPECT_THAT(refusal("abaqus", both), AllOf(HasSubstr("'skin'"), HasSubstr("'gel'"), HasSubstr("--name")));
}

TEST(Solvers, UseLsDynasLongFormatWhereTenColumnsLoseDigits) {
  CardMaterial material = skin();
  EXPECT_THAT(write_card("lsdyna", material, tonnes), Not(HasSubstr("TITLE+")));
  material.bulk_modulus = 3.7e6 * 63.75e6;  // nu = 0.49999986486: ten columns tell K to 0.1 %
  const std::string card = write_card("lsdyna", material, tonnes);
  EXPECT_THAT(card, AllOf(HasSubstr("*MAT_OGDEN_RUBBER_TITLE+\n"), HasSubstr("*MAT_ADD_EROSION+\n")));
  EXPECT_EQ(line_under(card, "*MAT_OGDEN_RUBBER_TITLE+", 3).size(), 160u);
  EXPECT_NEAR(read_card("lsdyna", card, tonnes).bulk_modulus / material.bulk_modulus, 1, 1e-8);
  EXPECT_NEAR(read_card("lsdyna", "*KEYWORD LONG=Y\n" + replaced(card, "TITLE+", "TITLE"), tonnes).bulk_modulus /
                  material.bulk_modulus,
              1, 1e-8);
}

TEST(CardModulus, IsConvertedThereAndBack) {
  const Ogden term{63.75, 8.5};
  EXPECT_EQ(modulus_field(term, CardModulus::mu), 63.75);
  EXPECT_EQ(modulus_field(term, CardModulus::two_mu_over_alpha), 15);
  EXPECT_EQ(modulus_field(term, CardModulus::two_mu), 127.5);
  for (const auto meaning : {CardModulus::mu, CardModulus::two_mu_over_alpha, CardModulus::two_mu})
    EXPECT_DOUBLE_EQ(term_of_field(modulus_field(term, meaning), 8.5, meaning).mu, 63.75);
}

// A D2 of 0 means that the term is absent in Abaqus; CalculiX replaces it, and a small D1 too.
TEST(CalculixCard, HasNoNumberThatCalculixReplaces) {
  const std::string card = write_card("calculix", two_terms(), tonnes);
  EXPECT_THAT(card, HasSubstr("1.e20"));
  EXPECT_THAT(write_card("abaqus", two_terms(), tonnes), Not(HasSubstr("1.e20")));
  const auto back = solver_named("calculix").read(card, "card", tonnes);
  ASSERT_EQ(back.cards.size(), 1u);
  EXPECT_TRUE(back.cards.front().ignored.empty());
  CardMaterial stiff = skin();
  stiff.bulk_modulus = 30e9;
  try {
    write_card("calculix", stiff, unit_system("si"));
    ADD_FAILURE() << "a D1 of 7e-11 was written";
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("D1"));
  }
  EXPECT_NO_THROW(write_card("abaqus", stiff, unit_system("si")));
}

}  // namespace
}  // namespace percal
