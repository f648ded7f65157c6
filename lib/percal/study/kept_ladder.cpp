#include "percal/study/kept_ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "percal/base/error.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/scene/erosion_length.hpp"

namespace percal {
namespace {

using Json = nlohmann::json;

// A stored row is never changed: newer ladders are kept under higher numbers.
std::string numbered(const std::string& key, int number) { return fmt::format("{} ladder={}", key, number); }

LadderOptions parse(const std::string& payload, const std::string& path) {
  try {
    const Json json = Json::parse(payload);
    return {.meshes = json.at("meshes").get<std::vector<double>>(),
            .replicates = json.at("replicates").get<int>(),
            .time_step_factor = json.at("time_step_factor").get<double>()};
  } catch (const Json::exception& error) {
    throw IoFailure(path + ": not a stored study: " + error.what() + "; remove the file or name another store");
  }
}

struct Newest {
  int number = 0;  // 0: there is none
  std::optional<LadderOptions> options;
};

Newest newest(const Store& store, const std::string& key) {
  Newest found;
  while (const auto row = store.find(numbered(key, found.number + 1)))
    found = {found.number + 1, parse(row->payload, store.path())};
  return found;
}

}  // namespace

std::string study_key(const Scene& scene) {
  const SolverScene solver;
  const double usual = std::max(MeshScene{}.elements_per_radius, coarsest_mesh(scene));
  const Scene any = rung_scene(scene, usual, solver.time_step_factor, Arithmetic::single_precision);
  return "study " + evaluation_key(reduce(any).problem, instruction_level());
}

std::optional<LadderOptions> kept_ladder(const Store& store, const std::string& key) {
  return newest(store, key).options;
}

void keep_ladder(Store& store, const std::string& key, const LadderOptions& options) {
  const Newest last = newest(store, key);
  if (last.options == options) return;
  const Json payload{{"meshes", options.meshes},
                     {"replicates", options.replicates},
                     {"time_step_factor", options.time_step_factor.value()}};
  store.put(numbered(key, last.number + 1), {"study", payload.dump(), 0});
}

}  // namespace percal
