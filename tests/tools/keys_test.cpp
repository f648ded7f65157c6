// The reference of keys and the templates: made from what the readers say.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "percal/base/version.hpp"
#include "predict/smooth_model.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::HasSubstr;

const std::vector<std::string> kinds{"scene", "scale", "identify", "calibrate", "campaign", "dose"};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

// "# key = value   # default: ..." or a header: a line of the template that is a comment but could be live.
bool is_commented_entry(const std::string& line) {
  static const std::regex entry(R"(# (\w+ = |\[).*)");
  return std::regex_match(line, entry);
}
bool says(const std::string& line, const std::string& note) {
  const auto comment = line.find("  # ");
  return comment != std::string::npos && line.compare(comment + 4, note.size(), note) == 0;
}
bool is_alternative(const std::string& line) { return says(line, "instead of") || says(line, "only "); }
std::string live(const std::string& line) { return line.substr(2); }
std::string key_of(const std::string& line) { return line.substr(0, line.find(" = ")); }

class Keys : public test::Program {
 protected:
  // What templates of powders name.
  void write_calibration_of_skin() const {
    ShotModel model = test::smooth_model();
    model.hypotheses.front().materials.front().name = "skin";
    const json result{{"schema", result_schema}, {"command", "calibrate"}, {"shot_model", shot_model_to_json(model)}};
    std::filesystem::create_directories(path("skin.out"));
    write("skin.out/result.json", result.dump());
  }
};

