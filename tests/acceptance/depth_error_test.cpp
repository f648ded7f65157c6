// The error of a depth on the command line; and that an erosion strain keeps its elements from identify to impact and card.
#include <gmock/gmock.h>

#include "acceptance/liver.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
using testing::MatchesRegex;

constexpr const char* ball = R"([particle]
name = "ball"
radius = "1 mm"
density = "1500 kg/m3"
speed = "100 m/s"
[target]
name = "gel"
density = "1000 kg/m3"
mu = "1 MPa"
alpha = 5
depth = "15 mm"
[mesh]
elements_per_radius = 5
[target.erosion]
strain = 0.9
)";

class DepthErrorOnTheCommandLine : public test::Program {
 protected:
  DepthErrorOnTheCommandLine() {
    write("ball.toml", ball);
    write("averaged.toml", std::string(ball) + "length_in_radii = 0.6\n");
  }
};

std::string how(const json& result, const std::string& source) {
  for (const json& one : result["depth_error"]["sources"])
    if (one["source"] == source) return one["how"];
  return "";
}

TEST_F(DepthErrorOnTheCommandLine, TheAnswerBeginsWithTheDepthAndItsError) {
  const Ended ended = run({"impact", "ball.toml", "--out", "none"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("\n  Depth "));
  const std::string answer = ended.out.substr(ended.out.find("  Depth "), 160);
  EXPECT_THAT(answer, MatchesRegex("  Depth [0-9.]+ mm ± [0-9.]+ mm \\(95 %: mesh phase [0-9.]+, wall [0-9.]+, step "
                                   "[0-9.]+, K[ \n]+[0-9.]+; belongs to elements of 1/5 radius\\)\n(.|\n)*"));
}

TEST_F(DepthErrorOnTheCommandLine, MeasuresWhatWasARule) {
  const json by_rule = json::parse(run({"impact", "ball.toml", "--json", "--out", "none"}).out);
  const json measured = json::parse(run({"impact", "ball.toml", "--json", "--out", "none", "--measure-errors"}).out);
  for (const char* source : {"wall", "time step", "K"}) {
    EXPECT_THAT(how(by_rule, source), HasSubstr("rule of random scenes")) << source;
    EXPECT_THAT(how(measured, source), HasSubstr("measured: ")) << source;
  }
  EXPECT_EQ(measured["depth_m"], by_rule["depth_m"]);
  EXPECT_EQ(measured["cost"]["runs"], 15) << "five from the store";
}

TEST_F(DepthErrorOnTheCommandLine, ExtrapolatesWhereErosionHasALength) {
  const json found = json::parse(run({"impact", "averaged.toml", "--extrapolate", "--json", "--out", "none"}).out);
  const json& line = found["extrapolation"];
  EXPECT_EQ(line["elements_per_radius"], json({5, 10}));
  EXPECT_EQ(line["mesh_depths_m"][0], found["depth_m"]);
  EXPECT_NEAR(line["depth_m"],
              (4 * line["mesh_depths_m"][1].get<double>() - line["mesh_depths_m"][0].get<double>()) / 3, 1e-12);
  EXPECT_TRUE(found["depth_error"]["belongs_to"].is_null());
  const json alone = json::parse(run({"impact", "averaged.toml", "--json", "--out", "none"}).out);
  EXPECT_TRUE(alone["extrapolation"].is_null());
  EXPECT_THAT(alone["depth_error"]["bias"]["how"].get<std::string>(), HasSubstr("0.33 of the erosion length"));
  const Ended refused = run({"impact", "ball.toml", "--extrapolate"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("the local rule has no limit"));
  EXPECT_EQ(run({"impact", "ball.toml", "--measure-errors", "--replicates", "1"}).code, 2);
}

TEST_F(DepthErrorOnTheCommandLine, ALadderBeginsWithThreeElementsInTheLength) {
  write("short.toml", std::string(ball).replace(std::string(ball).find("= 5\n[target.e"), 3, "= 9") +
                          "length_in_radii = 0.34\n");
  const Ended ended = run({"study", "short.toml", "--error-vs-time", "--check"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const Ended coarse = run({"study", "short.toml", "--error-vs-time", "--check", "--meshes", "5,9,13,18"});
  EXPECT_EQ(coarse.code, 2);
  EXPECT_THAT(coarse.err, HasSubstr("9 elements per radius or more"));
}

class ElementsOfAStrain : public acceptance::LiverJob {};

TEST_F(ElementsOfAStrain, AreThoseOfTheSceneTheImpactAndTheCard) {
  ASSERT_EQ(run({"identify", job(), "--quiet", "--out", "liver"}).code, 0);
  const Ended shot = run({"impact", "liver/scenes/calibration.toml", "--json", "--out", "none"});
  const json impact = json::parse(shot.out);
  EXPECT_EQ(impact["mesh"]["elements_per_radius"], 4) << "the ridge's";
  EXPECT_EQ(impact["depth_error"]["belongs_to"], "elements of 1/4 radius");
  const json erosion = result("liver/result.json")["cards"][0]["erosion"];
  EXPECT_EQ(erosion["element_over_radius"], 0.25);
  EXPECT_NEAR(erosion["element_m"], 5e-6, 1e-15);

  const std::vector<std::string> write_card{"card", "write", "liver/result.json", "--solver", "lsdyna"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), write_card.begin(), write_card.end());
    return run(more);
  };
  EXPECT_THAT(with({}).out, HasSubstr("for elements of 0.25 radii (5 um)"));
  const Ended other = with({"--element-size", "4 um"});
  ASSERT_EQ(other.code, 0) << other.err;
  EXPECT_THAT(other.err, HasSubstr("(95 %) for elements of 4 um (0.2 radii): with it a shot goes as deep"));
  EXPECT_THAT(other.out, HasSubstr("for elements of 0.2 radii (4 um)"));
  EXPECT_EQ(with({"--element-size", "4 um", "--shot", "calibration", "--check"}).code, 0);
  const Ended coarse = with({"--element-size", "6 um"}), unknown = with({"--element-size", "4 um", "--shot", "model"});
  EXPECT_EQ(coarse.code, 2);
  EXPECT_THAT(coarse.err, HasSubstr("500 nm to 5 um"));
  EXPECT_EQ(unknown.code, 2) << "a scene of another material";
  EXPECT_THAT(unknown.err, HasSubstr("calibration"));
  std::filesystem::rename(path("liver/result.json"), path("alone.json"));
  const Ended without = run({"card", "write", "alone.json", "--solver", "lsdyna", "--element-size", "4 um"});
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("with its scenes"));
}

}  // namespace
}  // namespace percal
