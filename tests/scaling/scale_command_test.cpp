// percal scale as its user meets it: the program is run.
#include <gmock/gmock.h>

#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::guha2009;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class PercalScale : public test::Program {
 protected:
  Ended scale(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "scale");
    return run(arguments);
  }
  // A job with these lines of [model], against the shipped gold scene.
  std::string job(const std::string& model, const std::string& rest = "") const {
    return write("job.toml", "[prototype]\nscene = \"" + guha2009 + "gold.toml\"\n[model]\n" + model + "\n" + rest);
  }
};

const std::string ball = "radius = \"1.59 mm\"\nparticle_density = \"7800 kg/m3\"\nspeed = \"83 m/s\"";

TEST_F(PercalScale, WritesTheShippedSteelSceneByteForByte) {
  auto ended = scale({guha2009 + "similar.toml", "--quiet", "--write-scene", path("steel.toml")});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out + ended.err, IsEmpty());
  EXPECT_EQ(read_file(path("steel.toml")), read_file(guha2009 + "steel.toml"));
}

TEST_F(PercalScale, MakesGoldAndSteelOneDimensionlessProblem) {
  auto gold = reduce(read_scene(guha2009 + "gold.toml")).problem,
       steel = reduce(read_scene(guha2009 + "steel.toml")).problem;
  EXPECT_EQ(evaluation_key(gold, "any"), evaluation_key(steel, "any"));
  gold.pi4 *= 1 + 1e-11;
  EXPECT_NE(evaluation_key(gold, "any"), evaluation_key(steel, "any")) << "the key sees the eleventh digit";
}

