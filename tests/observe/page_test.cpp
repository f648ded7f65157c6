// The page of impacts, and the JSON that it reads: made by the writer from made-up runs.
#include "percal/observe/page/page.hpp"

#include <gmock/gmock.h>

#include "page/page_words.hpp"
#include "percal/observe/page/impact_json.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using page::Json;
using test::figure_of;
using test::section_of;
using test::series_of;
using test::words_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string gold_into_skin = R"(
[particle]
name = "gold"
radius = "1 um"
density = "16800 kg/m3"
speed = "651 m/s"
[target]
name = "skin"
density = "1000 kg/m3"
mu = "15 MPa"
convention = "mu/alpha"
alpha = 8.5
depth = "75 um"
width = "5 um"
[mesh]
elements_per_radius = 14
)";

Evaluation stopped_at(double depth_in_radii, bool reused) {
  Evaluation run;
  run.result.outcome = Outcome::stopped;
  run.result.depth = depth_in_radii;
  run.result.elements = 22050;
  run.result.steps = 5722;
  run.result.energy = {.elastic = 0.25, .eroded = 0.745};
  run.instruction_level = "x86_64_v3";
  run.reused = reused;
  return run;
}

// In radii and radii over impact speed.
const std::vector<HistoryPoint> three_points{{0, 0, 1, 0, {.particle = 1}},
                                             {65.1, 20, 0.46, 1e-3, {.particle = 0.4, .elastic = 0.2, .eroded = 0.4}},
                                             {130.2, 27.5, 0, 5e-4, {.elastic = 0.25, .eroded = 0.745}}};

class AnImpact : public testing::Test {
 protected:
  Scene scene = parse_scene(gold_into_skin, "/a/gold.toml");
  Reduction reduction = reduce(scene);
  ImpactFindings found{.scene = scene,
                       .reduction = reduction,
                       .runs = {stopped_at(27.2, false), stopped_at(27.8, true)},
                       .cost = {.runs = 1, .reused = 1, .cpu_seconds = 0.87, .instruction_level = "x86_64_v3"}};
  Json result() {
    if (!found.runs.empty()) found.penetration = summarise(found.runs, reduction.problem, reduction.scales);
    return impact_to_json(found);
  }
  page::Page page() { return impact_page(result()); }
  void read(const std::string& toml) {
    scene = parse_scene(toml, "/a/gold.toml");
    reduction = reduce(scene);
  }
};
class ImpactJson : public AnImpact {};
class ImpactPage : public AnImpact {};

const AdvisedAccuracy two_percent{.target_error = 0.02,
                                  .elements_per_radius = 20,
                                  .replicates = 3,
                                  .discretisation_error = 0.0125,
                                  .noise_error = 0.0075,
                                  .error = 0.0146,
                                  .cpu_seconds = 2,
                                  .studied_meshes = {5, 7, 10, 14},
                                  .study_was_kept = true};

const AdvisedAccuracy phase_alone{.target_error = 0.02,
                                  .elements_per_radius = 14,
                                  .replicates = 3,
                                  .noise_error = 0.0075,
                                  .error = 0.0075,
                                  .cpu_seconds = 2,
                                  .studied_meshes = {5, 7, 10, 14}};

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST_F(ImpactJson, HasTheSameKeysWhateverWasFound) {
  const Json plain = result();
  found.runs.front().result.history = three_points;
  found.fields = WrittenFields{"gold.out/fields/gold.pvd", 41};
  found.picture = "gold.png";
  found.accuracy = two_percent;
  const Json everything = result();
  found.runs.clear();
  found.penetration = {};
  found.accuracy = AdvisedAccuracy{.target_error = 0.001, .why_not = "out of reach"};
  const Json not_run = result();
  EXPECT_EQ(keys_of(everything), keys_of(plain));
  EXPECT_EQ(keys_of(not_run), keys_of(plain));
  EXPECT_EQ(keys_of(not_run["accuracy"]), keys_of(everything["accuracy"]));
  for (const char* key : {"outcome", "depth_m", "energy", "energy_worst_closure", "elements"})
    EXPECT_TRUE(not_run[key].is_null()) << key;
}

TEST_F(ImpactPage, TakesNoMissingKeyForANo) {
  for (const char* key : {"convention", "bulk_was_chosen", "outcome", "accuracy", "history", "findings", "layers",
                          "final", "channel", "sectional_density_kg_m2"}) {
    Json cut = result();
    cut.erase(key);
    try {
      impact_page(cut);
      FAIL() << key;
    } catch (const page::MissingKey& missing) {
      EXPECT_EQ(missing.key, key);
    }
  }
}

