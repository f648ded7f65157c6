#include "percal/predict/shot_model.hpp"

#include <gmock/gmock.h>

#include "percal/base/error.hpp"
#include "predict/smooth_model.hpp"

namespace percal {
namespace {

using page::Json;

// As a file has it.
Json result_of(const ShotModel& model) {
  return Json::parse(Json{{"command", "calibrate"}, {"shot_model", shot_model_to_json(model)}}.dump());
}

TEST(ShotModels, PredictTheSameBitsOnceTheyHaveBeenWrittenAndRead) {
  const ShotModel model = test::smooth_model();
  const ShotModel read = shot_model_of(result_of(model), "result.json");
  const SphereShot shot = model.shots[0];
  const DepthPrediction first = Predictor(model, 0, 0, 0.95).depths(std::span(&shot, 1), 0.01).front(),
                        second = Predictor(read, 0, 0, 0.95).depths(std::span(&shot, 1), 0.01).front();
  EXPECT_EQ(first.depth, second.depth);
  EXPECT_EQ(first.mean.low, second.mean.low);
  EXPECT_EQ(first.shot.high, second.shot.high);
  EXPECT_EQ(shot_model_to_json(model), shot_model_to_json(read));
}

TEST(ShotModels, KeepALength) {
  ShotModel model = test::smooth_model();
  for (LayerMaterial& point : model.hypotheses[0].materials[0].points) point.erosion_length = 1e-4;
  const ShotModel read = shot_model_of(result_of(model), "result.json");
  EXPECT_EQ(read.hypotheses[0].materials[0].points[1].erosion_length, 1e-4);
}

TEST(ShotModels, OfOtherResultsAreRefused) {
  EXPECT_THROW(shot_model_of({{"command", "fit"}}, "f"), BadInput);
  EXPECT_THROW(shot_model_of({{"command", "calibrate"}, {"shot_model", nullptr}}, "f"), BadInput);
  EXPECT_THROW(shot_model_of({{"command", "calibrate"}}, "f"), page::MissingKey);
  const auto broken = [](auto change) {
    Json result = result_of(test::smooth_model());
    change(result["shot_model"]);
    return result;
  };
  EXPECT_THROW(shot_model_of(broken([](Json& m) { m["runs"][0].erase(0); }), "f"), page::MissingKey);
  EXPECT_THROW(shot_model_of(broken([](Json& m) { m["shots"][0]["material"] = 7; }), "f"), page::MissingKey);
  for (const double material : {-1.0, 1e300})
    EXPECT_THROW(shot_model_of(broken([=](Json& m) { m["shots"][0]["material"] = material; }), "f"), page::MissingKey);
  EXPECT_THROW(shot_model_of(broken([](Json& m) { m["replicates"] = 1e300; }), "f"), page::MissingKey);
  // An emulator without the length of an input that its runs vary knows nothing.
  EXPECT_THROW(shot_model_of(broken([](Json& m) { m["settings"]["length"].erase("ln_pi4"); }), "f"), page::MissingKey);
  EXPECT_THROW(shot_model_of(broken([](Json& m) { m["settings"]["length"]["alpha"] = 0; }), "f"), page::MissingKey);
  EXPECT_THROW(shot_model_of(broken([](Json& m) { m["settings"]["length"]["fn_pi4"] = 1; }), "f"), page::MissingKey);
  EXPECT_THROW(shot_model_of(broken([](Json& m) { m["shots"] = Json::array(); }), "f"), page::MissingKey);
  EXPECT_THROW(shot_model_of(broken([](Json& m) { m["hypotheses"][0]["materials"][0]["points"][0][0] = -1; }), "f"),
               page::MissingKey);
}

}  // namespace
}  // namespace percal
