// docs/formats/impact.md names every key of the result.
#include "support/program.hpp"

namespace percal {
namespace {

class ImpactPage : public test::Program {};

TEST_F(ImpactPage, NamesEveryKeyOfTheResult) {
  const test::Ended ended = run({"impact", test::guha2009 + "gold.toml", "--elements-per-radius", "3", "--json"});
  const auto result = nlohmann::json::parse(ended.out);
  const std::string page = text_of(test::docs + "formats/impact.md");
  const auto is_named = [&](const std::string& key) { return page.find("`" + key + "`") != std::string::npos; };
  EXPECT_GT(result.size(), 20u);
  for (const auto& [key, value] : result.items()) EXPECT_TRUE(is_named(key)) << key;
  for (const auto& [key, value] : result.at("energy").items()) EXPECT_TRUE(is_named(key)) << "energy." << key;
  for (const auto& [key, value] : result.at("cost").items()) EXPECT_TRUE(is_named(key)) << "cost." << key;
  for (const auto& [key, value] : result.at("runs").at(0).items()) EXPECT_TRUE(is_named(key)) << "runs." << key;
}

}  // namespace
}  // namespace percal
