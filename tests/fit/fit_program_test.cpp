// percal fit as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

const std::string treloar = PERCAL_DATA "/public/treloar1944_rubber_primary.csv";

struct Ended {
  int code;
  std::string out, err;
};

class FitProgram : public testing::Test {
 protected:
  FitProgram()
      : folder_(fs::temp_directory_path() / ("percal_fit_" + std::to_string(::getpid()) + "_" +
                                             testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
  }
  ~FitProgram() override { fs::remove_all(folder_); }

  static std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  Ended fit(const std::string& arguments) const {
    const auto out = folder_ / "stdout", err = folder_ / "stderr";
    const std::string command =
        std::string("'") + PERCAL_PROGRAM + "' fit " + arguments + " >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
  }
  std::string made(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name) << content;
    std::string quoted = "'";
    quoted += (folder_ / name).string();
    return quoted += '\'';
  }
  fs::path folder_;
};

std::string public_file(const std::string& name) { return std::string(PERCAL_DATA "/public/") + name; }

TEST_F(FitProgram, TheJsonHoldsTreloarsTwoMinimaBestFirstAndNothingElse) {
  const Ended run = fit(treloar + " --where mode=UT --residual absolute --json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const json result = json::parse(run.out);
  ASSERT_EQ(result["minima"].size(), 2u);
  const json& best = result["minima"][0];
  EXPECT_NEAR(best["alpha"].get<double>(), -7.785, 5e-4);
  EXPECT_NEAR(result["minima"][1]["alpha"].get<double>(), 3.901, 5e-4);
  EXPECT_NEAR(result["minima"][1]["objective"].get<double>() / best["objective"].get<double>(), 1.0055, 1e-4);
  EXPECT_GT(best["mu_Pa"].get<double>(), 0);
  EXPECT_NEAR(best["r2"].get<double>(), 0.9711, 1e-3);
  EXPECT_GT(best["mu_standard_error_Pa"].get<double>(), 0);
  EXPECT_GT(best["alpha_standard_error"].get<double>(), 0);
  EXPECT_EQ(best["converged"], true);
  EXPECT_EQ(result["points"], 24);
  EXPECT_EQ(result["left_out_zero_stress"], 0);
  EXPECT_EQ(result["residual"], "absolute");
  for (const char* key : {"version", "schema", "input", "cost", "findings"}) EXPECT_TRUE(result.contains(key)) << key;
  EXPECT_THAT(result["findings"][0].get<std::string>(), HasSubstr("negative"));
}

TEST_F(FitProgram, EveryPublicFileOfCurvesIsFitted) {
  const auto points = [&](const std::string& arguments) {
    const Ended run = fit(arguments + " --json");
    EXPECT_EQ(run.code, 0) << arguments << run.err;
    const json result = json::parse(run.out);
    EXPECT_GT(result["minima"].at(0)["mu_Pa"].get<double>(), 0);
    return result["points"].get<int>() + result["left_out_zero_stress"].get<int>();
  };
  EXPECT_EQ(points(treloar), 53);
  EXPECT_EQ(points(public_file("meunier2008_silicone_modes.csv")), 66);
  EXPECT_EQ(points(public_file("stpierre2023_meat_tension_compression_shear.csv") + " --where material_label=ac"), 78);
  EXPECT_EQ(points(public_file("stpierre2023_meat_tension_compression_shear.csv")), 890);
  EXPECT_EQ(points(public_file("budday2017_brain_cann_table.csv") + " --where region=cortex --where mode=simple_shear"),
            33);
  const std::string skin = public_file("tac2022_porcine_skin_biaxial.csv") + " --x stretch_x --y cauchy_xx_MPa";
  EXPECT_EQ(points(skin + " --where protocol=equibiaxial --mode equibiaxial"), 81);
  EXPECT_EQ(points(skin + " --where 'protocol=strip_x (stretch_y=1)' --mode planar"), 101);
  EXPECT_EQ(points(skin + " --mode general_biaxial --residual absolute"), 402);
  EXPECT_EQ(points(treloar + " " + public_file("meunier2008_silicone_modes.csv")), 53 + 66);
}

TEST_F(FitProgram, AFileOfDepthsIsRefusedWithAReason) {
  const Ended run = fit(public_file("gelatin_bb_calibration_points.csv"));
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("depths of shots"));
  EXPECT_EQ(run.out, "");
}

