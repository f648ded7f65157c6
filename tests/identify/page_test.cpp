// The page of an identification against a result made by hand.
#include "percal/identify/page/page.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "page/page_words.hpp"
#include "percal/page/text.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Block;
using test::Figure;
using test::figure_of;
using test::Page;
using test::Section;
using test::section_of;
using test::series_of;
using test::words_of;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// Two numbers to a few roundings.
auto are(double first, double second) { return ElementsAre(DoubleNear(first, 1e-9), DoubleNear(second, 1e-9)); }

struct Ball {
  std::string particle;
  double density, radius, speed;
};

json shot(const Ball& ball, double target_density, bool of_model, double measured, double depth) {
  return {{"system", of_model ? "gel shots" : "skin shots"},
          {"material", of_model ? "model" : "tissue"},
          {"particle", ball.particle},
          {"particle_density_kg_m3", ball.density},
          {"radius_m", ball.radius},
          {"speed_m_s", ball.speed},
          {"target_density_kg_m3", target_density},
          {"mu_true_Pa", 2e5},
          {"measured_m", measured},
          {"thesis_fe_m", of_model ? json(nullptr) : json(1.1 * measured)},
          {"depth_m", depth},
          {"depth_spread_m", 0.01 * depth},
          {"outcome", "stopped"}};
}

json small_result() {
  json result = json::parse(R"({
    "schema": 2, "percal": "0.1.0", "command": "identify", "title": "Skin from gel",
    "complete": true, "input": {"job": "skin.toml", "toml": "title = \"Skin from gel\"\n"},
    "calibration": {"particle": "gold", "radius_m": 1e-6, "particle_density_kg_m3": 16800, "speed_m_s": 600,
                    "penetration_m": 26e-6, "penetration_standard_error_m": 1e-6},
    "model": {"particle": "steel", "radius_m": 1e-3, "particle_density_kg_m3": 8000, "speed_m_s": 80,
              "material": "gel", "density_kg_m3": 1000,
              "formulations": [{"concentration": 7, "mu_quasistatic_as_given_Pa": 3.8e3, "in_law": true},
                               {"concentration": 12, "mu_quasistatic_as_given_Pa": 11.6e3, "in_law": true}]},
    "gelatin_law": {"k_Pa": 131, "n": 1.8, "k_standard_error_Pa": 4},
    "alpha": {"value": 8.6, "from": "scan", "best": 8.8, "best_mean_deviation": 0.04, "mean_deviation": 0.055,
              "standard_error": 0.02, "indistinguishable_from": 8.6, "indistinguishable_to": 9.1, "at_edge": false,
              "ridge_is_in_sample": true,
              "trials": [{"alpha": 8, "depth_m": 28.6e-6}, {"alpha": 8, "depth_m": 23.4e-6},
                         {"alpha": 9, "depth_m": null}],
              "scores": [{"alpha": 8, "mean_deviation": 0.11}, {"alpha": 9, "mean_deviation": 0.05}]},
    "ridge": [
      {"erosion_strain": 0.3, "outcome": "found", "mu_as_given_Pa": 50e6, "mu_true_Pa": 215e6,
       "relative_error_solver": 0.03, "relative_error_data": 0.04, "dlnP_dlnmu": -0.8, "table_mu_as_given_Pa": 55e6},
      {"erosion_strain": 0.7, "outcome": "found", "mu_as_given_Pa": 15e6, "mu_true_Pa": 64.5e6,
       "relative_error_solver": 0.03, "relative_error_data": 0.04, "dlnP_dlnmu": -0.8, "table_mu_as_given_Pa": null}],
    "similarity": {"formulation": 12, "formulation_mismatch": -0.02},
    "skin": {"name": "skin", "mu_highrate_as_given_Pa": 15e6, "mu_highrate_true_Pa": 64.5e6,
             "mu_quasistatic_as_given_Pa": 750e3, "mu_quasistatic_true_Pa": 3.225e6, "youngs_quasistatic_as_given_Pa": 2.25e6,
             "youngs_quasistatic_true_Pa": 9.675e6, "alpha": 8.6, "erosion_strain": 0.71,
             "erosion_strain_error": 0.014, "strain_measure": "engineering", "convention": "mu/alpha"},
    "mesh_study": [{"elements_per_radius": 10, "depth_m": 25e-6, "depth_spread_m": 1e-7},
                   {"elements_per_radius": 20, "depth_m": 26e-6, "depth_spread_m": 1e-7}],
    "prediction_means": [{"system": "skin shots", "target_density_kg_m3": 1000,
                          "mean_deviation_from_measured": 0.123, "mean_deviation_from_thesis_fe": null}],
    "predictions": [],
    "trends": [{"name": "squares", "x_name": "velocity_m_s", "y_name": "depth_cm", "x": [30, 40], "y": [2, 3],
                "reference_y": [2.1, 3.0], "slope": 0.1, "slope_error": null, "intercept": -1,
                "reference_slope": 0.11, "reference_intercept": -1.2}],
    "scaled_line": {"name": "scaled", "slope_m2_s_kg": 5e-5, "intercept_m": -0.008,
                    "cases": [{"particle": "gold", "particle_density_kg_m3": 16800, "radius_m": 1e-6,
                               "speed_m_s": 600, "depth_m": 24e-6, "measured_m": 20e-6, "reference_m": 24.1e-6}]},
    "tables": [{"name": "Table 9", "note": "made up", "reference": "thesis", "mean_difference": 0.5,
                "rows": [{"what": "slope", "unit": "cm", "reference": 2, "ours": 3, "difference": 0.5, "error": 0.25, "digits": 4,
                          "remark": "far"}]}],
    "steps": [{"name": "a step", "note": "", "reference": "measured", "mean_difference": null,
               "rows": [{"what": "depth", "unit": "um", "reference": null, "ours": 26.4449, "difference": null, "error": null,
                         "digits": 3, "remark": ""}]}],
    "left_out": [{"what": "gravity", "why": "nothing falls"}],
    "cards": [{"name": "skin", "density_kg_m3": 1000, "mu_true_Pa": 64.5e6, "alpha": 8.6, "bulk_modulus_Pa": 3.2e9,
             "erosion": {"strain": 0.71, "measure": "engineering"}, "comments": ["from gel"]}],
    "findings": ["gel is not skin"],
    "cost": {"runs": 12, "reused": 3, "wall_s": 4, "cpu_s": 8, "budget_s": null, "isa": "x86_64_v3", "advice": null,
             "mesh_study": [{"elements_per_radius": 10, "cpu_s": 2}, {"elements_per_radius": 20, "cpu_s": 14}]}
  })");
  json& shots = result["predictions"];
  for (const double v : {400.0, 600.0})
    shots.push_back(shot({"gold", 16800, 1e-6, v}, 1000, false, 0.04e-6 * v, 0.05e-6 * v));
  for (const double target : {460.0, 1000.0})
    for (const double v : {60.0, 100.0})
      for (const double a : {1e-3, 2e-3}) {
        shots.push_back(shot({"steel", 8000, a, v}, target, true, 0.4 * v * a, 0.3 * v * a));
        shots.push_back(shot({"plastic", 1000, a, v}, target, true, 0.1 * v * a, 0.1 * v * a));
      }
  return result;
}

