// percal dose and percal design on the command line, from a calibration of a smooth law.
#include <gmock/gmock.h>

#include <cmath>

#include "powder/small_job.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class PowderCommands : public test::PowderFolder {
 protected:
  static inline const std::string band = "[band]\nfrom = \"120 mm\"\nto = \"160 mm\"\n";
  static inline const std::string layers =
      "[[layers]]\nname = \"upper\"\nthickness = \"130 mm\"\n[[layers]]\nname = \"lower\"\nthickness = \"40 mm\"\n";
  static inline const std::string design =
      "[design]\nradius = [\"1.3 mm\", \"2 mm\"]\nspeed = [\"60 m/s\", \"100 m/s\"]\nmap = 7\n";
};

TEST_F(PowderCommands, ADoseSaysWhereThePowderEnds) {
  write("job.toml", job(sizes + speeds, no_bounce, layers + band));
  const Ended ended = run({"dose", "job.toml"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("of the mass"), HasSubstr("upper"), HasSubstr("lower"), HasSubstr("scatter")));
  const json found = json::parse(read("job.out/result.json"));
  for (const char* by : {"by_mass", "by_number"}) {
    double sum = 0;
    for (const char* share : {"bounced", "deeper", "passed"}) sum += found[by][share]["best"].get<double>();
    for (const json& layer : found[by]["layers"]) sum += layer["share"]["best"].get<double>();
    EXPECT_NEAR(sum, 1, 1e-9);
  }
  EXPECT_GT(found["depths_by_mass"]["mean_m"]["best"], found["depths_by_number"]["mean_m"]["best"]);
  EXPECT_TRUE(files().contains("job.out/dose.csv"));
  EXPECT_EQ(run({"report", "job.out", "--check"}).code, 0);
  // A powder of one kind goes as deep as percal predict says.
  write("one.toml", job("radius = \"1.59 mm\"\nspeed = \"80 m/s\"\n", no_bounce + "scatter = 0\n"));
  const json one = json::parse(run({"dose", "one.toml", "--json", "--out", "none"}).out),
             shot = json::parse(
                 run({"predict", "gel.json", "--speed", "80m/s", "--layer-depth", "200mm", "--json"}).out)["shots"][0];
  EXPECT_NEAR(one["depths_by_mass"]["mean_m"]["best"].get<double>() / shot["depth_m"].get<double>(), 1, 1e-5);
}

TEST_F(PowderCommands, TheSameJobHasTheSameBits) {
  write("job.toml", job(sizes + speeds, no_bounce, band));
  json first = json::parse(run({"dose", "job.toml", "--json", "--out", "none"}).out),
       second = json::parse(run({"dose", "job.toml", "--json", "--out", "none"}).out);
  first.erase("cost");
  second.erase("cost");
  EXPECT_EQ(first, second);
}

TEST_F(PowderCommands, ADesignSaysWhichPowderEndsInTheBand) {
  write("job.toml", job(sizes + speeds, no_bounce, band + design));
  const Ended ended = run({"design", "job.toml"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(read("job.out/result.json"));
  double most = 0;
  for (const json& point : found["map"]) most = std::max(most, point["dose"].get<double>());
  EXPECT_GE(found["best"]["expected_dose"].get<double>(), most);
  EXPECT_EQ(found["map"].size(), 49u);
  EXPECT_TRUE(files().contains("job.out/map.csv"));
  EXPECT_EQ(run({"report", "job.out", "--check"}).code, 0);
  // The dose of that powder is the design's.
  const auto written = [](const json& value, const std::string& unit) {
    return "\"" + value.dump() + " " + unit + "\"";
  };
  write("best.toml", job("[powder.radius]\nmedian = " + written(found["best"]["radius_m"], "m") +
                             "\ngeometric_deviation = 1.1\nweighting = \"number\"\n[powder.speed]\nmedian = " +
                             written(found["best"]["speed_m_s"], "m/s") + "\ngeometric_deviation = 1.05\n",
                         no_bounce, band));
  const json dose = json::parse(run({"dose", "best.toml", "--json", "--out", "none"}).out);
  EXPECT_NEAR(dose["by_mass"]["in_band"]["best"].get<double>(), found["best"]["dose"]["best"].get<double>(), 1e-3);
}

TEST_F(PowderCommands, ADesignWithoutACandidateEndsWithCode3) {
  write("job.toml", job(sizes + speeds, "breach = \"1e9 kg/(m s)\"\nlayer_depth = \"200 mm\"\n",
                        band + design + "[limits]\nbounced = \"1 %\"\n"));
  const Ended ended = run({"design", "job.toml"});
  EXPECT_EQ(ended.code, 3) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("within the limits"));
}

TEST_F(PowderCommands, WhatIsRefusedEndsWithCode2AndWritesNothing) {
  write("job.toml", job(sizes + speeds));
  EXPECT_THAT(run({"design", "job.toml"}).err, HasSubstr("design"));
  write("none.toml",
        "calibration = \"none.json\"\n[powder]\nradius = \"1 mm\"\ndensity = \"1 g/cm3\"\nspeed = \"9 m/s\"\n");
  const auto before = files();
  for (const auto& words : std::vector<std::vector<std::string>>{{"design", "job.toml"},
                                                                 {"dose", "none.toml"},
                                                                 {"dose", "gel.json"},
                                                                 {"dose", "job.toml", "--threads", "2"}}) {
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 2) << testing::PrintToString(words);
    EXPECT_THAT(ended.out, IsEmpty());
  }
  EXPECT_EQ(files(), before);
  EXPECT_EQ(run({"dose", "job.toml", "--check"}).code, 0);
  EXPECT_EQ(files(), before);
}

TEST_F(PowderCommands, TheAnswerFitsATerminal) {
  write("job.toml", job(sizes + speeds, no_bounce, layers + band + design));
  for (const char* command : {"dose", "design"}) {
    const std::string out = run({command, "job.toml", "--out", "none"}).out;
    std::istringstream lines(out);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count)
      if (!line.ends_with('.')) {  // sentences are wrapped on a terminal
        EXPECT_LE(line.size(), 80u) << line;
      }
    EXPECT_LE(count, 50) << out;
  }
}

}  // namespace
}  // namespace percal
