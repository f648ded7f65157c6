// percal card write, run as a user runs it.
#include "support/program.hpp"

#include <gmock/gmock.h>

#include "card/card_test.hpp"
#include "percal/card/abaqus.hpp"
#include "percal/card/card_json.hpp"
#include "percal/card/lsdyna.hpp"

namespace percal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

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
  EXPECT_EQ(lsdyna.out, lsdyna_card(card_test::skin(), unit_system("mm-ms-kg-GPa")));
  const test::Ended calculix = write_card("result.json --solver calculix");
  EXPECT_EQ(calculix.code, 0) << calculix.err;
  EXPECT_EQ(calculix.out, abaqus_card(card_test::skin(), unit_system("si")));
}

TEST_F(CardProgram, WritesTheCardToAFile) {
  const test::Ended ended = write_card("result.json --solver abaqus --units mm-t-s-MPa --file cards/skin.inp");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(read("cards/skin.inp"), abaqus_card(card_test::skin(), unit_system("mm-t-s-MPa")));
  EXPECT_THAT(ended.out, HasSubstr("cards/skin.inp"));
}

TEST_F(CardProgram, RefusesBadInputWithExitCodeTwo) {
  const test::Ended nowhere = write_card("nowhere.json --solver lsdyna");
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("nowhere.json"));
  const test::Ended units = write_card("result.json --solver lsdyna --units mm-t-s-GPa");
  EXPECT_EQ(units.code, 2);
  EXPECT_THAT(units.err, HasSubstr("units"));
  EXPECT_EQ(write_card("result.json --solver ansys").code, 2);
  write("fit.json", R"({"minima": [{"mu_Pa": 1e6, "alpha": 3}]})");
  const test::Ended fit = write_card("fit.json --solver lsdyna --file fit.k");
  EXPECT_EQ(fit.code, 2);
  EXPECT_THAT(fit.err, AllOf(HasSubstr("fit.json"), HasSubstr("density")));
  EXPECT_FALSE(std::filesystem::exists(path("fit.k")));
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
