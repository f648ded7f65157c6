#include "percal/mesh/box.hpp"

#include "percal/mesh/graded.hpp"

namespace percal {
namespace {

// The columns of a graded mesh (8a), (8b).
std::vector<double> nodes_along(const BoxAxis& axis, const BoxGridOptions& box) {
  GradedMeshOptions options{.elements_per_radius = box.elements_per_radius,
                            .fine_width = axis.fine,
                            .width = axis.end,
                            .depth = 1 / box.elements_per_radius};
  options.graded_columns = graded_columns_for(box.growth, options);
  return graded_mesh(options).radius;
}

}  // namespace

BoxGrid box_grid(const BoxGridOptions& options) {
  // Of both directions from 0, or of one.
  const auto both_ways = [&options](const BoxAxis& negative, const BoxAxis& positive) {
    std::vector<double> nodes;
    if (negative.end > 0) {
      const auto from_zero = nodes_along(negative, options);
      for (auto x = from_zero.rbegin(); *x > 0; ++x) nodes.push_back(-*x);
    }
    const auto from_zero = nodes_along(positive, options);
    nodes.insert(nodes.end(), from_zero.begin(), from_zero.end());
    return nodes;
  };
  return {both_ways(options.left, options.right), both_ways(options.against, options.along),
          nodes_along(options.down, options)};
}

}  // namespace percal
