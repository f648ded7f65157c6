#include "percal/units/words.hpp"

#include <gtest/gtest.h>

namespace percal {
namespace {

TEST(NearestWord, FindsWhatWasMeant) {
  const std::vector<std::string> known{"radius", "density", "speed", "mu", "nu"};
  EXPECT_EQ(nearest_word("radus", known), "radius");
  EXPECT_EQ(nearest_word("raduis", known), "radius");
  EXPECT_EQ(nearest_word("Density", known), "density");
  EXPECT_EQ(nearest_word("Mu", known), "mu");
  EXPECT_EQ(nearest_word("x", known), std::nullopt);
  EXPECT_EQ(nearest_word("temperature", known), std::nullopt);
  EXPECT_EQ(nearest_word("", known), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(100000, 'r'), known), std::nullopt);
}

TEST(InQuotes, ShowsHostileTextSafely) {
  EXPECT_EQ(in_quotes("26 \u00b5m"), "\"26 \u00b5m\"");
  EXPECT_EQ(in_quotes("a\x1b[2J\n\xff"), "\"a\\x1b[2J\\x0a\\xff\"");
  EXPECT_LT(in_quotes(std::string(1000, 'x')).size(), 80u);
}

}  // namespace
}  // namespace percal
