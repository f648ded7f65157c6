// Curves as machines write them: force and displacement, cycles, peaks, holds.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numbers>

#include "fit/fit_runs.hpp"
#include "percal/fit/read/read_curves.hpp"
#include "percal/fit/shape/peaks.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

CurveData machine_curve(const std::string& text, const CurveColumns& columns) {
  return curves_of(parse_csv(text, "c.csv"), columns);
}

std::string machine_refusal(const std::string& text, const CurveColumns& columns) {
  try {
    machine_curve(text, columns);
  } catch (const BadInput& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

// --- force and displacement ---

constexpr Specimen bar{.gauge_length = 10e-3, .area = 50e-6};
const std::string pulled = "time_s,Extension (mm),Load (N)\n0,0,0\n1,1,2\n2,2,5\n";

TEST(MachineCurves, ForceAndDisplacementOverTheSpecimenAreStressAndStretch) {
  const CurveData data = machine_curve(pulled, {.mode = "UT", .specimen = bar});
  ASSERT_EQ(data.points.size(), 3u);
  EXPECT_DOUBLE_EQ(data.points[2].strained.amount, 1.2);
  EXPECT_DOUBLE_EQ(data.points[2].nominal_stress, 1e5);
  EXPECT_THAT(data.sources[0].taken,
              ElementsAre("c.csv: stretch = 1 + Extension/10 mm, nominal stress = Load/50 mm2."));
  EXPECT_THAT(data.sources[0].warnings, IsEmpty());
}

TEST(MachineCurves, UnitsOfTheFieldAreConverted) {
  const CurveData data =
      machine_curve("Crosshead travel [in],F [lbf],F_sd [lbf]\n0.1,1,0.1\n", {.mode = "UT", .specimen = bar});
  EXPECT_NEAR(data.points[0].strained.amount, 1.254, 1e-12);
  EXPECT_NEAR(data.points[0].nominal_stress, 4.4482216152605 / 50e-6, 1e-6);
  EXPECT_NEAR(data.points[0].standard_error.value(), 0.44482216152605 / 50e-6, 1e-6);
  EXPECT_NEAR(machine_curve("travel_um,force_gf\n500,1\n", {.mode = "UT", .specimen = bar}).points[0].nominal_stress,
              9.80665e-3 / 50e-6, 1e-9);
}

TEST(MachineCurves, OneOfTheTwoMayBeInTheFileAlready) {
  const CurveData strained =
      machine_curve("strain,force_N\n0.1,2\n", {.mode = "UT", .specimen = {.gauge_length = {}, .area = 50e-6}});
  EXPECT_DOUBLE_EQ(strained.points[0].nominal_stress, 4e4);
  const CurveData stressed = machine_curve("displacement_mm,true_stress_kPa\n1,11\n",
                                           {.mode = "UT", .specimen = {.gauge_length = 10e-3, .area = {}}});
  EXPECT_DOUBLE_EQ(stressed.points[0].nominal_stress, 1e4);
}

TEST(MachineCurves, CompressionWithPositiveNumbersIsTurned) {
  const CurveData data =
      machine_curve("Compressive extension (mm),Compressive load (N)\n1,2\n2,5\n", {.mode = "UT", .specimen = bar});
  EXPECT_DOUBLE_EQ(data.points[1].strained.amount, 0.8);
  EXPECT_DOUBLE_EQ(data.points[1].nominal_stress, -1e5);
  EXPECT_THAT(data.sources[0].warnings, ElementsAre(HasSubstr("the signs of")));
}

TEST(MachineCurves, SimpleShearIsDisplacementOverHeight) {
  const CurveData data = machine_curve(pulled, {.mode = "simple_shear", .specimen = bar});
  EXPECT_DOUBLE_EQ(data.points[2].strained.amount, 0.2);
  EXPECT_THAT(data.sources[0].taken, ElementsAre(HasSubstr("gamma = Extension/10 mm")));
}

TEST(MachineCurves, WhatForceDoesNotTellIsRefused) {
  EXPECT_THAT(machine_refusal(pulled, {.mode = "equibiaxial", .specimen = bar}),
              AllOf(HasSubstr("c.csv:2"), HasSubstr("equibiaxial"), HasSubstr("uniaxial, planar or simple_shear")));
  EXPECT_THAT(machine_refusal("stretch,stress_kPa\n1.1,3\n", {.mode = "UT", .specimen = bar}),
              HasSubstr("no column of force (a name with force or load) among stretch, stress_kPa"));
  EXPECT_THAT(machine_refusal("Extension,Load (N)\n1,2\n", {.mode = "UT", .specimen = bar}), HasSubstr("Extension"));
}

TEST(MachineCurves, ACrossSectionIsSaidOnce) {
  const auto refused = [](const SpecimenSizes& sizes) {
    std::string key;
    specimen_of(sizes, [&](const std::string& of, const std::string&, const std::string&) { key = of; });
    return key;
  };
  EXPECT_EQ(refused({.gauge_length = 1, .area = 1}), "");
  EXPECT_EQ(refused({.area = 1, .specimen_diameter = 1}), "specimen_diameter");
  EXPECT_EQ(refused({.width = 1}), "thickness");
  EXPECT_EQ(refused({.thickness = 1}), "width");
  const auto accept = [](auto&&...) { FAIL(); };
  EXPECT_DOUBLE_EQ(specimen_of({.width = 2, .thickness = 3}, accept).area.value(), 6);
  EXPECT_DOUBLE_EQ(specimen_of({.specimen_diameter = 2}, accept).area.value(), std::numbers::pi);
}

// --- branches ---

// Two cycles to strains 0.5 and 0.8, ten rows a branch; loading has stress 100 * strain kPa, unloading half of it.
std::string cycles() {
  std::string text = "strain,stress_kPa\n0,0\n";
  for (const double top : {0.5, 0.8}) {
    for (int i = 1; i <= 10; ++i) text += fmt::format("{:.4f},{:.4f}\n", top * i / 10, 10 * top * i);
    for (int i = 9; i >= 0; --i) text += fmt::format("{:.4f},{:.4f}\n", top * i / 10, 5 * top * i);
  }
  return text;
}

CurveData branch(const char* which) {
  return machine_curve(cycles(), {.mode = "UT", .rows = {.branch = *branch_choice_of(which)}});
}

TEST(MachineCurves, TheBranchesOfLoadingAreKept) {
  const CurveData data = branch("loading");
  EXPECT_EQ(data.points.size(), 22u);
  for (const auto& point : data.points) EXPECT_NEAR(point.nominal_stress, 1e5 * (point.strained.amount - 1), 1);
  EXPECT_THAT(data.sources[0].warnings, ElementsAre(AllOf(HasSubstr("4 branches, 2 of loading and 2 of unloading"),
                                                          HasSubstr("fitted are the 2 of loading: 22 of 41 rows"))));
}

TEST(MachineCurves, TheBranchesOfUnloadingBeginAtTheirTurningPoints) {
  const CurveData data = branch("unloading");
  EXPECT_EQ(data.points.size(), 22u);
  EXPECT_DOUBLE_EQ(data.points[0].strained.amount, 1.5);
}

TEST(MachineCurves, ABranchIsChosenByItsNumber) {
  const CurveData third = branch("3");
  EXPECT_EQ(third.points.size(), 11u);
  EXPECT_DOUBLE_EQ(third.points.back().strained.amount, 1.8);
  EXPECT_THAT(machine_refusal(cycles(), {.mode = "UT", .rows = {.branch = OneBranch{5}}}),
              AllOf(HasSubstr("branch: found 5, which no test here has"), HasSubstr("1 is the first branch")));
  EXPECT_FALSE(branch_choice_of("0") || branch_choice_of("first") || branch_choice_of("-1") || branch_choice_of(""));
}

TEST(MachineCurves, WithoutAChoiceEveryRowIsTaken) {
  const CurveData data = machine_curve(cycles(), {.mode = "UT"});
  EXPECT_EQ(data.points.size(), 41u);
  EXPECT_THAT(data.sources[0].taken, IsEmpty());
  EXPECT_THAT(data.sources[0].warnings, ElementsAre(HasSubstr("--branch loading")));
}

// --- peaks ---

std::string to_failure(int curves) {
  std::string text = "strain,stress_kPa\n";
  for (int k = 0; k < curves; ++k) {
    for (int i = 0; i <= 20; ++i) text += fmt::format("{:.3f},{}\n", 0.025 * i * (k + 1), 2 * i);
    for (int i = 1; i <= 5; ++i) text += fmt::format("{:.3f},{}\n", (0.5 + 0.02 * i) * (k + 1), 40 - 6 * i);
  }
  return text;
}

constexpr RowChoice to_peak{.until = CurveEnd::peak};

TEST(MachineCurves, ACurveIsTakenUpToItsLargestStress) {
  const CurveData data = machine_curve(to_failure(1), {.mode = "UT", .rows = to_peak});
  EXPECT_EQ(data.points.size(), 21u);
  ASSERT_EQ(data.sources[0].peaks.size(), 1u);
  const CurvePeak& peak = data.sources[0].peaks[0];
  EXPECT_DOUBLE_EQ(peak.amount, 1.5);
  EXPECT_DOUBLE_EQ(peak.stress, 40e3);
  EXPECT_EQ(peak.end, CurvePeak::End::falls);
  EXPECT_EQ(peak.rows_behind, 5);
  EXPECT_THAT(data.sources[0].warnings, Not(Contains(HasSubstr("peaks"))));
}

TEST(MachineCurves, CurvesOneBehindTheOtherHaveTheirOwnPeaks) {
  const CurveData data = machine_curve(to_failure(2), {.mode = "UT", .rows = to_peak});
  EXPECT_EQ(data.points.size(), 42u);
  ASSERT_EQ(data.sources[0].peaks.size(), 2u);
  EXPECT_EQ(data.sources[0].peaks[1].test, "uniaxial tension, curve 2");
  EXPECT_DOUBLE_EQ(data.sources[0].peaks[1].erosion_strain, 1);
  const auto prior = prior_of_peaks(data.sources);
  EXPECT_NEAR(prior->strain, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(prior->error, std::log(2) / std::sqrt(2), 1e-12);  // what the two scatter by, above 0.4
}

TEST(MachineCurves, TheErosionStrainOfAPeakIsTheLargestPrincipalOne) {
  const auto strain = [](const std::string& mode) {
    std::string text = "strain,stress_kPa\n";
    for (int i = 0; i <= 12; ++i) text += fmt::format("{},{}\n", 0.05 * i, i <= 9 ? 10 * i : 90 - 20 * (i - 9));
    return machine_curve(text, {.mode = mode, .rows = to_peak}).sources[0].peaks.at(0).erosion_strain;
  };
  EXPECT_NEAR(strain("tension"), 0.45, 1e-12);
  EXPECT_NEAR(strain("compression"), 1 / std::sqrt(0.55) - 1, 1e-12);
  EXPECT_NEAR(strain("simple_shear"), 0.225 + std::sqrt(1 + 0.225 * 0.225) - 1, 1e-12);
}

TEST(MachineCurves, ACurveThatRisesToItsEndHasNoPriorToOffer) {
  std::string text = "strain,stress_kPa\n";
  for (int i = 0; i <= 20; ++i) text += fmt::format("{},{}\n", 0.02 * i, i);
  const CurveData data = machine_curve(text, {.mode = "UT", .rows = to_peak});
  EXPECT_EQ(data.points.size(), 21u);
  EXPECT_FALSE(prior_of_peaks(data.sources));
}

TEST(MachineCurves, AnUnloadingHasNoPeak) {
  EXPECT_THAT(
      machine_refusal(cycles(), {.mode = "UT", .rows = {.branch = UnloadingBranches{}, .until = CurveEnd::peak}}),
      HasSubstr("accepted: a branch of loading"));
  std::string sweep = "strain,stress_kPa\n";  // from compression to tension in one go
  for (int i = -10; i <= 10; ++i) sweep += fmt::format("{},{}\n", 0.02 * i, i);
  EXPECT_EQ(machine_curve(sweep, {.mode = "UT", .rows = to_peak}).points.size(), 21u);
}

// --- holds ---

std::string ramp_and_hold() {
  std::string text = "strain,stress_kPa\n";
  for (int i = 1; i <= 10; ++i) text += fmt::format("{},{}\n", 0.03 * i, 10 * i);
  for (int i = 1; i <= 8; ++i) text += fmt::format("0.3,{}\n", 100 - 5 * i);
  return text;
}

TEST(MachineCurves, AHoldIsLeftOutAndItsRelaxationSaid) {
  const CurveData data = machine_curve(ramp_and_hold(), {.mode = "UT", .rows = {.holds = Holds::left_out}});
  EXPECT_EQ(data.points.size(), 10u);
  ASSERT_EQ(data.sources[0].holds.size(), 1u);
  EXPECT_EQ(data.sources[0].holds[0].rows, 8);
  EXPECT_NEAR(data.sources[0].holds[0].stress_after / data.sources[0].holds[0].stress_before, 0.6, 1e-12);
  EXPECT_THAT(data.sources[0].taken, ElementsAre(HasSubstr("8 rows of 1 hold left out: the stress fell to 60 %")));
  EXPECT_THAT(data.sources[0].warnings, IsEmpty());
}

TEST(MachineCurves, RelaxationBehindThePeakIsNoFailure) {
  const CurveData data = machine_curve(ramp_and_hold(), {.mode = "UT", .rows = to_peak});
  EXPECT_EQ(data.points.size(), 10u);
  EXPECT_EQ(data.sources[0].peaks.at(0).end, CurvePeak::End::held);
  EXPECT_FALSE(prior_of_peaks(data.sources));
}

TEST(MachineCurves, TwoStretchesHaveNoBranches) {
  EXPECT_THAT(machine_refusal("stretch_x,stretch_y,stress_kPa\n1.1,1.1,3\n1.2,1.1,5\n",
                              {.mode = "general_biaxial", .x = "stretch_x", .rows = to_peak}),
              AllOf(HasSubstr("c.csv:2: until: found general_biaxial"), HasSubstr("--where")));
}

// --- as a user runs it ---

class MachineProgram : public test::FitRuns {
 protected:
  static std::string public_file(const std::string& name) { return std::string(PERCAL_DATA "/public/") + name; }
};

TEST_F(MachineProgram, ThePageSaysTheGeometry) {
  const std::string file = write("m.csv", "Extension (mm),Load (N)\n0,0\n1,2\n2,5\n3,9\n4,15\n");
  const Ended run =
      fit({file, "--mode", "tension", "--gauge-length", "10 mm", "--width", "10mm", "--thickness", "5 mm"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("nominal stress = Load/50 mm2"));
  const json source = json::parse(read("m.out/result.json"))["sources"][0];
  EXPECT_DOUBLE_EQ(source["specimen"]["gauge_length_m"], 0.01);
  EXPECT_DOUBLE_EQ(source["specimen"]["area_m2"], 50e-6);
}

TEST_F(MachineProgram, DoublesAndMissingSizesAreRefusedByName) {
  const std::string file = write("m.csv", "Extension (mm),Load (N)\n0,0\n1,2\n2,5\n");
  const auto refused = [&](std::vector<std::string> options, const std::string& text) {
    options.insert(options.begin(), {file, "--mode", "tension"});
    const Ended run = fit(options);
    EXPECT_EQ(run.code, 2) << text;
    EXPECT_THAT(run.err, HasSubstr(text));
  };
  refused({"--area", "50 mm2", "--specimen-diameter", "8 mm"}, "--specimen-diameter: found a diameter beside an area");
  refused({"--width", "10 mm"}, "--thickness: found none beside the width");
  refused({"--area", "50 mm"}, "--area: found \"50 mm\"; accepted: a positive area");
  refused({"--branch", "first"}, "--branch: found \"first\"; accepted: loading, unloading");
  refused({"--gauge-length", "10 mm"}, "(--gauge-length, --area)");  // the cross-section is missing
}

TEST_F(MachineProgram, BrainUpToItsPeaksOffersAPrior) {
  const std::string brain = public_file("franceschini2006_brain_to_failure.csv");
  const Ended one = fit({brain, "--mode", "uniaxial", "--where", "specimen=gm1", "--until", "peak", "--json"});
  ASSERT_EQ(one.code, 0) << one.err;
  const json result = json::parse(one.out);
  EXPECT_EQ(result["points"], 30);
  EXPECT_NEAR(result["minima"][0]["mu_Pa"].get<double>(), 2278, 1);
  EXPECT_NEAR(result["sources"][0]["peaks"][0]["amount"].get<double>(), 2.6325, 1e-9);
  EXPECT_NEAR(result["erosion_prior"]["strain"].get<double>(), 1.6325, 1e-9);
  const Ended four = fit({brain, "--mode", "uniaxial", "--until", "peak"});
  EXPECT_THAT(four.out, AllOf(HasSubstr("each of 4 curves"), HasSubstr("a specimen fails from its flaws"),
                              HasSubstr("prior = 1.24 and")));
  EXPECT_THAT(four.out, HasSubstr("prior_error = \"40 %\""));
}

TEST_F(MachineProgram, MuscleAtThreeRatesRelaxesInItsHolds) {
  for (const auto& [sheet, mu, left] :
       {std::tuple{"F_005", 558.0, 0.37}, {"F_01", 709.5, 0.37}, {"F_05", 234.1, 0.27}}) {
    const Ended run = fit({public_file("vanloocke2008_muscle_rates.csv"), "--mode", "compression", "--where",
                           fmt::format("sheet={}", sheet), "--without", "holds", "--json"});
    ASSERT_EQ(run.code, 0) << run.err;
    const json result = json::parse(run.out);
    EXPECT_NEAR(result["minima"][0]["mu_Pa"].get<double>(), mu, 0.5) << sheet;
    EXPECT_NEAR(result["sources"][0]["holds"].at(0)["relaxed_to"].get<double>(), left, 0.005) << sheet;
    EXPECT_TRUE(result["erosion_prior"].is_null());
  }
}

TEST_F(MachineProgram, EveryKeyOfTheChoiceIsOnThePageOfTheFormat) {
  const std::string page = text_of(test::docs + "formats/fit.md");
  const Ended run =
      fit({public_file("franceschini2006_brain_to_failure.csv"), "--mode", "uniaxial", "--until", "peak", "--json"});
  const json result = json::parse(run.out);
  for (const auto& [key, value] : result["sources"][0]["peaks"][0].items())
    EXPECT_THAT(page, HasSubstr("`" + key + "`"));
  for (const auto& [key, value] : result["erosion_prior"].items()) EXPECT_THAT(page, HasSubstr("`" + key + "`"));
}

}  // namespace
}  // namespace percal
