#include <fmt/format.h>
#include <fmt/ranges.h>

#include "percal/invert/reach.hpp"
#include "percal/plot/quoted.hpp"
#include "percal/predict/page/page.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

Json between_to_json(const Between& between) {
  return {{"low", finite(between.low)}, {"high", finite(between.high)}, {"low_open", false}, {"high_open", false}};
}

Json shot_to_json(const SphereShot& shot) {
  return {{"radius_m", shot.radius},
          {"density_kg_m3", shot.density},
          {"speed_m_s", shot.speed},
          {"layer_depth_m", shot.layer_depth},
          {"body", shot.body ? Json(shot.body->name()) : Json()}};
}

// Of a model that knows what passes: what the reach means behind the layer.
Json speed_left_to_json(const DepthPrediction& depth, const SphereShot& shot) {
  const auto left = [&](double reach) { return shot.speed * share_left(shot.layer_depth, reach); };
  const auto ends = [&](const Between& reach) { return between_to_json({left(reach.low), left(reach.high)}); };
  return {{"speed_left_m_s", finite(left(depth.depth))},
          {"speed_left_mean_interval_m_s", ends(depth.mean)},
          {"speed_left_shot_interval_m_s", ends(depth.shot)}};
}

// Of a depth, or of another number.
Json errors_to_json(const PredictedRange& prediction) {
  return {{"parameters", finite(prediction.by_parameters)},
          {"emulator", finite(prediction.by_emulator)},
          {"scatter", finite(prediction.by_scatter)},
          {"speed", finite(prediction.by_speed)}};
}

Json depth_to_json(const DepthPrediction& depth) {
  return {{"depth_m", finite(depth.depth)},
          {"mean_interval_m", between_to_json(depth.mean)},
          {"shot_interval_m", between_to_json(depth.shot)},
          {"passes_probability", finite(depth.passes)},
          {"speed_exponent", finite(depth.speed_exponent)},
          {"errors", errors_to_json(depth)},
          {"outside", depth.outside}};
}

Json number_to_json(const NumberPrediction& number) {
  return {{"value_m", finite(number.value)},
          {"mean_interval_m", between_to_json(number.mean)},
          {"shot_interval_m", between_to_json(number.shot)},
          {"errors", errors_to_json(number)}};
}

Json checked_to_json(const CheckedByRuns& checked, const SphereShot& shot, bool passage) {
  const auto left = passage && checked.depth.mean
                        ? std::optional(shot.speed * share_left(shot.layer_depth, *checked.depth.mean))
                        : std::nullopt;
  return {{"runs", checked.runs},
          {"run_speed_left_m_s", finite(left)},
          {"outcome", word(checked.outcome)},
          {"run_depth_m", finite(checked.depth.mean)},
          {"run_standard_error_m", finite(checked.depth.standard_error)},
          {"standardised_difference", finite(checked.standardised)}};
}

Json predicted_to_json(const ShotPrediction& one, bool passage) {
  Json json = shot_to_json(one.shot);
  json.update(depth_to_json(one.depth));
  json["speed_left"] = passage ? speed_left_to_json(one.depth, one.shot) : Json();
  for (const auto& [number, predicted] : one.depth.beside) json[kind_of(number).key] = number_to_json(predicted);
  json["label"] = one.shot.label;
  json["elsewhere_m"] = one.elsewhere;
  json["checked"] = one.checked ? checked_to_json(*one.checked, one.shot, passage) : Json();
  return json;
}

const char* unit_of(ShotNumber number) {
  return number == ShotNumber::speed ? "_m_s" : number == ShotNumber::diameter ? "_m" : "_kg_m3";
}

Json solved_to_json(const PredictRequest& request, const SolvedShot& solved) {
  const auto key_of = [&](const std::string& key) { return key + unit_of(*request.looked_for); };
  Json json{{"looked_for", word(*request.looked_for)},
            {"found", solved.found},
            {"passing", request.words.v50},
            {"wanted_depth_m", request.depth}};
  json[key_of("value")] = solved.found ? finite(solved.value) : Json();
  json[key_of("value_mean_interval")] = solved.found ? between_to_json(solved.mean) : Json();
  json[key_of("value_shot_interval")] = solved.found ? between_to_json(solved.shot) : Json();
  return json;
}

