// Scenes, and impacts as they are run for percal impact.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "core.hpp"
#include "percal/base/version.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/observe/penetration.hpp"
#include "percal/observe/result_json.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal::python {
namespace {

namespace py = pybind11;
using nlohmann::json;

json number_or_null(const std::optional<double>& number) { return number ? json(*number) : json(nullptr); }

// The first replicate keeps the history.
std::vector<Problem> replicates_of(const Scene& scene, const Problem& problem) {
  std::vector<Problem> problems(scene.replicates, problem);
  for (int k = 0; k < scene.replicates; ++k) {
    problems[k].speed_factor = replicate_speed_factor(k);
    if (k > 0) problems[k].history_samples = 0;
  }
  return problems;
}

json runs_of(const std::vector<Evaluation>& runs, const Penetration& penetration) {
  json all = json::array();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const ImpactResult& run = runs[k].result;
    all.push_back({{"speed_factor", replicate_speed_factor(static_cast<int>(k))},
                   {"outcome", word(run.outcome)},
                   {"reason", run.reason},
                   {"depth_m", penetration.depths[k]},
                   {"steps", run.steps},
                   {"elements", run.elements},
                   {"eroded", run.eroded},
                   {"energy_closure", run.energy.closure()},
                   {"cpu_s", runs[k].cpu_seconds},
                   {"reused", runs[k].reused}});
  }
  return all;
}

json result_of(const Scene& scene, const Reduction& reduction, const std::vector<Evaluation>& runs) {
  const Penetration penetration = summarise(runs, reduction.problem, reduction.scales);
  std::vector<std::string> notes = reduction.warnings;
  for (const std::string& warning : warnings(penetration, runs, reduction.problem)) notes.push_back(warning);
  json left_out = json::array();
  for (const LeftOut& omission : reduction.left_out)
    left_out.push_back({{"what", omission.what}, {"why", omission.why}});
  return {{"schema", result_schema},
          {"percal", version()},
          {"command", "impact"},
          {"input", {{"scene", scene.source}, {"toml", scene_to_toml(scene, "")}}},
          {"outcome", word(penetration.outcome)},
          {"depth_m", number_or_null(penetration.depth)},
          {"depth_spread_m", number_or_null(penetration.spread)},
          {"depth_standard_error_m", number_or_null(penetration.standard_error)},
          {"depth_at_least_m", number_or_null(penetration.at_least)},
          {"mu_as_given_Pa", scene.target.mu_as_given},
          {"mu_true_Pa", reduction.mu_true},
          {"bulk_modulus_Pa", reduction.bulk_modulus},
          {"mach", reduction.mach},
          {"energy", energy_to_json(penetration.energy)},
          {"energy_worst_closure", penetration.worst_closure},
          {"runs", runs_of(runs, penetration)},
          {"isa", instruction_level()},
          {"left_out", left_out},
          {"warnings", notes}};
}

// The result as JSON, and the history of the first run as CSV, empty where the scene wants none.
std::pair<std::string, std::string> impact(Scene scene, std::optional<int> elements_per_radius,
                                           std::optional<int> replicates, int threads,
                                           const std::optional<std::string>& store_path, bool history) {
  if (elements_per_radius) scene.mesh.elements_per_radius = *elements_per_radius;
  if (replicates) scene.replicates = *replicates;
  scene.output.history = history;
  parse_scene(scene_to_toml(scene, ""), "impact");  // throws where an option is out of range
  const Reduction reduction = reduce(scene);
  std::pair<std::string, std::string> result;
  interruptible([&](const std::atomic<bool>& stop) {
    std::optional<Store> store;
    if (store_path) store.emplace(*store_path);
    Campaign campaign(store ? &*store : nullptr, threads);
    campaign.stop_when([&] { return stop.load(); });
    const auto runs = campaign.evaluate(replicates_of(scene, reduction.problem), nullptr);
    result.first = result_of(scene, reduction, runs).dump(-1, ' ', false, json::error_handler_t::replace);
    if (history) result.second = history_csv(runs.front().result.history, reduction.scales);
  });
  return result;
}

}  // namespace

void bind_impact(py::module_& core) {
  py::class_<Scene>(core, "Scene")
      .def_static("read", &read_scene)
      .def_static("parse", &parse_scene)
      .def_readonly("source", &Scene::source)
      .def("to_toml", [](const Scene& scene) { return scene_to_toml(scene, ""); });
  core.def("impact", &impact);
}

}  // namespace percal::python
