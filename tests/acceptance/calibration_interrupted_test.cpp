// A calibration killed at any moment and started again with the same command ends with the result of an uninterrupted one, bit for
// bit, at any number of threads.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "acceptance/gel.hpp"
#include "percal/store/store.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
namespace fs = std::filesystem;

// What depends on the run and not on the problem.
json without_what_it_took(json result) {
  result.erase("cost");
  json& emulator = result["emulator"];
  emulator.erase("runs");
  emulator.erase("reused");
  for (json& round : emulator["rounds"]) round.erase("cpu_s");
  return result;
}

class SlowInterruptedCalibration : public test::Program {
 protected:
  SlowInterruptedCalibration() { acceptance::write_gel_job(*this); }
  std::vector<std::string> command(const std::string& name, int threads) const {
    return {"calibrate", "gel.toml", "--store",   name + ".store",        "--out",
            name,        "--quiet",  "--threads", std::to_string(threads)};
  }
  json found(const std::string& name) const { return result(name + "/result.json"); }
  long rows(const std::string& name) const {
    return fs::exists(path(name + ".store")) ? Store(path(name + ".store")).size() : 0;
  }
};

TEST_F(SlowInterruptedCalibration, EndsAsIfNothingHadHappened) {
  const auto begin = std::chrono::steady_clock::now();
  const Ended whole = run(command("whole", 2));
  ASSERT_EQ(whole.code, 0) << whole.err;
  const auto took = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
  const json expected = without_what_it_took(found("whole"));
  const long all = rows("whole");

  std::mt19937 random(20090401);
  std::uniform_int_distribution<long> moment(1000, took.count() / 3);
  long stored = 0;
  int kills = 0;
  Ended ended{-1, "", ""};
  for (; kills < 10 && ended.code == -1; ++kills) {
    const pid_t child = start(command("killed", 1 + kills % 2));
    std::this_thread::sleep_for(std::chrono::microseconds(moment(random)));
    kill(child, SIGKILL);
    ended = wait_for(child);
    EXPECT_GE(rows("killed"), stored) << "a finished run was lost";
    stored = rows("killed");
  }
  EXPECT_GE(kills, 5) << "it ended before it could be killed";
  ended = run(command("killed", 2));
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(without_what_it_took(found("killed")), expected);
  EXPECT_EQ(rows("killed"), all) << "no run beside those of the uninterrupted one";
  EXPECT_EQ(found("killed")["cost"]["runs"].get<long>() + stored, all) << "something finished was run again";
}

TEST_F(SlowInterruptedCalibration, OneThreadOrTwoGiveTheSameBits) {
  ASSERT_EQ(run(command("one", 1)).code, 0);
  ASSERT_EQ(run(command("two", 2)).code, 0);
  EXPECT_EQ(without_what_it_took(found("one")), without_what_it_took(found("two")));
}

TEST_F(SlowInterruptedCalibration, ASignalLeavesNothingHalfWrittenAndSaysHowToGoOn) {
  const pid_t child = start(command("signal", 2));
  for (int k = 0; k < 3000 && rows("signal") < 5; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(child, SIGTERM);
  const Ended ended = wait_for(child);
  EXPECT_EQ(ended.code, 130);
  EXPECT_THAT(ended.err, testing::HasSubstr("the same command goes on from there"));
  EXPECT_FALSE(fs::exists(path("signal/result.json")));
}

TEST_F(SlowInterruptedCalibration, ABudgetGivesTheBestAnswerWithinItAndSaysWhatMoreWouldBuy) {
  ASSERT_EQ(run(command("budget", 2)).code, 0);  // so that the store has the runs of the first rounds
  auto budgeted = command("budget", 2);
  budgeted.insert(budgeted.end(), {"--budget", "1s"});
  const Ended ended = run(budgeted);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json cost = found("budget")["cost"];
  EXPECT_EQ(cost["budget_s"], 1);
  EXPECT_FALSE(cost["advice"].get<std::string>().empty());
}

TEST_F(SlowInterruptedCalibration, ABudgetThatIsTooSmallForAnyAnswerEndsWithCodeThreeAndTheReason) {
  auto budgeted = command("tiny", 2);
  budgeted.insert(budgeted.end(), {"--budget", "1ms"});
  EXPECT_EQ(run(budgeted).code, 3);
  EXPECT_THAT(found("tiny")["findings"].dump(), testing::HasSubstr("the budget ended before there were enough runs"));
}

}  // namespace
}  // namespace percal
