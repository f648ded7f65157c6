#include "percal/scene/erosion_length.hpp"

#include <fmt/format.h>

#include <cmath>

#include "percal/units/quantity.hpp"

namespace percal {
namespace {

constexpr double rounding = 1e-9;  // of a length that is just three elements

}  // namespace

std::optional<double> erosion_length(const LayerScene& target) {
  const auto* average = std::get_if<AverageWithin>(&target.erosion_average);
  return average ? std::optional(average->length) : std::nullopt;
}

std::optional<double> element_over_erosion_length(const Scene& scene) {
  const auto length = erosion_length(scene.target);
  if (!length) return std::nullopt;
  return scene.particle.radius / scene.mesh.elements_per_radius / *length;
}

Refinement refinement(const Scene& scene) {
  if (std::holds_alternative<NoErosion>(scene.target.erosion)) return Refinement::any_order;
  return erosion_length(scene.target) ? Refinement::second_order : Refinement::no_limit;
}

double coarsest_mesh(const Scene& scene) {
  const auto length = erosion_length(scene.target);
  return length ? std::ceil(scene.particle.radius / *length / largest_element_in_length * (1 - rounding)) : 1;
}

void need_elements_in_erosion_length(const Scene& scene, const Place& place) {
  const auto share = element_over_erosion_length(scene);
  if (!share || *share <= largest_element_in_length * (1 + rounding)) return;
  const double radii = *erosion_length(scene.target) / scene.particle.radius;
  throw BadInput(place,
                 fmt::format("{} ({:.4g} radii), {:.3g} elements of 1/{} of the radius",
                             format_quantity(*erosion_length(scene.target), dimension::length), radii, 1 / *share,
                             scene.mesh.elements_per_radius),
                 fmt::format("a length of three elements or more: {:.4g} radii, or elements_per_radius = {:.0f}",
                             3.0 / scene.mesh.elements_per_radius, coarsest_mesh(scene)));
}

}  // namespace percal
