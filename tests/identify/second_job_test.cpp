// The whole chain on a job that has nothing in common with the shipped one: other balls, another gel, another tissue, other
// conventions. What the result must hold whatever the material, and that it depends on nothing but the job.
#include <gmock/gmock.h>

#include <cmath>

#include "acceptance/liver.hpp"
#include "percal/material/conventions.hpp"

namespace percal {
namespace {

using acceptance::LiverJob;
using acceptance::without_cost;
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

class SecondJob : public LiverJob {
 protected:
  // The result of `percal identify` with a store and a folder of this name.
  json identify(const std::string& name, const std::string& threads = "2", const std::string& store = "") const {
    const Ended ended = run({"identify", "liver.toml", "--store", path((store.empty() ? name : store) + ".store"),
                             "--out", path(name), "--quiet", "--threads", threads});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_THAT(ended.err, IsEmpty());
    return result(name + "/result.json");
  }
};

TEST_F(SecondJob, EndsWithEveryKeyOfAResult) {
  job();
  const json found = identify("out");
  for (const char* key :
       {"schema", "percal", "command", "input", "title", "complete", "gelatin_law", "alpha", "ridge", "similarity",
        "skin", "model_check", "predictions", "prediction_means", "cards", "steps", "tables", "findings", "cost"})
    EXPECT_TRUE(found.contains(key)) << key;
  EXPECT_EQ(found["complete"], true);
  EXPECT_EQ(found["alpha"]["value"], 5.0);
  EXPECT_EQ(found["alpha"]["from"], "given");
  EXPECT_TRUE(found["alpha"]["best"].is_null());

  ASSERT_EQ(found["ridge"].size(), 3u);
  double softer_than = INFINITY;
  for (const json& point : found["ridge"]) {
    EXPECT_EQ(point["outcome"], "found");
    EXPECT_EQ(point["mu_as_given_Pa"], point["mu_true_Pa"]) << "the job's moduli are true ones";
    EXPECT_TRUE(point["depth_over_radius_at_table_pair"].is_null()) << "no table";
    EXPECT_GT(point["relative_error_solver"], 0.0);
    EXPECT_GT(point["relative_error_data"], 0.0);
    EXPECT_LT(point["dlnP_dlnmu"], 0.0);
    EXPECT_LT(point["mu_true_Pa"], softer_than) << "a tougher material that lets the ball as deep is softer";
    softer_than = point["mu_true_Pa"];
  }
  for (const char* key : {"mu_highrate_as_given_Pa", "mu_highrate_true_Pa", "youngs_quasistatic_as_given_Pa",
                          "youngs_quasistatic_true_Pa", "erosion_strain"})
    EXPECT_GT(found["skin"][key], 0.0) << key;
  EXPECT_EQ(found["skin"]["strain_measure"], "true");
  EXPECT_EQ(found["skin"]["convention"], "true");
  EXPECT_GT(found["model_check"]["depth_m"], 0.0);
  EXPECT_GT(found["model_check"]["expected_m"], 0.0);
  ASSERT_EQ(found["predictions"].size(), 4u) << "two shots into agar, one into liver at two densities";
  for (const json& shot : found["predictions"]) {
    for (const char* key : {"radius_m", "speed_m_s", "depth_m", "depth_spread_m", "measured_m"})
      EXPECT_GT(shot[key], 0.0) << key;
    EXPECT_TRUE(shot.contains("thesis_fe_m") && shot.contains("system"));
  }
  EXPECT_NEAR(found["predictions"][2]["thesis_fe_m"], 225e-6, 1e-18);
  for (const json& table : found["tables"])
    for (const char* key : {"name", "note", "reference", "mean_difference", "rows"})
      EXPECT_TRUE(table.contains(key)) << key;
  for (const char* key : {"runs", "reused", "wall_s", "cpu_s", "isa"}) EXPECT_TRUE(found["cost"].contains(key)) << key;
  EXPECT_EQ(found["cost"]["reused"], 6)
      << "the model check, the mesh study's middle and the calibration again are one dimensionless problem";
  EXPECT_EQ(found["input"]["toml"], read("liver.toml"));
}

TEST_F(SecondJob, SimilarityHoldsExactly) {
  job();
  const json found = identify("out");
  const json &similar = found["similarity"], &liver = found["skin"];
  constexpr double exact = 1e-12;  // a few roundings
  const auto expect = [&](double value, double wanted) { EXPECT_NEAR(value / wanted, 1, exact); };
  expect(similar["target_density_kg_m3"], 1060.0 * 14900 / 15600);
  expect(similar["modulus_ratio"], 14900.0 * 20 * 20 / (15600.0 * 120 * 120));
  expect(similar["penetration_m"], 230e-6 * 2.5e-3 / 20e-6);
  expect(found["model_check"]["expected_m"], similar["penetration_m"]);
  EXPECT_EQ(similar["formulation"], 2.0);
  expect(similar["formulation_mismatch"].get<double>() + 1, 28e-3 / similar["penetration_m"].get<double>());
  expect(liver["mu_highrate_as_given_Pa"],
         similar["mu_as_given_Pa"].get<double>() / similar["modulus_ratio"].get<double>());
  expect(similar["mu_as_given_Pa"],
         10 * found["gelatin_law"]["k_Pa"].get<double>() * std::pow(2, found["gelatin_law"]["n"].get<double>()));
  expect(liver["youngs_quasistatic_true_Pa"], 3 * liver["mu_highrate_true_Pa"].get<double>() / 25);
  EXPECT_NEAR(found["gelatin_law"]["n"], 2, 0.05) << "the table was made with n = 2, rounded";
}

TEST_F(SecondJob, TheIdentifiedPairGivesTheDepthThatItCameFrom) {
  job();
  const json found = identify("out");
  const double strain = found["skin"]["erosion_strain"];
  EXPECT_GT(strain, 0.3);
  EXPECT_LT(strain, 1.0);
  const json& again = found["predictions"][2];
  EXPECT_NEAR(again["depth_m"].get<double>() / 230e-6, 1, 0.2)
      << "the calibration shot at the pair on the ridge, on the ridge's mesh: noise of 4 elements per radius, a ridge "
         "of three points";
  EXPECT_NEAR(found["model_check"]["depth_m"].get<double>() / found["model_check"]["expected_m"].get<double>(), 1, 0.2)
      << "its similar system";
}

// An erosion strain belongs to its mesh: percal impact runs the scene on that of the ridge, from the ridge's own runs.
TEST_F(SecondJob, TheScenesThatItWritesAreItsOwnRuns) {
  job();
  const json found = identify("out");
  const json model = json::parse(run({"impact", "out/scenes/model.toml", "--json", "--out", "none"}).out);
  EXPECT_EQ(model["depth_m"], found["model_check"]["depth_m"]);
  EXPECT_EQ(model["mesh"]["elements_per_radius"], 4.0);
  EXPECT_EQ(model["mesh"]["width_over_radius"], 4.0);
  EXPECT_FALSE(model["mesh"]["width_was_chosen"]);
  const json shot = json::parse(run({"impact", "out/scenes/calibration.toml", "--json", "--out", "none"}).out);
  EXPECT_EQ(shot["runs"].size(), 5u) << "as many as each depth of the ridge has";
  EXPECT_EQ(shot["mu_true_Pa"], found["skin"]["mu_highrate_true_Pa"]);
}

TEST_F(SecondJob, TheCardHoldsWhatWasFound) {
  job();
  const json found = identify("out");
  EXPECT_EQ(files("out"),
            (std::set<std::string>{"out/result.json", "out/liver_lsdyna.k", "out/liver_abaqus.inp", "out/scenes",
                                   "out/scenes/calibration.toml", "out/scenes/model.toml"}));
  EXPECT_EQ(found["cards"][0]["mu_true_Pa"], found["skin"]["mu_highrate_true_Pa"]);
  EXPECT_EQ(found["cards"][0]["erosion"]["strain"], found["skin"]["erosion_strain"]);
  EXPECT_EQ(found["cards"][0]["erosion"]["measure"], "true");
  EXPECT_EQ(found["cards"][0]["density_kg_m3"], 1060.0);
  EXPECT_THAT(found["cards"][0]["comments"].dump(), HasSubstr("its runs had bulk viscosity"));
  EXPECT_NEAR(found["cards"][0]["bulk_modulus_Pa"].get<double>() / found["cards"][0]["mu_true_Pa"].get<double>(), 40,
              1e-9);
  const Ended card = run({"card", "write", "out/result.json", "--solver", "lsdyna", "--units", "mm-ms-kg-GPa"});
  EXPECT_EQ(card.code, 0) << card.err;
  EXPECT_EQ(card.out, read("out/liver_lsdyna.k")) << "the card can be written again from the result";
}

TEST_F(SecondJob, TheSecondTimeEverythingComesFromTheStore) {
  job();
  const json first = identify("first", "2", "one"), second = identify("second", "2", "one");
  EXPECT_GT(first["cost"]["runs"], 20);
  EXPECT_EQ(second["cost"]["runs"], 0);
  EXPECT_EQ(second["cost"]["reused"], first["cost"]["runs"].get<long>() + first["cost"]["reused"].get<long>());
  EXPECT_EQ(without_cost(second).dump(), without_cost(first).dump()) << "to the last bit";
}

TEST_F(SecondJob, TheResultDoesNotDependOnTheNumberOfThreads) {
  job();
  const json alone = identify("alone", "1"), together = identify("together", "2"), many = identify("many", "7");
  EXPECT_EQ(without_cost(alone).dump(), without_cost(together).dump());
  EXPECT_EQ(without_cost(alone).dump(), without_cost(many).dump());
  EXPECT_EQ(alone["cost"]["runs"], many["cost"]["runs"]);
}

TEST_F(SecondJob, TheConventionOfTheModuliOnlyScalesThem) {
  job();
  const json as_true = identify("true");
  // mu/alpha at alpha = 5 means 2.5 times as much, so that 2.5 times less is the same gel.
  job({{"modulus = \"true\"", "modulus = \"mu/alpha\""},
       {"rate_factor = 10", "rate_factor = 4"},
       {"\"5 MPa\"", "\"2 MPa\""}});
  const json given = identify("given", "2", "true");
  EXPECT_LT(given["cost"]["runs"], 3) << "all but roundings of the modulus are the same impacts";
  const auto ratio = [](const json& a, const json& b) { return a.get<double>() / b.get<double>(); };
  EXPECT_NEAR(ratio(given["skin"]["mu_highrate_true_Pa"], given["skin"]["mu_highrate_as_given_Pa"]), 2.5, 1e-12);
  EXPECT_NEAR(ratio(given["skin"]["youngs_quasistatic_true_Pa"], given["skin"]["youngs_quasistatic_as_given_Pa"]), 2.5,
              1e-12);
  EXPECT_NEAR(ratio(given["skin"]["mu_highrate_true_Pa"], as_true["skin"]["mu_highrate_true_Pa"]), 1, 1e-12);
  EXPECT_NEAR(ratio(given["skin"]["erosion_strain"], as_true["skin"]["erosion_strain"]), 1, 1e-6);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(ratio(given["ridge"][k]["mu_true_Pa"], given["ridge"][k]["mu_as_given_Pa"]), 2.5, 1e-12);
    EXPECT_NEAR(ratio(given["ridge"][k]["mu_true_Pa"], as_true["ridge"][k]["mu_true_Pa"]), 1, 1e-6);
  }
}

TEST_F(SecondJob, AlphaComesFromAScanWhereTheJobNamesATarget) {
  write("pairs.csv", "mu_MPa,strain,model_kPa\n13.2,0.45,351\n10.03,0.6,266.5\n5.71,0.8,151.7\n");
  job({{"[0.3, 0.6, 0.8]", "[0.45, 0.6, 0.8]"},
       {"value = 5",
        "scan = [3, 4, 5, 6, 7]\nelements_per_radius = 4\n[alpha.target]\nname = \"pairs\"\nfile = \"pairs.csv\"\nmu = "
        "\"mu\"\nerosion_strain = \"strain\"\nmu_model = \"model\""}});
  const json found = identify("out");
  EXPECT_EQ(found["alpha"]["from"], "scan");
  EXPECT_EQ(found["alpha"]["ridge_is_in_sample"], true);
  EXPECT_NEAR(found["alpha"]["best"], 5, 0.5) << "the pairs are this solver's own ridge at alpha = 5";
  EXPECT_NEAR(found["alpha"]["value"].get<double>(), found["alpha"]["indistinguishable_from"].get<double>(), 1e-9);
  for (const json& point : found["ridge"]) {
    EXPECT_NEAR(point["depth_over_radius_at_table_pair"], 11.5, 2) << "all pairs were made for 230 um/20 um";
    EXPECT_GT(point["table_mu_as_given_Pa"], 0.0);
  }
  EXPECT_THAT(found["findings"].dump(), HasSubstr("in-sample"));
  EXPECT_THAT(found["findings"].dump(), HasSubstr("a factor of 2.1 in the modulus"));
  EXPECT_EQ(found["tables"][0]["name"], "pairs, identified modulus");
  for (const json& row : found["tables"][1]["rows"])
    EXPECT_NEAR(row["difference"], 0, 4e-3) << "rounded to 1 kPa in 150";
}

TEST_F(SecondJob, ARidgeThatDoesNotReachTheModulusEndsWithExitCodeThree) {
  job({{"[0.3, 0.6, 0.8]", "[0.9, 1.0]"}});
  const Ended ended = run({"identify", "liver.toml", "--store", "s.store", "--out", "out"});
  EXPECT_EQ(ended.code, 3) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("the ridge does not reach"));
  const json found = result("out/result.json");
  EXPECT_EQ(found["complete"], false);
  EXPECT_TRUE(found["skin"]["erosion_strain"].is_null());
  EXPECT_GT(found["skin"]["mu_highrate_true_Pa"], 0.0) << "the modulus does not take the ridge";
  EXPECT_TRUE(found["model_check"].is_null());
  EXPECT_TRUE(found["cards"].empty());
  EXPECT_THAT(found["findings"].dump(), HasSubstr("the ridge does not reach the modulus"));
  EXPECT_THAT(found["predictions"], IsEmpty()) << "all of this job's take the erosion strain";
  EXPECT_EQ(files("out"), (std::set<std::string>{"out/result.json"})) << "no card, no scenes";
}

