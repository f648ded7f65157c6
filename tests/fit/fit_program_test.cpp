// percal fit as a user runs it.
#include <gmock/gmock.h>

#include "fit/fit_runs.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;

const std::string treloar_csv = PERCAL_DATA "/public/treloar1944_rubber_primary.csv";

class FitProgram : public test::FitRuns {};

std::string public_file(const std::string& name) { return std::string(PERCAL_DATA "/public/") + name; }

// Every key is on the page of the format. Keys that are names of tests and deformations, and the arguments, are not.
void expect_documented(const json& value, const std::string& page) {
  if (value.is_array() && !value.empty()) expect_documented(value[0], page);
  if (!value.is_object()) return;
  for (const auto& [key, inner] : value.items()) {
    EXPECT_NE(page.find(key), std::string::npos) << key;
    if (key != "input" && key != "r2_of_test" && key != "points_of_mode") expect_documented(inner, page);
  }
}

TEST_F(FitProgram, TheJsonHoldsTreloarsTwoMinimaBestFirstAndNothingElse) {
  const Ended run = fit({treloar_csv, "--where", "mode=UT", "--residual", "absolute", "--json"});
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
  for (const char* key : {"percal", "schema", "input", "cost", "findings"}) EXPECT_TRUE(result.contains(key)) << key;
  EXPECT_THAT(result["findings"][0].get<std::string>(), HasSubstr("negative"));
}

TEST_F(FitProgram, EveryPublicFileOfCurvesIsFitted) {
  const auto points = [&](std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const Ended run = fit(arguments);
    EXPECT_EQ(run.code, 0) << testing::PrintToString(arguments) << run.err;
    const json result = json::parse(run.out);
    EXPECT_GT(result["minima"].at(0)["mu_Pa"].get<double>(), 0);
    return result["points"].get<int>() + result["left_out_zero_stress"].get<int>();
  };
  EXPECT_EQ(points({treloar_csv}), 53);
  EXPECT_EQ(points({public_file("meunier2008_silicone_modes.csv")}), 66);
  const std::string meat = public_file("stpierre2023_meat_tension_compression_shear.csv");
  EXPECT_EQ(points({meat, "--where", "material_label=ac"}), 78);
  EXPECT_EQ(points({meat}), 890);
  const std::string brain = public_file("budday2017_brain_cann_table.csv");
  EXPECT_EQ(points({brain, "--where", "region=cortex", "--where", "mode=simple_shear"}), 33);
  const auto points_of_skin = [&](std::vector<std::string> arguments) {
    const std::string skin = public_file("tac2022_porcine_skin_biaxial.csv");
    arguments.insert(arguments.begin(), {skin, "--x", "stretch_x", "--y", "cauchy_xx_MPa"});
    return points(arguments);
  };
  EXPECT_EQ(points_of_skin({"--where", "protocol=equibiaxial", "--mode", "equibiaxial"}), 81);
  EXPECT_EQ(points_of_skin({"--where", "protocol=strip_x (stretch_y=1)", "--mode", "planar"}), 101);
  EXPECT_EQ(points_of_skin({"--mode", "general_biaxial", "--residual", "absolute"}), 402);
  EXPECT_EQ(points({treloar_csv, public_file("meunier2008_silicone_modes.csv")}), 53 + 66);
}

TEST_F(FitProgram, AFileOfDepthsIsRefusedWithAReason) {
  const Ended run = fit({public_file("gelatin_bb_calibration_points.csv")});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("depths of shots"));
  EXPECT_EQ(run.out, "");
}

TEST_F(FitProgram, BadInputIsExitTwoWithOneClearMessage) {
  const Ended none = fit({treloar_csv, "--where", "mode=XX"});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("\"UT\", \"ET\", \"PS\""));
  EXPECT_EQ(fit({"/nowhere.csv"}).code, 2);
  EXPECT_EQ(fit({treloar_csv, "--where", "nonsense"}).code, 2);
  EXPECT_EQ(fit({treloar_csv, "--y", "nonsense"}).code, 2);
  EXPECT_EQ(fit({write("few.csv", "stretch,stress_kPa\n1.5,3\n"), "--mode", "UT"}).code, 2);
  const Ended lines = fit({write("bad.csv", "stretch,stress_kPa\n1.5,3\nx,4\n1.7,y\n1.8\n"), "--mode", "UT"});
  EXPECT_EQ(lines.code, 2);
  EXPECT_THAT(lines.err, HasSubstr("bad.csv:5"));
  const Ended cells = fit({write("cells.csv", "stretch,stress_kPa\n1.5,3\nx,4\n1.7,y\n"), "--mode", "UT", "--json"});
  EXPECT_EQ(cells.code, 2);
  EXPECT_THAT(cells.err, testing::AllOf(HasSubstr("cells.csv:3"), HasSubstr("cells.csv:4")));
  EXPECT_EQ(cells.out, "");
}

