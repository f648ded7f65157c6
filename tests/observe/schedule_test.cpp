#include "percal/observe/schedule.hpp"

#include <gmock/gmock.h>

#include "percal/base/error.hpp"

namespace percal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(FieldInterval, HasAUnitOrIsANumberOfSteps) {
  const auto parse = [](const char* text) { return parse_field_interval(text, "--fields"); };
  EXPECT_DOUBLE_EQ(std::get<EveryTime>(parse("every=0.5us")).seconds, 5e-7);
  EXPECT_DOUBLE_EQ(std::get<EveryTime>(parse("every=2 ms")).seconds, 2e-3);
  EXPECT_DOUBLE_EQ(std::get<EveryDepth>(parse("every=10um")).metres, 1e-5);
  EXPECT_DOUBLE_EQ(std::get<EveryShareOfDepth>(parse("every=2%")).share, 0.02);
  EXPECT_DOUBLE_EQ(std::get<EveryShareOfDepth>(parse("every=0.5 %")).share, 0.005);
  EXPECT_EQ(std::get<EverySteps>(parse("every=200")).steps, 200);
}

TEST(FieldInterval, AnythingElseIsRefusedInOneMessage) {
  for (const char* text : {"", "0.5us", "every", "every=", "every=0", "every=-3", "every=0us", "every=-1us",
                           "every=1.5", "every=3kg", "every=200%", "every=0%", "every=x%", "every=1us2",
                           "every=1furlong", "every=99999999999999999999", "EVERY=1us", "every=1us%"}) {
    try {
      parse_field_interval(text, "--fields");
      FAIL() << text;
    } catch (const BadInput& error) {
      EXPECT_THAT(error.what(), HasSubstr("--fields: found \"" + std::string(text) + "\""));
      EXPECT_THAT(error.what(), HasSubstr("accepted: every=TIME"));
    }
  }
}

// Steps of a hundredth of a radius' travel, a tip that goes half as far; which steps are due.
std::vector<long> due_steps(const FieldInterval& interval, long steps) {
  Problem p;
  p.depth = 4;
  FieldSchedule schedule(interval, p, {.radius = 1e-3, .speed = 100, .target_density = 1000});
  std::vector<long> due;
  for (long step = 0; step < steps; ++step)
    if (schedule.is_due({.time = step / 100.0, .tip = step / 200.0, .step = step})) due.push_back(step);
  return due;
}

TEST(FieldSchedule, TheFirstStepAtOrPastEachMultipleIsDue) {
  EXPECT_THAT(due_steps(EverySteps{30}, 100), ElementsAre(0, 30, 60, 90));
  EXPECT_THAT(due_steps(EveryTime{2.53e-6}, 100), ElementsAre(0, 26, 51, 76)) << "0.253 of radius over speed";
  EXPECT_THAT(due_steps(EveryDepth{0.201e-3}, 100), ElementsAre(0, 41, 81));
  EXPECT_THAT(due_steps(EveryShareOfDepth{0.0501}, 100), ElementsAre(0, 41, 81)) << "of four radii";
}

TEST(FieldSchedule, AStepThatPassesSeveralMultiplesIsDueOnce) {
  EXPECT_THAT(due_steps(EveryTime{3e-8}, 4), ElementsAre(0, 1, 2, 3)) << "each step passes three";
}

}  // namespace
}  // namespace percal
