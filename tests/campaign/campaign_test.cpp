#include "percal/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <set>
#include <stdexcept>
#include <thread>

#include "percal/math/instruction_level.hpp"
#include "percal/problem/replicates.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

// A run of some milliseconds.
Problem quick(double pi4 = 6.6474) {
  Problem p;
  p.pi4 = pi4;
  p.density_ratio = 16.8;
  p.alpha = 8.5;
  p.depth = 20;
  p.elements_per_radius = 4;
  p.graded_columns = 2;
  p.erosion = StrainErosion{0.7};
  p.end_time = 3;
  return p;
}

std::vector<Problem> several() {
  std::vector<Problem> problems;
  for (const double pi4 : {9.0, 1.0, 4.0, 2.0, 6.0, 3.0}) problems.push_back(quick(pi4));
  return problems;
}

class CampaignTest : public testing::Test, protected test::TemporaryFolder {
 protected:
  const std::unique_ptr<Store> store = std::make_unique<Store>(path("percal.store"));
};

TEST_F(CampaignTest, WhatIsInTheStoreIsNotRunAgain) {
  Campaign first(store.get(), 1);
  const Evaluation run = first.evaluate(quick());
  EXPECT_FALSE(run.reused);
  Campaign second(store.get(), 1);
  const Evaluation found = second.evaluate(quick());
  EXPECT_TRUE(found.reused);
  EXPECT_EQ(found.result.depth, run.result.depth);
  EXPECT_EQ(found.result.energy.sum(), run.result.energy.sum());
  EXPECT_EQ(found.result.outcome, run.result.outcome);
  EXPECT_EQ(second.cost().runs, 0);
  EXPECT_EQ(second.cost().reused, 1);
  EXPECT_EQ(second.cost().cpu_seconds, 0);
}

TEST_F(CampaignTest, EndsWithinARunWhereItIsAskedToStop) {
  Campaign campaign(store.get(), 1);
  int asked = 0;
  campaign.stop_when([&] { return ++asked > 10; });
  EXPECT_THROW(campaign.evaluate(quick()), Interrupted);
  EXPECT_EQ(asked, 11);
  EXPECT_EQ(campaign.cost().runs, 0);
}

TEST_F(CampaignTest, MayBeAskedToStopWithoutAnotherBit) {
  Campaign asked(nullptr, 1), never(nullptr, 1);
  asked.stop_when([] { return false; });
  const ImpactResult one = asked.evaluate(quick()).result, other = never.evaluate(quick()).result;
  EXPECT_EQ(one.depth, other.depth);
  EXPECT_EQ(one.energy.sum(), other.energy.sum());
}

TEST_F(CampaignTest, BeginsNoRunThatWouldEndAfterTheDeadline) {
  Campaign campaign(store.get(), 1);
  const auto now = std::chrono::steady_clock::now();
  const Evaluation first = campaign.evaluate(quick(1));
  const std::vector<Problem> both{quick(1), quick(9)};
  const auto late = campaign.evaluate_by(now, both, nullptr);
  ASSERT_TRUE(late[0]) << "it is in the store";
  EXPECT_EQ(late[0]->result.depth, first.result.depth);
  EXPECT_FALSE(late[1]);
  const auto in_time = campaign.evaluate_by(now + std::chrono::hours(1), both, nullptr);
  EXPECT_TRUE(in_time[1]);
  Problem long_run = quick(5);
  long_run.elements_per_radius = 400;
  EXPECT_FALSE(
      campaign.evaluate_by(std::chrono::steady_clock::now() + std::chrono::seconds(20), {long_run}, nullptr)[0])
      << "it would take a million times as long as the others";
  EXPECT_TRUE(campaign.evaluate_by({}, {quick(7)}, nullptr)[0]) << "no deadline, every run";
}