TEST_F(PercalScale, KeepsTheProblemOfASceneInOtherConventions) {
  write("skin.toml", R"(
replicates = 5
[particle]
radius = "1.4 um"
density = "16.8 g/cm3"
speed = "606 m/s"
[target]
density = "1060 kg/m3"
mu = "20 MPa"
convention = "true"
alpha = -3
nu = 0.48
depth = "60 um"
width = "9 um"
bottom = "fixed"
[target.erosion]
strain = 1.2
measure = "green-lagrange"
length = "0.8 um"
[mesh]
elements_per_radius = 6
fine_width = 2
[solver]
end_time = "0.3 us"
time_step_factor = 0.5
)");
  auto ended = scale({write(
      "job.toml", "[prototype]\nscene = \"skin.toml\"\n[model]\n" + ball + "\n[output]\nscene = \"model.toml\"\n")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  auto model = read_scene(path("model.toml"));
  EXPECT_NEAR(*model.solver.end_time, 0.3e-6 * (1.59e-3 / 1.4e-6) * (606.0 / 83), 1e-12);
  EXPECT_EQ(model.replicates, 5);
  EXPECT_EQ(evaluation_key(reduce(read_scene(path("skin.toml"))).problem, "any"),
            evaluation_key(reduce(model).problem, "any"));
}

TEST_F(PercalScale, FindsTheGroupsOfBothShippedScenesEqualToTwelveDigits) {
  auto ended =
      scale({"--json", write("job.toml", "tolerance = 1e-12\n[prototype]\nscene = \"" + guha2009 +
                                             "gold.toml\"\n[model]\nscene = \"" + guha2009 + "steel.toml\"\n")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, IsEmpty());
  auto result = nlohmann::json::parse(ended.out);
  ASSERT_EQ(result["groups"].size(), 10u);
  for (int number : {1, 2, 4, 5, 6, 7}) {
    const auto& group = result["groups"][static_cast<std::size_t>(number - 1)];
    EXPECT_EQ(group["agreement"], "agree") << group;
    EXPECT_EQ(round_to_12_digits(group["prototype"]), round_to_12_digits(group["model"])) << group;
  }
  EXPECT_EQ(result["groups"][2]["agreement"], "differ") << "steel is not gold: rigid in both";
}

TEST_F(PercalScale, PrintsTheMissingValuesBothModuliAndTheUnequalGroupsFirst) {
  const std::vector<std::string> arguments{guha2009 + "similar.toml", "--write-scene", path("steel.toml")};
  auto ended = scale(arguments);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("0.007547 times"), HasSubstr("41.34 mm"), HasSubstr("113.2 kPa"),
                               HasSubstr("481.127 kPa"), testing::ContainsRegex("464.286 kg/m3 +pi5"),
                               testing::ContainsRegex("pi10 .*both lack time"),
                               HasSubstr("The similar scene: " + path("steel.toml")), Not(HasSubstr("rho_t / rho_p"))));
  EXPECT_LE(std::count(ended.out.begin(), ended.out.end(), '\n'), 27);
  auto details = arguments;
  details.push_back("--details");
  EXPECT_THAT(scale(details).out, AllOf(HasSubstr("rho_t / rho_p"), HasSubstr("Both systems without dimensions")));
}

TEST_F(PercalScale, NamesTheUnitsInTheKeysOfItsResult) {
  auto ended = scale({job(ball), "--quiet", "--out", path("out")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  auto found = result("out/result.json");
  EXPECT_NEAR(found["model"]["mu_as_given_Pa"], 113206.35, 0.01);
  EXPECT_NEAR(found["model"]["mu_true_Pa"], 481126.99, 0.01);
  EXPECT_NEAR(found["model"]["target_density_kg_m3"], 464.2857, 1e-4);
  EXPECT_NEAR(found["modulus_ratio"], 0.00754709, 1e-8);
  EXPECT_TRUE(found["model"]["penetration_m"].is_null()) << "this job says no penetration";
  EXPECT_FALSE(fs::exists(path("job.out")));
}

TEST_F(PercalScale, WritesItsResultIntoAFolderOfItsJobsNameUnlessToldOtherwise) {
  const auto printed = scale({job(ball), "--json"});
  EXPECT_EQ(read("job.out/result.json"), printed.out);
  EXPECT_EQ(files("job.out"), (std::set<std::string>{"job.out/result.json"}));
  fs::remove_all(path("job.out"));
  EXPECT_EQ(scale({job(ball), "--out", "none"}).code, 0);
  EXPECT_FALSE(fs::exists(path("job.out")) || fs::exists(path("none")));
}

// docs/formats/scale.md
TEST_F(PercalScale, HasAPageOfItsFormatThatNamesEveryKey) {
  const auto found = nlohmann::json::parse(scale({job(ball), "--json"}).out);
  const std::string page = read_file(test::docs + "formats/scale.md");
  const auto expect_named = [&](const nlohmann::json& object) {
    for (const auto& [key, value] : object.items()) EXPECT_THAT(page, HasSubstr("`" + key + "`"));
  };
  expect_named(found);
  expect_named(found["groups"][0]);
  expect_named(found["derived"][0]);
}

TEST_F(PercalScale, ReadsSystemsWithoutAScene) {
  auto ended = scale({"--json", write("job.toml", R"(
[prototype]
radius = "1 um"
particle_density = "16.8 g/cm3"
speed = "651 m/s"
target_density = "1 g/cm3"
mu = "15 MPa"
convention = "mu/alpha"
alpha = 8.5
erosion_strain = 0.7
[model]
radius = "1.59 mm"
particle_density = "7800 kg/m3"
mu = "113206.34988 Pa"
)")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, IsEmpty());
  auto result = nlohmann::json::parse(ended.out);
  EXPECT_NEAR(result["prototype"]["mu_true_Pa"], 63.75e6, 1e-3);
  EXPECT_NEAR(result["model"]["speed_m_s"], 83, 1e-6) << "the model's modulus is meant as the prototype's";
  EXPECT_EQ(result["groups"][0]["missing_in_prototype"][0], "depth");
}

TEST_F(PercalScale, ChecksWithoutWritingAnything) {
  auto ended = scale({guha2009 + "similar.toml", "--check", "--write-scene", path("steel.toml"), "--out", path("out")});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_FALSE(fs::exists(path("steel.toml")) || fs::exists(path("out")));
}

TEST_F(PercalScale, ComparesAModelThatIsNotSimilarAndRefusesToCallItsSceneSimilar) {
  auto real_gelatin = job(ball + "\ntarget_density = \"1010 kg/m3\"");
  auto compared = scale({real_gelatin});
  EXPECT_EQ(compared.code, 0);
  EXPECT_THAT(compared.out,
              AllOf(HasSubstr("pi5 = rho_t / rho_p is over-determined"), HasSubstr("it would be 464.286 kg/m3")));
  auto written = scale({real_gelatin, "--write-scene", path("scene.toml")});
  EXPECT_EQ(written.code, 2);
  EXPECT_THAT(written.err,
              AllOf(HasSubstr("job.toml"), HasSubstr("cannot be made similar"), HasSubstr("over-determined")));
  EXPECT_FALSE(fs::exists(path("scene.toml")));
}

TEST_F(PercalScale, SaysWhichNumbersWouldSettleAModelThatIsNotDetermined) {
  auto ended =
      scale({job("radius = \"1.59 mm\"\nparticle_density = \"7800 kg/m3\""), "--write-scene", path("scene.toml")});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("speed and mu are missing; give one of them"));
}

TEST_F(PercalScale, RefusesErosionThatThePrototypesSceneHasNot) {
  auto text = read_file(guha2009 + "gold.toml");
  auto from = text.find("[target.erosion]"), to = text.find("[mesh]");
  write("plain.toml", text.erase(from, to - from));
  auto ended = scale({write("job.toml", "[prototype]\nscene = \"plain.toml\"\n[model]\n" + ball +
                                            "\nerosion_strain = 0.7\n[output]\nscene = \"s.toml\"\n")});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("model.erosion_strain"));
}

struct BadJob {
  std::string name, model;
  std::vector<std::string> says;
};
void PrintTo(const BadJob& job, std::ostream* out) { *out << job.name; }  // not its bytes, which change
class PercalScaleOfABadJob : public PercalScale, public testing::WithParamInterface<BadJob> {};

TEST_P(PercalScaleOfABadJob, EndsWithExitCode2AndSaysWhere) {
  auto ended = scale({job(GetParam().model)});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("job.toml:"));
  for (const auto& text : GetParam().says) EXPECT_THAT(ended.err, HasSubstr(text));
}
INSTANTIATE_TEST_SUITE_P(
    Jobs, PercalScaleOfABadJob,
    testing::Values(BadJob{"UnknownKey", "radios = \"1 mm\"", {"radios", "radius"}},
                    BadJob{"NoUnit", "radius = 1.59", {"radius", "m, mm"}},
                    BadJob{"WrongUnit", "radius = \"3 kg\"", {"radius"}},
                    BadJob{"NegativeRadius", "radius = \"-1 mm\"", {"radius", "positive"}},
                    BadJob{"UnknownConvention", "convention = \"mu1\"", {"convention", "mu/alpha"}},
                    BadJob{"NegativeModulus", "mu = \"-5 kPa\"", {"mu"}}, BadJob{"Malformed", "radius = ", {}}),
    [](const auto& info) { return info.param.name; });

TEST_F(PercalScale, EndsWithExitCode4WhereItCannotWrite) {
  write("file", "no folder");
  for (const auto& option :
       {std::vector<std::string>{"--out", path("file/out")}, {"--write-scene", path("file/scene.toml")}}) {
    auto ended = scale({job(ball), "--quiet", option[0], option[1]});
    EXPECT_EQ(ended.code, 4) << ended.err;
  }
}

}  // namespace
}  // namespace percal