TEST_F(ImpactPage, HasTheNumbersOfItsResult) {
  const std::string words = words_of(page());
  for (const char* there :
       {"Impact: gold into skin",
        "Depth 27.5 um ± 4.4 um (95 %: mesh phase 3.8, wall 1.6, step 0.5, K 1.4, mesh size not known)",
        "runs | 2 over the mesh phase: standard error 300 nm, a single run scatters by 424 nm", "mu, true | 63.75 MPa",
        "2 mu/alpha | 15 MPa, as the scene gives it", "4.671 GPa, chosen by the program", "22050, 14 per radius",
        "5, radii to the wall, given", "13 of them graded (chosen by the program), each 1.2 times", "radius | 1 um",
        "eroded elements | 74.50 %", "sum | 99.50 %", "rotation: ", "Mach number | 0.299", "x86_64_v3",
        "1.001 | stopped | 27.8 um"})
    EXPECT_THAT(words, HasSubstr(there));
}

TEST_F(ImpactPage, SaysHowManyElementsEachCriterionTookOut) {
  reduction.problem.erosion = StrainErosion{0.7};
  reduction.problem.further_erosion.energy = 1;
  for (Evaluation& run : found.runs) {
    run.result.eroded = 40;
    run.result.distorted = 3;
    run.result.eroded_by = {.strain = 30, .energy = 7};
  }
  EXPECT_EQ(result()["runs"][0]["eroded_by"], (Json{{"strain", 30}, {"energy", 7}, {"distortion", 3}}));
  EXPECT_THAT(words_of(page()), HasSubstr("elements taken out of a run | 30 by strain, 7 by energy, 3 by distortion"));
  reduction.problem.further_erosion = {};
  EXPECT_EQ(result()["runs"][0]["eroded_by"], (Json{{"strain", 37}, {"distortion", 3}}));
  reduction.problem.erosion = NoErosion{};
  EXPECT_TRUE(result()["runs"][0]["eroded_by"].is_null());
}

TEST_F(ImpactPage, AStudyWithoutALimitGivesTheNoiseAlone) {
  found.accuracy = phase_alone;
  const std::string words = words_of(page());
  EXPECT_THAT(words, AllOf(HasSubstr("mesh phase and noise alone"), HasSubstr("belongs to its elements")));
  EXPECT_THAT(words, Not(HasSubstr("element size |")));
}

TEST_F(ImpactPage, TheAnswerIsTheDepthItsErrorTheModuliAndWhatToKnow) {
  found.fields = WrittenFields{"gold.out/fields/gold.pvd", 41};
  found.picture = "gold.png";
  found.runs.front().result.distorted = 3;
  const page::Page whole = page();
  std::vector<std::string> answer;
  for (const page::Section& section : whole.sections)
    if (section.detail == page::Detail::answer) answer.push_back(section.id);
  EXPECT_THAT(answer, ElementsAre("result", "findings"));
  EXPECT_THAT(words_of(*section_of(whole, "result")), AllOf(HasSubstr("gold.out/fields/gold.pvd, 41 frames"),
                                                            HasSubstr("gold.png"), HasSubstr("--accuracy 2%")));
}

TEST_F(ImpactPage, ASceneWithTheTrueModulusShowsBothNumbersToo) {
  std::string toml = gold_into_skin;
  toml.replace(toml.find("15 MPa\"\nconvention = \"mu/alpha\""), 31, "63.75 MPa\"");
  read(toml);
  EXPECT_THAT(words_of(page()),
              AllOf(HasSubstr("mu, true | 63.75 MPa, as the scene gives it"), HasSubstr("2 mu/alpha | 15 MPa\n")));
}

TEST_F(ImpactPage, StacksTheEnergyLedgerOverTime) {
  found.runs.front().result.history = three_points;
  const page::Page whole = page();
  const page::Figure* figure = figure_of(whole, "energy_over_time");
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(figure->chart.x.label, "time since contact, us");
  const Series* elastic = series_of(*figure, "elastic");
  ASSERT_NE(elastic, nullptr);
  EXPECT_THAT(elastic->low, ElementsAre(1, 0.4, 0));
  EXPECT_THAT(elastic->high, ElementsAre(1, testing::DoubleEq(0.6), 0.25));
  EXPECT_THAT(figure->caption, HasSubstr("within 0.5 %"));
  ASSERT_NE(figure_of(whole, "tip_over_time"), nullptr);
  EXPECT_THAT(figure_of(whole, "tip_over_time")->chart.series[0].y,
              ElementsAre(0, testing::DoubleEq(20), testing::DoubleEq(27.5)));
  EXPECT_EQ(figure_of(whole, "force_over_time")->chart.y.label, "force upwards, uN");
}