TEST_F(CampaignTest, AnotherProblemIsRun) {
  Campaign campaign(store.get(), 1);
  campaign.evaluate(quick());
  Problem other = quick();
  other.speed_factor = 1.001;
  EXPECT_FALSE(campaign.evaluate(other).reused);
  EXPECT_EQ(store->size(), 2);
}

// An elastic sphere too stiff to be run.
TEST_F(CampaignTest, FailuresAreKeptAsFailures) {
  Problem p = quick();
  p.particle = ElasticSphere{1e8, 0.3};
  Campaign campaign(store.get(), 1);
  EXPECT_EQ(campaign.evaluate(p).result.outcome, Outcome::unstable);
  EXPECT_EQ(store->find(evaluation_key(p, instruction_level()))->outcome, "unstable");
  EXPECT_EQ(campaign.evaluate(p).result.outcome, Outcome::unstable);
  EXPECT_EQ(campaign.cost().reused, 1);
}

TEST_F(CampaignTest, AHistoryIsRunThoughTheStoreHasTheProblem) {
  Campaign campaign(store.get(), 1);
  campaign.evaluate(quick());
  Problem with_history = quick();
  with_history.history_samples = 400;
  const Evaluation run = campaign.evaluate(with_history);
  EXPECT_FALSE(run.reused);
  EXPECT_FALSE(run.result.history.empty());
  EXPECT_EQ(store->size(), 1);
}

TEST_F(CampaignTest, AChannelThatTheStoreLacksIsRunOnceAndKept) {
  Campaign campaign(store.get(), 1);
  campaign.evaluate(quick());
  Problem with_channel = quick();
  with_channel.channel = true;
  EXPECT_FALSE(campaign.evaluate(with_channel).reused);
  const Evaluation found = campaign.evaluate(with_channel);
  EXPECT_TRUE(found.reused);
  EXPECT_FALSE(found.result.channel.largest.empty());
  EXPECT_TRUE(campaign.evaluate(quick()).reused);
  EXPECT_EQ(store->size(), 1);
}

TEST_F(CampaignTest, AKeptResultThatIsOlderThanTheDepthAtHalfTheSpeedIsRunAgainWhereItIsAskedFor) {
  Campaign campaign(store.get(), 1);
  Problem stops = quick();
  stops.depth = 40;
  stops.end_time = 1000;
  Evaluation older = campaign.evaluate(stops);
  ASSERT_EQ(older.result.outcome, Outcome::stopped);
  const double depth = older.result.half_speed_depth;
  EXPECT_GT(depth, 0.3 * older.result.depth);
  older.result.half_speed_depth = 0;
  store->replace(evaluation_key(stops, older.instruction_level), as_stored(older));
  EXPECT_TRUE(campaign.evaluate(stops).reused);
  stops.half_speed_depth = true;
  EXPECT_FALSE(campaign.evaluate(stops).reused);
  const Evaluation again = campaign.evaluate(stops);
  EXPECT_TRUE(again.reused);
  EXPECT_EQ(again.result.half_speed_depth, depth);
}

TEST_F(CampaignTest, ARunToRestIsKeptApart) {
  Campaign campaign(store.get(), 1);
  Problem thin = quick();
  thin.depth = 2;
  thin.end_time = 100;
  const Evaluation deepest = campaign.evaluate(thin);
  thin.until = RunUntil::rest;
  EXPECT_FALSE(campaign.evaluate(thin).reused);
  const Evaluation rest = campaign.evaluate(thin);
  EXPECT_TRUE(rest.reused);
  EXPECT_EQ(rest.result.depth, deepest.result.depth);
  ASSERT_TRUE(rest.result.aftermath);
  EXPECT_EQ(rest.result.aftermath->ending, Ending::passed_through);
  EXPECT_EQ(store->size(), 2);
}

TEST_F(CampaignTest, TheSameProblemTwiceInABatchIsRunOnce) {
  Campaign campaign(store.get(), 2);
  const auto results = campaign.evaluate({quick(2), quick(3), quick(2), quick(2)}, nullptr);
  EXPECT_EQ(campaign.cost().runs, 2);
  EXPECT_EQ(results[0].result.depth, results[2].result.depth);
  EXPECT_EQ(results[0].result.depth, results[3].result.depth);
  EXPECT_NE(results[0].result.depth, results[1].result.depth);
}