Json words_to_json(PredictWords words, const std::string& result) {
  Json json{{"result", result}};
  for (const auto& [name, said] : named_texts(words))
    if (!said->empty()) json[name] = *said;
  if (words.v50) json["v50"] = true;
  return json;
}

}  // namespace

Json prediction_to_json(const Prediction& prediction, const std::string& result) {
  const PredictRequest& request = prediction.request;
  Json shots = Json::array(), curve = Json::array(), fired = Json::array();
  for (const ShotPrediction& one : prediction.shots) shots.push_back(predicted_to_json(one, prediction.passage));
  for (std::size_t k = 0; k < prediction.curve.size(); ++k) {
    SphereShot shot = request.shots.front();
    shot.speed = prediction.speeds[k];
    curve.push_back(depth_to_json(prediction.curve[k]));
    curve.back()["speed_m_s"] = shot.speed;
    curve.back()["speed_left"] = prediction.passage ? speed_left_to_json(prediction.curve[k], shot) : Json();
  }
  for (const FiredShot& shot : prediction.fired)
    fired.push_back({{"label", shot.label},
                     {"speed_m_s", shot.speed},
                     {"measured_depth_m", page::finite(shot.depth)},
                     {"seen", shot.seen},
                     {"fitted", shot.fitted}});
  Json json = page::result_head("predict", words_to_json(request.words, result));
  json.update({{"title", "Shots into " + prediction.material},
               {"level", request.level},
               {"material", prediction.material},
               {"hypothesis", prediction.hypothesis},
               {"shots", shots},
               {"like", request.shots.empty() ? Json() : shot_to_json(request.shots.front())},
               {"speed_was_a_range", request.speeds.has_value()},
               {"curve", curve},
               {"fired", fired},
               {"solved", prediction.solved ? solved_to_json(request, *prediction.solved) : Json()},
               {"findings", prediction.findings},
               {"cost", page::cost_to_json(prediction.cost)}});
  return json;
}

std::string prediction_to_csv(const Prediction& prediction) {
  std::string csv =
      "label,radius_m,density_kg_m3,speed_m_s,layer_depth_m,depth_m,mean_low_m,mean_high_m,shot_low_m,shot_high_m,"
      "passes_probability,speed_left_m_s,";
  for (const RunNumber number : prediction.beside) {
    const char* key = kind_of(number).key;
    csv += fmt::format("{0}_m,{0}_shot_low_m,{0}_shot_high_m,", key);
  }
  csv += "outside\n";
  const auto row = [&](const std::string& label, const SphereShot& shot, const DepthPrediction& depth) {
    const std::string left =
        prediction.passage ? fmt::format("{}", shot.speed * share_left(shot.layer_depth, depth.depth)) : "";
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},", csv_quoted(label), shot.radius, shot.density, shot.speed,
                       shot.layer_depth, depth.depth, depth.mean.low, depth.mean.high, depth.shot.low, depth.shot.high,
                       depth.passes, left);
    for (const auto& [number, predicted] : depth.beside)
      csv += fmt::format("{},{},{},", predicted.value, predicted.shot.low, predicted.shot.high);
    csv += csv_quoted(fmt::format("{}", fmt::join(depth.outside, "; "))) + "\n";
  };
  for (const ShotPrediction& one : prediction.shots) row(one.shot.label, one.shot, one.depth);
  if (prediction.request.speeds)
    for (std::size_t k = 0; k < prediction.curve.size(); ++k) {
      SphereShot shot = prediction.request.shots.front();
      shot.speed = prediction.speeds[k];
      row("", shot, prediction.curve[k]);
    }
  return csv;
}

}  // namespace percal
