#include "percal/observe/stored_run.hpp"

#include <limits>
#include <map>
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

namespace {

// An object's text. No JSON object is made: its destructor asks for memory, and where there is none, as beside other runs there may
// not be, that ends the program.
using Members = std::map<std::string, std::string>;  // texts of their values

std::string object_text(const Members& members) {
  std::string text;
  for (const auto& [key, value] : members) text += (text.empty() ? "{\"" : ",\"") + key + "\":" + value;
  return text + "}";
}

std::string value_text(const Json& scalar) { return scalar.dump(); }

// Of runs without friction, as of those before there was any, nothing is kept of it.
bool may_be_absent(const EnergyTerm& term) { return term.share == &EnergyLedger::friction; }

std::string energy_text(const EnergyLedger& energy) {
  Members members{{"sum", value_text(finite(energy.sum()))}};
  for (const EnergyTerm& term : energy_terms)
    if (!may_be_absent(term) || energy.*term.share != 0) members[term.key] = value_text(finite(energy.*term.share));
  return object_text(members);
}

}  // namespace

std::string to_payload(const Evaluation& evaluation) {
  const ImpactResult& r = evaluation.result;
  Members members{{"outcome", value_text(word(r.outcome))},
                      {"reason", value_text(r.reason)},
                      {"depth", value_text(finite(r.depth))},
                      {"end_time", value_text(finite(r.end_time))},
                      {"end_speed", value_text(finite(r.end_speed))},
                      {"sideways", value_text(finite(r.sideways))},
                      {"turn", value_text(finite(r.turn))},
                      {"target_momentum", value_text(finite(r.target_momentum))},
                      {"elements", value_text(r.elements)},
                      {"steps", value_text(r.steps)},
                      {"element_steps", value_text(r.element_steps)},
                      {"eroded", value_text(r.eroded)},
                      {"distorted", value_text(r.distorted)},
                      {"smallest_jacobian", value_text(finite(r.smallest_jacobian))},
                      {"smallest_step", value_text(finite(r.smallest_step))},
                      {"energy", energy_text(r.energy)},
                      {"level", value_text(evaluation.instruction_level)},
                      {"wall_s", value_text(evaluation.wall_seconds)},
                      {"cpu_s", value_text(evaluation.cpu_seconds)}};
  if (r.eroded_by != ErodedBy{})
    members["eroded_by"] = object_text({{"strain", value_text(r.eroded_by.strain)},
                                        {"stress", value_text(r.eroded_by.stress)},
                                        {"energy", value_text(r.eroded_by.energy)}});
  return object_text(members);
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
    if (const auto by = json.find("eroded_by"); by != json.end())
      r.eroded_by = {by->at("strain").get<long>(), by->at("stress").get<long>(), by->at("energy").get<long>()};
    r.smallest_jacobian = number(json.at("smallest_jacobian"));
    r.smallest_step = number(json.at("smallest_step"));
    for (const EnergyTerm& term : energy_terms)
      if (!may_be_absent(term) || json.at("energy").contains(term.key))
        r.energy.*term.share = number(json.at("energy").at(term.key));
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
