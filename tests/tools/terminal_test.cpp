// Colours, widths and progress: on a terminal, and nowhere else.
#include "tools/terminal.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace percal {
namespace {

using test::Terminal;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const std::string curve = PERCAL_DATA "/synthetic/joint_curve.csv";
const std::string scene = test::test_data + "layer.toml";
const std::string escape = "\033[", time_left = "[0-9]:[0-9][0-9] left", red_name = "\033[31mpercal:\033[0m";

TEST_F(Terminal, ErrorsAreRed) { EXPECT_THAT(on_terminal({"impact", "nowhere.toml"}), HasSubstr(red_name)); }

TEST_F(Terminal, HeadersOfTablesAreBold) { EXPECT_THAT(on_terminal({"fit", curve}), HasSubstr("\033[1m  ")); }

TEST_F(Terminal, NamesMoveNothing) {
  const std::string evil = "\\u001b[31mevil\\u001b]0;title\\u0007";  // as TOML writes it
  std::string text = text_of(scene);
  text.replace(text.find("tungsten carbide"), 16, evil);
  text.replace(text.find("name = \"layer\""), 14, "name = \"" + evil + "\"");
  const std::string file = "a\033[31mb.toml";
  write(file, text);
  write("unknown.toml", text + "\n[\"" + evil + "\"]\n");
  std::string seen = on_terminal({"impact", file, "--store", "a.store"}, {{"NO_COLOR", "1"}});
  seen += on_terminal({"impact", "unknown.toml"}, {{"NO_COLOR", "1"}});
  seen += on_terminal({"impact", "no\033[31mwhere.toml"}, {{"NO_COLOR", "1"}});
  seen += on_terminal({"fit", "no\033[31mwhere.csv"}, {{"NO_COLOR", "1"}});
  seen += on_terminal({"report", "a\033[31mb.out/result.json"}, {{"NO_COLOR", "1"}});
  seen += on_terminal({"report", "--\033[31m"}, {{"NO_COLOR", "1"}});
  EXPECT_THAT(seen, AllOf(Not(HasSubstr("\033[31m")), Not(HasSubstr("\033]")), Not(HasSubstr("\007"))));
  EXPECT_THAT(seen, HasSubstr("\\x1b[31mevil"));
}

TEST_F(Terminal, NothingIsColouredWhereNoColorIsSet) {
  EXPECT_THAT(on_terminal({"fit", curve}, {{"NO_COLOR", "1"}}), Not(HasSubstr(escape + "1m")));
  EXPECT_THAT(on_terminal({"impact", "nowhere.toml"}, {{"NO_COLOR", "1"}}), Not(HasSubstr(escape)));
}

TEST_F(Terminal, AnEmptyNoColorAsksForNothing) {
  EXPECT_THAT(on_terminal({"impact", "nowhere.toml"}, {{"NO_COLOR", ""}}), HasSubstr(red_name));
}

TEST_F(Terminal, NothingIsColouredOnADumbTerminal) {
  EXPECT_THAT(on_terminal({"impact", "nowhere.toml"}, {{"TERM", "dumb"}}), Not(HasSubstr(escape)));
}

TEST_F(Terminal, LongStepsShowHowMuchTimeIsLeft) {
  EXPECT_THAT(on_terminal({"impact", scene, "--store", "a.store"}),
              AllOf(HasSubstr("impact  3/3"), ContainsRegex(time_left)));
  EXPECT_THAT(on_terminal({"fit", curve, "--bootstrap", "300"}),
              AllOf(HasSubstr("bootstrap  "), ContainsRegex(time_left)));
}

TEST_F(Terminal, QuietShowsNoProgress) {
  EXPECT_EQ(on_terminal({"impact", scene, "--store", "a.store", "--quiet"}), "");
}

TEST_F(Terminal, APipeHasNeitherColoursNorProgress) {
  for (const auto& arguments : {std::vector<std::string>{"impact", scene, "--store", "a.store"}, {"fit", curve}}) {
    const test::Ended ended = run(arguments);
    EXPECT_THAT(ended.out + ended.err, AllOf(Not(HasSubstr("\033")), Not(ContainsRegex(time_left))));
    EXPECT_NE(ended.out, "");
  }
}

// Characters of the longest line, without colours.
std::size_t widest(const std::string& text) {
  std::istringstream lines(text);
  std::size_t most = 0;
  for (std::string line; std::getline(lines, line);) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '\033')
        i = line.find('m', i);
      else if (line[i] != '\r' && (static_cast<unsigned char>(line[i]) & 0xc0) != 0x80)
        ++count;
    }
    most = std::max(most, count);
  }
  return most;
}

// Lines of tables and sentences; titles and names of files stay whole.
std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ") || line.starts_with("\033[1m  ")) all += line + "\n";
  return all;
}

TEST_F(Terminal, WideTablesFitIntoNarrowOnes) {
  const std::vector<std::string> command{"fit", PERCAL_DATA "/public/treloar1944_rubber_primary.csv", "--compare"};
  const std::string wide = on_terminal(command, {}, 400), narrow = on_terminal(command, {}, 50);
  ASSERT_GT(widest(indented(wide)), 100U);
  EXPECT_LE(widest(indented(narrow)), 50U);
  for (const char* table : {"left out", "above best"}) {
    EXPECT_THAT(wide, Not(HasSubstr(table + std::string(": "))));
    EXPECT_THAT(narrow, HasSubstr(table + std::string(": "))) << "a list of cells";
  }
}

TEST_F(Terminal, HelpIsFoldedAtWordsAndExamplesAsAShellReadsThem) {
  for (const auto& command : {std::vector<std::string>{"--help"}, {"study", "--help"}, {"help", "calibrate"}}) {
    EXPECT_LE(widest(on_terminal(command, {}, 80)), 80U);
  }
  EXPECT_THAT(on_terminal({"--help"}, {}, 80),
              HasSubstr("exponents,\r\n                              every minimum, models compared"));
  EXPECT_THAT(on_terminal({"help", "fit"}, {}, 60), HasSubstr(" \\\r\n            --"));
}

TEST_F(Terminal, TheAnswerOfAFitIsOneScreenOfEightyColumns) {
  const std::string answer = on_terminal({"fit", PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {}, 80);
  EXPECT_LE(widest(indented(answer)), 80U);
  EXPECT_LE(std::count(answer.begin(), answer.end(), '\n'), 24);
}

}  // namespace
}  // namespace percal
