#include "percal/problem/replicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/problem/domain.hpp"

namespace percal {
namespace {

Problem usual_problem() {
  Problem p;
  p.graded_columns = usual_graded_columns(p);
  p.history_samples = 400;
  return p;
}

TEST(Replicates, OneIsTheProblemItself) {
  const auto one = replicates_of(usual_problem(), 1);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(evaluation_key(one[0], ""), evaluation_key(usual_problem(), ""));
  EXPECT_EQ(one[0].history_samples, 400);
}

// nf + (i - (n-1)/2) 1.7/n.
TEST(Replicates, WalkOnePeriodOfTheMeshPhase) {
  const auto five = replicates_of(usual_problem(), 5);
  const double expected[5] = {9.32, 9.66, 10, 10.34, 10.68};
  for (int k = 0; k < 5; ++k) EXPECT_DOUBLE_EQ(five[k].elements_per_radius, expected[k]) << k;
  double sum = 0;
  for (const Problem& p : replicates_of(usual_problem(), 4)) sum += p.elements_per_radius;
  EXPECT_NEAR(sum, 40, 1e-9) << "centred for even numbers too";
}

TEST(Replicates, TheMiddleOneIsTheProblemAndKeepsItsHistory) {
  for (const int count : {1, 2, 3, 4, 5, 8}) {
    const auto all = replicates_of(usual_problem(), count);
    for (int k = 0; k < count; ++k) EXPECT_EQ(all[k].history_samples > 0, k == middle_replicate(count)) << k;
    EXPECT_EQ(all[middle_replicate(count)].speed_factor, 1) << count;
    if (count % 2 == 1) EXPECT_EQ(all[middle_replicate(count)].elements_per_radius, 10) << count;
    std::set<double> speeds;
    for (const Problem& p : all) speeds.insert(p.speed_factor);
    EXPECT_EQ(speeds.size(), all.size()) << "each at a speed of its own";
    EXPECT_LT(std::abs(*speeds.rbegin() - 1), 0.001 * count);
  }
}

TEST(Replicates, SpeedsStepOutwardsInTenthsOfAPercent) {
  const double expected[] = {1, 1.001, 0.999, 1.002, 0.998, 1.003, 0.997};
  for (int k = 0; k < 7; ++k) EXPECT_DOUBLE_EQ(replicate_speed_factor(k), expected[k]) << k;
}

TEST(Replicates, UsualColumnsFollowTheMeshAndGivenOnesStay) {
  for (const Problem& p : replicates_of(usual_problem(), 5)) EXPECT_EQ(p.graded_columns, usual_graded_columns(p));
  Problem given = usual_problem();
  given.graded_columns = 5;
  for (const Problem& p : replicates_of(given, 5)) EXPECT_EQ(p.graded_columns, 5);
}

TEST(Replicates, DoNotWalkOffACoarseMesh) {
  for (const double n : {1.0, 2.0, 3.0})
    for (const double mesh : {replicate_mesh(n, 0, 9), replicate_mesh(n, 8, 9)}) {
      EXPECT_GT(mesh, 0.75 * n);
      EXPECT_LT(mesh, 1.25 * n);
    }
}

// A uniform sample of n has its largest gap at ln(n)/n; this one at less than 3/n.
TEST(Replicates, DrawnMeshesFillTheSpanEvenlyForAnySeed) {
  for (const unsigned seed : {0u, 1u, 20090401u, 4294967295u}) {
    std::vector<double> drawn;
    for (int k = 0; k < 200; ++k) drawn.push_back(drawn_mesh(8, seed, k));
    std::sort(drawn.begin(), drawn.end());
    EXPECT_GE(drawn.front(), 8 - phase_span / 2);
    EXPECT_LE(drawn.back(), 8 + phase_span / 2);
    for (std::size_t k = 1; k < drawn.size(); ++k) EXPECT_LT(drawn[k] - drawn[k - 1], 3 * phase_span / 200) << seed;
  }
  EXPECT_NE(drawn_mesh(8, 1, 0), drawn_mesh(8, 2, 0));
  EXPECT_EQ(drawn_mesh(8, 1, 7), drawn_mesh(8, 1, 7));
}

}  // namespace
}  // namespace percal
