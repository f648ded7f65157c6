// Batches made on a cluster, from the command line on: what comes back is what this machine would have made.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "cluster/fake_slurm.hpp"
#include "percal/math/instruction_level.hpp"

namespace percal {
namespace {

using test::FakeSlurm;

// Without what a run costs and where it came from.
nlohmann::json outcomes(const nlohmann::json& result) {
  nlohmann::json points = result["points"];
  for (auto& point : points)
    for (const char* name : {"cpu_s", "reused"}) point.erase(name);
  return points;
}

TEST_F(FakeSlurm, GivesTheBitsOfThisMachine) {
  const auto there =
      run_there({"campaign", eight(), "--slurm", "--batch", "2", "--store", "there.store", "--out", "there"});
  ASSERT_EQ(there.code, 0) << there.err;
  const auto here = run({"campaign", eight(), "--store", "here.store", "--out", "here"});
  ASSERT_EQ(here.code, 0) << here.err;
  EXPECT_EQ(outcomes(result("there/result.json")), outcomes(result("here/result.json")));
  EXPECT_EQ(result("there/result.json")["cost"]["runs"], 8);
  EXPECT_EQ(result("there/result.json")["cost"]["reused"], 0);
  EXPECT_EQ(arrays(), 1) << "of four tasks, as many as this cluster lets an array have";
  EXPECT_TRUE(files("plan.slurm/done").empty() ||
              std::ranges::none_of(files("plan.slurm/done"), [](const auto& name) { return name.ends_with(".json"); }))
      << "taken in, and gone";
}

TEST_F(FakeSlurm, ArraysAreNoLongerThanTheClusterLets) {
  ASSERT_EQ(run_there({"campaign", eight(), "--slurm", "--batch", "1"}).code, 0);
  EXPECT_EQ(arrays(), 2) << "eight tasks, four an array";
}

TEST_F(FakeSlurm, WhatALostTaskHadIsHandedOverAgain) {
  write("cluster/lose", "");
  const auto ended = run_there({"campaign", eight(), "--slurm", "--batch", "2"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(arrays(), 2);
  EXPECT_EQ(result("plan.out/result.json")["cost"]["runs"], 8);
}

TEST_F(FakeSlurm, AKilledCoordinatorIsStartedAgainAndNothingIsMadeTwice) {
  const pid_t first = start_there({"campaign", eight(), "--slurm", "--batch", "2"});
  while (!std::filesystem::exists(path("cluster/submitted"))) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(first, SIGKILL);
  wait_for(first);
  const auto second = run_there({"campaign", eight(), "--slurm", "--batch", "2"});
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_EQ(arrays(), 1) << "the tasks of the killed one went on";
}

TEST_F(FakeSlurm, WhatSlurmRefusesIsSaidInItsWords) {
  write("cluster/refuse", "");
  const auto ended = run_there({"campaign", eight(), "--slurm", "--partition", "nowhere"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, testing::HasSubstr("invalid partition specified"));
}

TEST_F(FakeSlurm, ADryRunPrintsTheScriptAndHandsNothingOver) {
  const auto ended =
      run_there({"campaign", eight(), "--slurm", "--batch", "3", "--partition", "short", "--time", "30", "--dry-run"});
  EXPECT_EQ(ended.code, 0);
  for (const char* line :
       {"#SBATCH --array=0-2\n", "#SBATCH --partition=short\n", "#SBATCH --time=30\n", "export PERCAL_ISA="})
    EXPECT_THAT(ended.out, testing::HasSubstr(line));
  EXPECT_FALSE(std::filesystem::exists(path("cluster/submitted")));
}

TEST_F(FakeSlurm, FewRunsStayHere) {
  const std::string three = plan_file(test::ranged("particle.speed", "\"60 m/s\"", "\"180 m/s\"", "count = 3\n"));
  ASSERT_EQ(run_there({"campaign", three, "--slurm"}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("cluster/submitted")));
}

TEST_F(FakeSlurm, AListOfAnotherVersionIsRefusedWithItsLine) {
  write("f.slurm/todo/a/0", "sphere solver=0 level=" + instruction_level() + " pi4=1\n");
  const auto ended = run({"work", "f.slurm/todo/a/0"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, testing::HasSubstr("f.slurm/todo/a/0:1"));
  write("elsewhere", "");
  EXPECT_EQ(run({"work", "elsewhere"}).code, 2);
}

}  // namespace
}  // namespace percal
