#include "percal/predict/explore/explorer.hpp"

#include <gmock/gmock.h>

#include "page/markup_faults.hpp"
#include "percal/base/version.hpp"
#include "predict/explorer_models.hpp"
#include "support/program.hpp"

namespace percal {
namespace {

using page::Json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// The text between two others, the first of its kind.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) return "";
  const std::size_t from = begin + before.size();
  return text.substr(from, text.find(after, from) - from);
}

// The smooth part at inputs that lie on a run is what K^-1 y says with that run's row of K, less its noise.
TEST(ExplorerData, ItsWeightsSolveForTheValuesOfTheRuns) {
  const ShotModel model = test::model_of_everything();
  const Json emulator = explorer_data(model)["emulator"];
  const InputScale scale = scale_of(model.runs);
  const DepthCovariance covariance(covariance_parameters(model.settings, scale),
                                   std::sqrt(emulator["plane_variance"].get<double>()));
  const auto count = static_cast<Eigen::Index>(model.runs.size());
  MeshPoints points{Eigen::MatrixXd(count, scale.inputs()), Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    points.h[i] = model.runs[i].h / reference_h;
    for (int j = 0; j < scale.inputs(); ++j) points.inputs(i, j) = emulator["runs"][i][j];
    EXPECT_NEAR((points.inputs.row(i).transpose() - scale.scaled(model.runs[i].at)).norm(), 0, 1e-12);
  }
  const std::vector<double> weights = emulator["weights"];
  const Eigen::VectorXd values = covariance.of_runs(points) * Eigen::Map<const Eigen::VectorXd>(weights.data(), count);
  for (Eigen::Index i = 0; i < count; ++i)
    EXPECT_NEAR(values[i] + emulator["mean"].get<double>(), model.runs[i].log_depth, 1e-8);
}

TEST(ExplorerData, HoldsWhatCanBeChosenAndNothingOfTheRunsScene) {
  const ShotModel model = test::model_of_two_gels();
  const Json data = explorer_data(model);
  EXPECT_EQ(data["hypotheses"].size(), 2u);
  EXPECT_EQ(data["hypotheses"][1]["materials"][0]["points"].size(), 7u);
  EXPECT_EQ(data["shots"].size(), model.shots.size());
  EXPECT_EQ(data["material"], 0);
  for (const char* left_out : {"runs", "settings", "scene_of_runs"}) EXPECT_FALSE(data.contains(left_out));
  EXPECT_EQ(data["emulator"]["mesh_here"], 0);  // all of its runs are on one mesh
}

TEST(ExplorerPage, NamesEndNoScriptAndNothingMayBeFetched) {
  const std::string page = explorer_page(test::model_of_two_gels(), "a</title>.json");
  EXPECT_THAT(page,
              AllOf(HasSubstr("default-src 'none'"), HasSubstr("script-src 'sha256-"), HasSubstr("<noscript>"),
                    Not(HasSubstr("a</title>")), Not(HasSubstr("<b>more")), Not(HasSubstr("http-equiv=\"refresh"))));
  const Json data = Json::parse(between(page, "id=\"data\">", "</script>"));
  EXPECT_EQ(data["hypotheses"][0]["materials"][1]["name"], "stiff \"gel\" & </script><b>more");
}

// What stands before the scripts, which hold letters behind "<" that are no tags.
TEST(ExplorerPage, ItsMarkupIsSound) {
  const std::string page = explorer_page(test::model_of_everything(), "gel.json");
  const std::string elements = page.substr(0, page.find("<script")) + "</body></html>";
  EXPECT_THAT(test::markup_faults(elements), testing::IsEmpty());
  EXPECT_EQ(page.substr(page.rfind("</script>")), "</script>\n</body>\n</html>\n");
}

class Explore : public test::Program {
 protected:
  void SetUp() override {
    write("gel.json", Json{{"schema", result_schema},
                           {"command", "calibrate"},
                           {"shot_model", shot_model_to_json(test::model_of_everything())}}
                          .dump());
  }
};

TEST_F(Explore, WritesAPageBesideTheResult) {
  const Ended ended = run({"report", "gel.json", "--explore"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("explore.html"));
  EXPECT_EQ(files(), (std::set<std::string>{"gel.json", "explore.html"}));
  EXPECT_EQ(run({"report", "gel.json", "--explore", "-o", "pages/mine.html", "--quiet"}).out, "");
  EXPECT_EQ(read("pages/mine.html"), read("explore.html"));
}

TEST_F(Explore, WhatIsNoCalibrationIsRefused) {
  write("fit.json", Json{{"schema", result_schema}, {"command", "fit"}}.dump());
  const Ended ended = run({"report", "fit.json", "--explore"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("no result of a calibration"), HasSubstr("percal calibrate")));
  EXPECT_EQ(run({"report", "gel.json", "gel.json", "--explore"}).code, 2);
  EXPECT_EQ(run({"report", "gel.json", "--explore", "--plots", "plots"}).code, 2);
  EXPECT_EQ(run({"report", "gel.json", "--explore", "-o", "gel.json"}).code, 2);
  EXPECT_EQ(run({"report", "gel.json", "--explore", "--check"}).code, 0);
  EXPECT_EQ(files(), (std::set<std::string>{"gel.json", "fit.json"}));
}

}  // namespace
}  // namespace percal
