// Cards of results: the object of identify, one of those of calibrate, the best minimum of fit.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "percal/card/card_json.hpp"

namespace percal {
namespace {

using nlohmann::json;

constexpr const char* results_with_cards =
    "a result of percal identify, calibrate or fit, or an object with a card object";

json parse(const std::string& text, const std::string& file) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const int line = 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
    throw BadInput(Place{file, line, ""}, "text that is not JSON", "a result.json of percal");
  } catch (const json::exception& error) {  // a number beyond a double's range
    throw BadInput(Place{file, 0, ""}, error.what(), "a result.json of percal");
  }
}

bool has(const json& object, const std::string& key) { return object.contains(key) && !object[key].is_null(); }

std::string name_of(const json& card) {
  return card.is_object() && card.contains("name") && card["name"].is_string() ? card["name"].get<std::string>() : "";
}

CardMaterial one_of(const json& cards, const std::string& name, const std::string& file) {
  const Place place{.file = file, .line = 0, .key = "cards"};
  if (!cards.is_array() || cards.empty()) throw BadInput(place, "no card in it", results_with_cards);
  std::string names;
  const json* chosen = nullptr;
  std::size_t index = 0;
  for (std::size_t i = 0; i < cards.size(); ++i) {
    names += fmt::format("{}'{}'", i == 0 ? "" : ", ", name_of(cards[i]));
    if (chosen || (name_of(cards[i]) != name && (cards.size() > 1 || !name.empty()))) continue;
    chosen = &cards[i];
    index = i;
  }
  if (!chosen)
    throw BadInput(place, name.empty() ? fmt::format("{} cards", cards.size()) : "no card '" + name + "'",
                   "one by its name (--card): " + names);
  return card_from_json(*chosen, Place{.file = file, .line = 0, .key = fmt::format("cards[{}]", index)});
}

std::optional<double> end_of(const json& interval, const std::string& end) {
  const bool open = interval.value(end + "_open", false);
  if (open || !has(interval, end) || !interval[end].is_number()) return std::nullopt;
  return interval[end].get<double>();
}

// Intervals of the first minimum of a fit's `uncertainty`.
std::optional<CardIntervals> intervals_of(const json& result, const CardMaterial& material) {
  if (!has(result, "uncertainty") || !has(result["uncertainty"], "minima") || result["uncertainty"]["minima"].empty())
    return std::nullopt;
  const json& about = result["uncertainty"]["minima"][0];
  CardIntervals intervals{result["uncertainty"].value("level", 0.95), {}};
  const bool single = material.terms.size() == 1;
  const auto take = [&](const json& all, const std::string& key, const std::string& parameter) {
    if (has(all, key)) intervals.of.push_back({parameter, end_of(all[key], "low"), end_of(all[key], "high")});
  };
  if (!single) take(about, "small_strain_mu_Pa", "mu_true_Pa");
  for (std::size_t k = 1; k <= material.terms.size() && has(about, "parameters"); ++k) {
    const std::string index = single ? "" : "_" + std::to_string(k);
    take(about["parameters"], "mu" + index + "_Pa", "mu_true_Pa" + index);
    take(about["parameters"], "alpha" + index, "alpha" + index);
  }
  return intervals;
}

CardMaterial card_of_fit(const json& result, const CardRequest& request, const std::string& file) {
  if (!request.density || !request.bulk_to_shear)
    throw BadInput(Place{.file = file, .line = 0, .key = "card"},
                   "a result of percal fit, which has moduli and exponents but no density or bulk modulus",
                   "--density \"1010 kg/m3\" and --bulk-to-shear NUMBER or --nu NUMBER beside it");
  const json& minima = result["minima"];
  const Place place{.file = file, .line = 0, .key = "minima"};
  if (!minima.is_array() || minima.empty()) throw BadInput(place, "no minimum", "a fit that found one");
  const json& best = minima[0];
  CardMaterial material{
      .name = request.name.empty() ? "fit" : request.name, .density = *request.density, .terms = {}, .bulk_modulus = 0};
  const auto number = [&](const json& object, const std::string& key) {
    if (!has(object, key) || !object[key].is_number())
      throw BadInput(Place{file, 0, "minima[0]." + key}, "nothing", "a number");
    return object[key].get<double>();
  };
  if (!best.is_object()) throw BadInput(place, best.type_name(), "objects");
  if (has(best, "terms") && best["terms"].is_array()) {
    for (const json& term : best["terms"])
      if (term.is_object()) material.terms.push_back({number(term, "mu_Pa"), number(term, "alpha")});
  } else {
    material.terms.push_back({number(best, "mu_Pa"), number(best, "alpha")});
  }
  material.bulk_modulus = *request.bulk_to_shear * shear_modulus(material);
  material.intervals = intervals_of(result, material);
  if (has(best, "r2") && best["r2"].is_number())
    material.fit_error = fmt::format("R^2 {:.6g} in stress, residual {}, {} points", best["r2"].get<double>(),
                                     result.value("residual", std::string("unknown")), result.value("points", 0));
  material.comments.push_back(fmt::format("fitted by percal: model {}", result.value("model", std::string("ogden"))));
  if (has(result, "sources") && result["sources"].is_array())
    for (const json& source : result["sources"])
      if (source.is_object() && has(source, "sha256") && has(source, "file"))
        material.data.push_back({std::filesystem::path(source["file"].get<std::string>()).filename().string(),
                                 source["sha256"].get<std::string>()});
  check(material, Place{.file = file, .line = 0, .key = "minima[0]"});
  return material;
}

CardMaterial found_card(const json& result, const CardRequest& request, const std::string& file) {
  const Place place{.file = file, .line = 0, .key = "card"};
  if (!result.is_object()) throw BadInput(place, "nothing", std::string("a card object: ") + results_with_cards);
  if (has(result, "card")) return card_from_json(result["card"], place);
  if (has(result, "cards")) return one_of(result["cards"], request.name, file);
  throw BadInput(place, "nothing", std::string("a card object: ") + results_with_cards);
}

}  // namespace

CardMaterial card_of_result(const std::string& text, const std::string& file, const CardRequest& request) {
  const json result = parse(text, file);
  try {
    if (result.is_object() && !has(result, "card") && has(result, "minima")) return card_of_fit(result, request, file);
    CardMaterial material = found_card(result, request, file);
    if (!request.name.empty() && !has(result, "cards")) material.name = request.name;
    if (request.density) material.density = *request.density;
    if (request.bulk_to_shear) material.bulk_modulus = *request.bulk_to_shear * shear_modulus(material);
    check(material, Place{.file = file, .line = 0, .key = "card"});
    return material;
  } catch (const json::exception& error) {  // a value of another kind than it should be
    throw BadInput(Place{file, 0, ""}, error.what(), results_with_cards);
  }
}

}  // namespace percal
