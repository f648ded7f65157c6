#include "percal/card/uniaxial_deck.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "card/card_test.hpp"
#include "percal/card/card_json.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const char* all_units[] = {"mm-t-s-MPa", "mm-ms-kg-GPa", "um-us-ng-MPa"};

std::vector<DeckFile> deck_of(const std::string& solver, const std::string& units = "mm-t-s-MPa",
                              UniaxialTest test = {}, const std::string& job = "skin_test") {
  return uniaxial_deck(solver_named(solver), card_test::skin(), unit_system(units), test, job);
}

// Comment lines as one text.
std::string joined(const std::string& text) {
  std::string flat;
  for (const std::string& line : card_test::lines_of(text))
    flat += line.substr(std::min(line.find_first_not_of("$*!# "), line.size())) + " ";
  return flat;
}

int times(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// The lines under `start` up to the next that begins with one of `ends`; comment lines are left out.
std::vector<std::string> block(const std::string& text, const std::string& start, const std::string& ends) {
  std::vector<std::string> lines;
  bool inside = false;
  for (const std::string& line : card_test::lines_of(text)) {
    if (line == start) {
      inside = true;
    } else if (inside) {
      if (line.find_first_of(ends) == 0) break;
      if (line[0] != '$' && line[0] != '#') lines.push_back(line);
    }
  }
  return lines;
}

// The volume of the brick with the corners of `lines` in the order 1 to 8, from its three edges at corner 1.
double volume(const std::vector<std::array<double, 3>>& corners) {
  std::array<std::array<double, 3>, 3> edges{};
  for (int k = 0; k < 3; ++k) {
    const int far[] = {1, 3, 4};
    for (int i = 0; i < 3; ++i) edges[k][i] = corners[far[k]][i] - corners[0][i];
  }
  const auto& [a, b, c] = edges;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

TEST(UniaxialStress, IsTheClosedFormWhereKIsLarge) {
  CardMaterial solid = card_test::skin();
  for (const double alpha : {-9.0, -2.0, 0.5, 8.5}) {
    solid.terms = {{2e6, alpha}};
    solid.bulk_modulus = 1e9 * 2e6;
    for (const double stretch : {0.5, 0.8, 1.3, 2.0}) {
      const double closed = 2 * 2e6 / alpha * (std::pow(stretch, alpha - 1) - std::pow(stretch, -alpha / 2 - 1));
      EXPECT_NEAR(incompressible_uniaxial_stress(solid, stretch), closed, 1e-12 * std::abs(closed));
      for (const auto law : {SolverLaw::quadratic, SolverLaw::logarithmic, SolverLaw::difference})
        EXPECT_NEAR(uniaxial_stress(solid, stretch, law), closed, 1e-5 * std::abs(closed)) << alpha << " " << stretch;
    }
  }
}

// d/dlambda of the least energy over the stretch of the sides, by differences: knows nothing of tau and ln J.
TEST(UniaxialStress, IsTheSlopeOfTheLeastEnergyWhereKIsSmall) {
  CardMaterial solid = card_test::skin();
  solid.terms = {{1, -4}, {0.5, 3}};
  solid.bulk_modulus = 10;
  const auto energy = [&](double stretch, double side, SolverLaw law) {
    const double J = stretch * side * side, root = std::cbrt(J);
    double sum = 0;
    for (const auto& [mu, alpha] : solid.terms)
      sum += 2 * mu / (alpha * alpha) * (std::pow(stretch / root, alpha) + 2 * std::pow(side / root, alpha) - 3);
    if (law == SolverLaw::quadratic) return sum + 10 * (J - 1) * (J - 1) / 2;
    if (law == SolverLaw::logarithmic) return sum + 10 * std::log(J) * std::log(J) / 2;
    return sum + 10 * (J - 1 - std::log(J));
  };
  const auto least = [&](double stretch, SolverLaw law) {
    double low = 0.5, high = 1.6;  // golden section
    const double golden = (std::sqrt(5.0) - 1) / 2;
    for (int i = 0; i < 80; ++i) {
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      (energy(stretch, left, law) < energy(stretch, right, law) ? high : low) =
          energy(stretch, left, law) < energy(stretch, right, law) ? right : left;
    }
    return energy(stretch, (low + high) / 2, law);
  };
  for (const auto law : {SolverLaw::quadratic, SolverLaw::logarithmic, SolverLaw::difference}) {
    for (const double stretch : {0.6, 0.9, 1.5, 2.0}) {
      const double slope = (least(stretch + 1e-4, law) - least(stretch - 1e-4, law)) / 2e-4;
      EXPECT_NEAR(uniaxial_stress(solid, stretch, law), slope, 1e-6 * std::max(1.0, std::abs(slope))) << stretch;
    }
  }
}

TEST(UniaxialDeck, HoldsTheCardAsItStands) {
  for (const std::string& solver : solver_words()) {
    for (const char* units : all_units) {
      const auto files = deck_of(solver, units);
      const std::string card = card_test::write_card(solver, card_test::skin(), unit_system(units));
      const std::size_t adaptor = std::min(card.find("<MeshAdaptor>"), card.size());  // FEBio's stands behind the mesh
      EXPECT_THAT(files.front().text, AllOf(HasSubstr(card.substr(0, adaptor)), HasSubstr(card.substr(adaptor))));
      EXPECT_EQ(files.size(), solver == "openradioss" ? 2U : 1U);
    }
  }
}

TEST(UniaxialDeck, SaysTheStressToExpectInItsUnits) {
  const double stress = uniaxial_stress(card_test::skin(), 1.5, SolverLaw::quadratic);
  for (const char* units : all_units) {
    const UnitSystem system = unit_system(units);
    const std::string text = deck_of("abaqus", units, {.stretch = 1.5}).front().text;
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, std::regex("expected nominal stress at stretch 1.5: ([^ ]+) ")));
    EXPECT_NEAR(std::stod(found[1]) * system.stress, stress, 1e-5 * stress) << units;
    EXPECT_THAT(text, HasSubstr(" " + system.stress_unit + " (U = K (J - 1)^2 / 2;"));
  }
}

