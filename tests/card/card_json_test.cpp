#include "percal/card/card_json.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "card/card_test.hpp"

namespace percal {
namespace {

using card_test::skin;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal_of_text(const std::string& result, const CardRequest& request = {}) {
  try {
    card_of_result(result, "result.json", request);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const json& card) { return refusal_of_text(json{{"card", card}}.dump()); }

json with(const std::string& key, const json& value) {
  json card = card_to_json(skin());
  card[key] = value;
  return card;
}

TEST(CardJson, ComesBackAsItWas) {
  const CardMaterial back = card_of_result(json{{"card", card_to_json(skin())}}.dump(), "result.json");
  EXPECT_EQ(back.name, "skin");
  EXPECT_EQ(back.density, 1000);
  ASSERT_EQ(back.terms.size(), 1u);
  EXPECT_EQ(back.terms[0].mu, 63.75e6);
  EXPECT_EQ(back.terms[0].alpha, 8.5);
  EXPECT_EQ(back.bulk_modulus, 50 * 63.75e6);
  ASSERT_TRUE(back.erosion);
  EXPECT_EQ(back.erosion->limit, 0.7);
  EXPECT_EQ(back.erosion->measure, StrainMeasure::engineering);
  EXPECT_EQ(back.comments, skin().comments);
}

TEST(CardJson, KeepsTheElementsOfAnErosionStrain) {
  CardMaterial material = skin();
  EXPECT_TRUE(card_to_json(material)["erosion"]["element_m"].is_null());
  material.erosion->element_over_radius = 0.1;
  material.erosion->element = 1e-7;
  json card = card_to_json(material);
  const CardMaterial back = card_from_json(card, {});
  EXPECT_EQ(back.erosion->element_over_radius, 0.1);
  EXPECT_EQ(back.erosion->element, 1e-7);
  card["erosion"]["element_m"] = -1;
  EXPECT_THAT(refusal(card), AllOf(HasSubstr("card.erosion.element_m"), HasSubstr("a positive number or null")));
  card["erosion"].erase("element_m");
  EXPECT_FALSE(card_from_json(card, {}).erosion->element) << "a card of one's own need not say it";
}

TEST(CardJson, TakesAMaterialWithoutErosionAndComments) {
  json card = with("erosion", nullptr);
  card.erase("comments");
  EXPECT_FALSE(card_from_json(card, {}).erosion);
  card.erase("erosion");
  EXPECT_FALSE(card_from_json(card, {}).erosion);
}

TEST(CardJson, NamesFileAndKeyOfEveryNumberItRefuses) {
  for (const char* key : {"density_kg_m3", "mu_true_Pa", "bulk_modulus_Pa"}) {
    for (const json& bad : {json(0), json(-1.5), json(nullptr), json("12 MPa")}) {
      EXPECT_THAT(refusal(with(key, bad)),
                  AllOf(HasSubstr("result.json: card." + std::string(key)), HasSubstr("accepted")));
    }
    json missing = card_to_json(skin());
    missing.erase(key);
    EXPECT_THAT(refusal(missing), AllOf(HasSubstr(key), HasSubstr("found nothing")));
  }
  EXPECT_THAT(refusal(with("alpha", 0)), HasSubstr("card.alpha"));
  EXPECT_EQ(refusal(with("alpha", -3)), "");
  EXPECT_THAT(refusal(with("name", 5)), HasSubstr("card.name"));
}

TEST(CardJson, NamesTheKeyInsideErosion) {
  EXPECT_THAT(refusal(with("erosion", {{"strain", 0}, {"measure", "true"}})), HasSubstr("card.erosion.strain"));
  EXPECT_THAT(refusal(with("erosion", {{"strain", 0.7}})), HasSubstr("card.erosion.measure"));
  EXPECT_THAT(refusal(with("erosion", {{"strain", 0.7}, {"measure", "log"}})),
              AllOf(HasSubstr("\"log\""), HasSubstr("green-lagrange")));
  EXPECT_THAT(refusal(with("erosion", 0.7)), HasSubstr("card.erosion"));
  EXPECT_THAT(refusal(with("comments", "text")), HasSubstr("card.comments"));
  EXPECT_THAT(refusal(with("comments", {1})), HasSubstr("card.comments"));
  EXPECT_THAT(refusal(json::array()), HasSubstr("array"));
}

TEST(CardJson, SaysWhatAResultWithoutACardLacks) {
  EXPECT_THAT(refusal_of_text(R"({"minima": [{"mu_Pa": 1, "alpha": 2}], "cards": []})"), HasSubstr("found no card"));
  EXPECT_THAT(refusal_of_text("{}"), HasSubstr("card object"));
  EXPECT_THAT(refusal_of_text(R"({"card": null})"), HasSubstr("card object"));
  EXPECT_THAT(refusal_of_text("[1]"), HasSubstr("card object"));
  EXPECT_THAT(refusal_of_text("{\n\"a\": 1,\n oops"), HasSubstr("result.json:3"));
  EXPECT_THAT(refusal_of_text(""), HasSubstr("not JSON"));
  EXPECT_THAT(refusal_of_text(R"({"card": {"name": "x", "density_kg_m3": 1e999}})"), HasSubstr("result.json"));
}

// What curves tell of a material: no density and no bulk modulus.
json fit() {
  CardMaterial material = skin();
  material.name = "fit";
  material.density = material.bulk_modulus = std::nan("");
  return {{"cards", cards_to_json({material})}};
}

TEST(CardOfFit, TakesDensityAndBulkModulusFromTheRequest) {
  EXPECT_TRUE(fit()["cards"][0]["density_kg_m3"].is_null());
  const CardMaterial card = card_of_result(fit().dump(), "r", {.name = "gel", .density = 1010, .bulk_to_shear = 50});
  EXPECT_EQ(card.name, "gel");
  EXPECT_EQ(card.density, 1010);
  EXPECT_EQ(card.terms[0].mu, 63.75e6);
  EXPECT_EQ(card.bulk_modulus, 50 * 63.75e6);
}

TEST(CardOfFit, SaysWhatIsMissing) {
  EXPECT_THAT(refusal_of_text(fit().dump()),
              AllOf(HasSubstr("cards[0].density_kg_m3"), HasSubstr("--density"), HasSubstr("--bulk-to-shear")));
  EXPECT_THAT(refusal_of_text(fit().dump(), {.density = 1010}),
              AllOf(HasSubstr("cards[0].bulk_modulus_Pa"), HasSubstr("--nu")));
  EXPECT_THAT(refusal_of_text(R"({"cards": []})"), HasSubstr("card object"));
  EXPECT_THROW(card_from_json(fit()["cards"][0], {}), BadInput);
}

TEST(CardOfCalibration, IsChosenByItsName) {
  json gel = card_to_json(skin());
  gel["name"] = "gel, mu free";
  const json result = {{"cards", {card_to_json(skin()), gel}}};
  EXPECT_THAT(refusal_of_text(result.dump()),
              AllOf(HasSubstr("'skin'"), HasSubstr("'gel, mu free'"), HasSubstr("--card")));
  EXPECT_THAT(refusal_of_text(result.dump(), {.name = "bone"}), HasSubstr("bone"));
  EXPECT_EQ(card_of_result(result.dump(), "r", {.name = "gel, mu free"}).name, "gel, mu free");
}

TEST(CardOfResult, TakesTheOnlyOneAndItsNewName) {
  EXPECT_EQ(card_of_result(json{{"cards", {card_to_json(skin())}}}.dump(), "r").name, "skin");
  EXPECT_EQ(card_of_result(json{{"cards", {card_to_json(skin())}}}.dump(), "r", {.name = "pig"}).name, "pig");
}

TEST(CardJson, KeepsTermsIntervalsErrorAndData) {
  CardMaterial material = skin();
  material.terms = {{60e6, 8}, {3.75e6, -2}};
  material.intervals = CardIntervals{0.95, {{"alpha_1", 7.5, std::nullopt}}};
  material.fit_error = "R^2 0.99";
  material.data = {{"a.csv", std::string(64, '0')}};
  const CardMaterial back = card_from_json(card_to_json(material), {});
  ASSERT_EQ(back.terms.size(), 2u);
  EXPECT_EQ(back.terms[1].alpha, -2);
  ASSERT_TRUE(back.intervals);
  EXPECT_EQ(back.intervals->of[0].parameter, "alpha_1");
  EXPECT_EQ(back.intervals->of[0].low, 7.5);
  EXPECT_FALSE(back.intervals->of[0].high);
  EXPECT_EQ(back.fit_error, "R^2 0.99");
  EXPECT_EQ(back.data[0].sha256, std::string(64, '0'));
}

TEST(CardJson, RefusesTermsAndProvenanceOfAnotherKind) {
  EXPECT_THAT(refusal(with("terms", json::array())), HasSubstr("1 to 3"));
  EXPECT_THAT(refusal(with("terms", {{{"mu_true_Pa", 1e6}}})), HasSubstr("card.terms[0].alpha"));
  EXPECT_THAT(refusal(with("terms", {{{"mu_true_Pa", 1e6}, {"alpha", 2}}, {{"mu_true_Pa", -2e6}, {"alpha", 3}}})),
              HasSubstr("sum of all"));
  EXPECT_THAT(refusal(with("intervals", {{"alpha", {{"low", 1}}}})), HasSubstr("card.intervals.level"));
  EXPECT_THAT(refusal(with("intervals", {{"level", 0.95}, {"alpha", 1}})), HasSubstr("card.intervals.alpha"));
  EXPECT_THAT(refusal(with("data", {{{"file", "a.csv"}, {"sha256", "12"}}})), HasSubstr("64 hexadecimal"));
  EXPECT_THAT(refusal(with("fit_error", 3)), HasSubstr("card.fit_error"));
}

}  // namespace
}  // namespace percal