TEST_F(ImpactPage, TheForceInPlaneStrainIsThatOnAMetreOfThickness) {
  read("geometry = \"plane strain\"\n" + gold_into_skin);
  found.runs.front().result.history = three_points;
  EXPECT_EQ(figure_of(page(), "force_over_time")->chart.y.label, "force upwards, N per metre of thickness");
}

TEST_F(ImpactPage, WithoutAHistoryItSaysHowToGetOne) {
  EXPECT_EQ(figure_of(page(), "energy_over_time"), nullptr);
  EXPECT_THAT(words_of(page()), HasSubstr("--history FILE.csv"));
}

TEST_F(ImpactPage, SaysWhereTheErrorComesFrom) {
  read(gold_into_skin + "[target.erosion]\nstrain = 0.7\n");
  EXPECT_THAT(words_of(page()), AllOf(HasSubstr("; belongs to elements of 1/14 radius)"),
                                      HasSubstr("mesh phase | 3.81 um | standard error of the mean of 2 runs"),
                                      HasSubstr("belongs to elements of 1/14 radius: erosion by"),
                                      HasSubstr("`--measure-errors` measures what wall")));
  found.accuracy = two_percent;
  EXPECT_THAT(words_of(page()),
              AllOf(HasSubstr("Estimated error of the depth 1.5 % (element size 1.2 %, mesh phase and noise 0.75 %)"),
                    HasSubstr("element size | 1.2 %"), HasSubstr("mesh phase and noise | 0.8 %"),
                    Not(HasSubstr("belongs to elements"))));
}

TEST_F(ImpactJson, HasTheErrorOfItsDepthBySource) {
  const Json error = result()["depth_error"];
  std::vector<std::string> sources;
  for (const Json& one : error["sources"]) sources.push_back(one["source"]);
  EXPECT_THAT(sources, ElementsAre("mesh phase", "mesh size", "wall", "time step", "K"));
  EXPECT_TRUE(error["sources"][1]["half_width_m"].is_null());
  EXPECT_NEAR(error["sources"][0]["half_width_m"], 12.7062 * 0.3e-6, 1e-10);  // t of one degree of freedom
  EXPECT_GT(error["half_width_m"], error["sources"][0]["half_width_m"]);
  for (Evaluation& run : found.runs) run.result.outcome = Outcome::passed_through;
  EXPECT_TRUE(result()["depth_error"].is_null());
}

TEST_F(ImpactPage, TheDepthAndItsErrorFillTwoLinesAtMost) {
  for (const double depth : {1.234, 27.5, 99.9}) {
    found.runs.clear();
    for (const double off : {-0.02, -0.01, 0.0, 0.01, 0.02}) found.runs.push_back(stopped_at(depth * (1 + off), false));
    EXPECT_LE(page().summary.size(), 2 * 78) << page().summary;
  }
}

TEST_F(ImpactPage, WithALengthTheElementsShareIsALineOfItsOwn) {
  read(gold_into_skin + "[target.erosion]\nstrain = 0.7\nlength_in_radii = 0.5\n");
  const page::Page whole = page();
  const auto& first = std::get<page::Sentence>(section_of(whole, "result")->blocks.front());
  EXPECT_THAT(first.text, HasSubstr("Not in this error: the elements' bias, ± "));
  EXPECT_THAT(words_of(whole), HasSubstr("elements of 0.143 of it"));
}

TEST_F(ImpactPage, AnExtrapolatedDepthIsTheOneThatIsShown) {
  read(gold_into_skin + "[target.erosion]\nstrain = 0.7\nlength_in_radii = 0.5\n");
  found.evidence.extrapolation = Extrapolation{.depth = 25e-6,
                                               .standard_error = 0.2e-6,
                                               .model_error = 0.6e-6,
                                               .elements_per_radius = 14,
                                               .finer_elements_per_radius = 28,
                                               .mesh_depth = 27.5e-6,
                                               .finer_depth = 26.25e-6,
                                               .replicates = 2};
  const page::Page whole = page();
  EXPECT_THAT(whole.summary, AllOf(HasSubstr("Depth 25.0 um ± 3.1 um"), HasSubstr("mesh size 0.6"),
                                   HasSubstr("extrapolated from 14 and 28 elements per radius")));
  EXPECT_THAT(words_of(whole), AllOf(HasSubstr("27.5 um with 14, 26.25 um with 28 elements per radius, 2 runs on each"),
                                     Not(HasSubstr("bias"))));
}