TEST(UniaxialDeck, SaysWhereTheElementErodes) {
  EXPECT_THAT(deck_of("lsdyna").front().text, HasSubstr("stretch of 1.7"));
  EXPECT_THAT(deck_of("lsdyna", "si", {.stretch = 1.6}).front().text, Not(HasSubstr("the material erodes")));
}

// Without a change of volume the sides reach 1.7 at 1.7^-2 = 0.346: with K = 50 mu later, or never. The numbers are of a bisection
// in Python.
TEST(UniaxialDeck, AnElementGoesWhereTheSidesOfItsOwnSolidReachTheLimit) {
  CardMaterial solid = card_test::skin(), negative = solid;
  negative.terms[0].alpha = -3;
  CardMaterial stiff = negative;
  stiff.bulk_modulus *= 1e6;
  for (const auto law : {SolverLaw::quadratic, SolverLaw::logarithmic, SolverLaw::difference}) {
    EXPECT_FALSE(stretch_where_largest_is(1.7, solid, 0.05, law));  // alpha = 8.5
    EXPECT_NEAR(stretch_where_largest_is(1.7, stiff, 0.2, law).value(), 1 / (1.7 * 1.7), 1e-5);
  }
  EXPECT_FALSE(stretch_where_largest_is(1.7, negative, 0.05, SolverLaw::quadratic));  // 1.696 at 0.261
  EXPECT_NEAR(stretch_where_largest_is(1.7, negative, 0.2, SolverLaw::logarithmic).value(), 0.30033, 1e-5);
  EXPECT_NEAR(stretch_where_largest_is(1.7, negative, 0.2, SolverLaw::difference).value(), 0.29533, 1e-5);
  EXPECT_EQ(stretch_where_largest_is(1.7, solid, 2, SolverLaw::quadratic), 1.7);
  EXPECT_FALSE(stretch_where_largest_is(1.7, solid, 1.6, SolverLaw::quadratic));
  EXPECT_THAT(joined(deck_of("lsdyna", "si", {.stretch = 0.3}).front().text),
              AllOf(HasSubstr("which is not reached"), HasSubstr("at stretch 0.346021")));
}