TEST_F(FitProgram, TheOutFolderGetsTheSameResult) {
  const Ended run = fit({treloar_csv, "--json", "--out", path("new/out")});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(result("new/out/result.json"), json::parse(run.out));
}

TEST_F(FitProgram, ResultsGoToAFolderNamedForTheFirstFileUnlessNoneAreWanted) {
  ASSERT_EQ(fit({treloar_csv, "--quiet", "--no-intervals", "--out", "none"}).code, 0);
  ASSERT_EQ(fit({treloar_csv, "--check"}).code, 0);
  EXPECT_EQ(files(), std::set<std::string>{});
  ASSERT_EQ(fit({treloar_csv, public_file("meunier2008_silicone_modes.csv"), "--quiet", "--no-intervals"}).code, 0);
  EXPECT_EQ(result("treloar1944_rubber_primary.out/result.json")["input"]["files"].size(), 2u);
}

TEST_F(FitProgram, AnUnwritableFolderIsExitFour) {
  write("file", "not a folder");
  const Ended run = fit({treloar_csv, "--out", path("file/out")});
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.out, "");
  // Found before the fit, which would refuse a single point.
  const std::string single = write("single.csv", "stretch,stress_kPa\n1.5,3\n");
  EXPECT_EQ(fit({single, "--mode", "UT", "--out", path("file/out")}).code, 4);
}

TEST_F(FitProgram, AFullDiskIsExitFour) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(fit({treloar_csv, "--json"}, test::into_a_full_disk).code, 4);
}

TEST_F(FitProgram, OptionsAndFilesMayStandInAnyOrder) {
  EXPECT_EQ(fit({"--where", "mode=UT", "--where", "stretch=1.02", "--check", "--quiet", treloar_csv}).code, 0);
  EXPECT_EQ(fit({"--residual", "absolute", "--where", "mode=UT", treloar_csv, "--quiet"}).code, 0);
}

TEST_F(FitProgram, CheckReadsAndFitsNothing) {
  const Ended run = fit({treloar_csv, "--check", "--json"});
  EXPECT_EQ(run.code, 0);
  EXPECT_FALSE(json::parse(run.out).contains("minima"));
  EXPECT_EQ(fit({treloar_csv, "--check", "--where", "mode=XX"}).code, 2);
  EXPECT_EQ(fit({treloar_csv, "--check", "--mode", "ET"}).code, 2);
}