class IdentifyPageOfResult : public testing::Test {
 protected:
  json result = small_result();
  Page whole = identify_page(result);
};

TEST_F(IdentifyPageOfResult, TheSummaryHasTheTrueModuliAndTheStrainWithItsError) {
  EXPECT_EQ(whole.title, "Skin from gel");
  for (const char* words : {"shear modulus 64.5 MPa at impact rate", "Young's modulus 9.68 MPa quasi-static, both true",
                            "0.71 \u00b1 0.014 (engineering)", "alpha 8.6"})
    EXPECT_THAT(whole.summary, HasSubstr(words));
}

TEST_F(IdentifyPageOfResult, SaysWhatWasAskedFoundLeftOutAndWhatItCost) {
  const std::string words = words_of(whole);
  for (const char* what :
       {"gold of radius 1 um at 600 m/s goes 26 um deep (standard error 1 um)",
        "shear modulus, quasi-static | 750 kPa | 3.225 MPa", "8.6 to 9.1 no worse", "skin shots | 1000 | 12.3 % | -",
        "0.3 | 50 MPa | 215 MPa | 3.0 % | 4.0 % | 55 MPa | found", "slope | cm | 2 | 3 | +50.0 % | 0.25 | far",
        "depth | um | - | 26.4 | - | -", "gravity: nothing falls", "gel is not skin", "bulk modulus | 3.2 GPa",
        "runs taken from the store | 3", "title = \"Skin from gel\""})
    EXPECT_THAT(words, HasSubstr(what));
  EXPECT_THAT(words, HasSubstr("\u00b1 2.5 %")) << "2 % of depth over a slope of 0.8";
}

TEST_F(IdentifyPageOfResult, TheRidgeHasTheFoundThePublishedAndTheIdentifiedPairs) {
  const Figure* ridge = figure_of(whole, "ridge");
  ASSERT_TRUE(ridge);
  const Series *found = series_of(*ridge, "percal"), *published = series_of(*ridge, "published pairs"),
               *identified = series_of(*ridge, "identified");
  ASSERT_TRUE(found && published && identified);
  EXPECT_THAT(found->y, are(50, 15));
  EXPECT_THAT(found->high, are(52.5, 15.75)) << "3 % and 4 % together are 5 %";
  EXPECT_THAT(published->y, ElementsAre(55));
  EXPECT_THAT(identified->x, ElementsAre(0.71));
}

TEST_F(IdentifyPageOfResult, TheScanShowsTheRunsTheChosenAlphaAndTheLimit) {
  const Figure* scan = figure_of(whole, "alpha");
  ASSERT_TRUE(scan);
  EXPECT_THAT(series_of(*scan, "as run")->y, ElementsAre(DoubleNear(10, 1e-9)))
      << "28.6 and 23.4 um are 10 % from 26; the third passed through";
  EXPECT_THAT(series_of(*scan, "taken")->y, ElementsAre(DoubleNear(5.5, 1e-9)));
  EXPECT_THAT(series_of(*scan, "one standard error above the best")->y, are(6, 6));
}

