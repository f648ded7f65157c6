// predict: depths of shots that were not fired, from a finished calibration.
//
// The model of a result.json, without its job, tables and runs; a predictor of one of its materials under one of its hypotheses.
//
//     const percal::ShotModel model = percal::shot_model_of(result, "joint.out/result.json");
//     const percal::Predictor gel(model, 0, 0, 0.95);
//     const percal::SphereShot bb{.radius = 2.25e-3, .density = 7800, .speed = 180, .layer_depth = 0.3, .layer_width = 0.05};
//     const percal::DepthPrediction answer = gel.depths(std::span(&bb, 1)).front();
//
// See docs/theory/prediction.md.
#pragma once
#include "percal/predict/explore/explorer.hpp"
#include "percal/predict/mixture.hpp"
#include "percal/predict/page/page.hpp"
#include "percal/predict/predictor.hpp"
#include "percal/predict/request.hpp"
#include "percal/predict/shot_model.hpp"
#include "percal/predict/shot_words.hpp"
#include "percal/predict/sphere_shot.hpp"
