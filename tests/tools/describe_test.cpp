// Completion, manual pages and suggestions: all from the options themselves.
#include <gmock/gmock.h>

#include <cstdlib>

#include "support/program.hpp"

namespace percal {
namespace {

using test::Ended;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Completion : public test::Program {
 protected:
  // What bash offers for the last of these words.
  std::vector<std::string> offered(const std::vector<std::string>& words) const {
    write("percal.bash", run({"completion", "bash"}).out);
    std::string script = "source '" + path("percal.bash") + "'\ncd '" + folder.string() + "'\nCOMP_WORDS=(percal";
    for (const auto& word : words) script += " '" + word + "'";
    script +=
        ")\nCOMP_CWORD=" + std::to_string(words.size()) + "\n_percal 2>/dev/null\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
    write("complete.sh", script);
    EXPECT_EQ(std::system(("bash '" + path("complete.sh") + "' > '" + path("offered") + "'").c_str()), 0);
    std::vector<std::string> found;
    std::istringstream lines(read("offered"));
    for (std::string line; std::getline(lines, line);)
      if (!line.empty()) found.push_back(line);
    return found;
  }
};

using Words = std::vector<std::string>;

TEST_F(Completion, OfCommands) {
  EXPECT_EQ(offered({"im"}), Words{"impact"});
  EXPECT_EQ(offered({"card", "w"}), Words{"write"});
}

TEST_F(Completion, OfOptions) {
  EXPECT_EQ(offered({"impact", "scene.toml", "--elem"}), Words{"--elements-per-radius"});
  EXPECT_THAT(offered({"fit", "--"}), AllOf(Contains("--no-intervals"), Not(Contains("--threads"))));
}

TEST_F(Completion, OfTheWordsThatAnOptionTakes) {
  EXPECT_EQ(offered({"card", "write", "--solver", "f"}), Words{"febio"});
  EXPECT_EQ(offered({"card", "write", "--solver", "=", "f"}), Words{"febio"});
  EXPECT_EQ(offered({"study", "scene.toml", "--replicates", ""}), Words{});
  EXPECT_EQ(offered({"new", "sc"}), (Words{"scene", "scale"}));
}

TEST_F(Completion, OfFilesAndFolders) {
  write("my scene.toml", "");
  write("my folder/x", "");
  EXPECT_EQ(offered({"impact", "my s"}), Words{"my scene.toml"});
  EXPECT_EQ(offered({"impact", "--out", "my"}), Words{"my folder"});
}

TEST_F(Completion, TheScriptsAreValid) {
  for (const std::string shell : {"bash", "zsh"}) {
    if (std::system(("command -v " + shell + " > /dev/null").c_str()) != 0) continue;
    write("script", run({"completion", shell}).out);
    EXPECT_EQ(std::system((shell + " -n '" + path("script") + "'").c_str()), 0) << shell;
  }
}

class Manual : public test::Program {
 protected:
  Manual() { EXPECT_EQ(run({"man", "--all", "man"}).code, 0); }
  std::vector<std::string> pages() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "man"))
      names.push_back(entry.path().filename().string());
    return names;
  }
};

TEST_F(Manual, HasAPageForEveryCommand) {
  EXPECT_THAT(pages(), AllOf(Contains("percal.1"), Contains("percal-impact.1"), Contains("percal-card-write.1"),
                             Contains("percal-man.1")));
  EXPECT_EQ(run({"man", "card", "write"}).out, read("man/percal-card-write.1"));
  EXPECT_THAT(run({"man", "crad"}), testing::Field(&Ended::code, 2));
}

// The options as the help has them: every word that begins with "--" where an option is described.
TEST_F(Manual, HasEveryOptionOfTheHelp) {
  for (const std::string& page : pages()) {
    Words command = test::words_of(page.substr(0, page.size() - 2));
    std::string words = page.substr(0, page.size() - 2);
    std::replace(words.begin(), words.end(), '-', ' ');
    command = test::words_of(words);
    command.erase(command.begin());
    command.push_back("--help");
    std::string text = read("man/" + page);
    for (auto at = text.find("\\-"); at != std::string::npos; at = text.find("\\-", at)) text.erase(at, 1);
    std::istringstream lines(run(command).out);
    int options = 0;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("  -")) continue;
      std::string names = line.substr(2, line.find_first_of(" :", 2) - 2);
      if (const auto no = names.find("{false}"); no != std::string::npos) names.erase(no, 7);  // of --no-intervals
      std::replace(names.begin(), names.end(), ',', ' ');
      for (const std::string& name : test::words_of(names)) {
        EXPECT_THAT(text, HasSubstr("\\fB" + name + "\\fR")) << page;
        ++options;
      }
    }
    EXPECT_GT(options, 0) << page;
  }
}

TEST_F(Manual, IsFormattedWithoutAWarning) {
  if (std::system("command -v groff > /dev/null") != 0) GTEST_SKIP() << "no groff";
  for (const std::string& page : pages()) {
    const std::string command =
        "groff -man -ww -Tutf8 -z '" + path("man/" + page) + "' > '" + path("warnings") + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_THAT(read("warnings"), IsEmpty()) << page;
  }
}

class Suggestion : public test::Program {};

TEST_F(Suggestion, OfACommandThatHelpIsAskedFor) {
  EXPECT_THAT(run({"help", "crad"}).err, HasSubstr("did you mean card?"));
  EXPECT_EQ(run({"help", "card", "write"}).out, run({"card", "write", "--help"}).out);
  EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
}

TEST_F(Suggestion, OfTheOptionThatWasMeant) {
  const std::string scene = test::test_data + "layer.toml";
  for (const Words& words :
       {Words{"impact", scene, "--elments-per-radius", "5"}, Words{"impact", "--elments-per-radius=5"}}) {
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_THAT(
        ended.err,
        HasSubstr("percal: --elments-per-radius: found an unknown option (did you mean --elements-per-radius?)"));
  }
}

TEST_F(Suggestion, NamesTheHelpWhereSomethingIsMissing) {
  EXPECT_THAT(run({"card", "write"}).err, HasSubstr("see percal card write --help"));
}

}  // namespace
}  // namespace percal