TEST_F(IdentifyPageOfResult, DepthsStandOverTheImpactParameter) {
  const Figure *skin = figure_of(whole, "depths_1"), *gel = figure_of(whole, "depths_2"),
               *measured = figure_of(whole, "measured_2");
  ASSERT_TRUE(skin && gel && measured);
  EXPECT_THAT(series_of(*skin, "measured")->x, are(6.72, 10.08));
  EXPECT_THAT(series_of(*skin, "measured")->y, are(16, 24));
  EXPECT_THAT(series_of(*skin, "the reference's finite elements")->y, are(17.6, 26.4));
  EXPECT_THAT(skin->caption, HasSubstr("25.0 % from the measured depths"));
  EXPECT_TRUE(series_of(*gel, "percal, target of 460 kg/m3"));
  EXPECT_TRUE(series_of(*gel, "percal, target of 1000 kg/m3"));
  ASSERT_TRUE(measured->chart.upper);
  EXPECT_NEAR(measured->chart.upper_factor, 16800 * 600 * 1e-6 / (8000 * 80 * 1e-3), 1e-12);
}

TEST_F(IdentifyPageOfResult, TheModelsShotsAreShownInEveryScale) {
  const Figure *energy = figure_of(whole, "energy"), *radius = figure_of(whole, "radius"),
               *density = figure_of(whole, "density"), *collapse = figure_of(whole, "collapse");
  ASSERT_TRUE(energy && radius && density && collapse);
  EXPECT_THAT(series_of(*energy, "steel of 2 mm")->x, are(18, 50)) << "1000 v^2 / 200 kPa";
  EXPECT_THAT(series_of(*energy, "steel of 2 mm")->y, are(24, 40));
  EXPECT_EQ(radius->chart.title, "Depth against radius at 100 m/s");
  EXPECT_THAT(series_of(*radius, "steel")->y, are(4, 8));
  EXPECT_THAT(series_of(*density, "plastic of 2 mm")->y, ElementsAre(DoubleNear(5, 1e-9)));
  EXPECT_THAT(series_of(*collapse, "steel of 4 mm")->y, are(1.5, 2.5));
}

TEST_F(IdentifyPageOfResult, MeshShapesLawAndScaledLineHaveFigures) {
  const Figure *mesh = figure_of(whole, "mesh"), *cost = figure_of(whole, "mesh_cost"),
               *shape = figure_of(whole, "shape_1"), *scaled = figure_of(whole, "scaled"),
               *law = figure_of(whole, "law");
  ASSERT_TRUE(mesh && cost && shape && scaled && law);
  EXPECT_THAT(series_of(*mesh, "percal")->y, are(25, 26));
  EXPECT_THAT(cost->chart.series.front().x, are(2, 14));
  EXPECT_EQ(shape->chart.x.label, "velocity, m/s");
  EXPECT_THAT(series_of(*shape, "published trend")->y, are(2.1, 3.2));
  EXPECT_THAT(scaled->caption, HasSubstr("20.0 % from the measured depths"));
  EXPECT_EQ(series_of(*law, "k c^1.8")->x.back(), 12);
}

TEST_F(IdentifyPageOfResult, EveryFigureHasACaptionAndAnAltText) {
  int figures = 0;
  for (const Section& section : whole.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) {
        ++figures;
        EXPECT_GT(figure->caption.size(), 40u) << figure->name;
        EXPECT_GT(figure->alt.size(), 40u) << figure->name;
        EXPECT_THAT(figure->caption + figure->alt, Not(HasSubstr("nan"))) << figure->name;
      }
  EXPECT_EQ(figures, 14);
}

TEST_F(IdentifyPageOfResult, AnUnfinishedChainIsSaidToBeOne) {
  result["complete"] = false;
  result["cards"] = json::array();
  result["mesh_study"] = json::array();
  result["skin"]["erosion_strain"] = nullptr;
  const Page unfinished = identify_page(result);
  EXPECT_THAT(unfinished.summary, HasSubstr("does not reach"));
  EXPECT_FALSE(section_of(unfinished, "card"));
  EXPECT_FALSE(section_of(unfinished, "mesh"));
}

TEST_F(IdentifyPageOfResult, TheAnswerIsTheModuliTheRidgeAndTheFindings) {
  const std::string answer = page::as_text(whole, {.columns = 80});
  for (const char* there :
       {"shear modulus at impact rate", "0.3          50 MPa   215 MPa", "gel is not skin", "percal card write"})
    EXPECT_THAT(answer, HasSubstr(there));
  for (const char* not_there : {"Table 9", "gravity", "a step"}) EXPECT_THAT(answer, Not(HasSubstr(not_there)));
}

TEST_F(IdentifyPageOfResult, AMissingKeyIsRefusedByName) {
  result["skin"].erase("erosion_strain_error");
  try {
    identify_page(result);
    ADD_FAILURE();
  } catch (const page::MissingKey& missing) {
    EXPECT_EQ(missing.key, "erosion_strain_error");
  }
}

}  // namespace
}  // namespace percal
