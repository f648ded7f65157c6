#include "percal/card/card_json.hpp"

#include <nlohmann/json.hpp>

#include "percal/card/card_provenance_json.hpp"

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

// One term as mu_true_Pa and alpha, or several in `terms`.
std::vector<Ogden> terms_of(const Reader& reader) {
  const json* several = reader.find("terms");
  if (!several || several->is_null()) return {{reader.number("mu_true_Pa"), reader.number("alpha")}};
  const std::string accepted = "an array of objects with mu_true_Pa and alpha";
  if (!several->is_array()) reader.refuse("terms", several, accepted);
  std::vector<Ogden> terms;
  for (const json& term : *several) {
    if (!term.is_object()) reader.refuse("terms", &term, accepted);
    const Reader of_term{term, reader.at("terms[" + std::to_string(terms.size()) + "]")};
    terms.push_back({of_term.number("mu_true_Pa"), of_term.number("alpha")});
  }
  return terms;
}

}  // namespace

json card_to_json(const CardMaterial& material) {
  json erosion;  // null
  if (material.erosion) {
    erosion = {{"strain", material.erosion->limit}, {"measure", word(material.erosion->measure)}};
  }
  json card = {{"name", material.name},
               {"density_kg_m3", material.density},
               {"bulk_modulus_Pa", material.bulk_modulus},
               {"erosion", erosion},
               {"comments", material.comments}};
  if (material.terms.size() == 1) {
    card["mu_true_Pa"] = material.terms[0].mu;
    card["alpha"] = material.terms[0].alpha;
  } else {
    card["terms"] = json::array();
    for (const Ogden& term : material.terms) card["terms"].push_back({{"mu_true_Pa", term.mu}, {"alpha", term.alpha}});
  }
  add_provenance(material, card);
  return card;
}

CardMaterial card_from_json(const json& card, const Place& place) {
  if (!card.is_object()) throw BadInput(place, card.type_name(), "an object");
  const Reader reader{card, place};
  CardMaterial material{.name = reader.text("name", "a text"),
                        .density = reader.number("density_kg_m3"),
                        .terms = terms_of(reader),
                        .bulk_modulus = 0};
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
  read_provenance(card, place, material);
  check(material, place);
  return material;
}

}  // namespace percal
