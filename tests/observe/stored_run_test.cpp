#include "percal/observe/stored_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

namespace percal {
namespace {

// Numbers that need all their bits.
Evaluation awkward() {
  Evaluation run;
  ImpactResult& r = run.result;
  r.outcome = Outcome::stopped;
  r.depth = 0.1 + 0.2;
  r.end_time = 1.0 / 3;
  r.end_speed = -std::numbers::pi * 1e-17;
  r.sideways = 1 / 37.0;
  r.turn = -1 / 41.0;
  r.target_momentum = 1 / 43.0;
  r.elements = 204750;
  r.steps = 123456789012345;
  r.element_steps = 2.5278409e15 + 0.5;
  r.eroded = 42;
  r.distorted = 3;
  r.eroded_by = {30, 4, 5};
  r.smallest_jacobian = std::nextafter(1.0, 0);
  r.smallest_step = 5e-324;
  r.end_time = 1e300 / 7;
  r.energy = {.particle = 1 / 3.0,
              .particle_elastic = 1 / 5.0,
              .live_kinetic = 1 / 7.0,
              .freed_mass = 1 / 11.0,
              .elastic = 1 / 13.0,
              .hourglass = 1 / 17.0,
              .viscosity = 1 / 19.0,
              .relaxation = 1 / 47.0,
              .eroded = 1 / 23.0,
              .collisions = 1 / 31.0};
  run.instruction_level = "x86_64_v3";
  run.wall_seconds = 0.1;
  run.cpu_seconds = 1 / 9.0;
  return run;
}

TEST(Payload, ComesBackToTheLastBit) {
  const Evaluation before = awkward(), after = from_payload(to_payload(before));
  const ImpactResult &a = before.result, &b = after.result;
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.elements, b.elements);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.eroded, b.eroded);
  EXPECT_EQ(a.distorted, b.distorted);
  EXPECT_EQ(a.eroded_by, b.eroded_by);
  for (double ImpactResult::*number :
       {&ImpactResult::depth, &ImpactResult::end_time, &ImpactResult::end_speed, &ImpactResult::sideways,
        &ImpactResult::turn, &ImpactResult::target_momentum, &ImpactResult::element_steps,
        &ImpactResult::smallest_jacobian, &ImpactResult::smallest_step})
    EXPECT_EQ(a.*number, b.*number);
  for (const auto& [key, share, words] : energy_terms) EXPECT_EQ(a.energy.*share, b.energy.*share) << key;
  EXPECT_EQ(before.instruction_level, after.instruction_level);
  EXPECT_EQ(before.cpu_seconds, after.cpu_seconds);
  EXPECT_EQ(before.wall_seconds, after.wall_seconds);
  EXPECT_FALSE(before.reused);
  EXPECT_TRUE(after.reused);
}

TEST(Payload, APathInSpaceComesBackToTheLastBit) {
  Evaluation before = awkward();
  EXPECT_FALSE(from_payload(to_payload(before)).result.in_space);
  before.result.in_space = {.across = 1 / 3.0, .axis = {1 / 7.0, -1 / 11.0, 1 / 13.0}};
  const auto after = from_payload(to_payload(before)).result.in_space;
  ASSERT_TRUE(after);
  EXPECT_EQ(after->across, before.result.in_space->across);
  EXPECT_EQ(after->axis, before.result.in_space->axis);
}

TEST(Payload, FieldMeasuresComeBackToTheLastBit) {
  Evaluation before = awkward();
  before.result.speeds_behind = {1 / 3.0, 1 / 7.0};
  before.result.channel = {.largest = {1 / 11.0, 0}, .end = {1 / 13.0, std::numeric_limits<double>::quiet_NaN()}};
  before.result.aftermath = {.ending = Ending::time_up,
                             .reason = "the time step collapsed",
                             .depth = 1 / 17.0,
                             .half_width = 1 / 19.0,
                             .time = 1 / 23.0,
                             .speed = -1 / 29.0,
                             .eroded = 12,
                             .energy = {.particle = 1 / 31.0, .eroded = 1 / 37.0}};
  const ImpactResult a = before.result, b = from_payload(to_payload(before)).result;
  EXPECT_EQ(a.speeds_behind, b.speeds_behind);
  EXPECT_EQ(a.channel.largest, b.channel.largest);
  EXPECT_EQ(a.channel.end[0], b.channel.end[0]);
  EXPECT_TRUE(std::isnan(b.channel.end[1]));
  ASSERT_TRUE(b.aftermath);
  EXPECT_EQ(a.aftermath->ending, b.aftermath->ending);
  EXPECT_EQ(a.aftermath->reason, b.aftermath->reason);
  EXPECT_EQ(a.aftermath->eroded, b.aftermath->eroded);
  for (double Aftermath::*number : {&Aftermath::depth, &Aftermath::half_width, &Aftermath::time, &Aftermath::speed})
    EXPECT_EQ((*a.aftermath).*number, (*b.aftermath).*number);
  for (const auto& [key, share, words] : energy_terms)
    EXPECT_EQ(a.aftermath->energy.*share, b.aftermath->energy.*share) << key;
}

