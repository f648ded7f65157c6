// Scenes, and impacts as they are run for percal impact.
#include <pybind11/stl.h>

#include <chrono>

#include "core.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/observe/page/impact_json.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/error_evidence.hpp"

namespace percal::python {
namespace {

namespace py = pybind11;

// The result as JSON; the middle run's history is in it where it is asked for.
std::string impact(Scene scene, std::optional<double> elements_per_radius, std::optional<int> replicates, int threads,
                   const std::optional<std::string>& store_path, bool history, bool measure_errors, bool extrapolate) {
  const auto start = std::chrono::steady_clock::now();
  if (elements_per_radius) scene.mesh.elements_per_radius = *elements_per_radius;
  if (replicates) scene.replicates = *replicates;
  scene.output.history = history;
  parse_scene(scene_to_toml(scene, ""), "impact");  // throws where an option is out of range
  const Reduction reduction = reduce(scene);
  refuse_what_is_too_large(reduction.problem, scene.source);
  const ErrorsAskedFor asked{.measured = measure_errors, .extrapolated = extrapolate};
  check_errors_asked_for(asked, scene);
  ImpactFindings found{.scene = scene, .reduction = reduction};
  interruptible([&](const std::atomic<bool>& stop) {
    std::optional<Store> store;
    if (store_path) store.emplace(*store_path);
    Campaign campaign(store ? &*store : nullptr, threads);
    campaign.stop_when([&] { return stop.load(); });
    found.runs = campaign.evaluate(replicates_of(reduction.problem, scene.replicates), nullptr);
    found.penetration = summarise(found.runs, reduction.problem, reduction.scales);
    found.evidence = error_evidence(asked, scene, reduction, found.runs, found.penetration, campaign);
    found.cost = cost_since(start, campaign);
  });
  return page::written(impact_to_json(found));
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
