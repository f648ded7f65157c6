// percal scale as its user meets it: the program is run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string guha2009 = std::string(PERCAL_DATA) + "/guha2009/";

struct Ran {
  int exit_code;
  std::string output;  // standard output and errors
};

Ran run_scale(const std::string& arguments) {
  auto command = std::string(PERCAL_PROGRAM) + " scale " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  Ran ran{-1, ""};
  std::array<char, 4096> buffer;
  while (auto count = std::fread(buffer.data(), 1, buffer.size(), pipe)) ran.output.append(buffer.data(), count);
  ran.exit_code = WEXITSTATUS(pclose(pipe));
  return ran;
}

class PercalScale : public testing::Test {
 protected:
  PercalScale() { fs::create_directories(folder_); }
  ~PercalScale() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    write_file(path(name), text);
    return path(name);
  }
  // A job with these lines of [model], against the shipped gold scene.
  std::string job(const std::string& model, const std::string& rest = "") const {
    return write("job.toml", "[prototype]\nscene = \"" + guha2009 + "gold.toml\"\n[model]\n" + model + "\n" + rest);
  }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("percal_scale_" + std::to_string(getpid()) + "_" +
                                                  testing::UnitTest::GetInstance()->current_test_info()->name());
};

const std::string ball = "radius = \"1.59 mm\"\nparticle_density = \"7800 kg/m3\"\nspeed = \"83 m/s\"";

TEST_F(PercalScale, WritesTheShippedSteelSceneByteForByte) {
  auto ran = run_scale(guha2009 + "similar.toml --quiet --write-scene " + path("steel.toml"));
  EXPECT_EQ(ran.exit_code, 0) << ran.output;
  EXPECT_THAT(ran.output, IsEmpty());
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
[mesh]
elements_per_radius = 6
fine_width = 2
[solver]
end_time = "0.3 us"
time_step_factor = 0.5
)");
  auto ran = run_scale(write(
      "job.toml", "[prototype]\nscene = \"skin.toml\"\n[model]\n" + ball + "\n[output]\nscene = \"model.toml\"\n"));
  ASSERT_EQ(ran.exit_code, 0) << ran.output;
  auto model = read_scene(path("model.toml"));
  EXPECT_NEAR(*model.solver.end_time, 0.3e-6 * (1.59e-3 / 1.4e-6) * (606.0 / 83), 1e-12);
  EXPECT_EQ(model.replicates, 5);
  EXPECT_EQ(evaluation_key(reduce(read_scene(path("skin.toml"))).problem, "any"),
            evaluation_key(reduce(model).problem, "any"));
}

TEST_F(PercalScale, FindsTheGroupsOfBothShippedScenesEqualToTwelveDigits) {
  auto ran =
      run_scale("--json " + write("job.toml", "tolerance = 1e-12\n[prototype]\nscene = \"" + guha2009 +
                                                  "gold.toml\"\n[model]\nscene = \"" + guha2009 + "steel.toml\"\n"));
  ASSERT_EQ(ran.exit_code, 0) << ran.output;
  auto result = nlohmann::json::parse(ran.output);
  ASSERT_EQ(result["groups"].size(), 10u);
  for (int number : {1, 2, 4, 5, 6, 7}) {
    const auto& group = result["groups"][static_cast<std::size_t>(number - 1)];
    EXPECT_EQ(group["agreement"], "agree") << group;
    EXPECT_EQ(round_to_12_digits(group["prototype"]), round_to_12_digits(group["model"])) << group;
  }
  EXPECT_EQ(result["groups"][2]["agreement"], "differ") << "steel is not gold: rigid in both";
}

TEST_F(PercalScale, PrintsTheGroupsTheMissingValuesAndBothModuli) {
  auto ran = run_scale(guha2009 + "similar.toml --write-scene " + path("steel.toml"));
  EXPECT_THAT(ran.output, AllOf(HasSubstr("pi10"), HasSubstr("prototype lacks strain_rate"),
                                HasSubstr("464.3 kg/m3    from pi5"), HasSubstr("41.34 mm"),
                                HasSubstr("113.2 kPa as given (mu/alpha), 481.1 kPa true"), HasSubstr("0.00754709")));
}

