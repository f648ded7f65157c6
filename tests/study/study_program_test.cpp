// percal study and percal impact --accuracy as a user runs them, on meshes of some milliseconds.
#include <gmock/gmock.h>

#include "support/program.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> ladder_arguments{"--error-vs-time", "--meshes", "3,4,5,6", "--replicates", "3",
                                                "--threads",       "1"};

class Study : public test::Program {
 protected:
  // tests/data/layer.toml as a dent: slow, and nothing erodes. In the test's own folder, beside which its results go.
  std::string scene(const std::vector<std::pair<std::string, std::string>>& replacements = {}) const {
    std::string text = text_of(test::test_data + "layer.toml");
    const std::string erosion = "[target.erosion]\nstrain = 0.6\nmeasure = \"true\"\n";
    text.erase(text.find(erosion), erosion.size());
    text.replace(text.find("120 m/s"), 7, "40 m/s");
    for (const auto& [from, to] : replacements) text.replace(text.find(from), from.size(), to);
    return write("dent.toml", text);
  }
  Ended study(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "study");
    arguments.insert(arguments.end(), ladder_arguments.begin(), ladder_arguments.end());
    return run(arguments);
  }
};

TEST_F(Study, PrintsTheTableAndWritesJsonCsvAndPlot) {
  const std::string file = scene();
  const Ended ended = study({file, "--markdown", "page.md"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(read("page.md"), HasSubstr("](dent.out/error_against_time.svg)"));
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(ended.out, AllOf(HasSubstr("Extrapolated depth"), HasSubstr("The cheapest setting for an error"),
                               testing::Not(HasSubstr("element-steps"))));
  const json found = result("dent.out/result.json");
  EXPECT_EQ(found["study"], "error vs time");
  EXPECT_EQ(found["meshes"].size(), 4u);
  EXPECT_EQ(found["half_steps"].size(), 2u);
  EXPECT_EQ(found["advice"].size(), 3u);
  EXPECT_EQ(found["cost"]["runs"], 21);
  EXPECT_THAT(read("dent.out/error_vs_time.csv"), HasSubstr("error_of_mean_of_3_high"));
  EXPECT_THAT(read("dent.out/error_against_time.csv"), HasSubstr("\"mean of 10\""));
  const bool has_plot = files("dent.out").contains("dent.out/error_against_time.svg");
  EXPECT_NE(has_plot, ended.out.find("the figures were not drawn") != std::string::npos);
  if (has_plot) {
    EXPECT_THAT(read("dent.out/error_against_time.svg"), AllOf(HasSubstr("<svg"), HasSubstr("mean of 10")));
  }
  const std::string details = study({file, "--details"}).out;
  EXPECT_THAT(details,
              AllOf(HasSubstr("half the time step"), HasSubstr("double precision"), HasSubstr("element-steps")));
}

TEST_F(Study, WithoutAFolderTheMarkdownHasItsFiguresBesideIt) {
  ASSERT_EQ(study({scene(), "--out", "none", "--markdown", "pages/page.md"}).code, 0);
  EXPECT_THAT(read("pages/page.md"), HasSubstr("](./error_against_time.svg)"));
  const auto written = files();
  EXPECT_TRUE(written.contains("pages/error_against_time.csv"));
  EXPECT_FALSE(written.contains("dent.out/result.json"));
}

TEST_F(Study, WithoutGnuplotSaysThatNoPlotWasDrawn) {
  std::vector<std::string> arguments{"study", scene()};
  arguments.insert(arguments.end(), ladder_arguments.begin(), ladder_arguments.end());
  const Ended ended = run(arguments, [] { setenv("PATH", "/nowhere", 1); });
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("the figures were not drawn: no gnuplot"));
  EXPECT_EQ(files("dent.out"), (std::set<std::string>{"dent.out/error_vs_time.csv", "dent.out/error_against_time.csv",
                                                      "dent.out/mesh_study.csv", "dent.out/result.json"}));
}

TEST_F(Study, OfASceneThatPassesThroughGivesAnAccountAndCodeThree) {
  const Ended ended = study({scene({{"\"600 um\"", "\"21 um\""}})});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("passed through"), HasSubstr("0 meshes stopped")));
  const json found = result("dent.out/result.json");
  EXPECT_EQ(found["convergence"]["outcome"], "too few grids");
  for (const json& advice : found["advice"]) EXPECT_EQ(advice["found"], false);
}

