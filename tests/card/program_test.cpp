// percal card write, run as a user runs it.
#include "support/program.hpp"

#include <gmock/gmock.h>

#include "card/card_test.hpp"
#include "percal/card/card_json.hpp"

namespace percal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CardProgram : public test::Program {
 protected:
  CardProgram() { write("result.json", nlohmann::json{{"card", card_to_json(card_test::skin())}}.dump()); }

  test::Ended write_card(const std::string& arguments, const std::function<void()>& in_child = {}) const {
    return run(test::words_of("card write " + arguments), in_child);
  }
};

TEST_F(CardProgram, PrintsTheCardOfAResult) {
  const test::Ended lsdyna = write_card("result.json --solver lsdyna --units mm-ms-kg-GPa");
  EXPECT_EQ(lsdyna.code, 0) << lsdyna.err;
  EXPECT_EQ(lsdyna.out, card_test::write_card("lsdyna", card_test::skin(), unit_system("mm-ms-kg-GPa")));
  const test::Ended calculix = write_card("result.json --solver calculix");
  EXPECT_EQ(calculix.code, 0) << calculix.err;
  EXPECT_EQ(calculix.out, card_test::write_card("abaqus", card_test::skin(), unit_system("si")));
}

TEST_F(CardProgram, WritesTheCardToAFile) {
  const test::Ended ended = write_card("result.json --solver abaqus --units mm-t-s-MPa --file cards/skin.inp");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(read("cards/skin.inp"), card_test::write_card("abaqus", card_test::skin(), unit_system("mm-t-s-MPa")));
  EXPECT_THAT(ended.out, HasSubstr("cards/skin.inp"));
}

TEST_F(CardProgram, RefusesBadInputWithExitCodeTwo) {
  const test::Ended nowhere = write_card("nowhere.json --solver lsdyna");
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("nowhere.json"));
  const test::Ended units = write_card("result.json --solver lsdyna --units mm-t-s-GPa");
  EXPECT_EQ(units.code, 2);
  EXPECT_THAT(units.err, HasSubstr("units"));
  EXPECT_EQ(write_card("result.json --solver nastran").code, 2);
  write("fit.json", R"({"cards": [{"name": "fit", "mu_true_Pa": 1e6, "alpha": 3}]})");
  const test::Ended fit = write_card("fit.json --solver lsdyna --file fit.k");
  EXPECT_EQ(fit.code, 2);
  EXPECT_THAT(fit.err, AllOf(HasSubstr("fit.json"), HasSubstr("density")));
  EXPECT_FALSE(std::filesystem::exists(path("fit.k")));
}

TEST_F(CardProgram, WritesACardOfContradictoryDataOnlyByForce) {
  CardMaterial contradicted = card_test::skin();
  contradicted.contradiction = "skin: the depths alone want another modulus.";
  write("result.json", nlohmann::json{{"card", card_to_json(contradicted)}}.dump());
  for (const std::string& solver : solver_words()) {
    const std::string command = "result.json --solver " + solver;
    const test::Ended refused = write_card(command);
    EXPECT_EQ(refused.code, 2) << solver;
    EXPECT_THAT(refused.err, AllOf(HasSubstr("want another modulus"), HasSubstr("--force")));
    const test::Ended forced = write_card(command + " --force");
    EXPECT_EQ(forced.code, 0) << forced.err;
    EXPECT_THAT(forced.out, HasSubstr("WARNING: the data behind this card contradict each other")) << solver;
  }
}

TEST_F(CardProgram, ReadsItsOwnCardsAndWritesThemAgain) {
  for (const std::string& solver : solver_words()) {
    SCOPED_TRACE(solver);
    write_card("result.json --solver " + solver + " --units um-ng-us-MPa --file skin." + solver);
    const test::Ended text = run(test::words_of("card read skin." + solver));
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_THAT(text.out, AllOf(HasSubstr("63.75 MPa"), HasSubstr("15 MPa"), HasSubstr("um-ng-us-MPa")));
    const test::Ended ended = run(test::words_of("card read --json skin." + solver));
    write("again.json", ended.out);
    const test::Ended again = write_card("again.json --solver " + solver + " --units um-ng-us-MPa");
    EXPECT_EQ(again.code, 0) << again.err;
  }
}

TEST_F(CardProgram, AsksForTheUnitsOfAForeignCard) {
  write("foreign.inp", "*MATERIAL, NAME=X\n*DENSITY\n1e-9\n*HYPERELASTIC, OGDEN, N=1\n63.75, 8.5, 6e-4\n");
  const test::Ended without = run(test::words_of("card read foreign.inp"));
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("--units"));
  const test::Ended with = run(test::words_of("card read foreign.inp --units mm-t-s-MPa"));
  EXPECT_EQ(with.code, 0) << with.err;
  EXPECT_THAT(with.out, HasSubstr("63.75 MPa"));
  write("nothing.txt", "density\n");
  EXPECT_THAT(run(test::words_of("card read nothing.txt --units si")).err, HasSubstr("no keyword of a solver"));
}

