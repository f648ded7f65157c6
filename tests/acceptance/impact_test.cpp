// percal impact: the outcomes by name and exit code, the keys of the result, the streams.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>

#include "support/program.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using test::guha2009;
using test::Program;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Impact : public Program {
 protected:
  // tests/data/layer.toml with pieces of its text replaced.
  std::string scene(const std::vector<std::pair<std::string, std::string>>& replacements = {}) const {
    std::string text = text_of(test::test_data + "layer.toml");
    for (const auto& [from, to] : replacements) text.replace(text.find(from), from.size(), to);
    return write("layer.toml", text);
  }
  Ended impact(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "impact");
    arguments.insert(arguments.end(), {"--store", path("store")});
    return run(arguments);
  }
};

TEST_F(Impact, ThatStopsGivesADepth) {
  const Ended ended = impact({scene(), "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, IsEmpty());
  const json found = json::parse(ended.out);
  EXPECT_EQ(found["outcome"], "stopped");
  for (const char* key : {"depth_m", "depth_spread_m", "steps", "elements"}) EXPECT_GT(found[key], 0.0) << key;
  for (const char* key : {"runs", "wall_s", "cpu_s"}) EXPECT_GT(found["cost"][key], 0.0) << key;
  EXPECT_LT(found["depth_m"], 600e-6);
  EXPECT_TRUE(found["depth_at_least_m"].is_null());
  EXPECT_THAT(found["cost"]["isa"].get<std::string>(), testing::Not(IsEmpty()));
  for (const char* term :
       {"particle", "live_kinetic", "freed_mass", "elastic", "hourglass", "viscosity", "eroded", "collisions", "sum"})
    EXPECT_TRUE(found["energy"].contains(term)) << term;
  EXPECT_NEAR(found["energy"]["sum"], 1, 0.05);
  ASSERT_GT(found["left_out"].size(), 0u);
  for (const json& omission : found["left_out"]) {
    EXPECT_THAT(omission["what"].get<std::string>(), testing::Not(IsEmpty()));
    EXPECT_THAT(omission["why"].get<std::string>(), testing::Not(IsEmpty()));
  }
  EXPECT_EQ(found["runs"].size(), 3u);
}

TEST_F(Impact, ThatPassesThroughIsAResult) {
  const std::string thin = scene({{"depth = \"600 um\"", "depth = \"60 um\""}});
  const Ended ended = impact({thin, "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(ended.out);
  EXPECT_EQ(found["outcome"], "passed through");
  EXPECT_TRUE(found["depth_m"].is_null() && found["depth_spread_m"].is_null());
  EXPECT_NEAR(found["depth_at_least_m"], 60e-6, 1e-15);
  EXPECT_THAT(impact({thin}).out, AllOf(HasSubstr("passed through"), HasSubstr("deeper than 60 um")));
}

TEST_F(Impact, WhoseTimeIsUpHasNoDepth) {
  const std::string hasty = scene({{"[mesh]", "[solver]\nend_time = \"0.2 us\"\n[mesh]"}});
  const Ended ended = impact({hasty, "--json"});
  EXPECT_EQ(ended.code, 3);
  const json found = json::parse(ended.out);
  EXPECT_EQ(found["outcome"], "time up");
  EXPECT_TRUE(found["depth_m"].is_null());
  EXPECT_THAT(impact({hasty}).out, HasSubstr("time up"));
}

TEST_F(Impact, FasterThanTheWavesIsRunAndTellsItsMachNumber) {
  const std::string fast = scene({{"\"120 m/s\"", "\"600 m/s\""}, {"alpha = 5", "alpha = 5\nnu = 0.45"}});
  const Ended ended = impact({fast, "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(ended.out);
  EXPECT_THAT(found["outcome"].get<std::string>(), testing::AnyOf("stopped", "passed through"));
  // v/sqrt((K + 4 mu/3)/rho), K/mu = 2 (1 + nu)/(3 (1 - 2 nu))
  EXPECT_NEAR(found["mach"], 600 / std::sqrt(12e6 * (2.9 / 0.3 + 4.0 / 3) / 1060), 1e-9);
  EXPECT_LT(found["energy_worst_closure"], 0.05);
  EXPECT_THAT(found["findings"].dump(), HasSubstr("faster than the target's waves"));
  EXPECT_THAT(impact({fast}).out,
              AllOf(testing::ContainsRegex("Mach number +1.7"), HasSubstr("note: Mach number 1.7")));
}

TEST_F(Impact, OfASimilarSystemIsNotRunAgain) {
  const auto at_four = [&](const std::string& name) {
    const Ended ended = impact({guha2009 + name, "--elements-per-radius", "4", "--json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return json::parse(ended.out);
  };
  const json gold = at_four("gold.toml"), steel = at_four("steel.toml");
  EXPECT_EQ(gold["cost"]["reused"], 0);
  EXPECT_EQ(steel["cost"]["reused"], 5) << "one dimensionless problem";
  EXPECT_EQ(steel["cost"]["cpu_s"], 0.0);
  EXPECT_NEAR(steel["depth_m"].get<double>() / 1.59e-3, gold["depth_m"].get<double>() / 1e-6, 1e-12 * 30);
  EXPECT_EQ(steel["energy"], gold["energy"]);
}

TEST_F(Impact, WritesItsHistoryAsCsv) {
  const Ended ended = impact({scene(), "--history", path("history/run.csv"), "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  std::istringstream lines(read("history/run.csv"));
  std::string line;
  std::getline(lines, line);
  EXPECT_THAT(line, AllOf(StartsWith("time_s,tip_m,speed_m_s,force_N,energy_particle,"), EndsWith(",energy_sum")));
  double deepest = 0, before = -1, first_speed = 0, last_speed = 0;
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    double time, tip, speed, force;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &time, &tip, &speed, &force), 4) << line;
    EXPECT_GT(time, before);
    before = time;
    deepest = std::max(deepest, tip);
    if (rows == 0) first_speed = speed;
    last_speed = speed;
  }
  EXPECT_GT(rows, 100);
  EXPECT_NEAR(first_speed, 120, 1);
  EXPECT_LE(last_speed, 0.5);
  EXPECT_NEAR(deepest / json::parse(ended.out)["runs"][1]["depth_m"].get<double>(), 1, 1e-6)
      << "the middle replicate's";
  const json history = json::parse(ended.out)["history"];
  for (const char* column : {"time_s", "tip_m", "speed_m_s", "force_N"})
    EXPECT_EQ(history[column].size(), static_cast<std::size_t>(rows)) << column;
  for (const double sum : history["energy"]["sum"]) EXPECT_NEAR(sum, 1, 0.05);
  EXPECT_EQ(history["energy"]["particle"][0], 1.0);
  EXPECT_TRUE(json::parse(impact({scene(), "--json"}).out)["history"].is_null());
}

TEST_F(Impact, WritesFieldsAndAPictureOfTheFirstReplicateWhichIsRunAnewWithTheSameDepth) {
  const json before = json::parse(impact({scene(), "--json"}).out);
  EXPECT_TRUE(before["fields"].is_null() && before["picture"].is_null());
  const Ended ended =
      impact({scene(), "--fields", "every=10%", "--picture", path("last.svg"), "--out", path("out"), "--json"});
  if (ended.code == 4 && ended.err.find("gnuplot") != std::string::npos) GTEST_SKIP() << ended.err;
  EXPECT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(ended.out);
  EXPECT_EQ(found["depth_m"], before["depth_m"]);
  EXPECT_EQ(found["cost"]["reused"], 2) << "of three";
  EXPECT_EQ(found["fields"]["list"], path("out/fields/layer.pvd"));
  const int frames = found["fields"]["frames"];
  EXPECT_GT(frames, 3);
  EXPECT_THAT(read("out/fields/layer.pvd"), HasSubstr(fmt::format("particle_{:04}.vtu", frames - 1)));
  EXPECT_THAT(read(fmt::format("out/fields/target_{:04}.vtu", frames - 1)), HasSubstr("vtkZLibDataCompressor"));
  EXPECT_THAT(read("last.svg"), AllOf(HasSubstr("<svg"), HasSubstr("tungsten carbide into layer: stopped, depth")));
}

TEST_F(Impact, RefusesFieldsAndPicturesThatItCannotMakeBeforeItRuns) {
  EXPECT_EQ(impact({scene(), "--fields", "every=2 kg"}).code, 2);
  EXPECT_EQ(impact({scene(), "--fields", "now", "--check"}).code, 2);
  EXPECT_EQ(impact({scene(), "--picture", path("a.jpeg")}).code, 2);
  EXPECT_EQ(impact({scene(), "--picture", "/proc/none/a.png"}).code, 4);
  EXPECT_EQ(impact({scene(), "--fields", "every=1us", "--out", "/proc/none"}).code, 4);
  EXPECT_EQ(impact({scene(), "--fields", "every=1us", "--out", "none"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(path("layer.out")));
}

TEST_F(Impact, PrintsNothingWhenAskedToBeQuiet) {
  const Ended ended = impact({scene(), "--quiet", "--out", path("out")});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out + ended.err, IsEmpty());
  EXPECT_EQ(result("out/result.json")["outcome"], "stopped");
}

TEST_F(Impact, TheResultsFolderHoldsWhatIsPrinted) {
  const Ended ended = impact({scene(), "--json", "--out", path("out")});
  EXPECT_EQ(read("out/result.json"), ended.out);
  EXPECT_EQ(files("out"), (std::set<std::string>{"out/result.json"}));
}

TEST_F(Impact, WithoutAFolderTheResultGoesToOneOfTheScenesName) {
  const Ended printed = impact({scene(), "--json", "--history", path("run.csv")});
  EXPECT_EQ(read("layer.out/result.json"), printed.out);
  EXPECT_EQ(read("layer.out/history.csv"), read("run.csv"));
  std::filesystem::remove_all(path("layer.out"));
  EXPECT_EQ(impact({scene(), "--out", "none"}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("layer.out")) || std::filesystem::exists(path("none")));
}

TEST_F(Impact, PrintsTheAnswerOnOneScreenAndTheRestWithDetails) {
  const std::string answer = impact({scene()}).out, all = impact({scene(), "--details"}).out;
  EXPECT_THAT(answer, AllOf(HasSubstr("Impact: tungsten carbide into layer"), HasSubstr("standard error"),
                            HasSubstr("2 mu/alpha"), HasSubstr("--accuracy 2%"), HasSubstr("layer.out/result.json")));
  EXPECT_LE(std::count(answer.begin(), answer.end(), '\n'), 24);
  for (const char* there :
       {"eroded elements", "What was left out", "Replicates walk through the phase", "Provenance and cost"}) {
    EXPECT_THAT(all, HasSubstr(there));
    EXPECT_THAT(answer, testing::Not(HasSubstr(there)));
  }
}

TEST_F(Impact, ACheckRunsAndWritesNothing) {
  const std::string file = scene();
  const auto before = files();
  EXPECT_EQ(impact({file, "--check", "--out", path("out")}).code, 0);
  const json said = json::parse(impact({file, "--check", "--json"}).out);
  EXPECT_EQ(said["valid"], true);
  EXPECT_EQ(said["largest_run"]["elements"], said["largest_run"]["columns"].get<double>() * said["largest_run"]["rows"].get<double>());
  EXPECT_THAT(impact({file, "--check", "--quiet"}).out, IsEmpty());
  EXPECT_EQ(files(), before);
}

TEST_F(Impact, ResultsDoNotDependOnTheNumberOfThreads) {
  scene();
  std::vector<json> found;
  for (const char* threads : {"1", "3"}) {
    const Ended ended =
        run({"impact", "layer.toml", "--json", "--threads", threads, "--store", path(std::string("store") + threads)});
    found.push_back(json::parse(ended.out));
    for (const char* time : {"wall_s", "cpu_s"}) found.back()["cost"].erase(time);
    for (json& one : found.back()["runs"]) one.erase("cpu_s");
  }
  EXPECT_EQ(found[0].dump(), found[1].dump());
}

}  // namespace
}  // namespace percal
