// The instruction level as a user chooses it: the program is run with PERCAL_ISA set.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "impact/element_reference.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

struct Ran {
  int exit_code;
  std::string output, errors;
};

// percal impact on the gold scene at 7 elements per radius, with a store of its own. Standard errors are read where asked for.
Ran run_gold(const std::string& level, const std::string& redirection = "2>/dev/null") {
  const auto store = std::filesystem::temp_directory_path() / ("percal_level_" + std::to_string(getpid()) + ".store");
  const std::string command = "PERCAL_ISA=" + level + " " + PERCAL_PROGRAM + " impact " + PERCAL_DATA +
                              "/guha2009/gold.toml --elements-per-radius 7 --json --store " + store.string() + " " + redirection;
  FILE* pipe = popen(command.c_str(), "r");
  Ran ran{-1, "", ""};
  std::array<char, 4096> buffer;
  while (const auto count = std::fread(buffer.data(), 1, buffer.size(), pipe)) ran.output.append(buffer.data(), count);
  ran.exit_code = WEXITSTATUS(pclose(pipe));
  for (const char* tail : {"", "-wal", "-shm"}) std::filesystem::remove(store.string() + tail);
  return ran;
}

// Levels differ in their last digits, which erosion turns into the scatter of replicates: three of them each.
TEST(InstructionLevel, DepthsOfAllLevelsAgreeWithinTheScatter) {
  std::map<std::string, double> depths;
  for (const auto& kernels : kernels_here()) {
    const Ran ran = run_gold(kernels.level);
    ASSERT_EQ(ran.exit_code, 0) << kernels.level;
    const auto json = nlohmann::json::parse(ran.output);
    EXPECT_EQ(json.at("isa"), kernels.level);
    depths[kernels.level] = json.at("depth_m");
  }
  for (const auto& [level, depth] : depths)
    for (const auto& [other, other_depth] : depths) EXPECT_NEAR(depth / other_depth, 1, 0.05) << level << " and " << other;
}

TEST(InstructionLevel, TheBestIsChosenWhereNoneIsNamed) {
  const Ran ran = run_gold("");
  ASSERT_EQ(ran.exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(ran.output).at("isa"), kernels_here().back().level);
}

TEST(InstructionLevel, AnUnknownOneIsBadInputThatNamesTheKnown) {
  const Ran ran = run_gold("pentium", "2>&1");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.output, HasSubstr("PERCAL_ISA: found pentium; accepted: x86_64_v4, x86_64_v3, x86_64_v2"));
}

TEST(InstructionLevel, OneThatTheProcessorLacksIsBadInput) {
  if (kernels_here().size() == 3) GTEST_SKIP() << "this processor has them all";
  const Ran ran = run_gold("x86_64_v4", "2>&1");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.output, HasSubstr("a level that this processor has"));
}

}  // namespace
}  // namespace percal