TEST_F(Keys, ThePageIsWhatTheProgramPrints) {
  const Ended ended = run({"keys", "--markdown"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, text_of(test::docs + "formats/keys.md")) << "percal keys --markdown > docs/formats/keys.md";
}

TEST_F(Keys, EveryKeyHasAMeaningAndEveryMeaningAKey) {
  for (const auto& kind : kinds) {
    const Ended ended = run({"keys", kind, "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;  // the program refuses otherwise
    const json keys = json::parse(ended.out)["keys"];
    for (const json& key : keys) EXPECT_NE(key["meaning"], "") << key;
  }
}

TEST_F(Keys, AKeyIsAsTheReaderSaysIt) {
  const json keys = json::parse(run({"keys", "scene", "--json"}).out)["keys"];
  const auto key = [&](const std::string& name) {
    return *std::find_if(keys.begin(), keys.end(), [&](const json& k) { return k["key"] == name; });
  };
  EXPECT_EQ(key("particle.speed")["kind"], "speed");
  EXPECT_EQ(key("particle.speed")["required"], true);
  EXPECT_EQ(key("solver.rates")["accepted"], "a whole number from 1 to 2");
  EXPECT_EQ(key("solver.rates")["default"], "2");
  EXPECT_EQ(key("target.bottom")["accepted"], "\"free\", \"fixed\"");
  EXPECT_EQ(key("target.relaxation[].share")["kind"], "number");
  EXPECT_EQ(key("target.erosion.stress")["kind"], "pressure");
}

class NewTemplate : public Keys, public testing::WithParamInterface<std::string> {
 protected:
  std::string command() const { return GetParam() == "scene" ? "impact" : GetParam(); }
  std::vector<std::string> written() const {
    const Ended ended = run({"new", GetParam(), "--all", "-o", "my.toml"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return lines_of(read("my.toml"));
  }
  Ended check(const std::vector<std::string>& lines) const {
    write("my.toml", joined(lines));
    if (GetParam() == "dose") write_calibration_of_skin();
    return run({command(), "my.toml", "--check"});
  }
};

TEST_P(NewTemplate, IsValidAsItStands) {
  const auto lines = written();
  const Ended ended = check(lines);
  EXPECT_EQ(ended.code, 0) << ended.err;
}

TEST_P(NewTemplate, IsValidWithEveryCommentTakenOff) {
  auto lines = written();
  for (auto& line : lines)
    if (is_commented_entry(line) && !is_alternative(line)) line = live(line);
  const Ended ended = check(lines);
  EXPECT_EQ(ended.code, 0) << ended.err;
}

// With all others live, the key that it stands in for is taken out.
TEST_P(NewTemplate, EveryAlternativeIsValidInPlaceOfWhatItNames) {
  auto lines = written();
  for (auto& line : lines)
    if (is_commented_entry(line) && !is_alternative(line)) line = live(line);
  static const std::regex named(R"(  # instead of ([a-z_, ]+):)");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (!says(lines[i], "instead of") || !std::regex_search(lines[i], match, named)) continue;
    auto changed = lines;
    changed[i] = live(lines[i]);
    const auto is_header = [](const std::string& line) { return line.starts_with('['); };
    auto first = changed.begin() + static_cast<long>(i), last = first;
    while (first != changed.begin() && !is_header(*first)) --first;
    while (last != changed.end() && !is_header(*last)) ++last;
    std::istringstream words(match[1]);
    for (std::string word; words >> word;)
      for (auto line = first; line != last; ++line)
        if (key_of(*line) == word) *line = "";
    const Ended ended = check(changed);
    EXPECT_EQ(ended.code, 0) << lines[i] << "\n" << ended.err;
  }
}

TEST_P(NewTemplate, HasEveryKeyAndShowsItsDefault) {
  const auto lines = written();
  const std::string text = joined(lines);
  const json keys = json::parse(run({"keys", GetParam(), "--json"}).out)["keys"];
  for (const json& key : keys) {
    const std::string path = key["key"], name = path.substr(path.rfind('.') + 1), value = key["default"];
    if (key["kind"] == "table" || key["kind"] == "tables" || name == "NAME") continue;
    EXPECT_THAT(text, HasSubstr(name + " = ")) << path;
    const bool is_value = value.find_first_of("\"0123456789") == 0 || value == "true" || value == "false";
    // Shown as the value of its line, or said beside an example; a line that is not commented out wants something else.
    if (is_value && path.find('.') != std::string::npos && path.rfind("scaled_line", 0) != 0) {
      const std::string plain = value.substr(0, value.find_first_of(":;"));
      const auto shows = [&](const std::string& line) {
        return line.starts_with("# " + name + " = " + plain + " ") || line.starts_with(name + " = ") ||
               (line.starts_with("# " + name + " = ") && line.find("default " + plain) != std::string::npos);
      };
      EXPECT_TRUE(std::ranges::any_of(lines, shows)) << path << ": " << value;
    }
  }
}

TEST_P(NewTemplate, NeverReplacesAFile) {
  write("my.toml", "mine");
  const Ended ended = run({"new", GetParam(), "-o", "my.toml"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("my.toml: found a file that is there already"));
  EXPECT_EQ(read("my.toml"), "mine");
  EXPECT_EQ(files(), (std::set<std::string>{"my.toml"}));
}

INSTANTIATE_TEST_SUITE_P(Kinds, NewTemplate, testing::ValuesIn(kinds), [](const auto& info) { return info.param; });

TEST_F(Keys, NewJobIsACalibrationAndNewFitACurve) {
  EXPECT_EQ(run({"new", "job"}).out, run({"new", "calibrate"}).out);
  EXPECT_EQ(run({"new", "impact"}).out, run({"new", "scene"}).out);
  EXPECT_EQ(run({"keys", "impact"}).out, run({"keys", "scene"}).out);
  ASSERT_EQ(run({"new", "fit", "-o", "curve.csv"}).code, 0);
  EXPECT_EQ(run({"fit", "curve.csv"}).code, 0);
}

// FBI's acceptance band: data/public/gelatin_bb_calibration_points.csv.
TEST_F(Keys, TheNewSceneIsABBThatGelatinStopsWhereItShould) {
  ASSERT_EQ(run({"new", "scene", "-o", "bb.toml"}).code, 0);
  const json found = json::parse(run({"impact", "bb.toml", "--replicates", "1", "--store", "s", "--json"}).out);
  EXPECT_EQ(found["outcome"], "stopped");
  EXPECT_NEAR(found["depth_m"], 0.085, 0.01);
}

// Half the radius makes half the depth, at the modulus of the squared ratio of speeds.
TEST_F(Keys, TheNewScalingHasAnAnswer) {
  ASSERT_EQ(run({"new", "scale", "-o", "my.toml"}).code, 0);
  const json found = json::parse(run({"scale", "my.toml", "--json"}).out);
  EXPECT_EQ(found["not_similar_because"], json::array());
  EXPECT_NEAR(found["modulus_ratio"], 4.0 / 9, 1e-12);
}

TEST_F(Keys, TheNewCalibrationIsAsLongAsOneNeedsAndValidWithItsCurveToo) {
  ASSERT_EQ(run({"new", "calibrate", "-o", "my.toml"}).code, 0);
  EXPECT_EQ(files(), (std::set<std::string>{"my.toml", "my_shots.csv", "my_curve.csv"}));
  auto lines = lines_of(read("my.toml"));
  EXPECT_LE(lines.size(), 45U);
  EXPECT_EQ(run({"calibrate", "my.toml", "--check"}).code, 0);
  for (auto& line : lines)
    if (is_commented_entry(line)) line = live(line);
  write("my.toml", joined(lines));
  const Ended ended = run({"calibrate", "my.toml", "--check"});
  EXPECT_EQ(ended.code, 0) << ended.err;
}

TEST_F(Keys, TheNewDoseAndTheNewDesignAreJobsOfTheSameKind) {
  write_calibration_of_skin();
  for (const char* kind : {"dose", "design"}) {
    const std::string file = std::string(kind) + ".toml";
    ASSERT_EQ(run({"new", kind, "-o", file}).code, 0);
    auto lines = lines_of(read(file));
    for (auto& line : lines)
      if (is_commented_entry(line)) line = live(line);
    write(file, joined(lines));
    const Ended ended = run({kind, file, "--check"});
    EXPECT_EQ(ended.code, 0) << ended.err;
  }
  EXPECT_EQ(run({"keys", "design"}).out, run({"keys", "dose"}).out);
}

TEST_F(Keys, ATableThatWouldBeReplacedStopsTheWholeTemplate) {
  write("my_shots.csv", "mine");
  EXPECT_EQ(run({"new", "calibrate", "-o", "my.toml"}).code, 2);
  EXPECT_EQ(files(), (std::set<std::string>{"my_shots.csv"}));
}

}  // namespace
}  // namespace percal
