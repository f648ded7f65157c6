#include "percal/observe/result_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

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
  r.smallest_jacobian = std::nextafter(1.0, 0);
  r.smallest_step = 5e-324;
  r.largest_gap = 1e300 / 7;
  r.energy = {.particle = 1 / 3.0,
              .particle_elastic = 1 / 5.0,
              .live_kinetic = 1 / 7.0,
              .freed_mass = 1 / 11.0,
              .elastic = 1 / 13.0,
              .hourglass = 1 / 17.0,
              .viscosity = 1 / 19.0,
              .relaxation = 1 / 47.0,
              .eroded = 1 / 23.0,
              .contact = 1 / 29.0,
              .contact_dropped = 1 / 31.0};
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
  for (double ImpactResult::*number :
       {&ImpactResult::depth, &ImpactResult::end_time, &ImpactResult::end_speed, &ImpactResult::sideways,
        &ImpactResult::turn, &ImpactResult::target_momentum, &ImpactResult::element_steps,
        &ImpactResult::smallest_jacobian, &ImpactResult::smallest_step, &ImpactResult::largest_gap})
    EXPECT_EQ(a.*number, b.*number);
  for (const auto& [key, share] : energy_terms) EXPECT_EQ(a.energy.*share, b.energy.*share) << key;
  EXPECT_EQ(before.instruction_level, after.instruction_level);
  EXPECT_EQ(before.cpu_seconds, after.cpu_seconds);
  EXPECT_EQ(before.wall_seconds, after.wall_seconds);
  EXPECT_FALSE(before.reused);
  EXPECT_TRUE(after.reused);
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
  for (const auto& [key, share] : energy_terms) EXPECT_EQ(json.at(key), awkward().result.energy.*share) << key;
  double sum = 0;
  for (const auto& [key, share] : json.items())
    if (key != "sum") sum += share.get<double>();
  EXPECT_NEAR(json.at("sum"), sum, 1e-15);
  EXPECT_EQ(json.at("contact_dropped"), 1 / 31.0);
}

constexpr const char* columns =
    "time_s,tip_m,speed_m_s,force_N,energy_particle,energy_particle_elastic,energy_live_kinetic,energy_freed_mass,"
    "energy_elastic,energy_hourglass,energy_viscosity,energy_relaxation,energy_eroded,energy_contact,"
    "energy_contact_dropped,energy_sum";

TEST(HistoryCsv, NamesItsUnitsAndIsInSi) {
  const std::vector<HistoryPoint> history{{0, 0, 1, 0, {.particle = 1}},
                                          {2, 1.5, 0.5, 0.25, {.particle = 0.25, .eroded = 0.5}}};
  const Scales scales{.radius = 1e-3, .speed = 100, .target_density = 1200};
  std::istringstream csv(history_csv(history, scales));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, columns);
  std::getline(csv, line);
  EXPECT_EQ(line, "0,0,100,0,1,0,0,0,0,0,0,0,0,0,0,1");
  double time, tip, speed, force;
  char comma;
  csv >> time >> comma >> tip >> comma >> speed >> comma >> force;
  EXPECT_NEAR(time, 2e-5, 1e-13);
  EXPECT_NEAR(tip, 1.5e-3, 1e-12);
  EXPECT_NEAR(speed, 50, 1e-7);
  EXPECT_NEAR(force, 0.25 * 2 * std::numbers::pi * 1200 * 1e4 * 1e-6, 1e-7) << "of the whole sphere, not per radian";
  std::getline(csv, line);
  EXPECT_EQ(line, ",0.25,0,0,0,0,0,0,0,0.5,0,0,0.75");
}

TEST(HistoryJson, HasTheColumnsOfTheCsv) {
  const std::vector<HistoryPoint> history{{0, 0, 1, 0, {.particle = 1}},
                                          {2, 1.5, 0.5, 0.25, {.particle = 0.25, .eroded = 0.5}}};
  const auto json = history_to_json(history, {.radius = 1e-3, .speed = 100, .target_density = 1200});
  EXPECT_EQ(json.at("tip_m"), (std::vector<double>{0, 1.5e-3}));
  EXPECT_EQ(json.at("speed_m_s"), (std::vector<double>{100, 50}));
  EXPECT_NEAR(json.at("time_s")[1], 2e-5, 1e-13);
  EXPECT_NEAR(json.at("force_N")[1], 0.25 * 2 * std::numbers::pi * 1200 * 1e4 * 1e-6, 1e-7);
  EXPECT_EQ(json.at("energy").size(), std::size(energy_terms) + 1);
  EXPECT_EQ(json.at("energy").at("eroded"), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(json.at("energy").at("sum"), (std::vector<double>{1, 0.75}));
}

TEST(HistoryCsv, WithoutPointsIsOnlyTheHeader) { EXPECT_EQ(history_csv({}, {}), std::string(columns) + "\n"); }

}  // namespace
}  // namespace percal