TEST_F(ImpactPage, AdvisesToMeasureOnlyWhatGoesByRule) {
  EXPECT_THAT(words_of(*section_of(page(), "result")), HasSubstr("--measure-errors"));
  for (const DepthErrorSource source : {DepthErrorSource::wall, DepthErrorSource::time_step, DepthErrorSource::bulk})
    found.evidence.effects.push_back({source, 0.1e-6, 0.1e-6, 2});
  EXPECT_THAT(words_of(*section_of(page(), "result")), Not(HasSubstr("--measure-errors")));
}

TEST_F(ImpactPage, SaysWhatTheAtlasExpectsAndWhereTheRunsAreElsewhere) {
  found.accuracy = phase_alone;
  found.accuracy->atlas = AtlasDepth{.depth = 27e-6, .deviation = 0.02, .noise = 0.03, .width = 20};
  EXPECT_THAT(words_of(page()),
              AllOf(HasSubstr("mesh phase and noise alone, from the atlas"),
                    HasSubstr("The atlas expects 27 um, of 100 single runs 95 between 25.2 um and 29 um (its wall at "
                              "20 radii)"),
                    Not(HasSubstr("than these runs"))));
  found.accuracy->atlas->depth = 33e-6;
  EXPECT_THAT(words_of(page()),
              HasSubstr("The atlas expects 33 um, 20 % more than these runs, where the errors of both"));
}

TEST_F(ImpactPage, AnAccuracyOutOfReachHasNoDepthAndSaysWhy) {
  found.runs.clear();
  found.accuracy = AdvisedAccuracy{.target_error = 0.001, .why_not = "An error of 0.1 %: no mesh reaches it"};
  const page::Page whole = page();
  EXPECT_EQ(whole.summary, "Not run. An error of 0.1 %: no mesh reaches it");
  EXPECT_THAT(words_of(whole),
              AllOf(HasSubstr("asked for | 0.1 %"), HasSubstr("mu, true | 63.75 MPa"), Not(HasSubstr("depth, mean"))));
}

// Both runs went on: they rest, or have left.
void go_on(std::vector<Evaluation>& runs, Ending ending, double depth, double speed) {
  for (Evaluation& run : runs)
    run.result.aftermath = {
        .ending = ending, .depth = depth, .half_width = 0.25, .speed = speed, .energy = {.elastic = 1}};
}

TEST_F(ImpactPage, SaysWhereTheParticleComesToRest) {
  go_on(found.runs, Ending::rests, 18.4, 0);
  EXPECT_THAT(page().summary, HasSubstr("; it comes to rest at 18.4 um ± 1.5 um"));
  EXPECT_THAT(words_of(page()), HasSubstr("final depth | 18.4 um ± 1.5 um; it still swings by 250 nm"));
  EXPECT_EQ(result()["final"]["ending"], "rests");
  EXPECT_NEAR(result()["runs"][0]["final"]["depth_m"].get<double>(), 18.4e-6, 1e-15);
}

TEST_F(ImpactPage, SaysHowFastTheParticleIsThrownBack) {
  go_on(found.runs, Ending::left_upwards, -2, -0.5);
  EXPECT_THAT(page().summary, HasSubstr("; it leaves upwards with 325.5 m/s"));
  EXPECT_THAT(words_of(page()), HasSubstr("speed upwards, thrown back | 325.5 m/s"));
  found.runs.front().result.aftermath->ending = Ending::rests;
  EXPECT_THAT(page().summary, Not(HasSubstr("leaves")));
  EXPECT_THAT(words_of(page()), HasSubstr("ended differently (rests, left upwards)"));
}

