// What percal scale found, as JSON.
#include <filesystem>

#include "percal/scaling/page/page.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

Json system_to_json(const System& system, ModulusConvention convention) {
  Json result = {{"particle", system.particle}, {"target", system.target}, {"convention", word(convention)}};
  for (const SystemQuantity& quantity : system_quantities())
    result[result_key(quantity)] = finite(system.*quantity.member);
  const bool known = system.mu && (convention == ModulusConvention::true_shear || system.alpha);
  result["mu_as_given_Pa"] =
      known ? Json(modulus_as_given(*system.mu, system.alpha.value_or(1), convention)) : Json(nullptr);
  result["impact_parameter_kg_m_s"] = finite(impact_parameter(system));
  result["sectional_density_kg_m2"] = finite(sectional_density(system));
  result["particle_compliance"] = finite(particle_compliance(system));
  return result;
}

Json group_to_json(const Comparison& compared) {
  return {{"symbol", compared.group->symbol},
          {"formula", compared.group->formula},
          {"name", compared.group->name},
          {"prototype", finite(compared.prototype)},
          {"model", finite(compared.model)},
          {"agreement", word(compared.agreement)},
          {"difference", finite(compared.difference)},
          {"missing_in_prototype", compared.missing_in_prototype},
          {"missing_in_model", compared.missing_in_model}};
}

}  // namespace

Json scale_to_json(const ScaleJob& job, const Completion& completion, const std::string& similar_scene) {
  const System &prototype = job.prototype.system, &model = completion.model;
  Json groups = Json::array(), derived = Json::array(), obstacles = Json::array();
  for (const Comparison& compared : compare(prototype, model, job.tolerance)) groups.push_back(group_to_json(compared));
  for (const Derived& one : completion.derived)
    derived.push_back({{"quantity", result_key(*one.quantity)}, {"value", one.value}, {"from", one.because->symbol}});
  for (const Conflict& conflict : completion.conflicts) obstacles.push_back(describe(conflict));
  for (const Gap& gap : completion.gaps) obstacles.push_back(describe(gap));
  const bool has_ratio = prototype.mu && model.mu;
  Json result =
      page::result_head("scale", {{"job", std::filesystem::path(job.file).filename().string()}, {"toml", job.text}});
  result.update({{"tolerance", job.tolerance},
                 {"prototype", system_to_json(prototype, job.prototype.convention)},
                 {"model", system_to_json(model, job.model.convention)},
                 {"groups", groups},
                 {"derived", derived},
                 {"not_similar_because", obstacles},
                 {"modulus_ratio", has_ratio ? Json(*model.mu / *prototype.mu) : Json(nullptr)},
                 {"similar_scene", similar_scene.empty() ? Json(nullptr) : Json(similar_scene)},
                 {"cost", nullptr}});
  return result;
}

}  // namespace percal