// The file that --file writes, or the one that a user makes of what is printed.
TEST(UniaxialDeck, RunsAFileThatExists) {
  const auto text = [](const std::string& solver, const std::string& file) {
    const DeckFile deck = deck_of(solver, "mm-t-s-MPa", {}, file).front();
    return deck.name + " | " + joined(deck.text);
  };
  EXPECT_THAT(text("abaqus", "decks/c.inp"), AllOf(StartsWith("c.inp | "), HasSubstr("abaqus job=c interactive")));
  EXPECT_THAT(text("abaqus", "my deck.inp"), HasSubstr("abaqus job=my_deck input=\"my deck.inp\" interactive"));
  EXPECT_THAT(text("calculix", "c.inp"), HasSubstr("run: ccx c; c.dat"));
  EXPECT_THAT(text("calculix", "c.txt"), HasSubstr("run: cp c.txt c.inp; ccx c; c.dat"));
  EXPECT_THAT(text("lsdyna", "a.key"), AllOf(StartsWith("a.key | "), HasSubstr("i=a.key (double")));
  EXPECT_THAT(text("febio", "b"), AllOf(StartsWith("b.feb | "), HasSubstr("febio4 -i b.feb;")));
  EXPECT_THAT(text("ansys", ""), AllOf(StartsWith("uniaxial.inp | "), HasSubstr("-i uniaxial.inp -o uniaxial.out")));
}

// The engine file is free-form: numbers of twenty characters may not touch.
TEST(UniaxialDeck, SeparatesTheNumbersOfOpenRadiossEngineFiles) {
  for (const char* units : all_units) {
    const auto files = deck_of("openradioss", units);
    const auto animation = block(files[1].text, "/ANIM/DT", "/");
    ASSERT_EQ(animation.size(), 1U);
    std::istringstream fields(animation[0]);
    double start = -1, step = -1;
    fields >> start >> step;
    EXPECT_EQ(start, 0);
    EXPECT_GT(step, 0);
    EXPECT_THAT(files[1].text, HasSubstr("\n/TH/TITLE\n"));
    const double end = std::stod(block(files[1].text, "/RUN/skin_test/1", "/")[0]);
    const double moved = std::stod(block(files[0].text, "/FUNCT/1", "/")[3].substr(0, 20));
    EXPECT_NEAR(end / moved, 1.02, 1e-9);  // the last stretch is recorded
    EXPECT_THAT(joined(files[0].text), AllOf(HasSubstr("J = RHO_I / DENS"), HasSubstr("REACX is an impulse")));
  }
}

// An adaptor without elem_set takes elements of other materials too, and can name them only after Mesh.
TEST(UniaxialDeck, ErodesTheElementsOfItsMaterialInFebio) {
  const std::string text = deck_of("febio").front().text;
  EXPECT_THAT(text, AllOf(HasSubstr("<mesh_adaptor type=\"erosion\" elem_set=\"skin\">"),
                          HasSubstr("<Elements type=\"hex8\" name=\"skin\">"),
                          HasSubstr("<SolidDomain name=\"skin\" mat=\"skin\"/>")));
  EXPECT_LT(text.find("</Mesh>"), text.find("<MeshAdaptor>"));
  EXPECT_THAT(joined(text), HasSubstr("keeps its last stress in skin_test_element.csv"));
  EXPECT_TRUE(card_test::read_card("febio", text, unit_system("mm-t-s-MPa")).erosion);
}

