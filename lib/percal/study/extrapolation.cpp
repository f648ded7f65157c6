#include "percal/study/extrapolation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/base/error.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/erosion_length.hpp"

namespace percal {
namespace {

// docs/theory/errors.md (14): what is left of the step between the meshes beyond the finer one, by the measured order and by the
// first, which it may be; and what two meshes may agree in by chance.
constexpr double step_left = 1 / (finer_mesh * finer_mesh - 1), step_left_by_line = 1 / (finer_mesh - 1);
constexpr double least_share = 0.01;

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
  const double depth = *fine.depth + step_left * step;
  return {.depth = depth,
          .standard_error = std::hypot((1 + step_left) * *fine.standard_error, step_left * *coarse.standard_error),
          .model_error = std::max((step_left_by_line - step_left) * std::abs(step), least_share * depth),
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