TEST(Payload, ARunThatKnowsLessThanIsAskedForIsRunAgain) {
  Problem one_layer, layered;
  one_layer.depth = 30;
  layered.depth = 10;
  layered.below = {LowerLayer{.depth = 15}, LowerLayer{.depth = 15}};
  ImpactResult run;
  run.depth = 27.5;
  EXPECT_FALSE(lacks_something(run, one_layer));
  EXPECT_TRUE(lacks_something(run, layered));
  run.speeds_behind = {0.5};
  EXPECT_TRUE(lacks_something(run, layered)) << "it crossed two faces";
  run.speeds_behind = {0.5, 0.2};
  EXPECT_FALSE(lacks_something(run, layered));
  one_layer.channel = true;
  EXPECT_TRUE(lacks_something(run, one_layer));
  run.channel.largest.resize(channel_shares.size());
  EXPECT_FALSE(lacks_something(run, one_layer));
}

// Stores of users live on: these keys, in this form.
TEST(Payload, HasTheFormatOfEarlierStores) {
  Evaluation run;
  run.result.outcome = Outcome::stopped;
  run.result.depth = 27.5;
  run.result.energy.eroded = 0.75;
  run.instruction_level = "x86_64_v3";
  EXPECT_EQ(
      to_payload(run),
      R"({"cpu_s":0.0,"depth":27.5,"distorted":0,"element_steps":0.0,"elements":0,"end_speed":0.0,"end_time":0.0,)"
      R"("energy":{"collisions":0.0,"elastic":0.0,"eroded":0.75,"freed_mass":0.0,)"
      R"("hourglass":0.0,"live_kinetic":0.0,"particle":0.0,"particle_elastic":0.0,"relaxation":0.0,"sum":0.75,)"
      R"("viscosity":0.0},"eroded":0,"level":"x86_64_v3","outcome":"stopped","reason":"",)"
      R"("sideways":0.0,"smallest_jacobian":1.0,"smallest_step":0.0,"steps":0,"target_momentum":0.0,"turn":0.0,)"
      R"("wall_s":0.0})");
}

TEST(Payload, EveryOutcomeAndReasonComesBack) {
  for (const Outcome outcome : {Outcome::stopped, Outcome::passed_through, Outcome::time_up, Outcome::unstable}) {
    Evaluation run = awkward();
    run.result.outcome = outcome;
    run.result.reason = "a \"force\" is\nnot finite";
    EXPECT_EQ(from_payload(to_payload(run)).result.outcome, outcome);
    EXPECT_EQ(from_payload(to_payload(run)).result.reason, run.result.reason);
  }
}

TEST(Payload, NanSurvivesAndInfinityComesBackAsOne) {
  Evaluation run = awkward();
  run.result.depth = std::numeric_limits<double>::quiet_NaN();
  run.result.energy.viscosity = std::numeric_limits<double>::quiet_NaN();
  run.result.energy.elastic = std::numeric_limits<double>::infinity();
  const Evaluation after = from_payload(to_payload(run));
  EXPECT_TRUE(std::isnan(after.result.depth));
  EXPECT_TRUE(std::isnan(after.result.energy.viscosity));
  EXPECT_TRUE(std::isnan(after.result.energy.elastic));
  EXPECT_TRUE(std::isnan(after.result.energy.sum()));
  EXPECT_EQ(after.result.energy.eroded, 1 / 23.0);
}

TEST(Payload, WhatIsNoPayloadIsRefused) {
  std::string misspelt = to_payload(awkward());
  misspelt.replace(misspelt.find("\"stopped\""), 9, "\"stooped\"");
  std::string wrong_kind = to_payload(awkward());
  wrong_kind.replace(wrong_kind.find("\"elements\":204750"), 17, "\"elements\":\"many\"");
  const std::string good = to_payload(awkward());
  for (const std::string& text : {std::string(), std::string("{}"), std::string("garbage"), std::string("[1, 2]"),
                                  std::string("null"), good.substr(0, good.size() / 2), misspelt, wrong_kind})
    EXPECT_THROW(from_payload(text), std::invalid_argument) << text;
}

TEST(EnergyJson, HasEveryTermAndTheSum) {
  const auto json = energy_to_json(awkward().result.energy);
  EXPECT_EQ(json.size(), std::size(energy_terms) + 1);
  for (const auto& [key, share, words] : energy_terms) EXPECT_EQ(json.at(key), awkward().result.energy.*share) << key;
  double sum = 0;
  for (const auto& [key, share] : json.items())
    if (key != "sum") sum += share.get<double>();
  EXPECT_NEAR(json.at("sum"), sum, 1e-15);
  EXPECT_EQ(json.at("collisions"), 1 / 31.0);
}

}  // namespace
}  // namespace percal
