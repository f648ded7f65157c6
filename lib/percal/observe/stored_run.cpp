#include "percal/observe/stored_run.hpp"

#include <algorithm>
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

std::string list_text(const std::vector<double>& values) {
  std::string text = "[";
  for (const double value : values) {
    if (text.size() > 1) text += ',';
    text += value_text(finite(value));
  }
  return text += ']';
}

std::string aftermath_text(const Aftermath& after) {
  return object_text({{"ending", value_text(word(after.ending))},
                      {"reason", value_text(after.reason)},
                      {"depth", value_text(finite(after.depth))},
                      {"half_width", value_text(finite(after.half_width))},
                      {"time", value_text(finite(after.time))},
                      {"speed", value_text(finite(after.speed))},
                      {"eroded", value_text(after.eroded)},
                      {"energy", energy_text(after.energy)}});
}

// What only some runs have. Rows of earlier versions have none of it: lacks_something().
void add_what_is_there(Members& members, const ImpactResult& r) {
  if (!r.speeds_behind.empty()) members["speeds_behind"] = list_text(r.speeds_behind);
  if (r.half_speed_depth > 0) members["half_speed_depth"] = value_text(finite(r.half_speed_depth));
  if (!r.channel.largest.empty())
    members["channel"] = object_text({{"largest", list_text(r.channel.largest)}, {"end", list_text(r.channel.end)}});
  if (r.aftermath) members["aftermath"] = aftermath_text(*r.aftermath);
  if (r.in_space)
    members["in_space"] = object_text({{"across", value_text(finite(r.in_space->across))},
                                       {"axis", list_text({r.in_space->axis.begin(), r.in_space->axis.end()})}});
  if (r.eroded_by != ErodedBy{})
    members["eroded_by"] = object_text({{"strain", value_text(r.eroded_by.strain)},
                                        {"stress", value_text(r.eroded_by.stress)},
                                        {"energy", value_text(r.eroded_by.energy)}});
}

std::vector<double> numbers(const Json& array) {
  std::vector<double> values;
  for (const Json& value : array) values.push_back(number(value));
  return values;
}

EnergyLedger energy_from(const Json& json) {
  EnergyLedger energy;
  for (const EnergyTerm& term : energy_terms)
    if (!may_be_absent(term) || json.contains(term.key)) energy.*term.share = number(json.at(term.key));
  return energy;
}

Aftermath aftermath_from(const Json& json) {
  return {.ending = ending_from(json.at("ending").get<std::string>()),
          .reason = json.at("reason").get<std::string>(),
          .depth = number(json.at("depth")),
          .half_width = number(json.at("half_width")),
          .time = number(json.at("time")),
          .speed = number(json.at("speed")),
          .eroded = json.at("eroded").get<long>(),
          .energy = energy_from(json.at("energy"))};
}

void take_what_is_there(const Json& json, ImpactResult& r) {
  if (json.contains("speeds_behind")) r.speeds_behind = numbers(json.at("speeds_behind"));
  if (json.contains("half_speed_depth")) r.half_speed_depth = number(json.at("half_speed_depth"));
  if (json.contains("channel"))
    r.channel = {.largest = numbers(json.at("channel").at("largest")), .end = numbers(json.at("channel").at("end"))};
  if (json.contains("aftermath")) r.aftermath = aftermath_from(json.at("aftermath"));
  if (const auto path = json.find("in_space"); path != json.end()) {
    const auto axis = numbers(path->at("axis"));
    r.in_space = {.across = number(path->at("across")), .axis = {axis.at(0), axis.at(1), axis.at(2)}};
  }
  if (const auto by = json.find("eroded_by"); by != json.end())
    r.eroded_by = {by->at("strain").get<long>(), by->at("stress").get<long>(), by->at("energy").get<long>()};
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
  add_what_is_there(members, r);
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
    r.smallest_jacobian = number(json.at("smallest_jacobian"));
    r.smallest_step = number(json.at("smallest_step"));
    r.energy = energy_from(json.at("energy"));
    take_what_is_there(json, r);
    evaluation.instruction_level = json.at("level").get<std::string>();
    evaluation.wall_seconds = json.at("wall_s").get<double>();
    evaluation.cpu_seconds = json.at("cpu_s").get<double>();
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("not a stored impact: ") + error.what());
  }
  evaluation.reused = true;
  return evaluation;
}

bool lacks_something(const ImpactResult& result, const Problem& problem) {
  const auto crossed = std::ranges::count_if(problem.lower_faces(), [&](double face) { return result.depth >= face; });
  return std::ssize(result.speeds_behind) < crossed || (problem.channel && result.channel.largest.empty()) ||
         (problem.half_speed_depth && result.outcome == Outcome::stopped && !(result.half_speed_depth > 0));
}

}  // namespace percal
