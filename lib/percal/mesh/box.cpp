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
  BoxGrid grid;
  if (options.left.end > 0) {
    const auto left = nodes_along(options.left, options);
    for (auto x = left.rbegin(); *x > 0; ++x) grid.x.push_back(-*x);
  }
  const auto right = nodes_along(options.right, options);
  grid.x.insert(grid.x.end(), right.begin(), right.end());
  grid.y = nodes_along(options.along, options);
  grid.z = nodes_along(options.down, options);
  return grid;
}

}  // namespace percal
