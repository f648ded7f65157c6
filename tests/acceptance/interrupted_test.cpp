// Killed at any moment and started again: nothing that was finished is run twice, and the result is the one of an
// uninterrupted run.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "acceptance/liver.hpp"
#include "percal/store/store.hpp"
#include "support/sanitized.hpp"

namespace percal {
namespace {

using acceptance::LiverJob;
using acceptance::without_cost;
using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
namespace fs = std::filesystem;

class Interrupted : public LiverJob {
 protected:
  // Long enough to be met in the middle: a second or two. Under a sanitizer the job as it stands takes longer than that.
  Interrupted() {
#ifdef PERCAL_SANITIZED
    job();
#else
    job({{"0.8]\nstart = \"5 MPa\"\nelements_per_radius = 4", "0.8]\nstart = \"5 MPa\"\nelements_per_radius = 6"},
         {"[3, 4, 5]", "[5, 6, 8]"}});
#endif
  }

  std::vector<std::string> command(const std::string& name) const {
    return {"identify", "liver.toml", "--store", name + ".store", "--out", name, "--quiet"};
  }
  long rows(const std::string& name) const { return Store(path(name + ".store")).size(); }
  json uninterrupted() {
    whole_time_ = time_of(command("whole"));
    const json found = result("whole/result.json");
    EXPECT_EQ(found["cost"]["runs"], rows("whole")) << "every run is one row";
    return found;
  }
  // Waits until the store has a row more than `before`, so that a signal comes in the middle of the work.
  void wait_for_a_row(const std::string& name, long before) const {
    for (int k = 0; k < 30000 && (!fs::exists(path(name + ".store")) || rows(name) <= before); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  // How long a command takes here, in microseconds: signals are to come while it works, on any machine.
  int time_of(const std::vector<std::string>& arguments) const {
    const auto began = std::chrono::steady_clock::now();
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return static_cast<int>(
        std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - began).count());
  }
  static void expect_no_temporary_file(const std::set<std::string>& names) {
    for (const auto& name : names) EXPECT_THAT(name, Not(HasSubstr(".tmp")));
  }

  int whole_time_ = 0;  // us, of the uninterrupted run
};

TEST_F(Interrupted, ByKillAtAnyMomentItGoesOnWhereItWas) {
  const json whole = uninterrupted();
  for (const unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> microseconds(1000, std::max(300000, whole_time_ / 4));
    const std::string name = "killed" + std::to_string(seed);
    long stored = 0;
    int kills = 0;
    Ended ended{-1, "", ""};
    while (ended.code == -1) {
      const pid_t child = start(command(name));
      std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
      if (++kills <= 30) kill(child, SIGKILL);  // then it may end
      ended = wait_for(child);
      if (ended.code != -1) break;
      const long now = fs::exists(path(name + ".store")) ? rows(name) : 0;
      EXPECT_GE(now, stored) << "a finished evaluation was lost";
      stored = now;
      if (!fs::exists(path(name + "/result.json"))) continue;
      EXPECT_EQ(now, whole["cost"]["runs"].get<long>()) << "a result before everything was run";
    }
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_GT(kills, 1);
    const json found = result(name + "/result.json");
    EXPECT_EQ(without_cost(found).dump(), without_cost(whole).dump());
    EXPECT_EQ(rows(name), whole["cost"]["runs"].get<long>());
    EXPECT_EQ(stored + found["cost"]["runs"].get<long>(), whole["cost"]["runs"].get<long>())
        << "something finished was run again";
  }
}

TEST_F(Interrupted, BySignalItSaysHowToGoOn) {
  const json whole = uninterrupted();
  for (const int number : {SIGINT, SIGTERM}) {
    const std::string name = "signal" + std::to_string(number);
    const pid_t child = start(command(name));
    wait_for_a_row(name, 2);
    kill(child, number);
    const Ended ended = wait_for(child);
    EXPECT_EQ(ended.code, 130);
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_THAT(ended.err, AllOf(HasSubstr("interrupted"), HasSubstr("the same command goes on from there")));
    EXPECT_THAT(files(name), IsEmpty()) << "nothing half-written";
    const long stored = rows(name);
    EXPECT_GT(stored, 2);
    EXPECT_LT(stored, whole["cost"]["runs"].get<long>());
    ASSERT_EQ(run(command(name)).code, 0);
    const json found = result(name + "/result.json");
    EXPECT_EQ(without_cost(found).dump(), without_cost(whole).dump());
    EXPECT_EQ(stored + found["cost"]["runs"].get<long>(), whole["cost"]["runs"].get<long>());
  }
}

TEST_F(Interrupted, WhileItWritesNothingIsLeftHalfWritten) {
  const json whole = uninterrupted();
  std::mt19937 random(20090401);
  const int again = time_of({"identify", "liver.toml", "--store", "whole.store", "--out", "again", "--quiet"});
  std::uniform_int_distribution<int> microseconds(0, again);
  int in_the_middle = 0;
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    fs::remove_all(path("out"));
    const pid_t child = start({"identify", "liver.toml", "--store", "whole.store", "--out", "out", "--quiet"});
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    kill(child, SIGINT);
    const Ended ended = wait_for(child);
    EXPECT_TRUE(ended.code == 0 || ended.code == 130 || ended.code == -1) << ended.code;  // -1: before it had begun
    in_the_middle += ended.code == 130;
    if (!fs::exists(path("out"))) continue;
    expect_no_temporary_file(files("out"));
    if (fs::exists(path("out/result.json"))) {
      EXPECT_EQ(without_cost(result("out/result.json")).dump(), without_cost(whole).dump());
    }
    for (const std::string card : {"/liver_lsdyna.k", "/liver_abaqus.inp"}) {
      if (!fs::exists(path("out" + card))) continue;
      EXPECT_EQ(read("out" + card), read("whole" + card));
    }
  }
  EXPECT_GT(in_the_middle, 0) << "no signal came while it ran";
}

// Fields are written by the threads that run, and a signal may be taken while they do.
TEST_F(Interrupted, WhileThreadsWriteNoTemporaryFileIsLeft) {
  write("layer.toml", text_of(test::test_data + "layer.toml"));
  std::mt19937 random(3);
  const int start_up = time_of({"keys"});
  std::uniform_int_distribution<int> microseconds(start_up, 10 * start_up);
  int in_the_middle = 0;
  for (int k = 0; k < 40; ++k) {
    const pid_t child = start({"impact", "layer.toml", "--store", "layer.store", "--out", "out", "--quiet", "--fields",
                               "every=2", "--threads", "2"});
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    kill(child, k % 2 == 0 ? SIGINT : SIGHUP);
    in_the_middle += wait_for(child).code == 130;
    if (fs::exists(path("out"))) expect_no_temporary_file(files("out"));
  }
  EXPECT_GT(in_the_middle, 0) << "no signal came while it ran";
}

TEST_F(Interrupted, ASignalThatItsCallerIgnoresIsIgnored) {
  const pid_t child = start(command("deaf"), [] { std::signal(SIGINT, SIG_IGN); });
  wait_for_a_row("deaf", 2);
  kill(child, SIGINT);
  EXPECT_EQ(wait_for(child).code, 0);
}

}  // namespace
}  // namespace percal
