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

namespace {

// An object's text, member by member. No JSON object is made: its destructor asks for memory, and where there is none, as beside other
// runs there may not be, that ends the program.
class ObjectText {
 public:
  void add(const char* key, const std::string& value) {
    text_ += (text_.size() > 1 ? ",\"" : "\"") + std::string(key) + "\":" + value;
  }
  void add(const char* key, const Json& scalar) { add(key, scalar.dump()); }
  std::string closed() const { return text_ + "}"; }

 private:
  std::string text_ = "{";
};

std::string energy_text(const EnergyLedger& energy) {
  ObjectText text;
  for (const EnergyTerm& term : energy_terms) text.add(term.key, finite(energy.*term.share));
  return text.closed();
}

}  // namespace

std::string to_payload(const Evaluation& evaluation) {
  const ImpactResult& r = evaluation.result;
  ObjectText text;
  text.add("outcome", Json(word(r.outcome)));
  text.add("reason", Json(r.reason));
  text.add("depth", finite(r.depth));
  text.add("end_time", finite(r.end_time));
  text.add("end_speed", finite(r.end_speed));
  text.add("sideways", finite(r.sideways));
  text.add("turn", finite(r.turn));
  text.add("target_momentum", finite(r.target_momentum));
  text.add("elements", Json(r.elements));
  text.add("steps", Json(r.steps));
  text.add("element_steps", Json(r.element_steps));
  text.add("eroded", Json(r.eroded));
  text.add("distorted", Json(r.distorted));
  text.add("smallest_jacobian", finite(r.smallest_jacobian));
  text.add("smallest_step", finite(r.smallest_step));
  text.add("energy", energy_text(r.energy));
  text.add("level", Json(evaluation.instruction_level));
  text.add("wall_s", Json(evaluation.wall_seconds));
  text.add("cpu_s", Json(evaluation.cpu_seconds));
  return text.closed();
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