TEST_F(FitProgram, QuietPrintsNothing) {
  const Ended run = fit({treloar_csv, "--quiet"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out + run.err, "");
}

TEST_F(FitProgram, TheTableShowsBothMinimaAndSaysTheSignIsOpen) {
  const Ended run = fit({treloar_csv, "--where", "mode=UT", "--residual", "absolute"});
  EXPECT_EQ(run.code, 0);
  for (const char* part : {"-7.785", "3.901", "0.555 %", "negative alpha", "24 points (24 uniaxial)", "95 % interval"})
    EXPECT_THAT(run.out, HasSubstr(part));
}

TEST_F(FitProgram, WhatTheAnswerLeavesOutIsAmongTheDetails) {
  const std::vector<std::string> arguments{treloar_csv, "--compare", "--bootstrap", "5"};
  std::vector<std::string> with_details = arguments;
  with_details.push_back("--details");
  const Ended answer = fit(arguments), details = fit(with_details);
  for (const char* part : {"-0.7971", "2 mu/alpha", "points drawn anew", "51 degrees of freedom", "weight of a point",
                           "alpha was searched from -40 to 40", "nominal_stress_MPa", "R2 of each test"}) {
    EXPECT_THAT(details.out, HasSubstr(part));
    EXPECT_THAT(answer.out, testing::Not(HasSubstr(part)));
  }
}

TEST_F(FitProgram, ModelsStandSideBySide) {
  const Ended run = fit({treloar_csv, "--compare", "--weights", "tests", "--residual", "absolute", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = json::parse(run.out);
  ASSERT_EQ(result["comparison"].size(), 5u);
  const json& three = result["comparison"][4];
  EXPECT_EQ(three["model"], "ogden3");
  EXPECT_EQ(three["aicc_above_lowest"], 0);
  EXPECT_GT(three["minima"][0]["r2_of_test"]["planar"].get<double>(), 0.99);
  EXPECT_LT(three["left_out_mean_relative_deviation"], result["comparison"][2]["left_out_mean_relative_deviation"]);
  EXPECT_EQ(three["stability"]["stable_throughout"], true);
  EXPECT_EQ(result["tests"].size(), 3u);
  const Ended table = fit({treloar_csv, "--compare"});
  for (const char* part : {"neo-hooke", "mooney-rivlin", "ogden3", "AICc", "left out"})
    EXPECT_THAT(table.out, HasSubstr(part));
}

TEST_F(FitProgram, OneModelIsPickedAndItsStableRangePrinted) {
  const Ended run = fit({treloar_csv, "--model", "mooney-rivlin", "--unconstrained", "--residual", "absolute",
                         "--stable", "0.5:9", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = json::parse(run.out);
  const json& best = result["minima"][0];
  EXPECT_LT(best["C01_Pa"], 0);
  EXPECT_NEAR(best["C10_Pa"].get<double>() * 2 + best["C01_Pa"].get<double>() * 2, best["mu_Pa"].get<double>(), 1e-6);
  EXPECT_EQ(best["alpha"], nullptr);
  const json& uniaxial = result["stability"]["stretches"]["uniaxial"];
  EXPECT_NEAR(uniaxial["high"].get<double>(),
              std::min(9.0, std::sqrt(-best["C10_Pa"].get<double>() / best["C01_Pa"].get<double>())), 1e-6);
  EXPECT_EQ(result["stability"]["searched_low"], 0.5);
  EXPECT_THAT(fit({treloar_csv, "--model", "ogden2"}).out, HasSubstr("Drucker-stable"));
}

TEST_F(FitProgram, StandardErrorsOfTheFileWeighThePoints) {
  const std::string meat = public_file("stpierre2023_meat_tension_compression_shear.csv");
  const Ended run = fit({meat, "--where", "material_label=ac", "--residual", "error", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_EQ(result["points"], 76);
  EXPECT_EQ(result["left_out_no_error"], 2);
  EXPECT_EQ(result["sources"][0]["error"], "sem_kPa");
  EXPECT_EQ(fit({treloar_csv, "--residual", "error"}).code, 2);
}

TEST_F(FitProgram, OptionsThatSayNothingAreRefused) {
  for (const std::string weights : {"planar", "planar=0", "planar=x", "=2", "nowhere=2", "planar=1 2", ""})
    EXPECT_EQ(fit({treloar_csv, "--weights", weights}).code, 2) << weights;
  EXPECT_EQ(fit({treloar_csv, "--weights", "planar=2,UT=0.5"}).code, 0);
  for (const std::string stable : {"3", "0:2", "1.5:2", "0.5:0.9", "a:b", "0.3:3x"})
    EXPECT_EQ(fit({treloar_csv, "--stable", stable}).code, 2) << stable;
  EXPECT_EQ(fit({treloar_csv, "--model", "yeoh"}).code, 2);
  for (const std::string level : {"nan", "-nan", "inf", "1", "x"})
    EXPECT_EQ(fit({treloar_csv, "--level", level}).code, 2) << level;
  EXPECT_EQ(fit({treloar_csv, "--loss", "cauchy"}).code, 0);
}

TEST_F(FitProgram, WarningsComeFirstOnThePage) {
  const std::string file = write("comp.csv",
                                 "Compressive strain (mm/mm),Compressive stress (kPa)\n0.06,9.33470362\n"
                                 "0.12,19.64849301\n0.24,45.97632168\n0.42,123.25373471\n");
  const Ended run = fit({file, "--mode", "compression"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto warning = run.out.find("are turned"), answer = run.out.find("4 points");
  ASSERT_NE(warning, std::string::npos);
  EXPECT_LT(warning, answer);
  const json result = json::parse(fit({file, "--mode", "compression", "--json"}).out);
  EXPECT_NEAR(result["minima"][0]["mu_Pa"].get<double>(), 50e3, 1);  // made from mu 50 kPa, alpha 4
  EXPECT_NEAR(result["minima"][0]["alpha"].get<double>(), 4, 1e-4);
  EXPECT_THAT(fit({file, "--mode", "compression", "--check"}).out, HasSubstr("are turned"));
  const json soft = json::parse(
      fit({write("soft.csv", "stretch,stress_Pa\n1.1,1\n1.3,2\n1.5,5\n1.7,9\n"), "--mode", "UT", "--json"}).out);
  EXPECT_THAT(soft["warnings"].at(0).get<std::string>(), HasSubstr("softer"));
}

TEST_F(FitProgram, ThePageOfTheFormatNamesEveryKey) {
  const Ended run = fit({treloar_csv, "--compare", "--model", "mooney-rivlin", "--json"});
  expect_documented(json::parse(run.out), text_of(PERCAL_DATA "/../docs/formats/fit.md"));
}

TEST_F(FitProgram, NoPositiveModulusIsANamedOutcome) {
  const Ended run = fit({write("sign.csv", "stretch,stress_kPa\n1.5,-3\n1.7,-4\n2,-6\n"), "--mode", "UT", "--json"});
  EXPECT_EQ(run.code, 3);
  EXPECT_TRUE(json::parse(run.out)["minima"].empty());
  EXPECT_THAT(run.err, HasSubstr("No positive modulus"));
}

}  // namespace
}  // namespace percal