// Nodes, element and moved face of all six, read as each format has them: a cube of edge 1 (CalculiX: 10), of positive
// volume, and the displacement to stretch 1.5.
TEST(UniaxialDeck, IsACubeOfOneElement) {
  struct Layout {
    std::string solver;
    std::string nodes, ends, element, moved;
    double edge;
  };
  const Layout layouts[] = {
      {"lsdyna", "*NODE", "*", "1       1       1       2       3       4       5       6       7       8",
       "         4         1         2         1       0.5", 1},
      {"abaqus", "*NODE, NSET=CUBE_NODES", "*", "1, 1, 2, 3, 4, 5, 6, 7, 8", "X1, 1, 1, 0.5\n", 1},
      {"calculix", "*NODE, NSET=CUBE_NODES", "*", "1, 1, 2, 3, 4, 5, 6, 7, 8", "X1, 1, 1, 5.\n", 10},
      {"openradioss", "/NODE", "/", "/BRICK/1\n         1         1         2         3         4", "/IMPVEL/1", 1},
      {"febio", "  <Nodes name=\"cube_nodes\">", "  </", "<elem id=\"1\">1,2,3,4,5,6,7,8</elem>",
       "<value lc=\"1\">0.5</value>", 1},
      {"ansys", "MP", "T", "\nE,1,2,3,4,5,6,7,8\n", "D,ALL,UX,0.5\n", 1}};
  for (const Layout& layout : layouts) {
    const std::string text = deck_of(layout.solver, "mm-t-s-MPa", {.stretch = 1.5}).front().text;
    EXPECT_EQ(times(text, layout.element), 1) << text;
    EXPECT_EQ(times(text, layout.moved), 1) << text;
    std::vector<std::string> lines = block(text, layout.nodes, layout.ends);
    if (layout.solver == "febio") lines = block(text, layout.nodes, "?");
    if (layout.solver == "ansys") lines = card_test::lines_of(text);
    std::vector<std::array<double, 3>> corners;
    const std::regex number("-?[0-9]*\\.[0-9]*");
    for (const std::string& line : lines) {
      const bool node = layout.solver == "ansys"   ? line.starts_with("N,")
                        : layout.solver == "febio" ? line.find("<node id") != std::string::npos
                                                   : true;
      if (!node) continue;
      std::array<double, 3> corner{};
      auto at = std::sregex_iterator(line.begin(), line.end(), number);
      for (double& coordinate : corner) coordinate = std::stod((at++)->str());
      corners.push_back(corner);
    }
    ASSERT_EQ(corners.size(), 8U) << text;
    EXPECT_DOUBLE_EQ(volume(corners), std::pow(layout.edge, 3));
  }
}

TEST(UniaxialDeck, FitsTheColumnsOfFixedFormats) {
  for (const char* units : all_units) {
    for (const auto& line : card_test::lines_of(deck_of("lsdyna", units).front().text))
      EXPECT_LE(line.size(), 80U) << line;
    for (const DeckFile& file : deck_of("openradioss", units))
      for (const auto& line : card_test::lines_of(file.text)) EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(UniaxialDeck, NamesTheOpenRadiossRunTheSameEverywhere) {
  const auto files = deck_of("openradioss");
  EXPECT_EQ(files[0].name, "skin_test_0000.rad");
  EXPECT_EQ(files[1].name, "skin_test_0001.rad");
  EXPECT_TRUE(files[0].text.starts_with("#RADIOSS STARTER\n"));
  EXPECT_EQ(block(files[0].text, "/BEGIN", "/").front(), "skin_test");
  EXPECT_THAT(files[1].text, HasSubstr("/RUN/skin_test/1\n"));
  EXPECT_EQ(deck_job("cards/skin of a pig.k"), "skin_of_a_pig");
  EXPECT_EQ(deck_job("run_0000.rad"), "run");
  EXPECT_EQ(deck_of("openradioss", "si", {}, "a")[0].name, "a____0000.rad");  // four letters at least
  EXPECT_EQ(deck_job("wide--name.feb"), "wide-_name");                        // "--" would end an XML comment
}

// The speed's integral is the displacement, and 200 shear-wave times are long: in every unit system alike.
TEST(UniaxialDeck, StretchesSlowlyInOpenRadioss) {
  for (const char* units : all_units) {
    const UnitSystem system = unit_system(units);
    const auto points = block(deck_of("openradioss", units, {.stretch = 0.6}).front().text, "/FUNCT/1", "/");
    ASSERT_EQ(points.size(), 5U);  // title and four points
    double displacement = 0, last_time = 0, last_speed = 0;
    for (std::size_t i = 1; i < 4; ++i) {
      const double time = std::stod(points[i].substr(0, 20)), speed = std::stod(points[i].substr(20));
      displacement += (time - last_time) * (speed + last_speed) / 2;
      last_time = time;
      last_speed = speed;
    }
    EXPECT_NEAR(displacement, -0.4, 1e-12) << units;
    const double shear_wave = system.length * std::sqrt(1000 / 63.75e6);
    EXPECT_NEAR(last_time * system.time, 200 * shear_wave, 1e-9 * shear_wave) << units;
  }
  std::smatch found;
  const std::string text = deck_of("openradioss").front().text;
  ASSERT_TRUE(std::regex_search(text, found, std::regex("halfway: about ([^ ]+) of")));
  EXPECT_LT(std::stod(found[1]), 1e-3);
  EXPECT_GT(std::stod(found[1]), 0);
}

TEST(UniaxialDeck, RefusesTestsOutOfRange) {
  for (const UniaxialTest& test : {UniaxialTest{.stretch = 0}, UniaxialTest{.stretch = -1}, UniaxialTest{.stretch = 1},
                                   UniaxialTest{.stretch = std::nan("")}})
    EXPECT_THROW(deck_of("abaqus", "si", test), BadInput);
  for (const int increments : {0, -3, 10001})
    EXPECT_THROW(deck_of("abaqus", "si", {.stretch = 2, .increments = increments}), BadInput);
}

// Below 1e-10 CalculiX puts another D1 in its place, without a word on the result.
TEST(UniaxialDeck, RefusesUnitsInWhichCalculixIgnoresD1) {
  CardMaterial stiff = card_test::skin();
  stiff.bulk_modulus = 1e6 * stiff.terms.front().mu;
  try {
    uniaxial_deck(solver_named("calculix"), stiff, unit_system("si"), {}, "stiff");
    ADD_FAILURE() << "not refused";
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("units"), HasSubstr("mm-t-s-MPa")));
  }
  EXPECT_NO_THROW(uniaxial_deck(solver_named("calculix"), stiff, unit_system("mm-t-s-MPa"), {}, "stiff"));
  EXPECT_NO_THROW(uniaxial_deck(solver_named("abaqus"), stiff, unit_system("si"), {}, "stiff"));
}

