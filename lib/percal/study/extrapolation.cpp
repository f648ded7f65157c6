#include "percal/study/extrapolation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "percal/base/error.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/erosion_length.hpp"

namespace percal {
namespace {

constexpr double model_share = 0.5;  // of the step to h = 0: what the line may be wrong by

Scene on_finer_mesh(const Scene& scene) {
  Scene finer = on_mesh(scene, finer_mesh * scene.mesh.elements_per_radius);
  finer.output = {};
  return finer;
}

}  // namespace

void need_a_limit(const Scene& scene) {
  if (!erosion_length(scene.target))
    throw BadInput(Place{.file = scene.source, .line = 0, .key = "--extrapolate"},
                   "a scene without target.erosion.length",
                   "one with it: the local rule has no limit in the element's size");
  if (scene.replicates < 2)
    throw BadInput(Place{.file = scene.source, .line = 0, .key = "--extrapolate"}, "one replicate",
                   "two or more: each depth is a mean over the mesh phase");
  refuse_what_is_too_large(reduce(on_finer_mesh(scene)).problem, scene.source);
}

Extrapolation extrapolate(const Penetration& coarse, const Penetration& fine, double elements_per_radius) {
  const double step = *fine.depth - *coarse.depth;
  return {.depth = *fine.depth + step / (finer_mesh - 1),
          .standard_error = std::hypot(finer_mesh * *fine.standard_error, *coarse.standard_error) / (finer_mesh - 1),
          .model_error = model_share * std::abs(step) / (finer_mesh - 1),
          .elements_per_radius = elements_per_radius,
          .finer_elements_per_radius = finer_mesh * elements_per_radius,
          .mesh_depth = *coarse.depth,
          .finer_depth = *fine.depth,
          .replicates = static_cast<int>(fine.depths.size())};
}

std::optional<Extrapolation> extrapolated(const Scene& scene, const Penetration& coarse, Campaign& campaign,
                                          Progress* progress) {
  if (!coarse.depth) return std::nullopt;
  const Reduction finer = reduce(on_finer_mesh(scene));
  const auto runs = campaign.replicate({finer.problem}, scene.replicates, progress).front();
  const Penetration fine = summarise(runs, finer.problem, finer.scales);
  if (!fine.depth) return std::nullopt;
  return extrapolate(coarse, fine, scene.mesh.elements_per_radius);
}

}  // namespace percal