TEST(Campaign, ATwinWithoutAHistoryDoesNotTakeTheOthersAway) {
  Problem with_history = quick();
  with_history.history_samples = 400;
  Campaign campaign(nullptr, 1);
  const auto results = campaign.evaluate({quick(), with_history}, nullptr);
  EXPECT_FALSE(results[1].result.history.empty());
}

TEST(Campaign, ATwinWithoutAChannelDoesNotTakeTheOthersAway) {
  Problem with_channel = quick();
  with_channel.channel = true;
  Campaign campaign(nullptr, 1);
  EXPECT_FALSE(campaign.evaluate({quick(), with_channel}, nullptr)[1].result.channel.largest.empty());
}

TEST(Campaign, ResultsComeInTheOrderOfTheProblemsWithTheSameBitsOnAnyNumberOfThreads) {
  Campaign alone(nullptr, 1), together(nullptr, 2), crowd(nullptr, 5);
  const auto expected = alone.evaluate(several(), nullptr), by_two = together.evaluate(several(), nullptr),
             by_five = crowd.evaluate(several(), nullptr);
  std::set<double> depths;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(expected[i].result.depth, alone.evaluate(several()[i]).result.depth);
    for (const auto* results : {&by_two, &by_five}) {
      EXPECT_EQ(expected[i].result.depth, (*results)[i].result.depth) << i;
      EXPECT_EQ(expected[i].result.end_speed, (*results)[i].result.end_speed) << i;
      EXPECT_EQ(expected[i].result.energy.sum(), (*results)[i].result.energy.sum()) << i;
    }
    depths.insert(expected[i].result.depth);
  }
  EXPECT_EQ(depths.size(), expected.size()) << "all different, so that their order shows";
}

TEST(Campaign, ReplicatesBelongToTheirProblems) {
  Campaign campaign(nullptr, 2);
  const auto grouped = campaign.replicate({quick(2), quick(8)}, 3, nullptr);
  ASSERT_EQ(grouped.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(grouped[i].size(), 3u);
    for (int k = 0; k < 3; ++k) {
      const Problem p = replicates_of(quick(i == 0 ? 2 : 8), 3)[k];
      EXPECT_EQ(grouped[i][k].result.depth, campaign.evaluate(p).result.depth) << i << " " << k;
    }
  }
}

TEST(Campaign, CountsWhatItSpent) {
  Campaign campaign(nullptr, 2);
  campaign.evaluate(several(), nullptr);
  EXPECT_EQ(campaign.cost().runs, 6);
  EXPECT_EQ(campaign.cost().reused, 0);
  EXPECT_GT(campaign.cost().cpu_seconds, 0);
}

TEST(Campaign, DoesEveryPieceOfWorkOnce) {
  for (const int threads : {1, 2, 7}) {
    const Campaign campaign(nullptr, threads);
    std::vector<std::atomic<int>> done(100);
    campaign.side_by_side(100, [&](int k) { ++done[k]; });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
}

TEST(Campaign, TheFirstExceptionEndsTheRestAndIsThrown) {
  for (const int threads : {1, 3}) {
    const Campaign campaign(nullptr, threads);
    std::atomic<int> begun{0};
    try {
      campaign.side_by_side(1000, [&](int k) {
        ++begun;
        if (k == 5) throw std::runtime_error("the fifth");
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "the fifth");
    }
    EXPECT_LT(begun, 100);
  }
}

TEST(Campaign, UsesEveryCoreWhereNoNumberOfThreadsIsGiven) {
  EXPECT_EQ(Campaign(nullptr, 0).threads(), static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  EXPECT_EQ(Campaign(nullptr, 3).threads(), 3);
}

}  // namespace
}  // namespace percal
