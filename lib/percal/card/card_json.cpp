#include "percal/card/card_json.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "percal/base/version.hpp"
#include "percal/text/json.hpp"

namespace percal {
namespace {

using nlohmann::json;

json number_or_null(double number) { return std::isfinite(number) ? json(number) : json(nullptr); }

json erosion_to_json(const std::optional<CardErosion>& erosion) {
  if (!erosion) return nullptr;
  const auto or_null = [](const std::optional<double>& size) { return size ? json(*size) : json(nullptr); };
  return {{"strain", erosion->limit},
          {"measure", word(erosion->measure)},
          {"element_over_radius", or_null(erosion->element_over_radius)},
          {"element_m", or_null(erosion->element)}};
}

json intervals_to_json(const CardIntervals& intervals) {
  const auto end = [](const std::optional<double>& value) { return value ? json(*value) : json(nullptr); };
  json all = {{"level", intervals.level}};
  for (const CardInterval& one : intervals.of) all[one.parameter] = {{"low", end(one.low)}, {"high", end(one.high)}};
  return all;
}

// A value of the file, and where it stands.
struct Reader {
  const json& value;
  Place place;

  [[noreturn]] void refuse(const std::string& accepted) const {
    if (value.is_discarded()) throw BadInput(place, "nothing", accepted);
    if (value.is_structured()) throw BadInput(place, fmt::format("an {}", value.type_name()), accepted);
    throw BadInput(place, value.dump(-1, ' ', true, json::error_handler_t::replace), accepted);
  }
  // A discarded value where there is no such key.
  Reader at(const std::string& key) const {
    static const json nothing(json::value_t::discarded);
    const auto found = value.find(key);
    return {found == value.end() ? nothing : *found,
            {place.file, place.line, place.key.empty() ? key : place.key + "." + key}};
  }
  bool absent() const { return value.is_discarded() || value.is_null(); }
  double number(const std::string& accepted = "a number") const {
    if (!value.is_number()) refuse(accepted);
    return value.get<double>();
  }
  std::optional<double> number_or_nothing() const {
    return absent() ? std::nullopt : std::optional(number("a number or null"));
  }
  std::string text(const std::string& accepted) const {
    if (!value.is_string()) refuse(accepted);
    return value.get<std::string>();
  }
  const Reader& object(const std::string& accepted) const {
    if (!value.is_object()) refuse(accepted);
    return *this;
  }
  // The entries of an array; none where there is nothing.
  std::vector<Reader> entries(const std::string& accepted) const {
    std::vector<Reader> all;
    if (absent()) return all;
    if (!value.is_array()) refuse(accepted);
    for (const json& entry : value)
      all.push_back({entry, {place.file, place.line, fmt::format("{}[{}]", place.key, all.size())}});
    return all;
  }
};

// One term as mu_true_Pa and alpha, or several in `terms`.
std::vector<Ogden> terms_of(const Reader& card) {
  const auto term_of = [](const Reader& term) {
    return Ogden{term.at("mu_true_Pa").number(), term.at("alpha").number()};
  };
  const Reader several = card.at("terms");
  if (several.absent()) return {term_of(card)};
  const std::string accepted = "an array of objects with mu_true_Pa and alpha";
  std::vector<Ogden> terms;
  for (const Reader& term : several.entries(accepted)) terms.push_back(term_of(term.object(accepted)));
  return terms;
}

// A positive number or nothing.
std::optional<double> size_of(const Reader& erosion, const std::string& key) {
  const Reader given = erosion.at(key);
  const auto size = given.number_or_nothing();
  if (size && !(*size > 0 && std::isfinite(*size))) given.refuse("a positive number or null");
  return size;
}

std::optional<CardErosion> erosion_of(const Reader& erosion) {
  if (erosion.absent()) return std::nullopt;
  const double strain = erosion.object("null or an object with strain and measure").at("strain").number();
  const Reader measure = erosion.at("measure");
  const std::string accepted = "\"engineering\", \"true\" or \"green-lagrange\"", found = measure.text(accepted);
  for (const auto one : {StrainMeasure::engineering, StrainMeasure::true_strain, StrainMeasure::green_lagrange})
    if (found == word(one))
      return CardErosion{strain, one, size_of(erosion, "element_over_radius"), size_of(erosion, "element_m")};
  measure.refuse(accepted);
}

std::optional<CardIntervals> intervals_of(const Reader& given) {
  if (given.absent()) return std::nullopt;
  given.object("an object with level and an interval of each parameter");
  CardIntervals intervals{given.at("level").number("a number between 0 and 1"), {}};
  for (const auto& entry : given.value.items()) {
    if (entry.key() == "level") continue;
    const Reader interval = given.at(entry.key()).object("an object with low and high");
    intervals.of.push_back(
        {entry.key(), interval.at("low").number_or_nothing(), interval.at("high").number_or_nothing()});
  }
  return intervals;
}

CardData data_of(const Reader& given) {
  const std::string accepted = "an object with file and sha256";
  const Reader digest = given.object(accepted).at("sha256");
  CardData data{given.at("file").text(accepted), digest.text(accepted)};
  if (data.sha256.size() != 64 || data.sha256.find_first_not_of("0123456789abcdef") != std::string::npos)
    digest.refuse("64 hexadecimal digits");
  return data;
}

// Density and bulk modulus may be null or missing, as of a fit.
CardMaterial read_block(const Reader& card) {
  card.object("an object");
  CardMaterial material{.name = card.at("name").text("a text"),
                        .density = card.at("density_kg_m3").number_or_nothing().value_or(not_known),
                        .terms = terms_of(card),
                        .bulk_modulus = card.at("bulk_modulus_Pa").number_or_nothing().value_or(not_known),
                        .erosion = erosion_of(card.at("erosion"))};
  const std::string texts = "an array of texts";
  for (const Reader& comment : card.at("comments").entries(texts)) material.comments.push_back(comment.text(texts));
  material.intervals = intervals_of(card.at("intervals"));
  if (const Reader error = card.at("fit_error"); !error.absent()) material.fit_error = error.text("a sentence");
  if (const Reader why = card.at("contradiction"); !why.absent()) material.contradiction = why.text("a sentence");
  for (const Reader& one : card.at("data").entries("an array of objects")) material.data.push_back(data_of(one));
  return material;
}

// The card with this name; where there is only one, that one.
Reader chosen(const std::vector<Reader>& cards, const std::string& name) {
  std::string names;
  for (const Reader& card : cards) {
    const Reader own = card.object("an object").at("name");
    if (own.text("a text") == name || cards.size() == 1) return card;
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", own.text("a text"));
  }
  throw BadInput({cards.front().place.file, 0, "cards"},
                 name.empty() ? fmt::format("{} cards", cards.size()) : "no card '" + name + "'",
                 "one by its name (--card): " + names);
}

}  // namespace

json card_to_json(const CardMaterial& material) {
  json card = {{"name", material.name},
               {"density_kg_m3", number_or_null(material.density)},
               {"bulk_modulus_Pa", number_or_null(material.bulk_modulus)},
               {"erosion", erosion_to_json(material.erosion)},
               {"comments", material.comments}};
  const auto add_term = [](const Ogden& term, json& to) {
    to["mu_true_Pa"] = term.mu;
    to["alpha"] = term.alpha;
  };
  if (material.terms.size() == 1) {
    add_term(material.terms[0], card);
  } else {
    card["terms"] = json::array();
    for (const Ogden& term : material.terms) add_term(term, card["terms"].emplace_back());
  }
  if (material.intervals) card["intervals"] = intervals_to_json(*material.intervals);
  if (!material.fit_error.empty()) card["fit_error"] = material.fit_error;
  if (!material.contradiction.empty()) card["contradiction"] = material.contradiction;
  for (const CardData& data : material.data) card["data"].push_back({{"file", data.file}, {"sha256", data.sha256}});
  return card;
}

json read_card_to_json(const ReadCard& read) {
  return {{"card", card_to_json(read.found.material)},
          {"solver", read.solver.empty() ? json(nullptr) : json(read.solver)},
          {"units", read.units},
          {"passed_over", read.found.ignored},
          {"erodes_otherwise", read.found.erodes_otherwise},
          {"warnings", read.warnings}};
}

json cards_to_json(const std::vector<CardMaterial>& materials) {
  json cards = json::array();
  for (const CardMaterial& material : materials) cards.push_back(card_to_json(material));
  return cards;
}

CardMaterial card_from_json(const json& card, const Place& place) {
  const CardMaterial material = read_block({card, place});
  check(material, place);
  return material;
}

CardMaterial card_of_result(const std::string& text, const std::string& file, const CardRequest& request) {
  const json whole = parse_json(text, file, "a result.json of percal");
  const Reader result{whole, {file, 0, ""}};
  const std::string accepted =
      "a card object: a result of percal identify, calibrate or fit of this version, or of percal card read --json";
  if (!whole.is_object()) result.at("card").refuse(accepted);
  if (const Reader schema = result.at("schema"); !schema.absent() && whole["schema"] != result_schema)
    schema.refuse(fmt::format("{}, as results of this percal have it: run the command again", result_schema));
  const Reader one = result.at("card");
  const auto cards = one.absent() ? result.at("cards").entries("an array of objects") : std::vector<Reader>{one};
  if (cards.empty()) throw BadInput(result.at("cards").place, "no card", accepted);
  const Reader card = chosen(cards, request.name);
  CardMaterial material = read_block(card);
  if (!request.name.empty()) material.name = request.name;
  if (request.density) material.density = *request.density;
  if (request.bulk_to_shear) material.bulk_modulus = *request.bulk_to_shear * shear_modulus(material);
  if (request.complete && (std::isnan(material.density) || std::isnan(material.bulk_modulus)))
    card.at(std::isnan(material.density) ? "density_kg_m3" : "bulk_modulus_Pa")
        .refuse(
            "a number, or beside a fit, whose curves tell neither, --density \"1010 kg/m3\" and --bulk-to-shear NUMBER "
            "or --nu NUMBER");
  check_solid(material, card.place);
  return material;
}

}  // namespace percal
