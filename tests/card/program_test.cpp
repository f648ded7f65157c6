// percal card write, run as a user runs it.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "card/card_test.hpp"
#include "percal/card/abaqus.hpp"
#include "percal/card/card_json.hpp"
#include "percal/card/lsdyna.hpp"

namespace percal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class CardProgram : public ::testing::Test {
 protected:
  CardProgram() {
    std::string name = (std::filesystem::temp_directory_path() / "percal-card-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder = name;
    write("result.json", nlohmann::json{{"card", card_to_json(card_test::skin())}}.dump());
  }
  ~CardProgram() override { std::filesystem::remove_all(folder); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
  std::string read(const std::string& name) const {
    std::ifstream file(folder / name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  // The exit code; standard output in "out", errors in "err" unless `redirection` says otherwise.
  int run(const std::string& arguments, const std::string& redirection = "> out 2> err") const {
    const std::string command =
        "cd '" + folder.string() + "' && '" PERCAL_PROGRAM "' card write " + arguments + " " + redirection;
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::filesystem::path folder;
};

TEST_F(CardProgram, PrintsTheCardOfAResult) {
  EXPECT_EQ(run("result.json --solver lsdyna --units mm-ms-kg-GPa"), 0) << read("err");
  EXPECT_EQ(read("out"), lsdyna_card(card_test::skin(), unit_system("mm-ms-kg-GPa")));
  EXPECT_EQ(run("result.json --solver calculix"), 0) << read("err");
  EXPECT_EQ(read("out"), abaqus_card(card_test::skin(), unit_system("si")));
}

TEST_F(CardProgram, WritesTheCardToAFile) {
  EXPECT_EQ(run("result.json --solver abaqus --units mm-t-s-MPa --file cards/skin.inp"), 0) << read("err");
  EXPECT_EQ(read("cards/skin.inp"), abaqus_card(card_test::skin(), unit_system("mm-t-s-MPa")));
  EXPECT_THAT(read("out"), HasSubstr("cards/skin.inp"));
}

TEST_F(CardProgram, RefusesBadInputWithExitCodeTwo) {
  EXPECT_EQ(run("nowhere.json --solver lsdyna"), 2);
  EXPECT_THAT(read("err"), HasSubstr("nowhere.json"));
  EXPECT_EQ(run("result.json --solver lsdyna --units mm-t-s-GPa"), 2);
  EXPECT_THAT(read("err"), HasSubstr("units"));
  EXPECT_EQ(run("result.json --solver ansys"), 2);
  write("fit.json", R"({"minima": [{"mu_Pa": 1e6, "alpha": 3}]})");
  EXPECT_EQ(run("fit.json --solver lsdyna --file fit.k"), 2);
  EXPECT_THAT(read("err"), AllOf(HasSubstr("fit.json"), HasSubstr("density")));
  EXPECT_FALSE(std::filesystem::exists(folder / "fit.k"));
}

TEST_F(CardProgram, ReportsWhatCannotBeWrittenWithExitCodeFour) {
  write("in_the_way", "a file, not a folder");
  EXPECT_EQ(run("result.json --solver lsdyna --file in_the_way/skin.k"), 4);
  EXPECT_EQ(run("result.json --solver lsdyna", "> /dev/full 2> err"), 4);
  EXPECT_THAT(read("err"), HasSubstr("standard output"));
}

}  // namespace
}  // namespace percal
