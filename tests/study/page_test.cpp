// The pages of the three kinds of study, of results that their own writers have made.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "page/page_words.hpp"
#include "percal/page/text.hpp"
#include "percal/study/page/extremes.hpp"
#include "percal/study/page/omissions.hpp"
#include "study/made_ladder.hpp"

namespace percal {
namespace {

using page::Json;
using study_test::ladder_of;
using study_test::pass_through;
using study_test::result_of;
using test::figure_of;
using test::series_of;
using test::words_of;
using testing::DoubleEq;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string answer_of(const page::Page& page) { return page::as_text(page, {.columns = 80}); }

// --- error against time -------------------------------------------------------------------------------------------

// 27 m (1 + 0.2 h): mesh errors 4, 2.9, 2, 1.4, 1, 0.7 %; a run takes 1 ms n^3.
Json error_result() { return result_of(ladder_of(0.2, 1, 0.02)); }

TEST(ErrorVsTimePage, TheAnswerIsEachMeshAndTheCheapestSettings) {
  const std::string answer = answer_of(study_page(error_result()));
  for (const char* there :
       {"gold into skin (gold.toml)", "5, 7, 10, 14, 20, 28 elements per radius, 5 runs on each",
        "14    27.39 m  +1.4 %", "2.74 s", "2 %      14     3     1.8 % (1.4 %, 1.2 %)", "percal impact SCENE"})
    EXPECT_THAT(answer, HasSubstr(there));
  EXPECT_THAT(answer, Not(HasSubstr("half the time step")));
}

TEST(ErrorVsTimePage, OfALocalRulePromisesNoLimit) {
  const page::Page page = study_page(result_of(study_test::local_ladder_of(0.2, 1, 0.02)));
  const std::string answer = answer_of(page);
  for (const char* there :
       {"28.08 m on 5 elements per radius, 27.19 m on 28", "no limit, each depth", "from the finest", "+0.7 %",
        "Runs on the scene's own mesh for an error", "2 %      10     1"})
    EXPECT_THAT(answer, HasSubstr(there));
  EXPECT_THAT(answer, Not(HasSubstr("xtrapolated")));
  EXPECT_EQ(figure_of(page, "error_against_time"), nullptr);
  EXPECT_THAT(words_of(page), HasSubstr("28 | 27.19 m | 87 mm | - | - |")) << "the finest is not off from itself";
  const test::Figure* depths = figure_of(page, "mesh_study");
  ASSERT_NE(depths, nullptr);
  EXPECT_EQ(series_of(*depths, "fitted"), nullptr);
  EXPECT_EQ(series_of(*depths, "extrapolated"), nullptr);
}

TEST(ErrorVsTimePage, SaysWhatEveryRungRanAndCost) {
  const std::string words = words_of(study_page(error_result()));
  for (const char* there : {"7 | 5488 | 0.4 | single | stopped", "7 | 5488 | 0.8 | double | stopped",
                            "half the time step | 7 | +0.00 %", "observed order 1", "runs done | 42", "seed | 2014"})
    EXPECT_THAT(words, HasSubstr(there));
}

TEST(ErrorVsTimePage, DrawsTheErrorOfEveryMeshAgainstTheTimeOfAllRuns) {
  Json result = error_result();
  Json& ten = result["meshes"][0]["error_of_mean_of"]["10"];
  ten = {{"value", 0.04}, {"low", 0.02}, {"high", nullptr}};
  const page::Page page = study_page(result);
  const test::Figure* figure = figure_of(page, "error_against_time");
  ASSERT_NE(figure, nullptr);
  const Series* drawn = series_of(*figure, "mean of 10");
  ASSERT_NE(drawn, nullptr);
  EXPECT_THAT(drawn->x.front(), DoubleNear(1.25, 1e-9));
  EXPECT_THAT(drawn->y.front(), DoubleEq(4));
  EXPECT_THAT(drawn->low.front(), DoubleEq(2));
  EXPECT_THAT(drawn->high.front(), DoubleEq(4)) << "no bound: no bar";
  EXPECT_TRUE(figure->chart.x.logarithmic && figure->chart.y.logarithmic);
}

TEST(ErrorVsTimePage, DrawsTheMeshStudyWithItsFit) {
  const page::Page page = study_page(error_result());
  const test::Figure* figure = figure_of(page, "mesh_study");
  ASSERT_NE(figure, nullptr);
  const Series* fitted = series_of(*figure, "fitted");
  ASSERT_NE(fitted, nullptr);
  EXPECT_NEAR(fitted->y.front(), 2700, 1);  // cm
  EXPECT_NEAR(fitted->y.back(), 2808, 1);
}

TEST(ErrorVsTimePage, WithoutAFitItSaysThatNoErrorCanBeGiven) {
  Ladder ladder = ladder_of(1, 1, 0.01);
  for (Rung& rung : ladder.meshes) pass_through(rung);
  const page::Page page = study_page(result_of(ladder));
  EXPECT_THAT(page.summary, HasSubstr("No error can be given: too few grids"));
  const std::string answer = answer_of(page);
  EXPECT_THAT(answer, HasSubstr("passed through"));
  EXPECT_THAT(answer, HasSubstr("None: the meshes of the ladder give no depth to extrapolate to."));
  EXPECT_EQ(answer.find("None:"), answer.rfind("None:")) << "once for all targets";
}

// --- omissions ----------------------------------------------------------------------------------------------------

AuditedOmission omission(const char* name, OmissionKind kind, std::optional<double> change, Effect effect) {
  AuditedOmission one{};
  one.variant = {.name = name, .kind = kind, .how = "they stay", .left_out = "", .is_illustration = false, .scene = {}};
  one.rung = study_test::rung_at(14, 25.5e-6, 1e-7);
  one.change = {.elements_per_radius = 14, .share = change, .standard_error = 0.01, .cost_ratio = 0.78};
  one.effect = effect;
  if (!change) {
    pass_through(one.rung);
    one.change.standard_error.reset();
    one.verdict = "ends otherwise: passed through (5 of 5 runs)";
  }
  return one;
}

Json omissions_result() {
  Omissions audit;
  audit.baseline = study_test::rung_at(14, 27.7e-6, 4e-7);
  audit.spread_of_a_run = 0.0146;
  audit.left_out = {{{"rotation", "it is round"}, {}, "no friction"},
                    {{"elastic particle", "rigid"}, {"elastic particle"}, ""}};
  audit.omissions = {omission("bottom", OmissionKind::domain, std::nullopt, Effect::ends_otherwise),
                     omission("eroded nodes", OmissionKind::physics, -0.08, Effect::clear)};
  audit.skipped = {{"rate", OmissionKind::physics, "refused", ""}};
  audit.conclusions = {"physics counts"};
  Scene scene;
  scene.source = "gold.toml";
  return omissions_to_json(scene, audit, {});
}

TEST(OmissionsPage, TheAnswerIsWhatCounts) {
  const std::string answer = answer_of(study_page(omissions_result()));
  EXPECT_THAT(answer, HasSubstr("Of 2 variants 1 change the depth of 27.7 um clearly."));
  EXPECT_THAT(answer, HasSubstr("physics counts"));
  EXPECT_THAT(answer, Not(HasSubstr("eroded nodes")));
}

TEST(OmissionsPage, HasEveryVariantAndEveryOmission) {
  const page::Page page = study_page(omissions_result());
  const std::string words = words_of(page);
  for (const char* there :
       {"eroded nodes | 2 | physics | 25.5 um | 100 nm | -8.0 % | 1.0 % | clear | 0.78",
        "bottom | 1 | domain | passed through | - | - | - | ends otherwise: passed through (5 of 5",
        "the scene as it is | - | - | 27.7 um | 400 nm", "rotation | it is round | not: no friction",
        "elastic particle | rigid | elastic particle", "Not run: rate: refused"})
    EXPECT_THAT(words, HasSubstr(there));
  EXPECT_THAT(series_of(*figure_of(page, "changes"), "clear")->low, ElementsAre(DoubleEq(-10)));
}

// --- extremes -----------------------------------------------------------------------------------------------------

Json extremes_result() {
  RunCell run{};
  run.reduction.problem.elements_per_radius = 7;
  run.evaluation.result.outcome = Outcome::stopped;
  run.evaluation.result.depth = 2.187;
  run.evaluation.result.energy.particle = 0.989;
  run.same_problem_as = "alpha 9";
  return extremes_to_json({{.cell = {"alpha", "alpha -20", {}}, .run = run, .reason = "", .troubles = {"too deep"}},
                           {.cell = {"refused", "nu 0.5", {}}, .run = {}, .reason = "nu is too large", .troubles = {}}},
                          {});
}

TEST(ExtremesPage, TheAnswerIsTheOutcomesTheWorstAndTheTroubles) {
  const std::string answer = answer_of(study_page(extremes_result()));
  for (const char* there :
       {"2 cells, 1 with troubles", "stopped      1", "1.100 %", "warning: alpha, alpha -20: too deep"})
    EXPECT_THAT(answer, HasSubstr(there));
  EXPECT_THAT(answer, Not(HasSubstr("nu 0.5")));
}

TEST(ExtremesPage, HasEveryCell) {
  const page::Page page = study_page(extremes_result());
  const std::string words = words_of(page);
  for (const char* there :
       {"Alpha", "alpha -20 | 1 | stopped | 2.187 | -1.100 %", "too deep; the same problem as alpha 9",
        "nu 0.5 | 2 | refused | - | - | - | - | - | - | - | - | nu is too large"})
    EXPECT_THAT(words, HasSubstr(there));
  EXPECT_THAT(series_of(*figure_of(page, "energy_errors"), "stopped")->y, ElementsAre(DoubleEq(1.1)));
}

// --- what is missing ----------------------------------------------------------------------------------------------

TEST(StudyPage, AMissingKeyIsRefusedByName) {
  for (const auto& [result, key] :
       {std::pair{error_result(), "half_steps"}, {omissions_result(), "baseline"}, {extremes_result(), "summary"}}) {
    Json cut = result;
    cut.erase(key);
    try {
      study_page(cut);
      ADD_FAILURE() << key;
    } catch (const page::MissingKey& missing) {
      EXPECT_EQ(missing.key, key);
    }
  }
}

}  // namespace
}  // namespace percal
