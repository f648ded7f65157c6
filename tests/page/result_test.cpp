// Looking things up in a result: what is missing is named, what is null is absent, numbers have one form.
#include "percal/page/result.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "percal/page/numbers.hpp"

namespace percal {
namespace {

using namespace page;
using testing::ElementsAre;

const Json result = {{"depth_m", 2.6e-5},
                     {"nothing", nullptr},
                     {"found", false},
                     {"level", 0.9},
                     {"interval_Pa", {{"low", 1.2e6}, {"high", 3.4e6}, {"low_open", true}, {"high_open", false}}}};

TEST(Result, AMissingKeyIsNamedAndNotTakenForNo) {
  try {
    yes(result, "converged");
    FAIL() << "nothing was thrown";
  } catch (const MissingKey& missing) {
    EXPECT_EQ(missing.key, "converged");
  }
  EXPECT_THROW(number(result, "width_m"), MissingKey);
  EXPECT_THROW(text(Json::array(), "name"), MissingKey);
  EXPECT_THROW(value_words(result, "width"), MissingKey);
  EXPECT_TRUE(maybe(result, "converged").is_null());
}

TEST(Result, NullIsAbsentAndSoIsWhatIsLookedUpInIt) {
  EXPECT_FALSE(number(result, "nothing"));
  EXPECT_FALSE(number(at(result, "nothing"), "depth_m"));
  EXPECT_TRUE(list(result, "nothing").empty());
  EXPECT_EQ(interval_words(result, "nothing"), absent);
  EXPECT_FALSE(yes(result, "found"));
}

TEST(Result, NumbersAreShownInTheUnitOfTheirKey) {
  EXPECT_EQ(value_words(result, "depth"), "26 um");
  EXPECT_EQ(value_words(result, "depth_m"), "26 um");
  EXPECT_EQ(interval_words(result, "interval"), "below 1.2 MPa to 3.4 MPa");
  EXPECT_EQ(level_words(result), "90 %");
}

TEST(Numbers, WhatIsNoNumberIsAbsent) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& words : {shown(nan), pressure(nan), length({}), percent(nan), signed_percent(nan),
                                   rough_percent({}), quantity(1 / 0.0, dimension::time)})
    EXPECT_EQ(words, absent);
  EXPECT_TRUE(finite(nan).is_null());
  EXPECT_EQ(with_error("3 m", absent), "3 m");
}

TEST(Numbers, HaveOneForm) {
  EXPECT_EQ(percent(0.0234), "2.3 %");
  EXPECT_EQ(signed_percent(0.0234, 2), "+2.34 %");
  EXPECT_EQ(rough_percent(0.00001), "< 0.01 %");
  EXPECT_EQ(counted(1, "run") + ", " + counted(3, "run"), "1 run, 3 runs");
  EXPECT_EQ(pressure_unit(2e4).name, "kPa");
  EXPECT_EQ(length_unit(2e-5).name, "um");
  EXPECT_EQ(column_label("velocity_m_s"), "velocity, m/s");
}

TEST(Result, BeginsAndEndsAlikeForEveryCommand) {
  const Json head = result_head("fit", {{"toml", "a"}}), cost = cost_to_json({.runs = 3, .cpu_seconds = 2});
  EXPECT_EQ(head["schema"], 2);
  EXPECT_EQ(head["command"], "fit");
  EXPECT_EQ(cost["runs"], 3);
  EXPECT_TRUE(cost["reused"].is_null() && cost["budget_s"].is_null() && cost["isa"].is_null());
}

}  // namespace
}  // namespace percal
