// What one column holds: kinetic energy of its nodes, energy stored in the elements of a plain solid. In double, whatever the fields are
// kept in. Compiled once for each instruction level (kernel_level.cpp).
#pragma once
#include "percal/impact/kernel/element.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/impact/kernel/uniform_solid.hpp"

namespace percal::PERCAL_LEVEL {

template <class T>
PERCAL_INLINE DoubleLanes::Vector in_double(const T* from) {
  typedef T Narrow __attribute__((vector_size(sizeof(T) * DoubleLanes::count)));
  Narrow narrow;
  __builtin_memcpy(&narrow, from, sizeof narrow);
  return __builtin_convertvector(narrow, DoubleLanes::Vector);
}

template <class Real>
KineticEnergy kinetic_energy(const FieldsView<const Real>& fields, int column, int nodes, const ColumnMasses& masses) {
  using V = DoubleLanes::Vector;
  const long start = static_cast<long>(column) * fields.stride;
  V live{}, freed{};
  for (int j = 0; j < nodes; j += DoubleLanes::count) {
    const V r = in_double(fields.v_r + start + j), z = in_double(fields.v_z + start + j);
    const V twice = load<V>(masses.row_density + j) * (r * r + z * z);
    const auto is_live = in_double(masses.live_elements + j) > 0.0;
    live += select(is_live, twice, V{});
    freed += select(is_live, V{}, twice);
  }
  const double half_mass = 0.5 * masses.column_mass;
  return {half_mass * lane_sum(live), half_mass * lane_sum(freed)};
}

template <class Real>
StoredEnergy stored_energy(const FieldsView<const Real>& fields, int column, int rows, const ColumnShape& shape,
                           const MaterialConstants& material) {
  using V = DoubleLanes::Vector;
  const long inner = static_cast<long>(column) * fields.stride, outer = inner + fields.stride;
  const double half_per_width = 0.5 / shape.width, half_per_height = 0.5 / shape.height;
  const double energy_scale = 2 * material.mu / (material.alpha * material.alpha);
  V elastic{}, hourglass{};
  for (int j = 0; j < rows; j += DoubleLanes::count) {
    const auto live = in_double(fields.alive + inner + j) > 0.0;
    if (!any(live)) continue;
    const auto corners = [&](const Real* u) {
      return Corners<V>{in_double(u + inner + j), in_double(u + outer + j), in_double(u + outer + j + 1), in_double(u + inner + j + 1)};
    };
    const Corners<V> r = corners(fields.u_r), z = corners(fields.u_z);
    const Gradient<V> F = gradient_of(r, z, half_per_width, half_per_height, 0.25 * shape.per_radius);
    const Stretches<V> s = stretches(F);
    const V energy = strain_energy(PressureLaw::log_quadratic, s, isochoric_powers(F, s, material.alpha), energy_scale, material.bulk);
    const V mode_r = r.hourglass(), mode_z = z.hourglass();
    elastic += select(live, energy, V{});
    hourglass += select(live, mode_r * mode_r + mode_z * mode_z, V{});
  }
  return {shape.thickness * shape.width * shape.height * lane_sum(elastic),
          0.5 * hourglass_stiffness(material, shape) * lane_sum(hourglass)};
}

}  // namespace percal::PERCAL_LEVEL
