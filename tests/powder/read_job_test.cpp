// Jobs of powders: what they say, and what they are refused for.
#include <gmock/gmock.h>

#include <cmath>

#include "percal/powder/powder_model.hpp"
#include "powder/small_job.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PowderJobTest : public test::PowderFolder {
 protected:
  std::string refusal(const std::string& text) const {
    try {
      read_job(text);
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "nothing";
  }
};

TEST_F(PowderJobTest, AValueATableAndAHistogramAreDistributions) {
  write("sizes.csv", "diameter_from_um,diameter_to_um,share\n2,4,1\n4,8,3\n");
  const PowderJob job = read_job(test::PowderFolder::job("speed = \"80 m/s\"\n" + sizes));
  EXPECT_EQ(std::get<Lognormal>(job.powder.density).log_deviation, 0);
  EXPECT_NEAR(std::get<Lognormal>(job.powder.radius).log_deviation, std::log(1.1), 1e-12);
  EXPECT_TRUE(std::holds_alternative<NoBounce>(job.bounce));
  const PowderJob other = read_job(
      test::PowderFolder::job("[powder.diameter]\nfile = \"sizes.csv\"\nweighting = \"mass\"\n[powder.speed]\nedges = "
                              "[\"1 m/s\", \"2 m/s\", \"4 m/s\"]\nshares = [1, 1]\n",
                              ""));
  EXPECT_TRUE(other.sizes_by_mass);
  EXPECT_NEAR(std::get<Histogram>(other.powder.radius).front().low, 1e-6, 1e-15);
  EXPECT_EQ(std::get<Histogram>(other.powder.speed)[1].share, 0.5);
  EXPECT_EQ(std::get<Breach>(other.bounce).impact_parameter, 7);
}

TEST_F(PowderJobTest, SpeedsGoBySize) {
  write("speeds.csv", "diameter_um,speed_m_s\n1,800\n4,400\n");
  const PowderJob job = read_job(
      test::PowderFolder::job(sizes + "[powder.speed]\nby_size = \"speeds.csv\"\ngeometric_deviation = 1.2\n"));
  ASSERT_TRUE(job.powder.by_size);
  EXPECT_NEAR(job.powder.by_size->at(1e-6), std::sqrt(800. * 400), 1e-9);
  EXPECT_EQ(median_of(job.powder.speed), 1);
}