TEST_F(FitProgram, BadInputIsExitTwoWithOneClearMessage) {
  const Ended none = fit(treloar + " --where mode=XX");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("\"UT\", \"ET\", \"PS\""));
  EXPECT_EQ(fit("/nowhere.csv").code, 2);
  EXPECT_EQ(fit(treloar + " --where nonsense").code, 2);
  EXPECT_EQ(fit(treloar + " --y nonsense").code, 2);
  EXPECT_EQ(fit(made("few.csv", "stretch,stress_kPa\n1.5,3\n") + " --mode UT").code, 2);
  const Ended lines = fit(made("bad.csv", "stretch,stress_kPa\n1.5,3\nx,4\n1.7,y\n1.8\n") + " --mode UT");
  EXPECT_EQ(lines.code, 2);
  EXPECT_THAT(lines.err, HasSubstr("bad.csv:5"));
  const Ended cells = fit(made("cells.csv", "stretch,stress_kPa\n1.5,3\nx,4\n1.7,y\n") + " --mode UT --json");
  EXPECT_EQ(cells.code, 2);
  EXPECT_THAT(cells.err, testing::AllOf(HasSubstr("cells.csv:3"), HasSubstr("cells.csv:4")));
  EXPECT_EQ(cells.out, "");
}

TEST_F(FitProgram, TheOutFolderGetsTheSameResult) {
  const auto out = folder_ / "new" / "out";
  const Ended run = fit(treloar + " --json --out '" + out.string() + "'");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(json::parse(text_of(out / "result.json")), json::parse(run.out));
}

TEST_F(FitProgram, AnUnwritableFolderIsExitFour) {
  made("file", "not a folder");
  const Ended run = fit(treloar + " --out '" + (folder_ / "file" / "out").string() + "'");
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.out, "");
  // Found before the fit, which would refuse a single point.
  const std::string single = made("single.csv", "stretch,stress_kPa\n1.5,3\n");
  EXPECT_EQ(fit(single + " --mode UT --out '" + (folder_ / "file" / "out").string() + "'").code, 4);
}

TEST_F(FitProgram, AFullDiskIsExitFour) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const std::string command = std::string("'") + PERCAL_PROGRAM + "' fit " + treloar + " --json >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 4);
}

TEST_F(FitProgram, OptionsAndFilesMayStandInAnyOrder) {
  EXPECT_EQ(fit("--where mode=UT --where stretch=1.02 --check --quiet " + treloar).code, 0);
  EXPECT_EQ(fit("--residual absolute --where mode=UT " + treloar + " --quiet").code, 0);
}

TEST_F(FitProgram, CheckReadsAndFitsNothing) {
  const Ended run = fit(treloar + " --check --json");
  EXPECT_EQ(run.code, 0);
  EXPECT_FALSE(json::parse(run.out).contains("minima"));
  EXPECT_EQ(fit(treloar + " --check --where mode=XX").code, 2);
  EXPECT_EQ(fit(treloar + " --check --mode ET").code, 2);
}

TEST_F(FitProgram, QuietPrintsNothing) {
  const Ended run = fit(treloar + " --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out + run.err, "");
}

TEST_F(FitProgram, TheTableShowsBothMinimaAndSaysTheSignIsOpen) {
  const Ended run = fit(treloar + " --where mode=UT --residual absolute");
  EXPECT_EQ(run.code, 0);
  for (const char* part : {"-7.785", "3.901", "0.555 %", "negative alpha", "24 points used", "±"})
    EXPECT_THAT(run.out, HasSubstr(part));
}

TEST_F(FitProgram, NoPositiveModulusIsANamedOutcome) {
  const Ended run = fit(made("sign.csv", "stretch,stress_kPa\n1.5,-3\n1.7,-4\n2,-6\n") + " --mode UT --json");
  EXPECT_EQ(run.code, 3);
  EXPECT_TRUE(json::parse(run.out)["minima"].empty());
  EXPECT_THAT(run.err, HasSubstr("No positive modulus"));
}

}  // namespace
