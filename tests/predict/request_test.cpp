#include "percal/predict/request.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "percal/base/error.hpp"
#include "percal/text/file.hpp"
#include "predict/smooth_model.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

class Asked : public testing::Test, protected test::TemporaryFolder {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    write_file(path(name), text);
    return path(name);
  }
  PredictRequest ask(const PredictWords& words) const { return understood(words, model_); }
  std::string refusal(const PredictWords& words) const {
    try {
      ask(words);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "understood";
  }

  ShotModel model_ = test::smooth_model();
};

TEST_F(Asked, WhatTheShotsHaveInCommonNeedNotBeSaid) {
  const PredictRequest request = ask({.speed = "83 m/s"});
  ASSERT_EQ(request.shots.size(), 1u);
  EXPECT_EQ(request.shots[0].radius, 1.59e-3);
  EXPECT_EQ(request.shots[0].density, 7800);
  EXPECT_EQ(request.shots[0].speed, 83);
  EXPECT_EQ(request.shots[0].layer_depth, 0.12);
  EXPECT_EQ(request.shots[0].label, "3.18 mm at 83 m/s");
  EXPECT_THAT(refusal({}), AllOf(HasSubstr("--speed"), HasSubstr("differ in it")));
}

TEST_F(Asked, ARadiusInCommonIsNoneOfAShotOfAnotherSize) {
  const PredictRequest request = ask({.speed = "83 m/s",
                                      .sphere = {.diameter = "4.5 mm", .mass = "0.35 g"},
                                      .layer_depth = "20 cm",
                                      .speed_error = "2 %"});
  EXPECT_EQ(request.shots[0].radius, 2.25e-3);
  EXPECT_NEAR(request.shots[0].density, 0.35e-3 / (4.0 / 3 * std::numbers::pi * std::pow(2.25e-3, 3)), 1e-6);
  EXPECT_NEAR(request.shots[0].layer_width / request.shots[0].radius, 8e-3 / 1.59e-3, 1e-9);
  EXPECT_EQ(request.shots[0].layer_depth, 0.2);
  EXPECT_EQ(request.speed_error, 0.02);
}

TEST_F(Asked, ARangeIsACurveAndADepthASearch) {
  const PredictRequest range = ask({.speed = "50..250m/s"});
  EXPECT_EQ(range.speeds->low, 50);
  EXPECT_EQ(range.speeds->high, 250);
  const PredictRequest search = ask({.speed = "80 m/s", .depth = "3 cm", .solve_for = "diameter"});
  EXPECT_EQ(search.looked_for, ShotNumber::diameter);
  EXPECT_EQ(search.depth, 0.03);
}

TEST_F(Asked, PassingIsASearchForTheLayersOwnDepth) {
  EXPECT_THAT(refusal({.v50 = true}), HasSubstr("has not learnt what passes"));
  model_.passage = true;
  const PredictRequest search = ask({.layer_depth = "50 mm", .v50 = true});
  EXPECT_EQ(search.looked_for, ShotNumber::speed);
  EXPECT_EQ(search.depth, 0.05);
  EXPECT_THAT(refusal({.depth = "3 cm", .v50 = true}), HasSubstr("one of the two"));
  EXPECT_THAT(refusal({.speed = "80 m/s", .v50 = true}), HasSubstr("--speed"));
}

TEST_F(Asked, AColumnStandsBeforeItsOption) {
  const PredictRequest request = ask({.speed = "80 m/s", .shots = file("t.csv", "label,diameter_mm\nfirst,3\n,4\n")});
  ASSERT_EQ(request.shots.size(), 2u);
  EXPECT_EQ(request.shots[0].label, "first");
  EXPECT_EQ(request.shots[1].label, "4 mm at 80 m/s");
  EXPECT_EQ(request.shots[1].radius, 2e-3);
  EXPECT_TRUE(request.columns_passed_over.empty());
  const PredictRequest misspelt =
      ask({.speed = "80 m/s", .shots = file("m.csv", "diameter_mm,sped_m_s,day\n3,70,1\n")});
  EXPECT_THAT(misspelt.columns_passed_over, testing::ElementsAre("sped_m_s", "day"));
  EXPECT_EQ(request.shots[1].speed, 80);
  EXPECT_THAT(refusal({.shots = file("u.csv", "speed_m_s\n80\n-3\n")}), HasSubstr("u.csv:3"));
}

TEST_F(Asked, EveryFaultIsRefusedByName) {
  EXPECT_THAT(refusal({.material = "bone", .speed = "80 m/s"}), AllOf(HasSubstr("--material"), HasSubstr("\"gel\"")));
  EXPECT_THAT(refusal({.hypothesis = "2", .speed = "80 m/s"}), HasSubstr("--hypothesis"));
  EXPECT_THAT(refusal({.speed = "80"}), AllOf(HasSubstr("--speed"), HasSubstr("unit")));
  EXPECT_THAT(refusal({.speed = "90..80 m/s"}), HasSubstr("low before high"));
  EXPECT_THAT(refusal({.speed = "80 m/s", .sphere = {.radius = "1 mm", .diameter = "2 mm"}}),
              HasSubstr("one of the two"));
  EXPECT_THAT(refusal({.speed = "80 m/s", .depth = "3 cm"}), HasSubstr("which looks for the speed"));
  EXPECT_THAT(refusal({.speed = "50..80 m/s", .depth = "3 cm", .solve_for = "diameter"}),
              HasSubstr("a range beside --depth"));
  EXPECT_THAT(refusal({.solve_for = "speed"}), HasSubstr("without --depth"));
  EXPECT_THAT(refusal({.depth = "3 cm", .solve_for = "mass"}), HasSubstr("speed, diameter or density"));
  EXPECT_THAT(refusal({.speed = "80 m/s", .layer_depth = "1 mm"}), HasSubstr("more than the sphere's radius"));
}

TEST_F(Asked, OfSeveralMaterialsOneIsNamed) {
  model_.hypotheses[0].materials.push_back(model_.hypotheses[0].materials[0]);
  model_.hypotheses[0].materials[1].name = "skin";
  EXPECT_EQ(ask({.speed = "80 m/s"}).material, 0);  // the one that was shot into
  EXPECT_EQ(ask({.material = "skin",
                 .speed = "80 m/s",
                 .sphere = {.diameter = "3 mm", .density = "7800 kg/m3"},
                 .layer_depth = "1 cm"})
                .material,
            1);
  model_.shots[0].material = 1;
  EXPECT_THAT(refusal({.speed = "80 m/s"}), AllOf(HasSubstr("--material"), HasSubstr("skin")));
}

}  // namespace
}  // namespace percal
