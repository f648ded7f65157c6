// The length over which a scene judges erosion, and the elements in it.
#pragma once
#include <optional>

#include "percal/base/error.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// An element may be so large a share of the length: three of them lie in it.
inline constexpr double largest_element_in_length = 1.0 / 3;

std::optional<double> erosion_length(const LayerScene& target);  // m; nothing where each element is judged by itself

// The side of an element over the length; nothing where there is none.
std::optional<double> element_over_erosion_length(const Scene& scene);

// How a depth goes as elements shrink. Without a limit it belongs to its mesh.
enum class Refinement {
  no_limit,      // each element goes by its own value               docs/decisions/0012-mesh-and-phase.md
  second_order,  // erosion is judged over a length                  docs/theory/impact.md, Erosion judged over a length
  any_order      // nothing erodes
};
Refinement refinement(const Scene& scene);

// Elements per radius, a whole number: the coarsest mesh that has three elements in the length; 1 where there is none.
double coarsest_mesh(const Scene& scene);

// Throws BadInput at `place` where the elements are too large.
void need_elements_in_erosion_length(const Scene& scene, const Place& place);

}  // namespace percal
