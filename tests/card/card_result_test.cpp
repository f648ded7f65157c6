// Cards of the results of identify, calibrate and fit.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "card/card_test.hpp"
#include "percal/card/card_json.hpp"

namespace percal {
namespace {

using card_test::skin;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const json& result, const CardRequest& request = {}) {
  try {
    card_of_result(result.dump(), "result.json", request);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

json fit() {
  return {{"command", "fit"},
          {"model", "ogden2"},
          {"residual", "relative"},
          {"points", 12},
          {"minima",
           {{{"mu_Pa", 63.75e6},
             {"alpha", nullptr},
             {"r2", 0.997},
             {"terms", {{{"mu_Pa", 60e6}, {"alpha", 8}}, {{"mu_Pa", 3.75e6}, {"alpha", -2}}}}}}},
          {"sources", {{{"file", "somewhere/skin.csv"}, {"sha256", std::string(64, 'b')}}}},
          {"uncertainty",
           {{"level", 0.9},
            {"minima",
             {{{"small_strain_mu_Pa", {{"low", 60e6}, {"high", 67e6}}},
               {"parameters", {{"mu_1_Pa", {{"low", 55e6}, {"high", 1e99}, {"high_open", true}}}}}}}}}}};
}

TEST(CardOfFit, TakesDensityAndBulkModulusFromTheRequest) {
  const CardMaterial card = card_of_result(fit().dump(), "r", {.name = "gel", .density = 1010, .bulk_to_shear = 50});
  EXPECT_EQ(card.name, "gel");
  EXPECT_EQ(card.density, 1010);
  ASSERT_EQ(card.terms.size(), 2u);
  EXPECT_EQ(card.terms[1].mu, 3.75e6);
  EXPECT_EQ(card.bulk_modulus, 50 * 63.75e6);
  ASSERT_TRUE(card.intervals);
  EXPECT_EQ(card.intervals->level, 0.9);
  ASSERT_EQ(card.intervals->of.size(), 2u);
  EXPECT_EQ(card.intervals->of[0].parameter, "mu_true_Pa");
  EXPECT_EQ(card.intervals->of[1].low, 55e6);
  EXPECT_FALSE(card.intervals->of[1].high);
  EXPECT_THAT(card.fit_error, HasSubstr("0.997"));
  ASSERT_EQ(card.data.size(), 1u);
  EXPECT_EQ(card.data[0].file, "skin.csv");
}

TEST(CardOfFit, SaysWhatIsMissing) {
  EXPECT_THAT(refusal(fit()), AllOf(HasSubstr("--density"), HasSubstr("--bulk-to-shear")));
  EXPECT_THAT(refusal(fit(), {.density = 1010}), HasSubstr("--nu"));
  EXPECT_THAT(refusal({{"minima", json::array()}}, {.density = 1010, .bulk_to_shear = 50}), HasSubstr("no minimum"));
}

TEST(CardOfCalibration, IsChosenByItsName) {
  json gel = card_to_json(skin());
  gel["name"] = "gel, mu free";
  const json result = {{"cards", {card_to_json(skin()), gel}}};
  EXPECT_THAT(refusal(result), AllOf(HasSubstr("'skin'"), HasSubstr("'gel, mu free'"), HasSubstr("--card")));
  EXPECT_THAT(refusal(result, {.name = "bone"}), HasSubstr("bone"));
  EXPECT_EQ(card_of_result(result.dump(), "r", {.name = "gel, mu free"}).name, "gel, mu free");
  EXPECT_EQ(card_of_result(json{{"cards", {gel}}}.dump(), "r").name, "gel, mu free");
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
  const auto with = [](const std::string& key, const json& value) {
    json card = card_to_json(skin());
    card[key] = value;
    return refusal({{"card", card}});
  };
  EXPECT_THAT(with("terms", json::array()), HasSubstr("1 to 3"));
  EXPECT_THAT(with("terms", {{{"mu_true_Pa", 1e6}}}), HasSubstr("card.terms[0].alpha"));
  EXPECT_THAT(with("terms", {{{"mu_true_Pa", 1e6}, {"alpha", 2}}, {{"mu_true_Pa", -2e6}, {"alpha", 3}}}),
              HasSubstr("sum of all"));
  EXPECT_THAT(with("intervals", {{"alpha", {{"low", 1}}}}), HasSubstr("card.intervals.level"));
  EXPECT_THAT(with("intervals", {{"level", 0.95}, {"alpha", 1}}), HasSubstr("card.intervals.alpha"));
  EXPECT_THAT(with("data", {{{"file", "a.csv"}, {"sha256", "12"}}}), HasSubstr("64 hexadecimal"));
  EXPECT_THAT(with("fit_error", 3), HasSubstr("card.fit_error"));
}

}  // namespace
}  // namespace percal
