#include "percal/card/card_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace percal {
namespace {

using nlohmann::json;

// One object of the file, and where it stands.
struct Reader {
  const json& object;
  Place place;

  Place at(const std::string& key) const {
    return {place.file, place.line, place.key.empty() ? key : place.key + "." + key};
  }
  [[noreturn]] void refuse(const std::string& key, const json* found, const std::string& accepted) const {
    throw BadInput(at(key), found ? found->dump(-1, ' ', true, json::error_handler_t::replace) : "nothing", accepted);
  }
  const json* find(const std::string& key) const {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }
  double number(const std::string& key) const {
    const json* found = find(key);
    if (!found || !found->is_number()) refuse(key, found, "a number");
    return found->get<double>();
  }
  std::string text(const std::string& key, const std::string& accepted) const {
    const json* found = find(key);
    if (!found || !found->is_string()) refuse(key, found, accepted);
    return found->get<std::string>();
  }
};

StrainMeasure measure(const Reader& reader) {
  const std::string accepted = "\"engineering\", \"true\" or \"green-lagrange\"";
  const std::string found = reader.text("measure", accepted);
  for (const auto one : {StrainMeasure::engineering, StrainMeasure::true_strain, StrainMeasure::green_lagrange}) {
    if (found == word(one)) return one;
  }
  reader.refuse("measure", reader.find("measure"), accepted);
}

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

}  // namespace

json card_to_json(const CardMaterial& material) {
  json erosion;  // null
  if (material.erosion) {
    erosion = {{"strain", material.erosion->limit}, {"measure", word(material.erosion->measure)}};
  }
  return {{"name", material.name},        {"density_kg_m3", material.density},        {"mu_true_Pa", material.mu_true},
          {"alpha", material.alpha},      {"bulk_modulus_Pa", material.bulk_modulus}, {"erosion", erosion},
          {"comments", material.comments}};
}

CardMaterial card_from_json(const json& card, const Place& place) {
  if (!card.is_object()) throw BadInput(place, card.type_name(), "an object");
  const Reader reader{card, place};
  CardMaterial material{};
  material.name = reader.text("name", "a text");
  material.density = reader.number("density_kg_m3");
  material.mu_true = reader.number("mu_true_Pa");
  material.alpha = reader.number("alpha");
  material.bulk_modulus = reader.number("bulk_modulus_Pa");
  if (const json* erosion = reader.find("erosion"); erosion && !erosion->is_null()) {
    if (!erosion->is_object()) reader.refuse("erosion", erosion, "null or an object with strain and measure");
    const Reader inner{*erosion, reader.at("erosion")};
    material.erosion = CardErosion{inner.number("strain"), measure(inner)};
  }
  if (const json* comments = reader.find("comments"); comments && !comments->is_null()) {
    if (!comments->is_array()) reader.refuse("comments", comments, "an array of texts");
    for (const json& comment : *comments) {
      if (!comment.is_string()) reader.refuse("comments", &comment, "an array of texts");
      material.comments.push_back(comment.get<std::string>());
    }
  }
  check(material, place);
  return material;
}

CardMaterial card_of_result(const std::string& text, const std::string& file) {
  const json result = parse(text, file);
  if (result.is_object() && result.contains("card") && !result["card"].is_null()) {
    return card_from_json(result["card"], Place{.file = file, .line = 0, .key = "card"});
  }
  const Place place{.file = file, .line = 0, .key = "card"};
  if (result.is_object() && result.contains("minima")) {
    throw BadInput(place, "a result of percal fit, which has a modulus and an alpha but no density or bulk modulus",
                   "a result with a card object, as percal identify writes it");
  }
  throw BadInput(place, "nothing", "a result with a card object, as percal identify writes it");
}

}  // namespace percal
