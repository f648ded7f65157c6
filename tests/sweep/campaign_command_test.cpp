// percal campaign as its user runs it.
#include <gmock/gmock.h>

#include <csignal>
#include <thread>

#include "percal/store/store.hpp"
#include "sweep/small_plan.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using test::listed_sweep;
using test::ranged;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class CampaignCommand : public test::PlanFolder {
 protected:
  // What does not hang on who ran what and when.
  static json findings_of(json result) {
    result.erase("cost");
    for (json& point : result["points"])
      for (const char* key : {"cpu_s", "reused"}) point.erase(key);
    return result;
  }
  // Runs of some tenths of a second.
  void slow_plan() const {
    plan_file(ranged("particle.speed", "\"100 m/s\"", "\"240 m/s\"", "count = 6\n") +
                  listed_sweep("mesh.elements_per_radius", "[9]"),
              "replicates = 2\n");
  }
  std::vector<std::string> command(const std::string& name) const {
    return {"campaign", "plan.toml", "--store", "shared.store", "--out", name, "--quiet"};
  }
  long rows() const { return Store(path("shared.store")).size(); }
  void wait_for_a_row() const {
    for (int k = 0; k < 30000 && (!std::filesystem::exists(path("shared.store")) || rows() == 0); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
};

TEST_F(CampaignCommand, WritesTableResultAndFigure) {
  plan_file(ranged("particle.speed", "\"40 m/s\"", "\"120 m/s\"", "count = 3\n") + listed_sweep("pi5", "[0.2, 1]"));
  const Ended ended = run({"campaign", "plan.toml", "--store", "s"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("6 points"), HasSubstr("stopped")));
  EXPECT_THAT(files("plan.out"), ElementsAre("plan.out/depths1.csv", "plan.out/depths1.svg", "plan.out/points.csv",
                                             "plan.out/result.json"));
  const std::string table = read("plan.out/points.csv");
  EXPECT_THAT(table,
              testing::StartsWith("point,particle.speed [m/s],pi5,outcome,runs,depth_m,depth_spread_m,depth_error_m,"));
  EXPECT_EQ(std::ranges::count(table, '\n'), 7);
  const json found = result("plan.out/result.json");
  EXPECT_EQ(found["command"], "campaign");
  EXPECT_EQ(found["input"]["toml"], read("plan.toml"));
  EXPECT_EQ(found["scene_toml"], read("scene.toml"));
  EXPECT_EQ(found["points"][3]["values"], json({80.0, 1.0}));
  EXPECT_EQ(found["cost"]["runs"], 6);
  EXPECT_EQ(run({"report", "plan.out"}).code, 0);
  EXPECT_THAT(read("plan.out/report.html"), HasSubstr("Depth over particle.speed"));
}

// The numbers are those of percal impact.
TEST_F(CampaignCommand, SaysOfAPointWhatAnImpactSaysOfItsScene) {
  plan_file(listed_sweep("particle.speed", "[\"50 m/s\"]"), "replicates = 3\n");
  ASSERT_EQ(run({"campaign", "plan.toml", "--store", "s", "--quiet"}).code, 0);
  std::string text = test::small_scene;
  write("one.toml", "replicates = 3\n" + text.replace(text.find("180 m/s"), 7, "50 m/s"));
  const json one = json::parse(run({"impact", "one.toml", "--store", "s", "--json"}).out),
             point = result("plan.out/result.json")["points"][0];
  EXPECT_EQ(one["cost"]["reused"], 3) << "the same runs";
  for (const char* key : {"outcome", "depth_m", "depth_spread_m", "depth_at_least_m"})
    EXPECT_EQ(point[key], one[key]) << key;
  EXPECT_EQ(point["depth_error_m"], one["depth_error"]["half_width_m"]);
  EXPECT_EQ(point["error_wall_m"], one["depth_error"]["sources"][2]["half_width_m"]);
}

TEST_F(CampaignCommand, EveryKeyOfTheResultStandsOnItsPage) {
  plan_file(listed_sweep("particle.speed", "[\"90 m/s\"]"));
  ASSERT_EQ(run({"campaign", "plan.toml", "--store", "s", "--quiet"}).code, 0);
  const std::string page = text_of(test::docs + "formats/campaign.md");
  const json found = result("plan.out/result.json");
  for (const json& object : {found, found["axes"][0], found["points"][0]})
    for (const auto& [key, value] : object.items()) EXPECT_THAT(page, HasSubstr("`" + key + "`"));
}

TEST_F(CampaignCommand, AFailureIsARowWithItsName) {
  plan_file(listed_sweep("solver.end_time", "[\"5 us\", \"20 ms\"]"));
  EXPECT_EQ(run({"campaign", "plan.toml", "--store", "s", "--quiet"}).code, 3);
  const json points = result("plan.out/result.json")["points"];
  EXPECT_EQ(points[0]["outcome"], "time up");
  EXPECT_EQ(points[0]["depth_m"], nullptr);
  EXPECT_NE(points[1]["outcome"], "time up");
  EXPECT_THAT(read("plan.out/points.csv"), HasSubstr("\n1,5,time up,1,,"));
}

TEST_F(CampaignCommand, SpeedLeftAndFinalDepthAreThereWhereTheSceneGoesOn) {
  std::string text = test::small_scene;
  write("scene.toml", text.replace(text.find("40 mm"), 5, "12 mm") + "[output]\nafter = \"rest\"\n");
  plan_file(listed_sweep("particle.speed", "[\"300 m/s\"]"));
  ASSERT_EQ(run({"campaign", "plan.toml", "--store", "s", "--quiet"}).code, 0);
  const json point = result("plan.out/result.json")["points"][0];
  EXPECT_EQ(point["outcome"], "passed through");
  EXPECT_EQ(point["ending"], "passed through");
  EXPECT_GT(point["speed_left_m_s"], 50);
  EXPECT_NEAR(point["depth_at_least_m"], 0.012, 1e-12);
}

TEST_F(CampaignCommand, CheckReadsAllPointsAndRunsNothing) {
  plan_file(ranged("particle.speed", "\"40 m/s\"", "\"120 m/s\"", "count = 9\n"), "");
  const Ended ended = run({"campaign", "plan.toml", "--check", "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(ended.out);
  EXPECT_EQ(found["points"], 9);
  EXPECT_EQ(found["runs"], 45);
  EXPECT_THAT(files(), ElementsAre("plan.toml", "scene.toml"));
  plan_file(listed_sweep("particle.speed", "[\"40 m/s\", \"0 m/s\"]"));
  const Ended bad = run({"campaign", "plan.toml", "--check"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.err, HasSubstr("plan.toml:4: particle.speed: point 2 of 2"));
}

TEST_F(CampaignCommand, EstimateSaysRunsSecondsAndMemoryAndKeepsNoRun) {
  plan_file(ranged("particle.speed", "\"40 m/s\"", "\"120 m/s\"", "count = 3\n"), "replicates = 2\n");
  const Ended ended = run({"campaign", "plan.toml", "--estimate", "--store", "s", "--threads", "2"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("3 points, 6 runs"), HasSubstr("processor time"), HasSubstr("wall time"),
                               HasSubstr("MB")));
  EXPECT_THAT(files(), Not(testing::Contains("plan.out")));
  ASSERT_EQ(run({"campaign", "plan.toml", "--store", "s", "--quiet"}).code, 0);
  EXPECT_EQ(result("plan.out/result.json")["cost"]["runs"], 6);
  const json again =
      json::parse(run({"campaign", "plan.toml", "--estimate", "--store", "s", "--json"}).out)["estimate"];
  EXPECT_EQ(again["stored"], 6);
  EXPECT_EQ(again["cpu_s"], 0);
}

TEST_F(CampaignCommand, HasTheSameBitsOnAnyNumberOfThreads) {
  plan_file(ranged("particle.speed", "\"40 m/s\"", "\"150 m/s\"", "count = 5\n"), "replicates = 2\n");
  for (const std::string threads : {"1", "2"})
    ASSERT_EQ(run({"campaign", "plan.toml", "--store", "s" + threads, "--out", "out" + threads, "--threads", threads,
                   "--quiet"})
                  .code,
              0);
  EXPECT_EQ(findings_of(result("out1/result.json")), findings_of(result("out2/result.json")));
}

TEST_F(CampaignCommand, TheTableNeverReplacesAnInput) {
  const std::string list = "particle.speed [m/s]\n90\n";
  write("points.csv", list);
  plan_file("", "list = \"points.csv\"\n");
  const Ended ended = run({"campaign", "plan.toml", "--store", "s", "--out", "."});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("points.csv"));
  EXPECT_EQ(read("points.csv"), list);
  EXPECT_THAT(files(), ElementsAre("plan.toml", "points.csv", "scene.toml"));
}

class SlowCampaignCommand : public CampaignCommand {};

TEST_F(SlowCampaignCommand, KilledAndStartedAgainItRunsNothingTwice) {
  slow_plan();
  const pid_t first = start(command("killed"));
  wait_for_a_row();
  kill(first, SIGKILL);
  wait_for(first);
  const long before = rows();
  ASSERT_GT(before, 0);
  ASSERT_LT(before, 12) << "it was killed in the middle";
  EXPECT_FALSE(std::filesystem::exists(path("killed/result.json"))) << "nothing half-written";
  ASSERT_EQ(run(command("again")).code, 0);
  EXPECT_EQ(result("again/result.json")["cost"]["runs"], 12 - before);
  EXPECT_EQ(result("again/result.json")["cost"]["reused"], before);
  EXPECT_THAT(files(), Not(testing::Contains("shared.store-claims")));
}

TEST_F(SlowCampaignCommand, TwoProcessesShareAPlan) {
  slow_plan();
  auto alone = command("alone");
  alone[3] = "other.store";
  ASSERT_EQ(run(alone).code, 0);
  const pid_t first = start(command("first"));
  wait_for_a_row();
  const pid_t second = start(command("second"));
  wait_for(first);
  wait_for(second);
  const json one = result("first/result.json"), other = result("second/result.json");
  EXPECT_EQ(one["cost"]["runs"].get<int>() + other["cost"]["runs"].get<int>(), 12) << "each evaluation once";
  EXPECT_GT(other["cost"]["runs"], 0) << "both had a share";
  EXPECT_EQ(findings_of(one), findings_of(other));
  EXPECT_EQ(findings_of(one), findings_of(result("alone/result.json")));
}

TEST_F(SlowCampaignCommand, ASecondProcessTakesOverWhatADeadOneWasAt) {
  slow_plan();
  auto slow = command("first");
  const pid_t first = start(slow);
  wait_for_a_row();
  const pid_t second = start(command("second"));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  kill(first, SIGKILL);
  wait_for(first);
  EXPECT_EQ(wait_for(second).code, 0);
  EXPECT_EQ(rows(), 12);
  EXPECT_EQ(result("second/result.json")["points"].size(), 6U);
}

}  // namespace
}  // namespace percal
