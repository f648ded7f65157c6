#include "percal/card/card_json.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "card/card_test.hpp"

namespace percal {
namespace {

using card_test::skin;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const json& card) {
  try {
    card_of_result(json{{"card", card}}.dump(), "result.json");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

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
  const auto refused = [](const std::string& text) -> std::string {
    try {
      card_of_result(text, "result.json");
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refused(R"({"minima": [{"mu_Pa": 1, "alpha": 2}]})"),
              AllOf(HasSubstr("percal fit"), HasSubstr("density")));
  EXPECT_THAT(refused("{}"), HasSubstr("card object"));
  EXPECT_THAT(refused(R"({"card": null})"), HasSubstr("card object"));
  EXPECT_THAT(refused("[1]"), HasSubstr("card object"));
  EXPECT_THAT(refused("{\n\"a\": 1,\n oops"), HasSubstr("result.json:3"));
  EXPECT_THAT(refused(""), HasSubstr("not JSON"));
  EXPECT_THAT(refused(R"({"card": {"name": "x", "density_kg_m3": 1e999}})"), HasSubstr("result.json"));
}

}  // namespace
}  // namespace percal
