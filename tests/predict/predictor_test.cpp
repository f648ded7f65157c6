#include "percal/predict/predictor.hpp"

#include <gmock/gmock.h>

#include "predict/smooth_model.hpp"

namespace percal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Predicted : public testing::Test {
 protected:
  const ShotModel model_ = test::smooth_model();
  const Predictor gel_{model_, 0, 0, 0.95};
  const SphereShot like_ = model_.shots[1];
};

TEST_F(Predicted, DepthsAreThoseOfTheLaw) {
  for (const FiredShot& shot : model_.shots) {
    const SphereShot one = shot;
    const DepthPrediction depth = gel_.depths(std::span(&one, 1)).front();
    EXPECT_NEAR(depth.depth / test::true_depth(one), 1, 0.01);
    EXPECT_THAT(depth.outside, IsEmpty());
    EXPECT_NEAR(depth.speed_exponent, 2 * (0.35 + 0.02 * 8), 0.05);  // of the law
  }
}

TEST_F(Predicted, IntervalsHoldParametersScatterAndSpeed) {
  const auto half = [](const Between& interval) { return std::log(interval.high / interval.low) / 2; };
  const DepthPrediction alone = gel_.depths(std::span(&like_, 1)).front();
  EXPECT_GT(half(alone.mean), 0.03);  // ln 1.1 of the modulus by the law's 0.5
  EXPECT_GT(half(alone.shot), std::hypot(half(alone.mean), 2 * 0.05) * 0.9);
  const DepthPrediction unsure = gel_.depths(std::span(&like_, 1), 0.1).front();
  EXPECT_NEAR(unsure.by_speed, 0.1 * alone.speed_exponent, 1e-9);
  EXPECT_GT(half(unsure.shot), 1.2 * half(alone.shot));
  EXPECT_EQ(half(unsure.mean), half(alone.mean));
  EXPECT_LT(alone.shot.low, alone.mean.low);
  EXPECT_LT(alone.depth, alone.mean.high);
  EXPECT_GT(alone.depth, alone.mean.low);
}

TEST_F(Predicted, ALayerAsDeepAsTheShotIsPassedByHalf) {
  SphereShot shot = like_;
  shot.layer_depth = gel_.best_depths(std::span(&shot, 1)).front();
  // The law hardly changes with the layer's depth; nothing is near the middle but this.
  const DepthPrediction depth = gel_.depths(std::span(&shot, 1)).front();
  EXPECT_NEAR(depth.passes, 0.5, 0.1);
  shot.layer_depth = 3 * depth.depth;
  EXPECT_LT(gel_.depths(std::span(&shot, 1)).front().passes, 1e-3);
}

TEST_F(Predicted, TheNumberThatGivesADepthGivesIt) {
  const double depth = 1.1 * gel_.best_depths(std::span(&like_, 1)).front();
  for (const ShotNumber number : {ShotNumber::speed, ShotNumber::diameter, ShotNumber::density}) {
    const SolvedShot solved = gel_.solve(number, like_, depth);
    ASSERT_TRUE(solved.found);
    EXPECT_NEAR(gel_.best_depths(std::span(&solved.at, 1)).front() / depth, 1, 1e-5);
    EXPECT_LT(solved.mean.low, solved.value);
    EXPECT_GT(solved.mean.high, solved.value);
    EXPECT_LT(solved.shot.low, solved.mean.low);
    EXPECT_GT(solved.shot.high, solved.mean.high);
  }
  EXPECT_FALSE(gel_.solve(ShotNumber::speed, like_, 1e3).found);
}

TEST_F(Predicted, WhatLiesBeyondTheShotsOrTheRunsIsSaid) {
  SphereShot fast = like_;
  fast.speed = 140;
  fast.density = 16000;
  EXPECT_THAT(gel_.depths(std::span(&fast, 1)).front().outside,
              ElementsAre(HasSubstr("speed 140 m/s, fitted 60 m/s to 100 m/s"), HasSubstr("density")));
  fast.speed = 2000;
  EXPECT_THAT(gel_.depths(std::span(&fast, 1)).front().outside, testing::Contains(HasSubstr("runs end")));
}

}  // namespace
}  // namespace percal