TEST_F(Study, ThePageNamesEveryKeyOfTheResult) {
  const json found = json::parse(study({scene(), "--json"}).out);
  const std::string page = text_of(test::docs + "formats/study.md");
  const std::function<void(const json&)> look = [&](const json& value) {
    if (value.is_object())
      for (const auto& [key, inner] : value.items()) {
        EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
        if (key != "input") look(inner);
      }
    if (value.is_array() && !value.empty()) look(value.front());
  };
  look(found);
  EXPECT_GT(found["meshes"][0].size(), 15u);
}

TEST_F(Study, RefusesBadOptions) {
  const std::string file = scene();
  EXPECT_EQ(run({"study", file}).code, 2);
  EXPECT_EQ(run({"study", "--error-vs-time"}).code, 2);
  EXPECT_EQ(run({"study", file, "--error-vs-time", "--meshes", "5,7,10"}).code, 2);
  EXPECT_EQ(run({"study", file, "--error-vs-time", "--meshes", "5,7,10,x"}).code, 2);
  EXPECT_EQ(run({"study", file, "--error-vs-time", "--replicates", "2"}).code, 2);
  EXPECT_EQ(files(), (std::set<std::string>{"dent.toml"})) << "nothing was run";
}

TEST_F(Study, ACheckRunsNothing) {
  const Ended ended = study({scene(), "--check"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("21 runs"));
  EXPECT_EQ(files(), (std::set<std::string>{"dent.toml"}));
}

TEST_F(Study, IsWhatAnAccuracyOfAnImpactComesFrom) {
  const std::string file = scene();
  ASSERT_EQ(study({file}).code, 0);
  const Ended ended = run({"impact", file, "--accuracy", "50%", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const json found = json::parse(ended.out), accuracy = found["accuracy"];
  EXPECT_EQ(accuracy["study_was_kept"], true);
  EXPECT_EQ(accuracy["study_cpu_s"], 0.0);
  EXPECT_EQ(accuracy["ladder"]["elements_per_radius"], (std::vector<int>{3, 4, 5, 6}));
  EXPECT_EQ(accuracy["target_error"], 0.5);
  EXPECT_LE(accuracy["error"], 0.5);
  EXPECT_NEAR(accuracy["error"],
              std::hypot(accuracy["discretisation_error"].get<double>(), accuracy["noise_error"].get<double>()), 1e-12);
  EXPECT_EQ(found["runs"].size(), accuracy["replicates"].get<std::size_t>());
  EXPECT_EQ(found["cost"]["reused"], found["runs"].size()) << "the ladder has run this setting";
  EXPECT_THAT(found["input"]["toml"].get<std::string>(),
              HasSubstr("elements_per_radius = " + std::to_string(accuracy["elements_per_radius"].get<int>())));
  EXPECT_THAT(run({"impact", file, "--accuracy", "50%"}).out, HasSubstr("Estimated error"));
}

TEST_F(Study, OfALocalRuleLeavesTheMeshAndPicksTheRuns) {
  const std::string file = write("channel.toml", text_of(test::test_data + "layer.toml"));
  const Ended ended = study({file});
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("from the finest"), HasSubstr("no limit"), HasSubstr("scene's own mesh")));
  const json accuracy = json::parse(run({"impact", file, "--accuracy", "20%", "--json"}).out)["accuracy"];
  EXPECT_EQ(accuracy["study_was_kept"], true);
  EXPECT_EQ(accuracy["elements_per_radius"], 4);
  EXPECT_TRUE(accuracy["discretisation_error"].is_null());
  EXPECT_LE(accuracy["noise_error"], 0.2);
}

// A ball into gel on a mesh of the atlas, a run of some hundredths of a second.
std::string ball_into_gel(const std::string& further = "") {
  return "[particle]\nradius = \"1 mm\"\ndensity = \"2500 kg/m3\"\nspeed = \"100 m/s\"\n[target]\ndensity = \"1000 "
         "kg/m3\"\nmu = "
         "\"800 kPa\"\nalpha = 8\ndepth = \"40 mm\"\n" +
         further + "[target.erosion]\nstrain = 0.6\n[mesh]\nelements_per_radius = 6\n";
}

TEST_F(Study, WhereTheAtlasKnowsTheScatterAnAccuracyNeedsNoLadder) {
  const std::string file = write("ball.toml", ball_into_gel());
  const Ended ended = run({"impact", file, "--accuracy", "2%", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const json found = json::parse(ended.out), accuracy = found["accuracy"], atlas = accuracy["atlas"];
  EXPECT_EQ(accuracy["from"], "the atlas");
  EXPECT_TRUE(accuracy["ladder"].is_null());
  EXPECT_EQ(accuracy["study_cpu_s"], 0.0);
  EXPECT_EQ(accuracy["elements_per_radius"], 6);
  EXPECT_LE(accuracy["error"], 0.02);
  EXPECT_EQ(found["cost"]["runs"], accuracy["replicates"]) << "these, and no others";
  EXPECT_EQ(found["runs"].size(), accuracy["replicates"].get<std::size_t>());
  EXPECT_LT(atlas["low_m"], atlas["depth_m"]);
  EXPECT_LT(atlas["depth_m"], atlas["high_m"]);
  EXPECT_NEAR(found["depth_m"].get<double>() / atlas["depth_m"].get<double>(), 1, 0.1);
  EXPECT_THAT(run({"impact", file, "--accuracy", "2%"}).out,
              AllOf(HasSubstr("from the atlas"), HasSubstr("The atlas expects"), HasSubstr("its wall at 20 radii")));
  EXPECT_EQ(run({"impact", file, "--accuracy", "0.1%"}).code, 3) << "more replicates than are advised";
}

TEST_F(Study, ANearerWallHasNoAtlas) {
  const std::string file = write("ball.toml", ball_into_gel("width = \"4 mm\"\n"));
  ASSERT_EQ(study({file}).code, 0);
  const json accuracy = json::parse(run({"impact", file, "--accuracy", "20%", "--json"}).out)["accuracy"];
  EXPECT_EQ(accuracy["from"], "the study");
  EXPECT_TRUE(accuracy["atlas"].is_null());
}

TEST_F(Study, AKeptStudyComesBeforeTheAtlas) {
  const std::string file = write("ball.toml", ball_into_gel());
  ASSERT_EQ(study({file}).code, 0);
  const json accuracy = json::parse(run({"impact", file, "--accuracy", "20%", "--json"}).out)["accuracy"];
  EXPECT_EQ(accuracy["from"], "the study");
  EXPECT_EQ(accuracy["study_was_kept"], true);
}

TEST_F(Study, AnAccuracyOutOfReachIsSaidAndNotRun) {
  const std::string file = scene();
  ASSERT_EQ(study({file}).code, 0);
  const Ended ended = run({"impact", file, "--accuracy", "0.1%", "--json"});
  EXPECT_EQ(ended.code, 3);
  const json found = json::parse(ended.out);
  EXPECT_TRUE(found["depth_m"].is_null());
  EXPECT_THAT(found["accuracy"]["why_not"].get<std::string>(), HasSubstr("An error of 0.1 %"));
  EXPECT_THAT(run({"impact", file, "--accuracy", "0.1%"}).out, HasSubstr("Not run. An error of 0.1 %"));
  EXPECT_TRUE(result("dent.out/result.json")["outcome"].is_null());
}

TEST_F(Study, AnAccuracyIsAShareOfTheDepth) {
  const std::string file = scene();
  for (const char* good : {"2%", "2 %", "0.02", "50%", "0.1%"})
    EXPECT_EQ(run({"impact", file, "--accuracy", good, "--check"}).code, 0) << good;
  for (const char* bad : {"2", "0", "-1%", "51%", "0.01%", "%", "two", "2 um", "nan"}) {
    const Ended ended = run({"impact", file, std::string("--accuracy=") + bad, "--check"});
    EXPECT_EQ(ended.code, 2) << bad;
    EXPECT_THAT(ended.err, HasSubstr("from 0.1% to 50%")) << bad;
  }
  EXPECT_EQ(run({"impact", file, "--accuracy", "2%", "--replicates", "3", "--check"}).code, 2) << "two who decide";
}

TEST_F(Study, AnImpactWithoutAKeptStudyRunsAndKeepsTheDefaultOne) {
  const std::string soon =
      scene({{"[mesh]", "[solver]\nend_time = \"0.1 us\"\n[mesh]"}});  // no mesh stops: the ladder is short
  const Ended ended = run({"impact", soon, "--accuracy", "5%"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("no study of this scene is kept"), HasSubstr("45 runs"),
                               HasSubstr("is kept\n"), HasSubstr("no depth to extrapolate to")));
  const Ended again = run({"impact", soon, "--accuracy", "5%"});
  EXPECT_THAT(again.out, testing::Not(HasSubstr("no study of this scene")));
}

}  // namespace
}  // namespace percal
