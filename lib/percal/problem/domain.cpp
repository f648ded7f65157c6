#include "percal/problem/domain.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/scene/width.hpp"

namespace percal {
namespace {

constexpr double tolerated_growth = 1.35;  // costs up to 0.7 % in depth; docs/decisions/0012-mesh-and-phase.md

// Growth shows in two widths of columns alone: no rows are needed.
double growth_of(const Problem& problem) {
  GradedMeshOptions options = mesh_options(problem);
  options.depth = 1 / options.elements_per_radius;
  return graded_mesh(options).growth;
}

}  // namespace

GradedMeshOptions mesh_options(const Problem& p) {
  return {.elements_per_radius = p.elements_per_radius,
          .fine_width = p.fine_width,
          .graded_columns = p.graded_columns,
          .width = p.width,
          .depth = p.whole_depth()};
}

BoxGridOptions box_options(const Problem& p) {
  const double sideways = std::tan(p.block.angle) * p.block.fine_depth;
  const BoxAxis half{p.fine_width, p.width}, along{p.block.fine_thickness, p.width};
  return {.elements_per_radius = p.elements_per_radius,
          .growth = p.block.growth,
          .left = p.whole ? half : BoxAxis{0, 0},
          .right = {half.fine + sideways, half.end + sideways},
          .along = along,
          .against = p.block.whole_across ? along : BoxAxis{0, 0},
          .down = {p.block.fine_depth, p.whole_depth()}};
}

int usual_graded_columns(const Problem& problem) { return graded_columns_for(usual_growth, mesh_options(problem)); }

Problem on_mesh(const Problem& problem, double elements_per_radius) {
  const bool usual = problem.geometry != Geometry::block && problem.graded_columns == usual_graded_columns(problem);
  Problem other = problem;
  other.elements_per_radius = round_to_12_digits(elements_per_radius);
  if (usual) other.graded_columns = usual_graded_columns(other);
  return other;
}

int graded_columns_like(const Problem& problem, double elements_per_radius, double width) {
  GradedMeshOptions options = mesh_options(problem);
  options.elements_per_radius = elements_per_radius;
  options.width = width;
  return std::max(1, graded_columns_for(growth_of(problem), options));
}

Scene on_mesh(const Scene& scene, double elements_per_radius) {
  Scene other = scene;
  if (scene.mesh.graded_columns && elements_per_radius != scene.mesh.elements_per_radius) {
    const Problem problem = reduce(scene).problem;
    other.mesh.graded_columns = graded_columns_like(problem, elements_per_radius, problem.width);
  }
  other.mesh.elements_per_radius = elements_per_radius;
  return other;
}

std::vector<std::string> mesh_warnings(const Scene& scene, const Problem& problem) {
  std::vector<std::string> warnings;
  const std::string near_wall = width_warning(problem.width, usual_width(scene) / scene.particle.radius);
  if (!near_wall.empty()) warnings.push_back(near_wall);
  const double growth = growth_of(problem);
  if (scene.mesh.graded_columns && growth > tolerated_growth)
    warnings.push_back(fmt::format(
        "with graded_columns = {} each column is {:.3g} times as wide as the last: expect 3 to 4 % in depth "
        "at 1.6 to 2, up to 15 % where the wall is near; {} columns or more keep it to {:.3g}, and without "
        "`graded_columns` the program chooses",
        problem.graded_columns, growth, usual_graded_columns(problem), usual_growth));
  return warnings;
}

MeshChoice mesh_choice(const Scene& scene, const Problem& problem) {
  if (problem.geometry == Geometry::block)
    return {.width_was_chosen = !scene.target.width.has_value(),
            .columns = static_cast<double>(box_grid(box_options(problem)).columns_x()),
            .growth = problem.block.growth};
  return {.width_was_chosen = !scene.target.width.has_value(),
          .columns_were_chosen = !scene.mesh.graded_columns.has_value(),
          .columns = counts_of(mesh_options(problem)).columns(),
          .growth = growth_of(problem)};
}

}  // namespace percal