TEST_F(CardProgram, ChecksWhatACardMeans) {
  write_card("result.json --solver febio --file skin.feb");
  const test::Ended ended = run(test::words_of("card check skin.feb --stretch 0.5:1.5 --points 3 --csv curve.csv"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  // 15 MPa (1.5^7.5 - 1.5^-5.25) = 312.10 MPa
  EXPECT_THAT(ended.out, AllOf(HasSubstr("312.1"), HasSubstr("incompressible"), HasSubstr("Drucker")));
  EXPECT_THAT(read("curve.csv"), HasSubstr("mode,stretch,nominal_stress [Pa]"));
  EXPECT_EQ(run(test::words_of("card check skin.feb --stretch 2:1")).code, 2);
  EXPECT_EQ(run(test::words_of("card check skin.feb --mode twist")).code, 2);
}

// A curve needs neither density nor bulk modulus: not of a fit, not of an incompressible card.
TEST_F(CardProgram, ChecksACardWithoutDensityOrBulkModulus) {
  write("fit.json", R"({"cards": [{"name": "fit", "mu_true_Pa": 1e6, "alpha": 3}]})");
  const test::Ended fit = run(test::words_of("card check fit.json"));
  EXPECT_EQ(fit.code, 0) << fit.err;
  EXPECT_THAT(fit.out, AllOf(HasSubstr("density: not given"), HasSubstr("bulk modulus K: not given")));
  write("gel.inp", "*MATERIAL, NAME=gel\n*HYPERELASTIC, OGDEN, N=1\n0.1, 9., 0.\n");
  const test::Ended check = run(test::words_of("card check gel.inp --units mm-t-s-MPa --csv curve.csv"));
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.out,
              AllOf(HasSubstr("without limit: incompressible"), Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
  EXPECT_THAT(read("curve.csv"), AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf "))));
  write("gel.json", run(test::words_of("card read --json gel.inp --units mm-t-s-MPa")).out);
  const test::Ended written = write_card("gel.json --solver abaqus");
  EXPECT_EQ(written.code, 2);
  EXPECT_THAT(written.err, HasSubstr("--bulk-to-shear"));
}

TEST_F(CardProgram, SaysFirstWhatWrongUnitsMake) {
  write("gel.inp", "*MATERIAL, NAME=gel\n*DENSITY\n1e-9\n*HYPERELASTIC, OGDEN, N=1\n0.1, 9., 1e-2\n");
  const test::Ended read = run(test::words_of("card read gel.inp --units mm-kg-ms-GPa"));
  EXPECT_EQ(read.code, 0) << read.err;
  EXPECT_TRUE(read.out.starts_with("warning: 1 kg/m3 is no density of a solid")) << read.out;
}

TEST_F(CardProgram, SaysThatElementsErodeByWhatItPassesOver) {
  write("eff.k",
        "*MAT_077_O\n         1    1.0E-6    0.4990\n      0.01\n       8.0\n*MAT_ADD_EROSION\n"
        "         1     0.000     0.000     0.000     0.900\n         0\n");
  const test::Ended read = run(test::words_of("card read eff.k --units mm-kg-ms-GPa"));
  EXPECT_EQ(read.code, 0) << read.err;
  EXPECT_THAT(read.out, AllOf(HasSubstr("passed over: EFFEPS of *MAT_ADD_EROSION: 0.9"), Not(HasSubstr("no erosion"))));
}

TEST_F(CardProgram, NamesTheFileThatADeckIsRunFrom) {
  EXPECT_EQ(write_card("result.json --solver abaqus --deck uniaxial --file decks/c.inp").code, 0);
  EXPECT_THAT(read("decks/c.inp"), HasSubstr("abaqus job=c interactive"));
  EXPECT_EQ(write_card("result.json --solver lsdyna --deck uniaxial --file decks/c").code, 0);
  EXPECT_THAT(read("decks/c.k"), HasSubstr("i=c.k"));
}

TEST_F(CardProgram, WritesATableThatFitReads) {
  const test::Ended table = write_card("result.json --solver csv --units mm-t-s-MPa --range 0.6:1.8 --file skin.csv");
  EXPECT_EQ(table.code, 0) << table.err;
  const test::Ended fit = run(test::words_of("fit skin.csv --out fit --no-intervals --quiet"));
  EXPECT_EQ(fit.code, 0) << fit.err;
  const auto best = result("fit/result.json")["cards"][0];
  EXPECT_NEAR(best["mu_true_Pa"].get<double>(), 63.75e6, 63.75);
  EXPECT_NEAR(best["alpha"].get<double>(), 8.5, 1e-5);
  std::vector<std::string> words = test::words_of("card write fit/result.json --solver ansys --nu 0.49 --name gel");
  words.insert(words.end(), {"--density", "1010 kg/m3"});
  const test::Ended card = run(words);
  EXPECT_EQ(card.code, 0) << card.err;
  EXPECT_THAT(card.out, AllOf(HasSubstr("! name: gel"), HasSubstr("SHA-256"), HasSubstr("skin.csv")));
  run(test::words_of("fit skin.csv --where mode=uniaxial --out chosen --no-intervals --quiet"));
  EXPECT_EQ(result("chosen/result.json")["cards"][0]["name"], "uniaxial");
  words.back() = "1010 kg";
  EXPECT_EQ(run(words).code, 2);
}

TEST_F(CardProgram, ReportsWhatCannotBeWrittenWithExitCodeFour) {
  write("in_the_way", "a file, not a folder");
  EXPECT_EQ(write_card("result.json --solver lsdyna --file in_the_way/skin.k").code, 4);
  const test::Ended full = write_card("result.json --solver lsdyna", test::into_a_full_disk);
  EXPECT_EQ(full.code, 4);
  EXPECT_THAT(full.err, HasSubstr("standard output"));
}

}  // namespace
}  // namespace percal
