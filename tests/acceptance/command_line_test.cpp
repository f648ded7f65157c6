// The command line itself: help, version, words that it does not know.
#include <gmock/gmock.h>

#include "support/program.hpp"

namespace percal {
namespace {

using test::Ended;
using test::Program;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;

class CommandLine : public Program {};

TEST_F(CommandLine, TheHelpOfEveryCommandHasAnExample) {
  const Ended help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  for (const std::string command : {"fit", "scale", "impact", "identify", "calibrate", "card"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    const Ended ended = command == "card" ? run({command, "write", "--help"}) : run({command, "--help"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_THAT(ended.err, IsEmpty());
    EXPECT_THAT(ended.out, testing::ContainsRegex("Examples?: percal " + command)) << command;
  }
}

TEST_F(CommandLine, ShowsItsVersion) {
  const Ended ended = run({"--version"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, MatchesRegex("percal [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(CommandLine, RefusesWhatItDoesNotKnowWithExitCodeTwo) {
  const std::string scene = test::test_data + "layer.toml", job = test::guha2009 + "skin.toml";
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{}, "command"},
      {{"identfy", job},
       "command: found \"identfy\" (did you mean identify?); accepted: fit, scale, impact, study, identify, calibrate, card"},
      {{"identify"}, "job"},
      {{"identify", job, job}, "skin.toml"},
      {{"impact", scene, "--threads", "-1"}, "--threads"},
      {{"impact", scene, "--threads", "many"}, "--threads"},
      {{"impact", scene, "--threads", "1.5"}, "--threads"},
      {{"impact", scene, "--threads", "5000"}, "--threads"},
      {{"identify", job, "--threads", "two"}, "--threads"},
      {{"impact", scene, "--replicates", "0"}, "--replicates"},
      {{"impact", scene, "--elements-per-radius", "0"}, "--elements-per-radius"},
      {{"impact", scene, "--arithmetic", "half"}, "--arithmetic"},
      {{"impact", scene, "--verbose"}, "--verbose"},
      {{"fit", PERCAL_DATA "/public/treloar1944_rubber_primary.csv", "--residual", "squared"}, "--residual"},
      {{"fit", PERCAL_DATA "/public/treloar1944_rubber_primary.csv", "--threads", "2"}, "--threads"},
      {{"card", "raed", "x"}, "command: found \"raed\""},
  };
  for (const auto& [arguments, word] : wrong) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 2) << testing::PrintToString(arguments);
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_THAT(ended.err, AllOf(HasSubstr(word), Not(HasSubstr("internal error"))))
        << testing::PrintToString(arguments);
  }
  EXPECT_THAT(files(), IsEmpty()) << "nothing was written";
}

TEST_F(CommandLine, ZeroThreadsMeansOneForEachCore) {
  EXPECT_EQ(run({"impact", test::test_data + "layer.toml", "--threads", "0", "--store", "store", "--quiet"}).code, 0);
}

}  // namespace
}  // namespace percal