TEST_F(SecondJob, AStrainAtWhichNoModulusGivesTheDepthIsNamedAndLeftOut) {
  job({{"[0.3, 0.6, 0.8]", "[1e-6, 0.3, 1.0]"}});
  const json found = identify("out");
  EXPECT_NE(found["ridge"][0]["outcome"], "found");
  EXPECT_TRUE(found["ridge"][0]["mu_true_Pa"].is_null());
  EXPECT_EQ(found["ridge"][1]["outcome"], "found");
  EXPECT_EQ(found["complete"], true);
}

TEST_F(SecondJob, WithoutAFolderGivenItWritesIntoTheWorkingFolder) {
  write("place/liver.toml", text_of(test::test_data + "liver/liver.toml"));
  for (const char* table : {"agar.csv", "shots.csv"}) fs::rename(path(table), path(std::string("place/") + table));
  const Ended ended = run({"identify", "place/liver.toml", "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_EQ(json::parse(ended.out), result("liver.out/result.json"))
      << "standard output holds the result and nothing else";
  EXPECT_TRUE(fs::exists(path("cache/percal/percal.store"))) << "the store's own place";
}

TEST_F(SecondJob, TheTerminalShowsEveryStepAsATableAndThenTheAnswer) {
  job();
  const Ended ended = run({"identify", "liver.toml", "--store", "s.store", "--out", "out"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, IsEmpty()) << "no progress bar in a pipe";
  const json found = result("out/result.json");
  std::size_t at = 0;
  for (const json& step : found["steps"]) {
    const auto next = ended.out.find(step["name"].get<std::string>(), at);
    EXPECT_NE(next, std::string::npos) << step["name"];
    at = next;
  }
  EXPECT_NE(ended.out.find("What came out", at), std::string::npos);
  for (const char* word : {"difference", "error", "shear modulus at impact rate"})
    EXPECT_THAT(ended.out, HasSubstr(word));
  const std::string details = run({"identify", "liver.toml", "--store", "s.store", "--details"}).out;
  const std::string step = found["steps"][0]["name"];
  EXPECT_NE(details.find(step), std::string::npos);
  EXPECT_EQ(details.find(step), details.rfind(step)) << "once";
  EXPECT_THAT(details, HasSubstr("runs taken from the store"));
}

TEST_F(SecondJob, ACheckRunsAndWritesNothing) {
  job();
  const auto before = files();
  const Ended ended = run({"identify", "liver.toml", "--check"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(run({"identify", test::guha2009 + "skin.toml", "--check", "--quiet"}).code, 0);
  const Ended as_json = run({"identify", "liver.toml", "--check", "--json"});
  EXPECT_EQ(json::parse(as_json.out)["valid"], true);
  EXPECT_EQ(files(), before);
}

TEST_F(SecondJob, NamesThatAreNotUtf8DoNotSpoilTheResult) {
  std::string shots = read("shots.csv");
  shots.replace(shots.find("steel"), 5, "st\xe4hl");
  write("shots.csv", shots);
  job();
  EXPECT_EQ(identify("out")["predictions"][0]["particle"], "st\xef\xbf\xbdhl");
}

}  // namespace
}  // namespace percal
