// percal predict on the command line, from a result that holds what predictions need and nothing else.
#include <gmock/gmock.h>

#include "percal/base/version.hpp"
#include "predict/smooth_model.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class PredictCommand : public test::Program {
 protected:
  void SetUp() override { write("result.json", result().dump()); }
  static json result() {
    return {
        {"schema", result_schema}, {"command", "calibrate"}, {"shot_model", shot_model_to_json(test::smooth_model())}};
  }
};

TEST_F(PredictCommand, SaysADepthAndWritesNothingUnasked) {
  const auto before = files();
  const auto ended = run({"predict", "result.json", "--speed", "83m/s"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("3.18 mm at 83 m/s"), HasSubstr("95 % of one shot")));
  EXPECT_EQ(files(), before);
}

TEST_F(PredictCommand, AnswersInJsonAsOnItsPage) {
  const auto ended = run({"predict", "result.json", "--speed", "80 m/s", "--json"});
  const json said = json::parse(ended.out);
  SphereShot shot = test::smooth_model().shots[1];
  EXPECT_NEAR(said["shots"][0]["depth_m"].get<double>() / test::true_depth(shot), 1, 0.01);
  EXPECT_EQ(said["fired"].size(), 3u);
  EXPECT_TRUE(said["solved"].is_null());
  const auto wanted = run({"predict", "result.json", "--depth", "40 mm", "--json"});
  EXPECT_GT(json::parse(wanted.out)["solved"]["value_m_s"], 1.0);
  EXPECT_EQ(run({"predict", "result.json", "--depth", "4 km"}).code, 3);
}

// The smooth law's depths taken for reaches: behind a layer of 30 mm some speed is left.
TEST_F(PredictCommand, SaysWhatPassesAndWithWhichSpeed) {
  json knows = result();
  knows["shot_model"]["passage"] = true;
  write("knows.json", knows.dump());
  const auto ended =
      run({"predict", "knows.json", "--speed", "80m/s", "--layer-depth", "30mm", "--json", "--out", "out"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const json shot = json::parse(ended.out)["shots"][0];
  SphereShot thin = test::smooth_model().shots[1];
  thin.layer_depth = 0.03;
  const double reach = test::true_depth(thin);
  ASSERT_GT(reach, 0.03);
  EXPECT_NEAR(shot["speed_left"]["speed_left_m_s"].get<double>(), 80 * std::sqrt(1 - 0.03 / reach), 1);
  EXPECT_GT(shot["passes_probability"], 0.9);
  EXPECT_LT(shot["speed_left"]["speed_left_shot_interval_m_s"]["low"], shot["speed_left"]["speed_left_m_s"]);
  EXPECT_TRUE(files().contains("out/passing_over_speed.csv"));
  const auto v50 = run({"predict", "knows.json", "--v50", "--layer-depth", "30mm", "--json"});
  const json solved = json::parse(v50.out)["solved"];
  thin.speed = solved["value_m_s"];
  EXPECT_NEAR(test::true_depth(thin), 0.03, 3e-4);
}

TEST_F(PredictCommand, WritesATableForATable) {
  write("shots.csv", "speed_m_s\n60\n80\n");
  const auto ended = run({"predict", "result.json", "--shots", "shots.csv", "--out", "out"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(files().contains("out"));
  EXPECT_EQ(run({"report", "out", "--check"}).code, 0);
}

TEST_F(PredictCommand, ARefusedResultEndsWithCode2AndSaysWhy) {
  json cut = result();
  cut["shot_model"].erase("runs");
  write("cut.json", cut.dump());
  const auto without = run({"predict", "cut.json", "--speed", "80 m/s"});
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("cut.json: runs"));
  cut = result();
  cut["schema"] = 1;
  write("old.json", cut.dump());
  EXPECT_THAT(run({"predict", "old.json", "--speed", "80 m/s"}).err, HasSubstr("schema"));
}

}  // namespace
}  // namespace percal