TEST_F(PercalScale, NamesTheUnitsInTheKeysOfItsResult) {
  auto ran = run_scale(job(ball) + " --quiet --out " + path("out"));
  ASSERT_EQ(ran.exit_code, 0) << ran.output;
  auto result = nlohmann::json::parse(read_file(path("out/result.json")));
  EXPECT_NEAR(result["model"]["mu_as_given_Pa"], 113206.35, 0.01);
  EXPECT_NEAR(result["model"]["mu_true_Pa"], 481126.99, 0.01);
  EXPECT_NEAR(result["model"]["target_density_kg_m3"], 464.2857, 1e-4);
  EXPECT_NEAR(result["modulus_ratio"], 0.00754709, 1e-8);
  EXPECT_TRUE(result["model"]["penetration_m"].is_null()) << "this job says no penetration";
  EXPECT_FALSE(fs::exists(path("job.out"))) << "no folder without being asked for one";
}

TEST_F(PercalScale, ReadsSystemsWithoutAScene) {
  auto ran = run_scale("--json " + write("job.toml", R"(
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
)"));
  ASSERT_EQ(ran.exit_code, 0) << ran.output;
  auto result = nlohmann::json::parse(ran.output);
  EXPECT_NEAR(result["prototype"]["mu_true_Pa"], 63.75e6, 1e-3);
  EXPECT_NEAR(result["model"]["speed_m_s"], 83, 1e-6) << "the model's modulus is meant as the prototype's";
  EXPECT_EQ(result["groups"][0]["missing_in_prototype"][0], "depth");
}

TEST_F(PercalScale, ChecksWithoutWritingAnything) {
  auto ran = run_scale(guha2009 + "similar.toml --check --write-scene " + path("steel.toml") + " --out " + path("out"));
  EXPECT_EQ(ran.exit_code, 0) << ran.output;
  EXPECT_FALSE(fs::exists(path("steel.toml")) || fs::exists(path("out")));
}

TEST_F(PercalScale, ComparesAModelThatIsNotSimilarAndRefusesToCallItsSceneSimilar) {
  auto real_gelatin = job(ball + "\ntarget_density = \"1010 kg/m3\"");
  auto compared = run_scale(real_gelatin);
  EXPECT_EQ(compared.exit_code, 0);
  EXPECT_THAT(compared.output,
              AllOf(HasSubstr("pi5 = rho_t / rho_p is over-determined"), HasSubstr("it would be 464.286 kg/m3")));
  auto written = run_scale(real_gelatin + " --write-scene " + path("scene.toml"));
  EXPECT_EQ(written.exit_code, 2);
  EXPECT_THAT(written.output,
              AllOf(HasSubstr("job.toml"), HasSubstr("cannot be made similar"), HasSubstr("over-determined")));
  EXPECT_FALSE(fs::exists(path("scene.toml")));
}

TEST_F(PercalScale, SaysWhichNumbersWouldSettleAModelThatIsNotDetermined) {
  auto ran = run_scale(job("radius = \"1.59 mm\"\nparticle_density = \"7800 kg/m3\"") + " --write-scene " +
                       path("scene.toml"));
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.output, HasSubstr("speed and mu are missing; give one of them"));
}

TEST_F(PercalScale, RefusesErosionThatThePrototypesSceneHasNot) {
  auto text = read_file(guha2009 + "gold.toml");
  auto from = text.find("[target.erosion]"), to = text.find("[mesh]");
  write("plain.toml", text.erase(from, to - from));
  auto ran = run_scale(write("job.toml", "[prototype]\nscene = \"plain.toml\"\n[model]\n" + ball +
                                             "\nerosion_strain = 0.7\n[output]\nscene = \"s.toml\"\n"));
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.output, HasSubstr("model.erosion_strain"));
}

struct BadJob {
  std::string name, model;
  std::vector<std::string> says;
};
void PrintTo(const BadJob& job, std::ostream* out) { *out << job.name; }  // not its bytes, which change
class PercalScaleOfABadJob : public PercalScale, public testing::WithParamInterface<BadJob> {};

TEST_P(PercalScaleOfABadJob, EndsWithExitCode2AndSaysWhere) {
  auto ran = run_scale(job(GetParam().model));
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.output, HasSubstr("job.toml:"));
  for (const auto& text : GetParam().says) EXPECT_THAT(ran.output, HasSubstr(text));
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
  for (const auto& option : {" --out " + path("file/out"), " --write-scene " + path("file/scene.toml")}) {
    auto ran = run_scale(job(ball) + " --quiet" + option);
    EXPECT_EQ(ran.exit_code, 4) << ran.output;
  }
}

}  // namespace
}  // namespace percal
