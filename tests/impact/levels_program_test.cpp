// The instruction level as a user chooses it: the program is run with PERCAL_ISA set.
#include <gmock/gmock.h>

#include <map>

#include "impact/element_reference.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using test::Ended;
using testing::HasSubstr;

class InstructionLevel : public test::Program {
 protected:
  // percal impact on the gold scene at 7 elements per radius, with a store for each level.
  Ended run_gold(const std::string& level) const {
    return run(
        {"impact", test::guha2009 + "gold.toml", "--elements-per-radius", "7", "--json", "--store", level + ".store"},
        [&] { setenv("PERCAL_ISA", level.c_str(), 1); });
  }
};

// Levels differ in their last digits, which erosion turns into the scatter of replicates: three of them each.
TEST_F(InstructionLevel, DepthsOfAllLevelsAgreeWithinTheScatter) {
  std::map<std::string, double> depths;
  for (const auto& kernels : kernels_here()) {
    const Ended ended = run_gold(kernels.level);
    ASSERT_EQ(ended.code, 0) << kernels.level;
    const auto json = nlohmann::json::parse(ended.out);
    EXPECT_EQ(json.at("cost").at("isa"), kernels.level);
    depths[kernels.level] = json.at("depth_m");
  }
  for (const auto& [level, depth] : depths)
    for (const auto& [other, other_depth] : depths)
      EXPECT_NEAR(depth / other_depth, 1, 0.05) << level << " and " << other;
}

TEST_F(InstructionLevel, TheBestIsChosenWhereNoneIsNamed) {
  const Ended ended = run_gold("");
  ASSERT_EQ(ended.code, 0);
  EXPECT_EQ(nlohmann::json::parse(ended.out).at("cost").at("isa"), kernels_here().back().level);
}

TEST_F(InstructionLevel, AnUnknownOneIsBadInputThatNamesTheKnown) {
  const Ended ended = run_gold("pentium");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("PERCAL_ISA: found pentium; accepted: x86_64_v4, x86_64_v3, x86_64_v2"));
}

TEST_F(InstructionLevel, OneThatTheProcessorLacksIsBadInput) {
  if (kernels_here().size() == 3) GTEST_SKIP() << "this processor has them all";
  const Ended ended = run_gold("x86_64_v4");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("a level that this processor has"));
}

}  // namespace
}  // namespace percal
