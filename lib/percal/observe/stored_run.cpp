#include "percal/observe/stored_run.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "percal/page/result.hpp"

namespace percal {
namespace {

using page::finite;  // an unstable run may end with NaN
using Json = nlohmann::json;

double number(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

}  // namespace

Json energy_to_json(const EnergyLedger& energy) {
  Json json;
  for (const EnergyTerm& term : energy_terms) json[term.key] = finite(energy.*term.share);
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
    for (const EnergyTerm& term : energy_terms) r.energy.*term.share = number(json.at("energy").at(term.key));
    evaluation.instruction_level = json.at("level").get<std::string>();
    evaluation.wall_seconds = json.at("wall_s").get<double>();
    evaluation.cpu_seconds = json.at("cpu_s").get<double>();
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("not a stored impact: ") + error.what());
  }
  evaluation.reused = true;
  return evaluation;
}

}  // namespace percal
