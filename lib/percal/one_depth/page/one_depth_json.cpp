#include <cmath>

#include "percal/one_depth/page/page.hpp"
#include "percal/units/quantity.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

Json interval_to_json(const std::optional<Between>& interval) {
  if (!interval) return nullptr;
  return {{"low", finite(interval->low)}, {"high", finite(interval->high)}, {"low_open", false}, {"high_open", false}};
}

Json words_to_json(InvertWords words) {
  Json json = Json::object();
  for (const auto& [name, said] : named_texts(words))
    if (!said->empty()) json[name] = *said;
  return json;
}

// A number of the pair that was looked for and not found is null.
Json pair_to_json(const PairOfDepth& pair, LayerNumber sought) {
  const bool found = pair.found();
  const auto value = [&](LayerNumber number) -> Json {
    return number == sought && !found ? Json() : finite(number_of(pair.material, number));
  };
  const auto interval = [&](LayerNumber number) {
    return interval_to_json(number == sought ? pair.interval : std::nullopt);
  };
  return {{"mu_Pa", value(LayerNumber::mu)},
          {"mu_interval_Pa", interval(LayerNumber::mu)},
          {"erosion_strain", value(LayerNumber::erosion_strain)},
          {"erosion_strain_interval", interval(LayerNumber::erosion_strain)},
          {"outcome", word(pair.search.outcome)},
          {"why_not", found ? Json() : Json(pair.why_not)},
          {"slope", found ? finite(pair.search.slope) : Json()},
          {"run_scatter", found ? finite(pair.search.scatter) : Json()},
          {"runs", pair.search.points.size()},
          {"runs_in_line", pair.search.points_in_line}};
}

Json errors_to_json(const std::vector<ValueErrorPart>& shares) {
  Json errors = Json::array();
  for (const ValueErrorPart& share : shares)
    errors.push_back({{"source", share.source},
                      {"of_depth", finite(share.of_depth)},
                      {"of_value", finite(share.of_value)},
                      {"how", share.how}});
  return errors;
}

Json trials_to_json(const PairOfDepth& pair, LayerNumber sought) {
  Json trials = Json::array();
  for (const InversionPoint& point : pair.search.points) {
    LayerMaterial material = pair.material;
    number_of(material, sought) = std::exp(point.log_modulus);
    trials.push_back({{"mu_Pa", finite(material.mu_true)},
                      {"erosion_strain", finite(material.erosion_strain)},
                      {"depth_m", finite(point.answer.depth)},
                      {"at_least", point.answer.censored},
                      {"in_line", point.in_line}});
  }
  return trials;
}

}  // namespace

Json one_depth_to_json(const OneDepth& found) {
  const InvertRequest& request = found.request;
  Json ridge = Json::array();
  for (const PairOfDepth& pair : found.ridge) ridge.push_back(pair_to_json(pair, request.sought));
  Json json = page::result_head("invert", words_to_json(request.words));
  const std::string speed = format_quantity(request.shot.speed, dimension::speed);
  json.update({{"title", "One depth of a shot: " +
                             (request.scene ? request.scene->particle.name + " at " + speed : words_of(request.shot))},
               {"particle", request.scene ? Json(request.scene->particle.name) : Json()},
               {"level", request.level},
               {"looked_for", name_of(request.sought)},
               {"found", found.own().found()},
               {"measured_depth_m", request.depth},
               {"measured_depth_error", finite(request.depth_error)},
               {"speed_error", finite(request.speed_error)},
               {"radius_m", request.shot.radius},
               {"particle_density_kg_m3", request.shot.density},
               {"speed_m_s", request.shot.speed},
               {"density_kg_m3", request.material.density},
               {"alpha", request.material.alpha},
               {"erosion_length_m", finite(request.material.erosion_length)},
               {"layer_depth_m", request.shot.layer_depth},
               {"layer_width_m", request.shot.layer_width},
               {"elements_per_radius", request.elements_per_radius},
               {"pair", pair_to_json(found.own(), request.sought)},
               {"errors", errors_to_json(found.own().errors)},
               {"trials", trials_to_json(found.own(), request.sought)},
               {"ridge", ridge},
               {"ridge_exponent", finite(found.ridge_exponent)},
               {"warnings", found.warnings},
               {"findings", found.findings},
               {"cost", page::cost_to_json(found.cost)}});
  return json;
}

}  // namespace percal
