#include "percal/scaling/groups.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "percal/base/error.hpp"
#include "systems.hpp"

namespace percal {
namespace {

using testing::ElementsAre;

TEST(Groups, AreTenInTheOrderOfTheTable) {
  ASSERT_EQ(groups().size(), 10u);
  for (int number = 1; number <= 10; ++number) {
    EXPECT_EQ(group(number).number, number);
    EXPECT_EQ(group(number).symbol, "pi" + std::to_string(number));
  }
}

TEST(Groups, HaveNoDimension) {
  for (const auto& one : groups()) {
    Dimension sum;
    for (const auto& factor : one.factors) {
      auto dimension = system_quantity(factor.member).dimension;
      sum.mass += factor.power * dimension.mass;
      sum.length += factor.power * dimension.length;
      sum.time += factor.power * dimension.time;
    }
    EXPECT_EQ(sum, dimension::none) << one.symbol;
  }
}

// The formula's symbols are exactly those of its factors, so the printed text is what is computed.
TEST(Groups, PrintTheFormulaThatTheyCompute) {
  for (const auto& one : groups()) {
    std::set<std::string> symbols, printed;
    for (const auto& factor : one.factors) {
      auto symbol = system_quantity(factor.member).symbol;
      symbols.insert(std::abs(factor.power) == 1 ? symbol : symbol + "^" + std::to_string(std::abs(factor.power)));
    }
    std::istringstream words(one.formula);
    for (std::string word; words >> word;)
      if (word != "/") printed.insert(word);
    EXPECT_EQ(printed, symbols) << one.formula;
  }
}

TEST(Groups, OfGoldInSkinAreTheNumbersDoneByHand) {
  auto gold = gold_in_skin();
  EXPECT_DOUBLE_EQ(value(group(1), gold).value(), 75);
  EXPECT_DOUBLE_EQ(value(group(2), gold).value(), 5);
  EXPECT_NEAR(value(group(3), gold).value(), 0.0901, 5e-5);  // the "0.090" that is not small
  EXPECT_NEAR(value(group(4), gold).value(), 1000 * 651.0 * 651 / 63.75e6, 1e-12);
  EXPECT_NEAR(value(group(5), gold).value(), 1 / 16.8, 1e-12);
  EXPECT_EQ(value(group(6), gold), 8.5);
  EXPECT_EQ(value(group(7), gold), 0.7);
  EXPECT_NEAR(value(group(8), gold).value(), 26, 1e-12);
  gold.strain_rate = 651e6;
  gold.time = 2e-9;
  EXPECT_NEAR(value(group(9), gold).value(), 1, 1e-12);
  EXPECT_NEAR(value(group(10), gold).value(), 1.302, 1e-12);
}

TEST(Groups, SayWhatTheyLack) {
  System empty;
  EXPECT_THAT(missing_for(group(4), empty), ElementsAre("target_density", "speed", "mu"));
  auto gold = gold_in_skin();
  gold.mu.reset();
  EXPECT_THAT(missing_for(group(4), gold), ElementsAre("mu"));
  EXPECT_FALSE(value(group(4), gold));
  EXPECT_THAT(missing_for(group(5), gold), ElementsAre());
}

TEST(Groups, SolvedForAnyOfTheirNumbersGiveThatNumberBack) {
  auto gold = gold_in_skin();
  gold.strain_rate = 3e8;
  gold.time = 1e-7;
  for (const auto& one : groups())
    for (const auto& factor : one.factors) {
      double number = *(gold.*factor.member);
      EXPECT_NEAR(solve(one, *value(one, gold), factor.member, gold).value() / number, 1, 1e-14) << one.symbol;
    }
  EXPECT_FALSE(solve(group(1), 75, &System::speed, gold));
}

TEST(Comparison, AgreesWithinTheToleranceAndSaysByHowMuchItDoesNot) {
  auto gold = gold_in_skin(), other = gold;
  other.depth = 75e-6 * 1.02;
  other.width.reset();
  auto compared = compare(gold, other, 0.01);
  EXPECT_EQ(compared[0].agreement, Agreement::differ);
  EXPECT_NEAR(compared[0].difference.value(), 0.02, 1e-12);
  EXPECT_EQ(compared[1].agreement, Agreement::missing);
  EXPECT_THAT(compared[1].missing_in_model, ElementsAre("width"));
  EXPECT_THAT(compared[1].missing_in_prototype, ElementsAre());
  EXPECT_EQ(compared[3].agreement, Agreement::agree);
  EXPECT_EQ(compare(gold, other, 0.03)[0].agreement, Agreement::agree);
  EXPECT_EQ(compare(other, gold, 0.03)[0].agreement, Agreement::agree);
  EXPECT_EQ(compare(other, gold, 0.01)[0].agreement, Agreement::differ);
}

TEST(Comparison, OfAnExponentOfZeroAsksForZero) {
  auto gold = gold_in_skin(), other = gold;
  gold.alpha = other.alpha = 0;
  EXPECT_EQ(compare(gold, other, 0.01)[5].agreement, Agreement::agree);
  other.alpha = 1e-9;
  EXPECT_EQ(compare(gold, other, 0.01)[5].agreement, Agreement::differ);
}

// The figures that the rigid particle is justified with.
TEST(ParticleCompliance, IsSmallForGoldInSkinAndTinyForSteelInGelatin) {
  EXPECT_NEAR(particle_compliance(gold_in_skin()).value(), 0.0135, 0.0001);
  EXPECT_NEAR(particle_compliance(steel_in_gelatin()).value(), 4e-5, 0.3e-5);
  EXPECT_FALSE(particle_compliance(System{}));
}

}  // namespace
}  // namespace percal
