#include "percal/observe/result_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

namespace percal {
namespace {

using Json = nlohmann::json;

// JSON has no NaN; an unstable run may end with one.
Json finite(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
double number(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

}  // namespace

Json energy_to_json(const EnergyLedger& energy) {
  Json json;
  for (const auto& [key, term] : energy_terms) json[key] = finite(energy.*term);
  json["sum"] = finite(energy.sum());
  return json;
}

std::string to_payload(const Evaluation& evaluation) {
  const ImpactResult& r = evaluation.result;
  return Json{{"outcome", word(r.outcome)},
              {"reason", r.reason},
              {"depth", finite(r.depth)},
              {"end_time", finite(r.end_time)},
              {"end_speed", finite(r.end_speed)},
              {"sideways", finite(r.sideways)},
              {"turn", finite(r.turn)},
              {"target_momentum", finite(r.target_momentum)},
              {"elements", r.elements},
              {"steps", r.steps},
              {"element_steps", r.element_steps},
              {"eroded", r.eroded},
              {"distorted", r.distorted},
              {"smallest_jacobian", finite(r.smallest_jacobian)},
              {"smallest_step", finite(r.smallest_step)},
              {"largest_gap", finite(r.largest_gap)},
              {"energy", energy_to_json(r.energy)},
              {"level", evaluation.instruction_level},
              {"wall_s", evaluation.wall_seconds},
              {"cpu_s", evaluation.cpu_seconds}}
      .dump();
}

Evaluation from_payload(const std::string& payload) {
  Evaluation evaluation;
  try {
    const Json json = Json::parse(payload);
    ImpactResult& r = evaluation.result;
    r.outcome = outcome_from(json.at("outcome").get<std::string>());
    r.reason = json.at("reason").get<std::string>();
    r.depth = number(json.at("depth"));
    r.end_time = number(json.at("end_time"));
    r.end_speed = number(json.at("end_speed"));
    r.sideways = number(json.at("sideways"));
    r.turn = number(json.at("turn"));
    r.target_momentum = number(json.at("target_momentum"));
    r.elements = json.at("elements").get<long>();
    r.steps = json.at("steps").get<long>();
    r.element_steps = json.at("element_steps").get<double>();
    r.eroded = json.at("eroded").get<long>();
    r.distorted = json.at("distorted").get<long>();
    r.smallest_jacobian = number(json.at("smallest_jacobian"));
    r.smallest_step = number(json.at("smallest_step"));
    r.largest_gap = number(json.at("largest_gap"));
    for (const auto& [key, term] : energy_terms) r.energy.*term = number(json.at("energy").at(key));
    evaluation.instruction_level = json.at("level").get<std::string>();
    evaluation.wall_seconds = json.at("wall_s").get<double>();
    evaluation.cpu_seconds = json.at("cpu_s").get<double>();
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("not a stored impact: ") + error.what());
  }
  evaluation.reused = true;
  return evaluation;
}

namespace {

// Forces inside are per radian and in units of rho_t v^2 a^2.
struct HistoryUnits {
  explicit HistoryUnits(const Scales& scales)
      : time(scales.radius / scales.speed),
        length(scales.radius),
        speed(scales.speed),
        force(2 * std::numbers::pi * scales.target_density * scales.speed * scales.speed * scales.radius *
              scales.radius) {}
  double time, length, speed, force;
};

}  // namespace

std::string history_csv(const std::vector<HistoryPoint>& history, const Scales& scales) {
  const HistoryUnits unit(scales);
  std::string csv = "time_s,tip_m,speed_m_s,force_N";
  for (const auto& [key, share] : energy_terms) csv += fmt::format(",energy_{}", key);
  csv += ",energy_sum\n";
  for (const auto& point : history) {
    csv += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}", point.time * unit.time, point.tip * unit.length,
                       point.speed * unit.speed, point.force * unit.force);
    for (const auto& [key, share] : energy_terms) csv += fmt::format(",{:.9g}", point.energy.*share);
    csv += fmt::format(",{:.9g}\n", point.energy.sum());
  }
  return csv;
}

Json history_to_json(const std::vector<HistoryPoint>& history, const Scales& scales) {
  const HistoryUnits unit(scales);
  const auto column = [&](const auto& value) {
    Json numbers = Json::array();
    for (const HistoryPoint& point : history) numbers.push_back(finite(value(point)));
    return numbers;
  };
  Json energy = Json::object();
  for (const auto& [key, share] : energy_terms)
    energy[key] = column([term = share](const HistoryPoint& p) { return p.energy.*term; });
  energy["sum"] = column([](const HistoryPoint& p) { return p.energy.sum(); });
  return {{"time_s", column([&](const HistoryPoint& p) { return p.time * unit.time; })},
          {"tip_m", column([&](const HistoryPoint& p) { return p.tip * unit.length; })},
          {"speed_m_s", column([&](const HistoryPoint& p) { return p.speed * unit.speed; })},
          {"force_N", column([&](const HistoryPoint& p) { return p.force * unit.force; })},
          {"energy", energy}};
}

}  // namespace percal
