// percal invert on the command line.
#include <gmock/gmock.h>

#include "support/program.hpp"

namespace percal {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class InvertCommand : public test::Program {
 protected:
  static std::vector<std::string> words(const std::string& depth, const std::string& further = "") {
    auto all = test::words_of("invert --depth " + depth +
                              " --diameter 4.5mm --speed 100m/s --alpha 5 --erosion-strain 1 --layer-depth 40mm "
                              "--layer-width 11.25mm --elements-per-radius 4 --store store " +
                              further);
    for (const char* word : {"--particle-density", "2500 kg/m3", "--density", "1000 kg/m3"}) all.push_back(word);
    return all;
  }
};

TEST_F(InvertCommand, SaysOnItsPageWhatItsResultSays) {
  const auto said = run(words("20mm", "--depth-error 1mm --out out"));
  ASSERT_EQ(said.code, 0) << said.err;
  const json found = result("out/result.json");
  EXPECT_TRUE(files().contains("out/ridge.csv"));
  EXPECT_EQ(found["ridge"].size(), 5u);
  EXPECT_EQ(found["pair"], found["ridge"][2]);
  const double mu = found["pair"]["mu_Pa"];
  EXPECT_THAT(said.out, HasSubstr("A true modulus of " + std::to_string(std::lround(mu / 1e3)) + " kPa (95 % "));
  const double low = found["pair"]["mu_interval_Pa"]["low"];
  EXPECT_THAT(said.out, HasSubstr(std::to_string(std::lround(low / 1e3)) + " kPa to"));
  EXPECT_EQ(found["errors"][1]["source"], "measured depth");
  EXPECT_NEAR(found["errors"][1]["of_depth"].get<double>(), 0.05, 1e-12);
  const auto again = run(words("20mm", "--depth-error 1mm --json"));
  EXPECT_EQ(json::parse(again.out)["pair"], found["pair"]);
  EXPECT_EQ(json::parse(again.out)["cost"]["runs"], 0) << "all from the store";
  EXPECT_EQ(run({"report", "out", "--check"}).code, 0);
}

TEST_F(InvertCommand, OutOfReachEndsWithCode3) {
  const auto ended = run(words("0.1mm"));
  EXPECT_EQ(ended.code, 3) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("out of reach"));
}

TEST_F(InvertCommand, BadWordsEndWithCode2AndNothingIsRun) {
  EXPECT_THAT(run(words("20mm", "--mu 300kPa")).err, AllOf(HasSubstr("--mu"), HasSubstr("--erosion-strain")));
  EXPECT_EQ(run(words("50mm")).code, 2);
  EXPECT_EQ(run({"invert"}).code, 2);
  EXPECT_EQ(run(words("20mm", "--check")).code, 0);
  EXPECT_TRUE(files().empty());
}

void collect_keys(const json& value, std::set<std::string>& keys) {
  for (const auto& [key, inner] : value.items()) {
    if (value.is_object()) keys.insert(key);
    if (inner.is_structured()) collect_keys(inner, keys);
  }
}

TEST_F(InvertCommand, EveryKeyOfItsResultIsOnItsPageOfFormats) {
  const auto ended = run(words("20mm", "--json"));
  json found = json::parse(ended.out);
  for (const char* of_all : {"schema", "percal", "command", "input", "cost"}) found.erase(of_all);
  std::set<std::string> keys;
  collect_keys(found, keys);
  const std::string page = text_of(test::docs + "formats/invert.md");
  for (const std::string& key : keys) EXPECT_THAT(page, HasSubstr("`" + key + "`"));
}

}  // namespace
}  // namespace percal