class DeckProgram : public test::Program {
 protected:
  DeckProgram() { write("result.json", nlohmann::json{{"card", card_to_json(card_test::skin())}}.dump()); }
  test::Ended write_deck(const std::string& arguments) const {
    return run(test::words_of("card write result.json --deck uniaxial " + arguments));
  }
};

TEST_F(DeckProgram, PrintsAndWritesDecks) {
  const test::Ended printed = write_deck("--solver febio --stretch 1.5 --increments 7");
  EXPECT_EQ(printed.code, 0) << printed.err;
  EXPECT_EQ(printed.out, deck_of("febio", "si", {1.5, 7}, "uniaxial").front().text);
  const test::Ended written = write_deck("--solver calculix --units mm-t-s-MPa --file decks/skin_test.inp");
  EXPECT_EQ(written.code, 0) << written.err;
  EXPECT_EQ(read("decks/skin_test.inp"), deck_of("calculix").front().text);
  const test::Ended two = write_deck("--solver openradioss --units mm-t-s-MPa --file decks/skin_test.rad");
  EXPECT_EQ(two.code, 0) << two.err;
  EXPECT_EQ(read("decks/skin_test_0000.rad"), deck_of("openradioss")[0].text);
  EXPECT_EQ(read("decks/skin_test_0001.rad"), deck_of("openradioss")[1].text);
}

TEST_F(DeckProgram, RefusesWhatItCannotWrite) {
  EXPECT_EQ(write_deck("--solver openradioss").code, 2);  // two files, one output
  EXPECT_EQ(write_deck("--solver csv").code, 2);
  EXPECT_EQ(write_deck("--solver abaqus --stretch 1").code, 2);
  EXPECT_EQ(run(test::words_of("card write result.json --solver abaqus --stretch 2")).code, 2);
}

TEST_F(DeckProgram, WritesXmlThatParses) {
  CardMaterial odd = card_test::skin();
  odd.name = "skin <\"&'> -- of a pig";
  odd.comments = {"a -- b", "--"};
  for (const std::string job : {"skin_test", "a--b--.feb"}) {
    write("deck.feb", uniaxial_deck(solver_named("febio"), odd, unit_system("si"), {}, job).front().text);
    const std::string parse =
        "python3 -c \"import sys, xml.etree.ElementTree as tree; deck = tree.parse(sys.argv[1]);"
        "name = deck.find('Material/material').get('name');"
        "sys.exit(deck.find('MeshDomains/SolidDomain').get('mat') != name)\" ";
    EXPECT_EQ(std::system((parse + path("deck.feb")).c_str()), 0);
  }
}

}  // namespace
}  // namespace percal