TEST_F(PowderJobTest, WhatCannotBeUsedIsRefusedByItsName) {
  const std::string fixed = "speed = \"80 m/s\"\n";
  write("down.csv", "radius_um,speed_m_s\n2,800\n1,400\n");
  write("bad.csv", "radius_um,share\n1,1\n-2,1\n");
  write("back.csv", "radius_from_um,radius_to_um\n2,1\n");
  write("bare.csv", "radius,share\n1,1\n");
  const auto sized = [&](const std::string& keys) {
    return test::PowderFolder::job(fixed + "[powder.radius]\n" + keys + "weighting = \"number\"\n");
  };
  const std::string good = fixed + sizes;
  const std::vector<std::pair<std::string, std::vector<std::string>>> wrong{
      {test::PowderFolder::job(fixed + "radius = \"1 um\"\ndiameter = \"2 um\"\n"),
       {"powder.diameter", "beside radius"}},
      {test::PowderFolder::job(fixed), {"powder.radius", "no such key"}},
      {test::PowderFolder::job("radius = 1e-6\n" + fixed), {"job.toml:6", "powder.radius", "length with its unit"}},
      {test::PowderFolder::job("radius = \"1 kg\"\n" + fixed), {"powder.radius", "\"1 kg\""}},
      {test::PowderFolder::job(fixed + "[powder.radius]\nmedian = \"1 um\"\ngeometric_deviation = 1.5\n"),
       {"powder.radius.weighting", "\"number\", \"mass\""}},
      {sized("median = \"1 um\"\ngeometric_deviation = 0.5\n"), {"geometric_deviation", "0.5", "from 1 to 20"}},
      {sized("median = \"1 um\"\nmean = \"1 um\"\n"), {"powder.radius.mean", "beside median"}},
      {sized("median = \"1 um\"\ndeviation = \"1 um\"\n"), {"powder.radius.deviation", "beside median"}},
      {sized("mean = \"1 um\"\n"), {"powder.radius.deviation", "no such key"}},
      {sized(""), {"powder.radius.median", "edges and shares"}},
      {sized("edges = [\"2 um\", \"1 um\"]\nshares = [1]\n"), {"powder.radius.edges", "do not rise"}},
      {sized("edges = [\"1 um\", \"2 um\"]\nshares = [1, 2]\n"), {"powder.radius.shares", "2 of them for 2 edges"}},
      {sized("edges = [\"1 um\", \"2 um\"]\nshares = [0]\n"), {"powder.radius.shares", "zeros alone"}},
      {sized("file = \"bad.csv\"\n"), {"bad.csv:3", "radius_um", "-2", "positive length"}},
      {sized("file = \"back.csv\"\n"), {"back.csv:2", "radius_to"}},
      {sized("file = \"bare.csv\"\n"), {"bare.csv", "unit"}},
      {sized("file = \"none.csv\"\n"), {"none.csv"}},
      {test::PowderFolder::job(sizes + "[powder.speed]\nby_size = \"down.csv\"\n"), {"down.csv:3", "rise"}},
      {test::PowderFolder::job(sizes + "[powder.speed]\nby_size = \"down.csv\"\nmedian = \"2 m/s\"\n"),
       {"powder.speed.median", "beside by_size"}},
      {test::PowderFolder::job(good, "bounce = \"none\"\nbreach = \"7 kg/(m s)\"\n"),
       {"breach", "bounce = \"breach\""}},
      {test::PowderFolder::job(good, "bounce = \"off\"\n"), {"bounce", "\"off\""}},
      {test::PowderFolder::job(good, "breach = \"7 kg\"\n"), {"breach", "\"7 kg\""}},
      {test::PowderFolder::job(good, "levle = 0.9\n"), {"levle", "level"}},
      {test::PowderFolder::job(good, "", "[band]\nfrom = \"2 mm\"\nto = \"1 mm\"\n"), {"band.to", "more than from"}},
      {test::PowderFolder::job(good, "", "[limits]\nbounced = 0.1\n"), {"limits", "[design]"}},
      {test::PowderFolder::job(good, "", "[design]\nradius = [\"1 mm\", \"2 mm\"]\nspeed = [\"1 m/s\", \"2 m/s\"]\n"),
       {"band", "where the dose is wanted"}},
      {test::PowderFolder::job(good, "",
                               "[band]\nfrom = \"1 mm\"\nto = \"2 mm\"\n[design]\nradius = [\"2 mm\", \"1 mm\"]\nspeed "
                               "= [\"1 m/s\", \"2 m/s\"]\n"),
       {"design.radius", "smaller one first"}},
      {test::PowderFolder::job(good, "",
                               "[band]\nfrom = \"1 mm\"\nto = \"2 mm\"\n[design]\nradius = [\"1 mm\", \"2 mm\"]\nspeed "
                               "= [\"1 m/s\", \"2 m/s\"]\n[limits]\ndeeper = 0.1\n"),
       {"limits.deeper", "deeper_than"}},
      {test::PowderFolder::job(
           good, "",
           "[[layers]]\nname = \"a\"\nthickness = \"1 mm\"\n[[layers]]\nname = \"a\"\nthickness = \"1 mm\"\n"),
       {"layers[2].name", "another layer"}},
      {"[particle]\nspeed = \"1 m/s\"\n", {"a scene"}},
  };
  for (const auto& [text, words] : wrong) {
    const std::string said = refusal(text);
    for (const std::string& word : words) EXPECT_THAT(said, HasSubstr(word)) << text;
  }
}

TEST_F(PowderJobTest, WhatTheCalibrationDoesNotKnowIsRefused) {
  const ShotModel calibration = test::smooth_model();
  const auto refused = [&](const std::string& head, const std::string& rest = "") -> std::string {
    try {
      powder_model(read_job(test::PowderFolder::job(sizes + speeds, head, rest)), calibration);
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "nothing";
  };
  EXPECT_EQ(refused(""), "nothing");
  EXPECT_THAT(refused("material = \"skin\"\n"), AllOf(HasSubstr("job.toml:2: material"), HasSubstr("\"gel\"")));
  EXPECT_THAT(refused("hypothesis = \"3\"\n"), AllOf(HasSubstr("hypothesis"), HasSubstr("as given")));
  EXPECT_THAT(refused("", "[[layers]]\nname = \"a\"\nthickness = \"1 m\"\n"), HasSubstr("layers"));
  EXPECT_THAT(refused("", "[band]\nfrom = \"1 mm\"\nto = \"2 m\"\n"), HasSubstr("band"));
}

TEST_F(PowderJobTest, WhatLiesBeyondTheFittedShotsIsCounted) {
  const ShotModel calibration = test::smooth_model();  // one radius, 60 to 100 m/s
  const PowderJob job = read_job(test::PowderFolder::job(
      "radius = \"1.59 mm\"\n[powder.speed]\nedges = [\"60 m/s\", \"100 m/s\", \"120 m/s\"]\nshares = [3, 1]\n"));
  const auto beyond = beyond_fitted(classes_of(job.powder, {}), powder_model(job, calibration));
  ASSERT_EQ(beyond.size(), 1u);
  EXPECT_EQ(beyond[0].number, "speeds");
  EXPECT_NEAR(beyond[0].by_mass, 0.25, 1e-9);
}

}  // namespace
}  // namespace percal
