// Campaigns that share a store: what another is at is left to it. And in which order, and how many side by side, runs go.
#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <string>
#include <thread>

#include "percal/campaign/campaign.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/observe/stored_run.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

// A run of some milliseconds, in a layer of so many radii.
Problem shared_problem(double depth) {
  Problem p;
  p.pi4 = 6.6474;
  p.density_ratio = 16.8;
  p.alpha = 8.5;
  p.depth = depth;
  p.elements_per_radius = 4;
  p.graded_columns = 2;
  p.erosion = StrainErosion{0.7};
  p.end_time = 3;
  return p;
}
std::string key_of(const Problem& problem) { return evaluation_key(problem, instruction_level()); }

class SharedStore : public testing::Test, protected test::TemporaryFolder {
 protected:
  Store mine{path("percal.store")}, theirs{path("percal.store")};
};

TEST_F(SharedStore, WhatAnotherIsAtIsTakenFromItWhenItIsDone) {
  const Problem claimed = shared_problem(20), free = shared_problem(21);
  Campaign elsewhere(nullptr, 1);
  Evaluation done = elsewhere.evaluate(claimed);
  auto claim = theirs.claim(key_of(claimed));
  std::thread other([&, held = std::move(claim)]() mutable {
    while (!theirs.find(key_of(free))) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    theirs.put(key_of(claimed), {word(done.result.outcome), to_payload(done), done.cpu_seconds});
    const auto given_back = std::move(held);
  });
  Campaign campaign(&mine, 2);
  const auto found = campaign.evaluate({claimed, free}, nullptr);
  other.join();
  EXPECT_EQ(campaign.cost().runs, 1) << "the free one, while the other was at work";
  EXPECT_TRUE(found[0].reused);
  EXPECT_EQ(found[0].result.depth, done.result.depth);
  EXPECT_FALSE(found[1].reused);
}

TEST_F(SharedStore, WhatAnotherGivesUpIsRunHere) {
  std::optional<Claims::Claim> claim = theirs.claim(key_of(shared_problem(20)));
  std::thread other([held = std::move(claim)] { std::this_thread::sleep_for(std::chrono::milliseconds(60)); });
  Campaign campaign(&mine, 1);
  EXPECT_FALSE(campaign.evaluate(shared_problem(20)).reused);
  other.join();
}

TEST_F(SharedStore, ADeadlineEndsTheWaitForAnother) {
  const auto claim = theirs.claim(key_of(shared_problem(20)));
  Campaign campaign(&mine, 1);
  const auto soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(40);
  EXPECT_FALSE(campaign.evaluate_by(soon, {shared_problem(20)}, nullptr)[0]);
}

TEST_F(SharedStore, TwoCampaignsOnOneBatchRunEachProblemOnce) {
  std::vector<Problem> problems;
  for (int k = 0; k < 12; ++k) problems.push_back(shared_problem(20 + k));
  Campaign one(&mine, 1), other(&theirs, 1);
  std::vector<Evaluation> by_other;
  std::thread beside([&] { by_other = other.evaluate(problems, nullptr); });
  const auto by_one = one.evaluate(problems, nullptr);
  beside.join();
  EXPECT_EQ(one.cost().runs + other.cost().runs, 12);
  for (std::size_t k = 0; k < problems.size(); ++k) EXPECT_EQ(by_one[k].result.depth, by_other[k].result.depth);
}

TEST_F(SharedStore, TheLongestRunGoesFirst) {
  Campaign campaign(&mine, 1);
  campaign.stop_when([&] { return mine.size() > 0; });
  EXPECT_THROW(campaign.evaluate({shared_problem(20), shared_problem(40), shared_problem(30)}, nullptr), Interrupted);
  EXPECT_TRUE(mine.find(key_of(shared_problem(40))));
}

class SlowSharedStore : public SharedStore {};

// By the share of their time that threads are in runs, which no other load of the machine changes.
TEST_F(SlowSharedStore, TwoThreadsAreBusyWithAHundredEqualRuns) {
  std::vector<Problem> problems;
  for (int k = 0; k < 100; ++k) {
    problems.push_back(shared_problem(40));
    problems.back().alpha += 1e-6 * k;
    problems.back().elements_per_radius = 18;
    problems.back().end_time = 12;
  }
  Campaign campaign(&mine, 2);
  const auto start = std::chrono::steady_clock::now();
  double busy = 0;
  for (const Evaluation& run : campaign.evaluate(problems, nullptr)) busy += run.wall_seconds;
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("efficiency", std::to_string(busy / (2 * wall)));
  EXPECT_GT(busy / (2 * wall), 0.95) << wall << " s, a run " << busy / 100 << " s";
}

// What a claim costs beside a run of milliseconds.
TEST_F(SharedStore, AClaimIsCheap) {
  constexpr int many = 2000;
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < many; ++k) {
    const auto claim = mine.claim(std::to_string(k));
    ASSERT_TRUE(claim);
  }
  const double each = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / many;
  RecordProperty("claim_us", std::to_string(1e6 * each));
  EXPECT_LT(each, 1e-3) << "some microseconds";
}

TEST(MemoryOfACampaign, HoldsNoMoreRunsThanFit) {
  Campaign campaign(nullptr, 4);
  campaign.keep_within(1);  // bytes: one after the other, since one alone is always let in
  int turns = 0;
  std::mutex mutex;
  std::thread::id inside;
  campaign.stop_when([&] {
    const std::lock_guard lock(mutex);
    const auto self = std::this_thread::get_id();
    turns += inside != self;
    inside = self;
    return false;
  });
  std::vector<Problem> problems;
  for (int k = 0; k < 8; ++k) problems.push_back(shared_problem(20 + k));
  campaign.evaluate(problems, nullptr);
  EXPECT_LE(turns, 8) << "each run was asked from its begin to its end, then another one";
}

}  // namespace
}  // namespace percal
