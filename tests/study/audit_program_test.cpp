// percal study --omissions and --extremes as a user runs them.
#include <gmock/gmock.h>

#include "support/program.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Every key of the result is on the page of formats.
void expect_documented(const json& value, const std::string& page) {
  if (value.is_object())
    for (const auto& [key, inner] : value.items()) {
      EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
      if (key != "input" && key != "outcomes") expect_documented(inner, page);
    }
  if (value.is_array())
    for (const auto& inner : value) expect_documented(inner, page);
}

class Audit : public test::Program {
 protected:
  // tests/data/layer.toml for a short time: nothing stops.
  std::string scene() const {
    return write("short.toml", text_of(test::test_data + "layer.toml") + "\n[solver]\nend_time = \"0.05 us\"\n");
  }
};

TEST_F(Audit, OfASceneThatDoesNotStopNamesEachOutcomeAndEndsWithCodeThree) {
  const Ended ended = run({"study", scene(), "--omissions", "--replicates", "3", "--markdown", "page.md"});
  EXPECT_EQ(ended.code, 3) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("The scene as it is ends as time up."),
                               HasSubstr("there is no depth to compare with"), Not(HasSubstr("elastic particle"))))
      << "the answer alone";
  const json found = result("short.out/result.json");
  EXPECT_EQ(found["study"], "omissions");
  EXPECT_GT(found["omissions"].size(), 15u);
  EXPECT_EQ(found["skipped"][0]["name"], "elastic particle") << "no Young's modulus";
  EXPECT_EQ(found["cost"]["runs"].get<std::size_t>(), 3 * (1 + found["omissions"].size()));
  expect_documented(found, text_of(test::docs + "formats/study.md"));
  EXPECT_THAT(read("short.out/omissions.csv"), HasSubstr("\"half the time step\",numerics,time up,"));
  EXPECT_THAT(read("page.md"),
              AllOf(HasSubstr("# What the omissions are worth: tungsten carbide into layer (short.toml)"),
                    HasSubstr("| one rate |"), HasSubstr("no comparison: time up (3 of 3 runs)"),
                    HasSubstr("Not run: elastic particle")));
  EXPECT_THAT(run({"study", scene(), "--omissions", "--replicates", "3", "--details"}).out,
              AllOf(HasSubstr("What was left out, and why"), HasSubstr("elastic particle")));
}

TEST_F(Audit, ACheckRunsNothing) {
  EXPECT_THAT(run({"study", scene(), "--omissions", "--check"}).out, HasSubstr("runs"));
  EXPECT_EQ(run({"study", "--extremes", "--check"}).code, 0);
  EXPECT_EQ(files(), (std::set<std::string>{"short.toml"}));
}

TEST_F(Audit, RefusesOptionsOfOtherStudies) {
  const std::string file = scene();
  EXPECT_EQ(run({"study", "--omissions"}).code, 2) << "no scene";
  EXPECT_EQ(run({"study", file, "--extremes"}).code, 2) << "brings its own";
  EXPECT_EQ(run({"study", file, "--omissions", "--extremes"}).code, 2) << "one at a time";
  EXPECT_EQ(run({"study", file, "--omissions", "--meshes", "3,4,5,6"}).code, 2);
  EXPECT_EQ(run({"study", "--extremes", "--replicates", "3"}).code, 2);
  EXPECT_EQ(files(), (std::set<std::string>{"short.toml"})) << "nothing was run";
}

class SlowAudit : public Audit {};

TEST_F(SlowAudit, TheMatrixIsPrintedAndWritten) {
  const Ended ended = run({"study", "--extremes", "--json", "--out", "out", "--markdown", "page.md", "--threads", "1"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(ended.out);
  EXPECT_EQ(found, result("out/result.json"));
  EXPECT_GE(found["cells"].size(), 60u);
  expect_documented(found, text_of(test::docs + "formats/study.md"));
  EXPECT_THAT(read("out/extremes.csv"), HasSubstr("\"pi4\",\"pi4 1e4\","));
  EXPECT_THAT(read("page.md"), AllOf(HasSubstr("# Stiff and extreme impacts"), HasSubstr("**Supersonic**"),
                                     HasSubstr("](out/energy_errors.svg)")));
}

}  // namespace
}  // namespace percal
