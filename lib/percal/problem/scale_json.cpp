#include <filesystem>
#include <nlohmann/json.hpp>

#include "percal/base/version.hpp"
#include "percal/problem/scale_job.hpp"

namespace percal {
namespace {

using nlohmann::json;

json number_or_null(const std::optional<double>& number) { return number ? json(*number) : json(nullptr); }

std::string json_key(const SystemQuantity& quantity) {
  auto key = quantity.member == &System::mu ? std::string("mu_true") : quantity.key;
  return quantity.unit.empty() ? key : key + "_" + quantity.unit;
}

json as_json(const System& system, ModulusConvention convention) {
  json result = {{"particle", system.particle}, {"target", system.target}, {"convention", word(convention)}};
  for (const auto& quantity : system_quantities()) result[json_key(quantity)] = number_or_null(system.*quantity.member);
  bool known = system.mu && (convention == ModulusConvention::true_shear || system.alpha);
  result["mu_as_given_Pa"] =
      known ? json(modulus_as_given(*system.mu, system.alpha.value_or(1), convention)) : json(nullptr);
  return result;
}

}  // namespace

json scale_to_json(const ScaleJob& job, const Completion& completion, const std::vector<Comparison>& comparisons) {
  json groups = json::array(), derived = json::array(), obstacles = json::array();
  for (const auto& one : comparisons)
    groups.push_back({{"symbol", one.group->symbol},
                      {"formula", one.group->formula},
                      {"name", one.group->name},
                      {"prototype", number_or_null(one.prototype)},
                      {"model", number_or_null(one.model)},
                      {"agreement", word(one.agreement)},
                      {"difference", number_or_null(one.difference)},
                      {"missing_in_prototype", one.missing_in_prototype},
                      {"missing_in_model", one.missing_in_model}});
  for (const auto& one : completion.derived)
    derived.push_back({{"quantity", json_key(*one.quantity)}, {"value", one.value}, {"from", one.because->symbol}});
  for (const auto& conflict : completion.conflicts) obstacles.push_back(describe(conflict));
  for (const auto& gap : completion.gaps) obstacles.push_back(describe(gap));
  const auto& prototype = job.prototype.system;
  const auto& model = completion.model;
  bool has_ratio = prototype.mu && model.mu;
  return {{"schema", result_schema},
          {"version", version()},
          {"command", "scale"},
          {"job", std::filesystem::path(job.file).filename().string()},
          {"input", job.text},
          {"tolerance", job.tolerance},
          {"prototype", as_json(prototype, job.prototype.convention)},
          {"model", as_json(model, job.model.convention)},
          {"groups", groups},
          {"derived", derived},
          {"not_similar_because", obstacles},
          {"modulus_ratio", has_ratio ? json(*model.mu / *prototype.mu) : json(nullptr)}};
}

}  // namespace percal
