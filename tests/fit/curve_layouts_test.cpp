// Curves as they lie in folders and logs: a file for each deformation, words of others, raw logs.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/resource.h>

#include "fit/fit_runs.hpp"
#include "percal/text/csv.hpp"
#include "support/synthetic_curves.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;

const std::string treloar_csv_file = PERCAL_DATA "/public/treloar1944_rubber_primary.csv";

class CurveLayouts : public test::FitRuns {
 protected:
  json fitted(std::vector<std::string> arguments) const {
    for (const char* last : {"--json", "--no-intervals", "--out", "none"}) arguments.push_back(last);
    const Ended run = fit(arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }
  // One of Treloar's tests as a file that does not say which.
  std::string file_of(const std::string& mode) const {
    const CsvTable table = read_csv(treloar_csv_file).where({"mode=" + mode});
    std::string text = "stretch,stress_MPa\n";
    for (const auto& row : table.rows)
      text += table.cell(row, table.column("stretch")) + "," + table.cell(row, table.column("nominal_stress")) + "\n";
    return write(mode + ".csv", text);
  }
};

TEST_F(CurveLayouts, EachFileMayHaveItsDeformation) {
  const std::string ut = file_of("UT"), et = file_of("ET"), ps = file_of("PS");
  const std::vector<std::string> in_front{"uniaxial=" + ut, "equibiaxial=" + et, "planar=" + ps};
  for (const auto& arguments : {in_front, std::vector<std::string>{ut, et, ps, "--mode", "uniaxial", "--mode",
                                                                   "equibiaxial=" + et, "--mode", "planar=" + ps}}) {
    const json result = fitted(arguments);
    const json& best = result["minima"][0];
    EXPECT_NEAR(best["mu_Pa"].get<double>(), 361456, 1);
    EXPECT_NEAR(best["alpha"].get<double>(), 2.12020, 1e-5);
    EXPECT_NEAR(best["objective"].get<double>(), 2.49860, 1e-5);
    EXPECT_EQ(result["points_of_mode"], json({{"uniaxial", 24}, {"equibiaxial", 16}, {"planar", 13}}));
  }
  EXPECT_THAT(fit({"uniaxial=" + ut, "--mode", "planar=" + ut}).err, HasSubstr("uniaxial and planar for"));
  EXPECT_THAT(fit({ut, "--mode", "uniaxial", "--mode", "planar"}).err,
              HasSubstr("\"uniaxial\" and \"planar\" for all files"));
  EXPECT_EQ(fit({"--mode", "uniaxial"}).code, 2);
  EXPECT_THAT(fit({"planar=" + treloar_csv_file}).err, HasSubstr("mode column says uniaxial"));
}

TEST_F(CurveLayouts, ModeStandsWhereTheColumnsWordsAreForeign) {
  const std::string foreign =
      write("uc.csv",
            "mode,stretch,stress_kPa\nUC,0.95,-7.724394\nUC,0.90,-16.068553\nUC,0.85,-25.355200\nUC,0.80,-36.028125\n");
  const json result = fitted({foreign, "--mode", "compression"});
  EXPECT_NEAR(result["minima"][0]["mu_Pa"].get<double>(), 50e3, 1);
  EXPECT_NEAR(result["minima"][0]["alpha"].get<double>(), 4, 1e-4);
  EXPECT_THAT(result["warnings"].at(0).get<std::string>(),
              AllOf(HasSubstr("\"UC\""), HasSubstr("compression is taken")));
  const Ended without = fit({foreign});
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, AllOf(HasSubstr("found \"UC\""), HasSubstr("also lines 3-5"), HasSubstr("--mode")));
  const std::string mixed = write("mixed.csv", "mode,stretch,stress_kPa\nUT,1.1,14\nXY,1.2,29\n");
  EXPECT_THAT(fit({mixed, "--mode", "uniaxial"}).err, HasSubstr("found \"XY\""));
}

TEST_F(CurveLayouts, ARangeOfRowsMayBeChosen) {
  EXPECT_EQ(fitted({treloar_csv_file, "--where", "mode=UT", "--where", "stretch<3"})["points"], 8);
  EXPECT_EQ(fitted({treloar_csv_file, "--where", "mode=UT", "--where", "stretch>=3.02"})["points"], 16);
  const Ended words = fit({treloar_csv_file, "--where", "stretch<three"});
  EXPECT_EQ(words.code, 2);
  EXPECT_THAT(words.err, HasSubstr("a number behind <"));
}

TEST_F(CurveLayouts, ForceAndDisplacementAreToldHowToBecomeACurve) {
  const Ended run = fit({write("machine.csv", "Load (N),Extension (mm)\n1,2\n2,4\n"), "--mode", "uniaxial"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("stretch = 1 + displacement"), HasSubstr("force/(cross-section")));
}

TEST_F(CurveLayouts, TensionWithTheHeaderOfCompressionIsRefused) {
  const std::string file = write("c.csv", "Compressive strain,stress_kPa\n0.1,14\n0.2,29\n0.3,50\n");
  const Ended run = fit({file, "--mode", "tension"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("found the word of compression in the header, but the mode \"tension\""));
}

class SlowCurveLayouts : public CurveLayouts {};

TEST_F(SlowCurveLayouts, ARawLogOf300000RowsIsFittedInSecondsAndIn200Megabytes) {
  test::NormalNumbers normal(1);
  std::string text = "time_s,strain,stress_kPa\n";
  for (int i = 0; i < 300000; ++i) {
    const double strain = i / 300000.0;
    const double stress = nominal_stress(Ogden{50e3, 4}, Strained{Deformation::uniaxial, 1 + strain}) / 1e3;
    text += fmt::format("{:.3f},{:.6f},{:.6f}\n", i * 1e-3, strain, stress + 0.3 * normal());
  }
  const std::string file = write("rows.csv", text);
  for (const char* model : {"ogden3", "ogden"}) {
    const Ended run =
        fit({file, "--mode", "uniaxial", "--residual", "absolute", "--model", model, "--json", "--out", "none"});
    ASSERT_EQ(run.code, 0) << run.err;
    const json result = json::parse(run.out);
    ASSERT_EQ(result["minima"][0]["terms"].size(), 1u);
    EXPECT_NEAR(result["minima"][0]["mu_Pa"].get<double>(), 50e3, 20);
    EXPECT_NEAR(result["minima"][0]["alpha"].get<double>(), 4, 1e-3);
    EXPECT_THAT(result["warnings"].dump(), HasSubstr("300000 rows are averaged"));
    EXPECT_LT(result["cost"]["cpu_s"].get<double>(), 20);
  }
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  EXPECT_LT(children.ru_maxrss, 200 * 1024);  // kB
}

}  // namespace
}  // namespace percal
