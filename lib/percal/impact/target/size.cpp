#include "percal/impact/target/size.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "percal/base/error.hpp"
#include "percal/impact/settings.hpp"
#include "percal/impact/target/block.hpp"
#include "percal/problem/domain.hpp"

namespace percal {
namespace {

constexpr double mean_over_first_step = 0.25;  // docs/decisions/0012-mesh-and-phase.md
constexpr double most_elements = 2e9;          // they are counted by ints
constexpr double usual_elements_per_radius = MeshScene{}.elements_per_radius;

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

// Of the undeformed cell, a square or a cube; density, mu and K over mu of the layer where it is least.
double first_step(const Problem& p, double side) {
  double fastest = (p.bulk_ratio + 4.0 / 3) * p.mu();  // wave speed squared
  for (const LowerLayer& layer : p.below)
    fastest = std::max(fastest, (layer.bulk_ratio + 4.0 / 3) * layer.mu / layer.density);
  const int dimensions = p.geometry == Geometry::block ? 3 : 2;
  return std::min(p.time_step_factor * side / std::sqrt(dimensions * fastest), largest_travel * side / p.speed_factor);
}

double most_steps_of(const Problem& p) {
  return std::min(p.end_time, 2 * p.whole_depth()) / (mean_over_first_step * first_step(p, 1 / p.elements_per_radius));
}

double bytes_of_a_number(const Problem& p) {
  return p.arithmetic == Arithmetic::single_precision ? sizeof(float) : sizeof(double);
}

RunSize size_of_block(const Problem& p) {
  const BoxGrid grid = box_grid(box_options(p));
  const double across = static_cast<double>(grid.columns_x()) * grid.columns_y();
  const double nodes = (grid.columns_x() + 1.0) * (grid.columns_y() + 1.0) * (grid.rows() + 1.0);
  return {.columns = across,
          .rows = static_cast<double>(grid.rows()),
          .elements = across * grid.rows(),
          .bytes = nodes * (bytes_of_a_number(p) * fields_per_brick + 1),
          .steps = most_steps_of(p)};
}

bool beyond_memory(const RunSize& size) { return size.bytes > physical_memory() || size.elements > most_elements; }
bool beyond_patience(const RunSize& size) { return size.steps > static_cast<double>(most_steps); }

// The key that makes the run too large: the mesh, where one of the usual fineness would do.
std::string key_to_blame(const Problem& problem, const SizeKeys& keys, bool (*too_large)(const RunSize&)) {
  if (problem.elements_per_radius > usual_elements_per_radius &&
      !too_large(size_of(on_mesh(problem, usual_elements_per_radius))))
    return keys.mesh;
  const RunSize size = size_of(problem);
  return size.rows >= size.columns || !beyond_memory(size) ? keys.depth : keys.width;
}

}  // namespace

RunSize size_of(const Problem& p) {
  if (p.geometry == Geometry::block) return size_of_block(p);
  const GradedCounts counts = counts_of(mesh_options(p));
  RunSize size{.columns = counts.columns() * (p.whole ? 2 : 1), .rows = counts.rows};
  size.elements = size.columns * size.rows;
  size.bytes = (size.columns + 1) * (size.rows + 1) * (bytes_of_a_number(p) * fields_per_element(p) + 1);
  size.steps = most_steps_of(p);
  return size;
}

bool is_too_large(const Problem& problem) {
  const RunSize size = size_of(problem);
  return beyond_memory(size) || beyond_patience(size);
}

void refuse_what_is_too_large(const Problem& problem, const std::string& file, const SizeKeys& keys) {
  const RunSize size = size_of(problem);
  if (beyond_memory(size))
    throw BadInput(Place{file, 0, key_to_blame(problem, keys, beyond_memory)}, in_words(size),
                   fmt::format("a run that fits into this machine's {:.3g} GB of memory and has up to {:g} elements",
                               1e-9 * physical_memory(), most_elements));
  if (beyond_patience(size))
    throw BadInput(Place{file, 0, key_to_blame(problem, keys, beyond_patience)}, in_words(size),
                   fmt::format("a run of up to about {:g} steps", static_cast<double>(most_steps)));
}

std::string in_words(const RunSize& size) {
  return fmt::format("{:.6g} elements ({:.6g} columns, {:.6g} rows), {:.3g} MB, up to about {:.2g} steps",
                     size.elements, size.columns, size.rows, 1e-6 * size.bytes, size.steps);
}

}  // namespace percal