// Turned by 0.5 and 0.3 rad about one axis; a quarter has no such path.
TEST_F(ImpactPage, SaysHowABodyTurnsAboutAllAxesAndWhatIsComputedOfABlock) {
  read(R"(geometry = "block"
[particle]
shape = "polyhedron"
vertices = [["-1 um", "-1 um", "0 um"], ["1 um", "-0.5 um", "0 um"], ["0 um", "1 um", "0 um"], ["0.2 um", "0 um", "2 um"]]
rotation = "free"
)" + gold_into_skin.substr(gold_into_skin.find("density"),
                           gold_into_skin.find("[mesh]") - gold_into_skin.find("density")));
  for (Evaluation& run : found.runs)
    run.result.sideways = -2, run.result.turn = 0.5, run.result.in_space = {.across = 0.5, .axis = {0, -0.6, 0.8}};
  found.runs.back().result.turn = 0.3;
  const Json run = result()["runs"][0];
  EXPECT_NEAR(run["across_m"].get<double>(), 0.5e-6, 1e-12);
  EXPECT_EQ(run["turn_axis"], (std::array{0.0, -0.6, 0.8}));
  EXPECT_EQ(result()["mesh"]["computed_share"], 1);
  const std::string words = words_of(page());
  EXPECT_THAT(words, HasSubstr("computed | all of the block"));
  EXPECT_THAT(words, HasSubstr("2 um to the left, 500 nm to the back, turned by 22.9 deg about (0, -0.6, 0.8)"));
  read(gold_into_skin);
  for (Evaluation& flat : found.runs) flat.result.in_space.reset();
  EXPECT_TRUE(result()["runs"][0]["across_m"].is_null());
  EXPECT_TRUE(result()["mesh"]["computed_share"].is_null());
}

TEST_F(ImpactPage, HasTheShotsNumbersAndTheSpeedsBehindLayers) {
  read(gold_into_skin +
       "[[below]]\nname = \"fat\"\ndensity = \"900 kg/m3\"\nmu = \"9 MPa\"\nalpha = 8\ndepth = \"5 um\"\n");
  for (Evaluation& run : found.runs) {
    run.result.outcome = Outcome::passed_through;
    run.result.speeds_behind = {0.6, 0.4};
  }
  found.runs.back().result.speeds_behind = {0.62, 0.4};
  const std::string words = words_of(page());
  for (const char* there :
       {"impact parameter rho v a | 10.94 kg/(m s)", "sectional density, mass over area | 22.4 g/m2",
        "speed behind skin | 397.1 m/s ±", "speed behind fat | 260.4 m/s ±", "left with 260.4 m/s ±"})
    EXPECT_THAT(words, HasSubstr(there));
  const Json layer = result()["layers"][1];
  EXPECT_EQ(layer["name"], "fat");
  EXPECT_NEAR(layer["lower_face_m"].get<double>(), 80e-6, 1e-15);
  EXPECT_NEAR(result()["exit_speed_m_s"].get<double>(), 260.4, 1e-9);
  // Student's t of two runs, and what wall, step and K make of the energy that was lost.
  const double phase = 12.706 * 0.01 * 651, rules = result()["exit_speed_error_m_s"];
  EXPECT_GT(rules, 0.02 * 260.4);
  EXPECT_GT(result()["layers"][0]["speed_behind_error_m_s"].get<double>(), phase);
  EXPECT_LT(result()["layers"][0]["speed_behind_error_m_s"].get<double>(), std::hypot(phase, rules));
}

TEST_F(ImpactPage, DrawsTheChannelAndTheParticle) {
  EXPECT_EQ(section_of(page(), "channel"), nullptr) << "nobody asked";
  for (Evaluation& run : found.runs) run.result.channel = {std::vector<double>(10, 1.03), std::vector<double>(10, 0.5)};
  const page::Page whole = page();
  const page::Figure* figure = figure_of(whole, "channel");
  ASSERT_NE(figure, nullptr);
  EXPECT_TRUE(figure->chart.equal_scales);
  const Series* widest = series_of(*figure, "channel at its widest");
  ASSERT_NE(widest, nullptr);
  EXPECT_NEAR(widest->y.front(), 1.03, 1e-9);
  EXPECT_NEAR(widest->x.back(), 0.95 * 27.5, 1e-9);
  const Series* particle = series_of(*figure, "particle, deepest");
  ASSERT_NE(particle, nullptr);
  EXPECT_EQ(particle->x.size(), 73u);
  EXPECT_THAT(words_of(*section_of(whole, "channel")), HasSubstr("5 % | 1.375 um | 1.03 um | 36 nm | 500 nm | 36 nm"));
}

TEST_F(ImpactPage, AParticleThatPassedThroughHasALowerBound) {
  for (Evaluation& run : found.runs) run.result.outcome = Outcome::passed_through;
  EXPECT_THAT(page().summary, HasSubstr("deeper than 75 um"));
}

}  // namespace
}  // namespace percal
