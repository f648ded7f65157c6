// The command line itself: help, version, words that it does not know.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include "support/program.hpp"
#include "support/sanitized.hpp"

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
  for (const std::string command :
       {"fit", "scale", "impact", "campaign", "identify", "calibrate", "predict", "dose", "design", "invert", "card"}) {
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
       "command: found \"identfy\" (did you mean identify?); accepted: fit, scale, impact, study, campaign, atlas, "
       "identify, "
       "calibrate, predict, "
       "dose, design, "
       "invert, card"},
      {{"campaign"}, "plan"},
      {{"campaign", test::guha2009 + "gold_sweep.toml", "--estimates"}, "--estimates"},
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

TEST_F(CommandLine, ADocumentOfAnotherCommandIsCalledWhatItIs) {
  const std::vector<std::pair<std::string, std::string>> documents{
      {test::guha2009 + "gold.toml", "found a scene, for percal impact"},
      {test::guha2009 + "similar.toml", "found a job of percal scale"},
      {test::guha2009 + "skin.toml", "found a job of percal identify"},
      {PERCAL_DATA "/synthetic/joint.toml", "found a job of percal calibrate"},
      {test::guha2009 + "gold_sweep.toml", "found a plan of percal campaign"},
      {test::guha2009 + "gold_dose.toml", "found a job of percal dose and percal design"}};
  const std::vector<std::pair<std::string, std::string>> commands{{"impact", "a scene"},
                                                                  {"study --omissions", "a scene"},
                                                                  {"scale", "percal scale"},
                                                                  {"identify", "identify"},
                                                                  {"calibrate", "percal calibrate"},
                                                                  {"campaign", "percal campaign"},
                                                                  {"dose", "percal dose"},
                                                                  {"design", "percal dose"},
                                                                  {"fit", "CSV files"},
                                                                  {"report", "the result.json"},
                                                                  {"card check", "a card of a solver"},
                                                                  {"card write --solver febio", "result.json"}};
  for (const auto& [document, kind] : documents)
    for (const auto& [command, accepted] : commands) {
      if (kind.find(test::words_of(command)[0]) != std::string::npos) continue;
      if (command.starts_with("study") && kind.find("scene") != std::string::npos) continue;
      auto words = test::words_of(command);
      words.push_back(document);
      const Ended ended = run(words);
      EXPECT_EQ(ended.code, 2) << command << " " << document;
      EXPECT_THAT(ended.err, AllOf(HasSubstr(kind), HasSubstr(accepted))) << command << " " << document;
    }
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(CommandLine, ASceneWithVelocityIsAskedWhetherItMeansSpeed) {
  std::string text = text_of(test::test_data + "layer.toml");
  write("s.toml", text.replace(text.find("speed"), 5, "velocity"));
  EXPECT_THAT(run({"impact", "s.toml"}).err, HasSubstr("\"velocity\": did you mean speed?"));
}

// Where addresses are few no thread can be begun, or no run; either is told, and no thread takes the program down.
TEST_F(CommandLine, ShortOfMemoryItTakesFewerThreadsOrSaysSo) {
#ifdef PERCAL_SANITIZED
  GTEST_SKIP() << "which want all addresses for themselves";
#endif
  for (const rlim_t megabytes : {150, 600})
    for (const std::string threads : {"2", "4096"}) {
      const Ended ended = run({"impact", test::test_data + "layer.toml", "--replicates", "40", "--threads", threads,
                               "--store", "store" + threads + std::to_string(megabytes), "--quiet"},
                              [megabytes] {
                                const rlimit limit{megabytes << 20, megabytes << 20};
                                setrlimit(RLIMIT_AS, &limit);
                              });
      EXPECT_THAT(ended.code, testing::AnyOf(0, 4, 127)) << megabytes << " MB, " << threads << ": " << ended.err;
      if (ended.code == 4) {
        EXPECT_THAT(ended.err, HasSubstr("memory"));
      }
      if (megabytes == 600) {
        EXPECT_EQ(ended.code, 0) << threads << ": " << ended.err;
      }
    }
}

TEST_F(CommandLine, ZeroThreadsMeansOneForEachCore) {
  EXPECT_EQ(run({"impact", test::test_data + "layer.toml", "--threads", "0", "--store", "store", "--quiet"}).code, 0);
}

}  // namespace
}  // namespace percal
